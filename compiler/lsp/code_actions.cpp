#include "lsp/features.h"
#include "lsp/fixes.h"
#include "lsp/imports.h"
#include "lsp/positions.h"
#include "lsp/protocol.h"

#include <algorithm>

namespace gliftc::lsp {

namespace {

/// The edits of the fix, by URI; absent if there is nothing to change.
std::optional<nlohmann::json> changes_of(const Workspace& workspace, const Analysis& analysis, const Fix& fix) {
    nlohmann::json changes;
    if (!fix.import.empty()) {
        const auto edit = import_edit(analysis, fix.import);
        if (!edit) return std::nullopt;
        changes[uri_of(workspace, analysis, 0)] = nlohmann::json::array({*edit});
        return changes;
    }
    const nlohmann::json edit = {{"range", range_of(analysis.compilation.sources, fix.replaced)},
                                 {"newText", fix.text}};
    changes[uri_of(workspace, analysis, fix.replaced.file)] = nlohmann::json::array({edit});
    return changes;
}

/// Whether the diagnostic lies in the document and touches the range of bytes.
bool touches(const Diagnostic& diagnostic, std::size_t begin, std::size_t end) {
    const Span span = diagnostic.span;
    return span && span.file == 0 && span.begin <= end && begin <= span.end;
}

}  // namespace

nlohmann::json code_actions(Workspace& workspace, const nlohmann::json& params) {
    const nlohmann::json& range = member(params, "range");
    const TextPosition start = read_position(member(range, "start")), stop = read_position(member(range, "end"));
    const Analysis& analysis = analysis_in(workspace, params);
    const std::size_t begin = offset_of(analysis.text(), start), end = offset_of(analysis.text(), stop);
    nlohmann::json actions = nlohmann::json::array();
    for (const Diagnostic& diagnostic : analysis.compilation.diagnostics.all()) {
        if (!touches(diagnostic, begin, end)) continue;
        for (const Fix& fix : fixes_of(analysis, diagnostic))
            if (const auto changes = changes_of(workspace, analysis, fix))
                actions.push_back({{"title", fix.title},
                                   {"kind", "quickfix"},
                                   {"isPreferred", true},
                                   {"edit", {{"changes", *changes}}}});
    }
    return actions;
}

}  // namespace gliftc::lsp
