// The functions that libglift_clang.so exports. It is built together with gliftc; the version detects a library of
// another build.
#pragma once

#include "interop/interop.h"

namespace gliftc {

inline constexpr int plugin_version = 1;

extern "C" {
int glift_clang_version();
void glift_clang_import_struct(const ImportRequest& request, ImportResult& result);
void glift_clang_format(std::string_view text, std::string_view style, FormatResult& result);
}

}  // namespace gliftc
