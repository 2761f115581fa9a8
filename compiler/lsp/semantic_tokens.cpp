#include "lsp/builtins.h"
#include "lsp/features.h"
#include "lsp/names.h"
#include "lsp/positions.h"

#include <algorithm>
#include <array>

namespace gliftc::lsp {

namespace {

/// The types of tokens; their numbers in the protocol are their places in `type_names`.
enum class TokenType : std::uint8_t {
    comment,
    keyword,
    string,
    number,
    operator_,
    type,
    enum_member,
    struct_,
    type_parameter,
    parameter,
    variable,
    property,
    function,
    namespace_,
    decorator,
};

constexpr std::array type_names = {"comment",  "keyword",    "string",   "number",        "operator",
                                   "type",     "enumMember", "struct",   "typeParameter", "parameter",
                                   "variable", "property",   "function", "namespace",     "decorator"};

enum Modifier : unsigned { no_modifier = 0, declaration = 1, default_library = 2 };
constexpr std::array modifier_names = {"declaration", "defaultLibrary"};

TokenType type_of(EntityKind kind) {
    switch (kind) {
    case EntityKind::function:
    case EntityKind::kernel:
    case EntityKind::raster:
    case EntityKind::pipeline:
    case EntityKind::test: return TokenType::function;
    case EntityKind::structure:
    case EntityKind::translator:
    case EntityKind::enum_:
    case EntityKind::interface:
    case EntityKind::alias: return TokenType::type;
    case EntityKind::struct_: return TokenType::struct_;
    case EntityKind::constant:
    case EntityKind::variable: return TokenType::variable;
    case EntityKind::field:
    case EntityKind::memory:
    case EntityKind::member:
    case EntityKind::host_state: return TokenType::property;
    case EntityKind::enumerator: return TokenType::enum_member;
    case EntityKind::generic: return TokenType::type_parameter;
    case EntityKind::parameter: return TokenType::parameter;
    }
    return TokenType::variable;
}

struct Coloured {
    std::uint32_t begin = 0, end = 0;
    TokenType type = TokenType::variable;
    unsigned modifiers = no_modifier;
};

/// The colour of a name: by what it denotes; built-in names by their kind. Absent for names of which nothing is known.
std::optional<Coloured> coloured_name(const Analysis& analysis, const Token& token) {
    const std::string_view text = analysis.text(token);
    const std::vector<Span> declared = declarations_of(analysis, token);
    if (!declared.empty()) {
        const Entity* entity = analysis.entity_at(declared.front());
        if (entity == nullptr) return Coloured{token.begin, token.end, TokenType::namespace_};
        const bool is_own = entity->name.span == Span{0, token.begin, token.end};
        return Coloured{token.begin, token.end, type_of(entity->kind), is_own ? declaration : no_modifier};
    }
    if (find_builtin_function(text) != nullptr)
        return Coloured{token.begin, token.end, TokenType::function, default_library};
    if (std::ranges::find(builtin_types(), text) != builtin_types().end())
        return Coloured{token.begin, token.end, TokenType::type, default_library};
    if (token.word != Word::no_word) return Coloured{token.begin, token.end, TokenType::keyword};
    return std::nullopt;
}

std::optional<Coloured> coloured(const Analysis& analysis, const Token& token) {
    using enum TokenKind;
    switch (token.kind) {
    case identifier: return coloured_name(analysis, token);
    case integer:
    case floating:
    case bad_number: return Coloured{token.begin, token.end, TokenType::number};
    case string: return Coloured{token.begin, token.end, TokenType::string};
    case at_sign: return Coloured{token.begin, token.end, TokenType::decorator};
    default:
        if (token.name) return Coloured{token.begin, token.end, TokenType::keyword};
        return std::nullopt;
    }
}

/// Adds the token, line by line if it has several, as differences to the token before it.
void write(const SourceFile& file, const Coloured& token, TextPosition& before, nlohmann::json& data) {
    for (std::size_t begin = token.begin; begin < token.end;) {
        const std::size_t line_end = std::min<std::size_t>(file.text.find('\n', begin), token.end);
        const TextPosition start = position_of(file, begin), end = position_of(file, line_end);
        if (end.character > start.character) {
            data.push_back(start.line - before.line);
            data.push_back(start.line == before.line ? start.character - before.character : start.character);
            data.push_back(end.character - start.character);
            data.push_back(static_cast<int>(token.type));
            data.push_back(token.modifiers);
            before = start;
        }
        begin = line_end + 1;
    }
}

}  // namespace

nlohmann::json semantic_tokens_legend() { return {{"tokenTypes", type_names}, {"tokenModifiers", modifier_names}}; }

nlohmann::json semantic_tokens(Workspace& workspace, const nlohmann::json& params) {
    const Analysis& analysis = analysis_in(workspace, params);
    std::vector<Coloured> all;
    for (const Token& token : analysis.tokens.tokens)
        if (const auto found = coloured(analysis, token)) all.push_back(*found);
    for (const Comment& comment : analysis.tokens.comments)
        all.push_back({comment.begin, comment.end, TokenType::comment});
    std::ranges::sort(all, {}, &Coloured::begin);
    nlohmann::json data = nlohmann::json::array();
    TextPosition before;
    for (const Coloured& token : all) write(analysis.compilation.sources[0], token, before, data);
    return {{"data", std::move(data)}};
}

}  // namespace gliftc::lsp
