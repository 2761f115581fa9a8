// GLIFT_API marks what the runtime library exports. All other symbols are hidden, so that they cannot clash with those
// of the program, which may itself load Vulkan's functions.
#pragma once

#if defined(_MSVC_LANG) ? _MSVC_LANG < 202002L : __cplusplus < 202002L
#error "Glift needs C++20: compile with -std=c++20 (CMake: target_compile_features(your_target PUBLIC cxx_std_20))"
#endif

#if defined(_WIN32)
#define GLIFT_API
#else
#define GLIFT_API __attribute__((visibility("default")))
#endif

// Marks functions that several generated sources define identically; the linker keeps one.
#define GLIFT_SHARED __attribute__((weak))
