// Devices, memories, commands, recordings, calls of kernels, errors and the log. What else a program may want is
// included by generated code (structure.h) or by name: vulkan.h, inspect.h, profile.h.
#pragma once

#include <glift/commands.h>
#include <glift/device.h>
#include <glift/error.h>
#include <glift/log.h>
#include <glift/mark.h>
#include <glift/memory.h>
#include <glift/message.h>
#include <glift/pass.h>
#include <glift/recording.h>
#include <glift/version.h>
