// Expectations written into a .glift file, and diagnostics read from what gliftc printed, in one form.
#pragma once

#include <string>
#include <vector>

namespace glift::test {

struct Report {
    std::string file;  ///< name without folder; empty: no place
    int line = 0;
    int first_column = 0;
    int last_column = 0;
    std::string severity;  ///< error, warning, note
    std::string text;
    std::string id;  ///< empty for a note

    auto operator<=>(const Report&) const = default;
};

std::string to_string(const Report& report);

/// The `//~` comments of a file named `file`.
std::vector<Report> read_expectations(const std::string& file, const std::string& text);

/// The diagnostics in gliftc's text format.
std::vector<Report> read_diagnostics(const std::string& printed);

/// The words after "// gliftc:" on the first line.
std::vector<std::string> extra_arguments(const std::string& text);

}  // namespace glift::test
