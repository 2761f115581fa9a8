// GLIFT_API marks what the runtime library exports. All other symbols are hidden, so that they cannot clash with those
// of the program, which may itself load Vulkan's functions.
#pragma once

#if defined(_MSVC_LANG) ? _MSVC_LANG < 202002L : __cplusplus < 202002L
#error "Glift needs C++20: compile with -std=c++20 (CMake: target_compile_features(your_target PUBLIC cxx_std_20))"
#endif

// GLIFT_LOCAL marks what each library or program has for itself. An inline variable that is not so marked is one for
// the whole process, and stays that of the first library when another version of the library is loaded.
#if defined(_WIN32)
#define GLIFT_API
#define GLIFT_LOCAL
#else
#define GLIFT_API __attribute__((visibility("default")))
#define GLIFT_LOCAL __attribute__((visibility("hidden")))
#endif

// Marks functions and tables that several generated sources define identically; the linker keeps one. Windows has no
// such weak symbols, but inline functions, here also where the source itself does not use them.
#if defined(_WIN32)
#define GLIFT_SHARED inline __attribute__((used))
#else
#define GLIFT_SHARED __attribute__((weak))
#endif
