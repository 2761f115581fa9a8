// Made by gliftc from image_parts.glift. Changes are lost when it is made again.
#pragma once

#include <glift/vector.h>

#include <cstddef>
#include <optional>

