// The functions that libglift_clang.so exports. The library is built together with gliftc. Both contain
// `plugin_version`, the version of this interface, so that gliftc can detect a library built with another interface.
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
