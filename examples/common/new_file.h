// A file that replaces an old one only when it is whole.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

/// A file that is written beside `path` under a name that no other file has; take_name() gives it the name `path`.
/// Whatever happens before that, `path` is what it was. The destructor deletes a file that has not taken its name;
/// where the program is killed, it is left behind. The constructor and the other members throw std::runtime_error,
/// which names `path` and what is wrong.
class NewFile {
public:
    /// If `path` is a link to a file, that file is replaced, and the link stays; what is no ordinary file (a folder, a
    /// device) is refused.
    explicit NewFile(std::string path);
    ~NewFile();
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span(text))); }
    /// Gives the file its name, in place of an old file. Its contents are on the disk before that.
    void take_name();

private:
    [[noreturn]] void fail(const char* what) const;

    std::string path_, target_, name_;  ///< as it was given; where links lead; the temporary name
    int file_ = -1;
};
