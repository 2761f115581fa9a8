#include "lsp/builtins.h"
#include "lsp/features.h"
#include "lsp/members.h"
#include "lsp/names.h"
#include "lsp/probes.h"

#include <algorithm>

namespace gliftc::lsp {

namespace {

/// A call around an offset: the token of the callee's name, and which argument the offset is in.
struct OpenCall {
    std::size_t callee = 0;  ///< index of the token
    std::size_t argument = 0;
};

/// The index of the token before the generic arguments that end at token `close`, `close` itself if there are none.
std::size_t before_generics(const std::vector<Token>& tokens, std::size_t close) {
    using enum TokenKind;
    int depth = 0;
    for (std::size_t i = close; i > 0; --i) {
        const TokenKind kind = tokens[i].kind;
        if (kind == greater) ++depth;
        if (kind == greater_greater) depth += 2;
        if (kind == less) --depth;
        if (depth <= 0) return depth == 0 && kind == less ? i - 1 : close;
        if (kind == semicolon || kind == close_brace) break;
    }
    return close;
}

std::optional<OpenCall> open_call(const Analysis& analysis, std::size_t offset) {
    using enum TokenKind;
    const std::vector<Token>& tokens = analysis.tokens.tokens;
    const auto after = std::ranges::lower_bound(tokens, offset, {}, &Token::begin);
    std::size_t commas = 0;
    int depth = 0;
    for (auto i = static_cast<std::size_t>(after - tokens.begin()); i-- > 0;) {
        const TokenKind kind = tokens[i].kind;
        if (kind == close_paren || kind == close_bracket || kind == close_brace) ++depth;
        if (kind == comma && depth == 0) ++commas;
        if (kind == semicolon && depth == 0) return std::nullopt;
        if (kind != open_paren && kind != open_bracket && kind != open_brace) continue;
        if (depth-- > 0) continue;
        if (kind != open_paren || i == 0) return std::nullopt;
        const std::size_t callee = before_generics(tokens, i - 1);
        if (!is_name(tokens[callee])) return std::nullopt;
        return OpenCall{callee, commas};
    }
    return std::nullopt;
}

nlohmann::json signature(const std::string& label, const std::vector<std::string>& parameters, const std::string& doc) {
    nlohmann::json list = nlohmann::json::array();
    for (const std::string& parameter : parameters) list.push_back({{"label", parameter}});
    nlohmann::json made = {{"label", label}, {"parameters", std::move(list)}};
    if (!doc.empty()) made["documentation"] = {{"kind", "markdown"}, {"value", doc}};
    return made;
}

/// The entities that a call may mean: what the name denotes or, behind a dot, the members of that name.
std::vector<const Entity*> callees(const Analysis& analysis, const Token& name) {
    std::vector<const Entity*> found;
    for (Span declared : declarations_of(analysis, name))
        if (const Entity* entity = analysis.entity_at(declared)) found.push_back(entity);
    const std::size_t dot = last_before(analysis.text(), name.begin);
    if (!found.empty() || dot == std::string::npos || analysis.text()[dot] != '.') return found;
    const std::size_t end = last_before(analysis.text(), dot);
    if (end == std::string::npos) return found;
    for (const Suggestion& member : members_before(analysis, end + 1))
        if (member.entity != nullptr && member.name == analysis.text(name)) found.push_back(member.entity);
    return found;
}

nlohmann::json signature_of(const Analysis& analysis, const Entity& entity) {
    const Sources& sources = analysis.compilation.sources;
    std::vector<std::string> parameters;
    for (const Entity* part : parts_of(analysis, entity)) {
        const bool is_parameter = part->kind == EntityKind::parameter ||
                                  (part->kind == EntityKind::field && entity.kind == EntityKind::struct_);
        if (is_parameter) parameters.push_back(header_of(*part, sources[part->name.span.file].text));
    }
    std::string label = header_of(entity, sources[entity.name.span.file].text);
    if (entity.kind == EntityKind::struct_) {
        label += "(";
        for (std::size_t i = 0; i < parameters.size(); ++i) label += (i ? ", " : "") + parameters[i];
        label += ")";
    }
    return signature(label, parameters, entity.doc);
}

}  // namespace

nlohmann::json signature_help(Workspace& workspace, const nlohmann::json& params) {
    const Place place = place_in(workspace, params);
    const std::optional<OpenCall> written = open_call(place.analysis, place.offset);
    if (!written) return nullptr;
    // With a name at the cursor the call is complete enough to be checked.
    const auto probed =
        probe(workspace, place.path, place.analysis.text(), name_before(place.analysis.text(), place.offset));
    const Token& name = probed->tokens.tokens[written->callee];
    nlohmann::json signatures = nlohmann::json::array();
    for (const Entity* entity : callees(*probed, name))
        if (is_callable(entity->kind)) signatures.push_back(signature_of(*probed, *entity));
    if (signatures.empty())
        if (const BuiltinFunction* function = find_builtin_function(probed->text(name)))
            signatures.push_back(signature(function->signature(), function->parameters, {}));
    if (signatures.empty()) return nullptr;
    std::size_t active = 0;
    while (active + 1 < signatures.size() && signatures[active]["parameters"].size() <= written->argument) ++active;
    return {{"signatures", std::move(signatures)}, {"activeSignature", active}, {"activeParameter", written->argument}};
}

}  // namespace gliftc::lsp
