// Errors and warnings of the compiler: their ids and texts (diagnostics.def), and the collector to which stages report
// them.
#pragma once

#include "source/source.h"

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gliftc {

enum class Severity : std::uint8_t { note, warning, error };

/// One enumerator for each line of diagnostics.def: DIAGNOSTIC(name, severity, "text with {0} {1}"). The id shown to
/// users is the enumerator with '-' for '_': [unknown-name].
enum class Diag : std::uint16_t {
#define DIAGNOSTIC(name, severity, text) name,
#include "diag/diagnostics.def"
#undef DIAGNOSTIC
};

Severity severity_of(Diag id);
std::string_view id_of(Diag id);    ///< "unknown-name"
std::string_view text_of(Diag id);  ///< the text with placeholders {0}, {1} …

struct Note {
    Span span;  ///< may be empty: a note without a location
    std::string text;
};

struct Diagnostic {
    Diag id;
    Severity severity;
    Span span;
    std::string text;
    std::vector<Note> notes;
};

/// Collects diagnostics in the order reported. One mistake gives one error: an error is dropped if one of the latest
/// hundred diagnostics is an error at the same span, neither of them a warning that -Werror made one; and any
/// diagnostic is dropped if one of them has the same id and span. Diagnostics without a location are not compared.
/// Errors beyond the limit are dropped, too.
class Diagnostics {
public:
    /// Reports `id` at `span`. Notes can be added to the diagnostic returned, until the next report.
    Diagnostic& report(Diag id, Span span, std::initializer_list<std::string_view> arguments = {});

    /// Adds the diagnostics of another collector with the same settings.
    void append(Diagnostics&& others);
    /// A state of the collector. back_to() forgets what was reported since mark().
    struct Mark {
        std::size_t count, errors, own_errors;
    };
    Mark mark() const { return {all_.size(), errors_, own_errors_}; }
    void back_to(Mark mark) {
        all_.resize(mark.count);
        errors_ = mark.errors;
        own_errors_ = mark.own_errors;
    }
    /// An empty collector with the same settings.
    Diagnostics emptied() const;

    bool has_errors() const { return errors_ > 0; }
    /// How many errors were reported, without repeated ones and without warnings that -Werror made errors. Errors that
    /// were dropped because of the limit count, too.
    std::size_t own_error_count() const { return own_errors_; }
    bool has_own_errors() const { return own_errors_ > 0; }
    std::size_t error_count() const { return errors_; }
    const std::vector<Diagnostic>& all() const { return all_; }

    bool warnings_are_errors = false;
    std::vector<Diag> silenced;    ///< disabled warnings (-Wno-…)
    std::vector<Diag> promoted;    ///< warnings that are errors (-Werror=…)
    std::size_t error_limit = 50;  ///< errors kept; 0 is no limit
    bool at_limit() const { return error_limit != 0 && errors_ >= error_limit; }

private:
    Diagnostic& keep(Diagnostic&& made);

    std::vector<Diagnostic> all_;
    std::size_t errors_ = 0, own_errors_ = 0;
    Diagnostic dropped_{};
};

/// The diagnostic with this id as users write it, such as "unknown-name"; none if there is no such diagnostic.
std::optional<Diag> find_diagnostic(std::string_view id);

/// The id nearest to a misspelled one; empty if none is near.
std::string_view nearest_diagnostic(std::string_view word);

/// The candidate nearest to `name` by edit distance, other than `name` itself; of equally near ones the first. Empty if
/// none is within a third of the length of `name` (or 1, if that is more). A candidate does not count if its distance
/// is the length of the longer of the two.
std::string_view did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates);

}  // namespace gliftc
