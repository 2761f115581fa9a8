// Items in the bodies of structures.
#include "syntax/parser_state.h"

namespace gliftc {

using ast::Item;
using ast::ItemKind;

/// items = "{" { item } "}" ;
std::vector<Item> Parser::parse_items() {
    std::vector<Item> items;
    std::uint32_t open = cursor_;
    if (lost_ || !expect(TokenKind::open_brace)) return items;
    while (!list_ends()) {
        std::uint32_t before = cursor_;
        if (accept(TokenKind::semicolon)) continue;
        std::string doc = doc_before(cursor_);
        Item item = parse_item();
        item.span = since(before);
        item.doc = std::move(doc);
        bool readable = !lost_ || item.value || item.decl;
        if (lost_) recover_in_list();
        if (readable) items.push_back(std::move(item));
        if (cursor_ == before) advance();
    }
    close_list(open);
    return items;
}

Item Parser::new_item(ItemKind kind) const {
    Item item{};
    item.kind = kind;
    return item;
}

/// item = memory | member | via | otherwise | host | condition | method | [ "pub" ] pipeline ;
Item Parser::parse_item() {
    using enum TokenKind;
    Nesting nesting(*this);
    Item item = new_item(ItemKind::function);
    if (!nesting.ok) return item;
    ignore_pub_of_member();
    if (at_word_before_name(Word::memory)) return parse_memory();
    if (at_word_before_name(Word::structure)) return parse_member_item();
    if (at_word_before_name(Word::host)) return parse_host();
    if (at_word_before_name(Word::via)) return parse_value_item(ItemKind::via);
    if (at_word(Word::otherwise)) return parse_value_item(ItemKind::otherwise);
    if (at(kw_if)) return parse_condition();
    if (at_word_before_name(Word::allocator)) {
        fail_reserved("allocators come in a later version");
        return item;
    }
    bool declares = at(kw_fn) || at(kw_pub) || at(at_sign) || at_word_before_name(Word::pipeline);
    if (declares || (at(identifier) && (peek(1).kind == open_paren || peek(1).kind == less)))
        return parse_nested_declaration();
    fail_expected("an item",
                  "items are 'memory', 'structure', 'via', 'otherwise', 'host', 'if', functions and pipelines");
    return item;
}

/// Reports a `pub` before a member, and goes on as if it were not there.
void Parser::ignore_pub_of_member() {
    const Word word = peek(1).word;
    const bool is_member = word == Word::memory || word == Word::structure || word == Word::host;
    if (!at(TokenKind::kw_pub) || !is_member || peek(2).kind != TokenKind::identifier) return;
    advance();
    diagnostics_.report(Diag::expected, here(), {"'fn' or 'pipeline'", shown(peek())})
        .notes.push_back(
            {{}, "members take no 'pub': C++ reaches all of them, as in 'a." + std::string(text_of(peek(1))) + "()'"});
}

/// method | [ "pub" ] pipeline
Item Parser::parse_nested_declaration() {
    bool is_pipeline =
        at_word_before_name(Word::pipeline) ||
        (at(TokenKind::kw_pub) && peek(1).word == Word::pipeline && peek(2).kind == TokenKind::identifier);
    Item item = new_item(is_pipeline ? ItemKind::pipeline : ItemKind::function);
    item.decl = is_pipeline ? parse_declaration() : parse_method();
    if (item.decl) item.name = tree_.decls[item.decl].name;
    return item;
}

/// memory = "memory" name "=" expression { "mips" "(" expression ")" | "filter" name | "compare" name | "apart" "("
/// expression ")" } ";" ; `mips`, `filter`, `compare` and `apart` must not be the first word on their line.
Item Parser::parse_memory() {
    Item item = new_item(ItemKind::memory);
    advance();
    item.name = parse_name("a name");
    expect(TokenKind::equal);
    item.value = lost_ ? error_expr() : parse_expression();
    while (!lost_ && at(TokenKind::identifier) && !peek().first_on_line) {
        const bool is_mips = peek().word == Word::mips;
        if (is_mips || peek().word == Word::apart) {
            advance();
            std::uint32_t open = cursor_;
            expect(TokenKind::open_paren);
            (is_mips ? item.mips : item.apart) = lost_ ? error_expr() : parse_expression();
            expect_close(TokenKind::close_paren, open);
        } else if (accept_word(Word::filter)) {
            auto name = parse_name("'linear' or 'nearest'");
            item.filter = name.name;
            item.filter_span = name.span;
        } else if (accept_word(Word::compare)) {
            auto name = parse_name("a comparison: 'less', 'greater', …");
            item.compare = name.name;
            item.compare_span = name.span;
        } else {
            fail_expected("';', 'mips', 'filter', 'compare' or 'apart'");
        }
    }
    end_statement();
    return item;
}

/// member = "structure" name "=" expression ";" ;
Item Parser::parse_member_item() {
    Item item = new_item(ItemKind::member);
    advance();
    item.name = parse_name("a name");
    expect(TokenKind::equal);
    item.value = lost_ ? error_expr() : parse_expression();
    end_statement();
    return item;
}

/// host = "host" name ":" type "=" expression ";" ;
Item Parser::parse_host() {
    Item item = new_item(ItemKind::host);
    advance();
    item.name = parse_name("a name");
    expect(TokenKind::colon);
    item.type = parse_type();
    expect(TokenKind::equal);
    item.value = lost_ ? error_expr() : parse_expression();
    end_statement();
    return item;
}

/// via = "via" expression ";" ;    otherwise = "otherwise" expression ";" ;
Item Parser::parse_value_item(ItemKind kind) {
    Item item = new_item(kind);
    advance();
    item.value = parse_expression();
    end_statement();
    return item;
}

/// condition = "if" expression items [ "else" ( condition | items ) ] ;
Item Parser::parse_condition() {
    Item item = new_item(ItemKind::condition);
    advance();
    item.value = parse_expression();
    item.body = parse_items();
    if (!lost_ && accept(TokenKind::kw_else)) {
        if (at(TokenKind::kw_if)) {
            std::uint32_t first = cursor_;
            Item nested = parse_item();
            nested.span = since(first);
            item.alternative.push_back(std::move(nested));
        } else {
            item.alternative = parse_items();
        }
    }
    return item;
}

}  // namespace gliftc
