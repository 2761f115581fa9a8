// URIs of documents and the paths of their files.
#pragma once

#include <string>
#include <string_view>

namespace gliftc::lsp {

/// The path that a file URI names, without symbolic links, so that one file has one path. Of another URI (untitled
/// documents), the URI itself.
std::string path_of(std::string_view uri);
/// The file URI of a path; of a URI itself.
std::string uri_of(std::string_view path);
/// The path without symbolic links, as far as it exists.
std::string canonical(const std::string& path);

}  // namespace gliftc::lsp
