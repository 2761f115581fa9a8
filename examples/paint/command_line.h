// Arguments of the command line: validators that CLI11 lacks, for CLI::Option::check, and quoting for a shell.
#pragma once

#include <string>

namespace command_line {

// Each validator returns what is wrong with the argument, or an empty string if it is valid.

/// Not infinite, and no NaN, which CLI::Range accepts. Whether it is a number at all is left to CLI11.
std::string is_finite(const std::string& number);
/// The name ends as one of a format that picture::write has: .png or .exr.
std::string is_picture(const std::string& path);
/// The folder of the path exists, and the path is no folder itself: so a wrong path is reported before the work, not
/// after it. Whether the file may be written is not checked.
std::string can_be_made(const std::string& path);

/// The argument, in quotes if a POSIX shell needs them.
std::string quoted(const std::string& argument);

}  // namespace command_line
