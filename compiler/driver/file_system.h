// How the compiler reaches files; tests and fuzzers give it others than the disk's.
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
    std::function<bool(const std::string& path)> exists;      ///< as a file
    std::function<std::vector<std::string>(const std::string& folder)>
        list;                                                      ///< names of the files in a folder, sorted
    std::function<std::string(const std::string& path)> identity;  ///< the same for two paths to one file
};

/// The disk.
FileSystem disk();

/// One file, "input.glift", and nothing else.
FileSystem only_text(std::string text);

/// Writes the file if its bytes are others than `bytes`; makes its folder. Returns what went wrong, or nothing.
std::optional<std::string> write_if_changed(const std::string& path, const std::string& bytes);

/// The folder of the standard library beside this executable: ../share/glift/stdlib.
std::string library_beside_executable();
/// The folder of the diagnostics' examples beside this executable: ../share/glift/diagnostics.
std::string diagnostics_beside_executable();

}  // namespace gliftc
