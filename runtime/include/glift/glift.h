// The whole runtime but for vulkan.h.
#pragma once

#include <glift/commands.h>
#include <glift/device.h>
#include <glift/error.h>
#include <glift/log.h>
#include <glift/memory.h>
#include <glift/pass.h>
#include <glift/recording.h>
