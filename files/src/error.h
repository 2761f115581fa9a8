// Errors of files.
#pragma once

#include <string>

namespace glift::files {

/// Throws ErrorCode::bad_file: the file is damaged, cut off, or of no format that this library reads.
[[noreturn]] void throw_bad(const std::string& path, const std::string& why);
/// Throws ErrorCode::wrong_argument with the text of the last failed system call.
[[noreturn]] void throw_system(const std::string& call, const std::string& path);

}  // namespace glift::files
