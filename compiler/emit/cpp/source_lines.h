// `#line` directives, by which debuggers show generated statements at their lines of the .glift source.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace gliftc::cpp {

/// Inserts a `#line` before each line, unless it is blank, that follows a comment `// name.glift:7` in the same block,
/// and after the block one that returns to the generated file. `path_of` maps the file's name in the comment to its
/// path; `name` is the generated file's name.
std::string with_source_lines(std::string_view text, const std::string& name,
                              const std::function<std::string(std::string_view)>& path_of);

}  // namespace gliftc::cpp
