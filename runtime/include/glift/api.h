// What the runtime library exports. Everything else in it stays hidden, so that its own Vulkan function pointers never
// meet those of the program that uses it.
#pragma once

#if defined(_WIN32)
#define GLIFT_API
#else
#define GLIFT_API __attribute__((visibility("default")))
#endif
