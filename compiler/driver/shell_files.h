// Manual pages and shell completion, made from the options that the command line declares.
#pragma once

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace gliftc {

struct ShellFile {
    std::string path;  ///< below the folder for all of them, `man1/gliftc.1`
    std::string text;
};

/// A page of section 1 for the program and one for each of its commands; completion for bash, zsh and fish. Commands
/// and options without a group are hidden, and left out.
std::vector<ShellFile> shell_files(const CLI::App& app, const std::string& version);

/// Writes them. Throws EnvironmentError if one cannot be written.
void write_shell_files(const CLI::App& app, const std::string& version, const std::string& folder);

}  // namespace gliftc
