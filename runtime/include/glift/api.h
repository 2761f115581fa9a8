// What the runtime library exports. Everything else in it stays hidden, so that its own Vulkan function pointers never
// meet those of the program that uses it.
#pragma once

#if defined(_MSVC_LANG) ? _MSVC_LANG < 202002L : __cplusplus < 202002L
#error "Glift needs C++20: compile with -std=c++20 (CMake: target_compile_features(your_target PUBLIC cxx_std_20))"
#endif

#if defined(_WIN32)
#define GLIFT_API
#else
#define GLIFT_API __attribute__((visibility("default")))
#endif

// Before functions that several generated sources may define, all alike: the linker takes one.
#define GLIFT_SHARED __attribute__((weak))
