// Glift's version: that of the runtime, of gliftc, and of the packages. CMake reads it from here.
//
// Versions are semantic (semver.org). While the major number is 0, minor versions may change the interface between
// generated code and the runtime, and patches do not: generated code needs the runtime of the same major and minor
// version, which it asserts. CHANGELOG.md says what else is stable.
#pragma once

#define GLIFT_VERSION_MAJOR 0
#define GLIFT_VERSION_MINOR 1
#define GLIFT_VERSION_PATCH 0
