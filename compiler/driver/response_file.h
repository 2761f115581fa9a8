// Response files: `@file` on the command line.
#pragma once

#include "driver/file_system.h"

#include <string>
#include <vector>

namespace gliftc {

/// Replaces each `@file` by its words, separated by white space. Quotes, single or double, hold a word together; a
/// backslash, also inside quotes, takes the next character as it is. Files may name further files, nested 16 deep at
/// most. Returns the text of an error, such as that a file cannot be read; empty if there is none.
std::string expand_response_files(std::vector<std::string>& words, const FileSystem& files);

}  // namespace gliftc
