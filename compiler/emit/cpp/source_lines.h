// `#line` directives, by which debuggers show generated statements at their lines of the .glift source.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace gliftc::cpp {

/// The text with a `#line` before each line, unless it is blank, that follows a comment `// name.glift:7` in the same
/// block. `path_of` gives the path of a file that such a comment names; `name`: of the generated file, to which the
/// other lines belong.
std::string with_source_lines(std::string_view text, const std::string& name,
                              const std::function<std::string(std::string_view)>& path_of);

}  // namespace gliftc::cpp
