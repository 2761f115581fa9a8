// The compiler's access to files; tests and fuzzers substitute their own.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gliftc {

struct ReadResult {
    std::string text;
    std::string error;  ///< empty: read
};

struct FileSystem {
    std::function<ReadResult(const std::string& path)> read;  ///< "-" is standard input
    std::function<bool(const std::string& path)> exists;      ///< and is a file
    std::function<std::vector<std::string>(const std::string& folder)>
        list;                                                      ///< names of the files in a folder, sorted
    std::function<std::string(const std::string& path)> identity;  ///< the same for two paths to one file
};

/// The disk.
FileSystem disk();

/// One file, "input.glift", and nothing else.
FileSystem only_text(std::string text);

/// Writes the file unless its contents are `bytes` already; creates its folder. Returns an error, or nothing.
std::optional<std::string> write_if_changed(const std::string& path, const std::string& bytes);

/// The folder of the standard library beside this executable: ../share/glift/stdlib.
std::string library_beside_executable();
/// The folder of the diagnostics' examples beside this executable: ../share/glift/diagnostics.
std::string diagnostics_beside_executable();

}  // namespace gliftc
