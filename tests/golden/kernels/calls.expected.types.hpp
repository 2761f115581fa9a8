// Made by gliftc from calls.glift. Changes are lost when it is made again.
#pragma once

#include <glift/vector.h>

#include <cstddef>
#include <optional>

