// Diagnostics in one form: those that comments of a .glift file expect, and those read from the output of gliftc.
#pragma once

#include <string>
#include <vector>

namespace glift::test {

struct Report {
    std::string file;  ///< name without folder; empty for a diagnostic without a location
    int line = 0;
    int first_column = 0;
    int last_column = 0;
    std::string severity;  ///< error, warning, note
    std::string text;
    std::string id;  ///< empty for a note

    auto operator<=>(const Report&) const = default;
};

std::string to_string(const Report& report);

/// The diagnostics that the `//~` comments of a file expect; `file` is its name.
std::vector<Report> read_expectations(const std::string& file, const std::string& text);

/// The diagnostics in gliftc's text format.
std::vector<Report> read_diagnostics(const std::string& printed);

/// The arguments after "// gliftc:" on the first line; none if the text does not begin with that.
std::vector<std::string> extra_arguments(const std::string& text);

}  // namespace glift::test
