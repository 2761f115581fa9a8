// Words of the command line: checks that CLI11 does not have, for CLI::Option::check, and words for a shell.
#pragma once

#include <string>

namespace command_line {

/// Checks return what is wrong with a word; nothing if it is right. CLI::Range lets NaN through.
std::string is_finite(const std::string& number);
/// A name of a picture that picture::write writes.
std::string is_picture(const std::string& path);
/// A name in a folder that there is, and of no folder: so that a mistake is found before the work, not after it.
std::string can_be_made(const std::string& path);

/// A word as a shell takes it.
std::string quoted(const std::string& word);

}  // namespace command_line
