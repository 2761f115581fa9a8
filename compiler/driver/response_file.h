// `@file` on the command line: the words that the file holds.
#pragma once

#include "driver/file_system.h"

#include <string>
#include <vector>

namespace gliftc {

/// Replaces each `@file` by its words, which white space separates; quotes hold words together and a backslash takes
/// the next character as it is. Files may name further files. Returns what went wrong; empty: nothing.
std::string expand_response_files(std::vector<std::string>& words, const FileSystem& files);

}  // namespace gliftc
