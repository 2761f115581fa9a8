#include "lsp/features.h"
#include "lsp/positions.h"
#include "syntax/format.h"

#include <algorithm>

namespace gliftc::lsp {

namespace {

/// One edit that makes `before` into `after`: it replaces the lines that differ, from the first to the last.
nlohmann::json edit_between(std::string_view before, std::string_view after) {
    const std::size_t most = std::min(before.size(), after.size());
    std::size_t begin = 0;
    while (begin < most && before[begin] == after[begin]) ++begin;
    while (begin > 0 && before[begin - 1] != '\n') --begin;
    std::size_t same_end = 0;
    while (same_end < most - begin && before[before.size() - 1 - same_end] == after[after.size() - 1 - same_end])
        ++same_end;
    // Back to a line's beginning, so that no character of several bytes is cut.
    while (same_end > 0 && before[before.size() - same_end - 1] != '\n') --same_end;
    const std::string_view inserted = after.substr(begin, after.size() - same_end - begin);
    return {{"range", range_of(before, begin, before.size() - same_end)}, {"newText", inserted}};
}

}  // namespace

nlohmann::json formatting(Workspace& workspace, const nlohmann::json& params) {
    const Analysis& analysis = analysis_in(workspace, params);
    Sources sources;
    Names names;
    Diagnostics errors;
    const std::uint32_t file = sources.add(analysis.compilation.sources[0].path, analysis.text());
    const std::optional<std::string> formatted = format(file, sources, names, errors);
    nlohmann::json edits = nlohmann::json::array();
    if (formatted && *formatted != analysis.text()) edits.push_back(edit_between(analysis.text(), *formatted));
    return edits;
}

}  // namespace gliftc::lsp
