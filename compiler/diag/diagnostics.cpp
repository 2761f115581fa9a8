#include "diag/diagnostics.h"

#include <algorithm>
#include <iterator>

namespace gliftc {

namespace {

struct Entry {
    Severity severity;
    std::string_view name;
    std::string_view text;
};

using enum Severity;
constexpr Entry entries[] = {
#define DIAGNOSTIC(name, severity, text) {severity, #name, text},
#include "diag/diagnostics.def"
#undef DIAGNOSTIC
};

/// The ids as shown to users: '-' for '_'.
const std::vector<std::string>& shown_ids() {
    static const std::vector<std::string> ids = [] {
        std::vector<std::string> made;
        for (const Entry& entry : entries) {
            std::string id(entry.name);
            std::replace(id.begin(), id.end(), '_', '-');
            made.push_back(std::move(id));
        }
        return made;
    }();
    return ids;
}

const Entry& entry_of(Diag id) { return entries[static_cast<std::size_t>(id)]; }

std::string fill(std::string_view text, std::initializer_list<std::string_view> arguments) {
    std::string filled;
    for (std::size_t i = 0; i < text.size(); ++i) {
        bool place =
            text[i] == '{' && i + 2 < text.size() && text[i + 2] == '}' && text[i + 1] >= '0' && text[i + 1] <= '9';
        if (!place) {
            filled += text[i];
            continue;
        }
        auto index = static_cast<std::size_t>(text[i + 1] - '0');
        if (index < arguments.size()) filled += *(arguments.begin() + index);
        i += 2;
    }
    return filled;
}

/// The least number of insertions, deletions, replacements and swaps of neighbours that make one text the other, none
/// of which edits a character twice (restricted Damerau-Levenshtein distance).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), row(b.size() + 1), next(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        next[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            std::size_t replaced = row[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            next[j] = std::min({row[j] + 1, next[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                next[j] = std::min(next[j], before[j - 2] + 1);
        }
        std::swap(before, row);
        std::swap(row, next);
    }
    return row[b.size()];
}

}  // namespace

Severity severity_of(Diag id) { return entry_of(id).severity; }
std::string_view id_of(Diag id) { return shown_ids()[static_cast<std::size_t>(id)]; }
std::string_view text_of(Diag id) { return entry_of(id).text; }

Diagnostic& Diagnostics::report(Diag id, Span span, std::initializer_list<std::string_view> arguments) {
    Severity severity = severity_of(id);
    auto among = [id](const std::vector<Diag>& ids) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
    if (severity == Severity::warning && among(silenced)) {
        dropped_ = {};
        return dropped_;
    }
    if (severity == Severity::warning && (warnings_are_errors || among(promoted))) severity = Severity::error;
    return keep({id, severity, span, fill(text_of(id), arguments), {}});
}

/// Whether the diagnostic is an error, and not a warning that -Werror made one.
static bool is_own_error(const Diagnostic& one) { return severity_of(one.id) == Severity::error; }

Diagnostic& Diagnostics::keep(Diagnostic&& made) {
    // Compared with the latest 100 only: a duplicate comes soon after the first, and thousands of warnings must not
    // take quadratic time.
    auto latest = all_.size() > 100 ? all_.end() - 100 : all_.begin();
    bool repeated = std::any_of(latest, all_.end(), [&](const Diagnostic& earlier) {
        bool same_place = made.span && earlier.span == made.span;
        return same_place && (earlier.id == made.id || (is_own_error(earlier) && is_own_error(made)));
    });
    if (!repeated && is_own_error(made)) ++own_errors_;
    if (repeated || (made.severity == Severity::error && at_limit())) {
        dropped_ = {};
        return dropped_;
    }
    if (made.severity == Severity::error) ++errors_;
    return all_.emplace_back(std::move(made));
}

void Diagnostics::append(Diagnostics&& others) {
    const auto kept = static_cast<std::size_t>(std::ranges::count_if(others.all_, is_own_error));
    own_errors_ += others.own_errors_ - kept;  // those that were dropped because of the limit
    for (Diagnostic& one : others.all_) keep(std::move(one));
}

Diagnostics Diagnostics::emptied() const {
    Diagnostics made = *this;
    made.all_.clear();
    made.errors_ = made.own_errors_ = 0;
    return made;
}

std::optional<Diag> find_diagnostic(std::string_view id) {
    const auto& ids = shown_ids();
    auto found = std::find(ids.begin(), ids.end(), id);
    if (found == ids.end()) return std::nullopt;
    return static_cast<Diag>(found - ids.begin());
}

std::string_view nearest_diagnostic(std::string_view word) {
    const auto& ids = shown_ids();
    return did_you_mean(word, {ids.begin(), ids.end()});
}

std::string_view did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates) {
    std::size_t limit = std::max<std::size_t>(1, name.size() / 3);
    std::string_view best;
    for (std::string_view candidate : candidates) {
        std::size_t difference =
            candidate.size() > name.size() ? candidate.size() - name.size() : name.size() - candidate.size();
        if (difference > limit || candidate == name || candidate.empty()) continue;
        std::size_t distance = edit_distance(name, candidate);
        if (distance > limit || distance >= std::max(name.size(), candidate.size())) continue;
        if (!best.empty() && distance == limit) continue;
        best = candidate;
        limit = distance;
        if (limit == 0) break;
    }
    return best;
}

}  // namespace gliftc
