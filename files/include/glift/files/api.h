// What libglift_files exports.
#pragma once

#if defined(GLIFT_FILES_STATIC)
#define GLIFT_FILES_API
#else
#define GLIFT_FILES_API __attribute__((visibility("default")))
#endif
