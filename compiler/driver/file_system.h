// The compiler's access to files; tests and fuzzers substitute their own.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gliftc {

struct ReadResult {
    std::string text;
    std::string error;  ///< empty if the file was read
};

struct FileSystem {
    std::function<ReadResult(const std::string& path)> read;  ///< "-" is standard input (disk() only)
    std::function<bool(const std::string& path)> exists;      ///< whether the path leads to a file, not a folder
    std::function<std::vector<std::string>(const std::string& folder)>
        list;                                                      ///< names of all files and folders in it, sorted
    std::function<std::string(const std::string& path)> identity;  ///< a text that is equal for two paths to one file
};

/// The files of the operating system.
FileSystem disk();

/// A file system with one file, "input.glift".
FileSystem only_text(std::string text);

/// Writes the file, unless its contents are `bytes` already, so that build tools see no change. Creates its folder.
/// Returns the text of an error, such as "No space left on device"; absent if there is none.
std::optional<std::string> write_if_changed(const std::string& path, const std::string& bytes);

/// Replaces the contents of a file of the user's. The bytes go into a new file beside it, with the same mode, which is
/// then renamed: after an error, or if the process is killed, the file is as it was. Follows symbolic links. Returns
/// the text of an error; absent if there is none.
std::optional<std::string> replace_file(const std::string& path, const std::string& bytes);

/// The folder of the standard library: ../share/glift/stdlib, seen from the folder of this executable.
std::string library_beside_executable();
/// The folder of programs that cause diagnostics, one for each, which `gliftc explain ID` prints:
/// ../share/glift/diagnostics, seen from the folder of this executable.
std::string diagnostics_beside_executable();

}  // namespace gliftc
