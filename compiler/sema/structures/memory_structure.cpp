#include "sema/structures/memory_structure.h"

#include "ir/chain.h"
#include "sema/structures/components.h"
#include "sema/types/meta.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

/// Whether a name denotes a symbol in scope, a type, or a declaration of a structure or alias.
bool names_structure(Body& body, ast::Identifier name) {
    if (find_symbol(body, name.name)) return true;
    const Context& c = body.context;
    const Meta meta = find_meta(body.context, body.env, name);
    if (meta.kind == MetaKind::type) return true;
    if (meta.kind != MetaKind::declarations) return false;
    const auto& decl = c[meta.declarations[0]].body;
    return std::holds_alternative<ast::Structure>(decl) || std::holds_alternative<ast::Alias>(decl);
}

/// Makes the structure `base`, at `place`, the memory of structure `index`, under the name that the item gives.
void set_base(Body& body, ir::StructureId index, const ast::Item& item, const ir::Place& place, ir::StructureId base) {
    Context& c = body.context;
    const ir::Structure& memory = c.program.structures[base];
    if (memory.kind == ir::StructureKind::no_elements) {
        note(c.error(Diag::memory_form, c[item.value].span), c[item.value].span,
             memory.display + " has no elements: name one of its members");
        return;
    }
    if (item.mips || item.filter || item.compare)
        note(c.error(Diag::memory_of_structure, item.span), c[item.value].span,
             "they stand where the image itself is declared, in " + memory.display);
    ir::Structure& structure = c.program.structures[index];
    structure.base = place.members;
    structure.base_name = item.name.name;
    structure.base_span = item.name.span;
}

/// Whether one path of members begins with the other: one of the two structures contains the other, or both are the
/// same.
bool is_within(const ir::Place& one, const std::vector<std::uint32_t>& other) {
    const auto [a, b] = std::mismatch(one.members.begin(), one.members.end(), other.begin(), other.end());
    return a == one.members.end() || b == other.end();
}

}  // namespace

bool has_memory(Body& body, ir::StructureId index, const ast::Item& another) {
    const ir::Structure& structure = body.program().structures[index];
    if (structure.memories.empty() && structure.base.empty()) return false;
    const Span first = structure.base.empty() ? structure.memories[0].span : structure.base_span;
    Diagnostic& diagnostic = body.context.error(Diag::two_memories, another.name.span, {structure.display});
    note(diagnostic, first, "the first one is declared here");
    note(diagnostic, another.name.span,
         "what translators read is a structure of its own: structure " + body.context.text(another.name.name) + " = …");
    return true;
}

bool is_structure_memory(Body& body, ast::ExprId id) {
    const Context& c = body.context;
    const ast::Expr& expr = c[id];
    if (expr.kind == ast::ExprKind::member) return true;
    if (expr.kind == ast::ExprKind::name) return names_structure(body, {expr.name, expr.span});
    if (expr.kind != ast::ExprKind::call) return false;
    const ast::Expr& callee = c[expr.operands[0]];
    const ast::Expr& name = callee.kind == ast::ExprKind::generic ? c[callee.operands[0]] : callee;
    if (name.kind == ast::ExprKind::member) return true;
    return name.kind == ast::ExprKind::name && names_structure(body, {name.name, name.span});
}

void add_base(Body& body, ir::StructureId index, const ast::Item& item) {
    Context& c = body.context;
    if (c[item.value].kind == ast::ExprKind::call) {
        if (!add_member(body, index, item)) return;
        const auto member = static_cast<std::uint32_t>(c.program.structures[index].members.size() - 1);
        return set_base(body, index, item, {0, {member}}, c.program.structures[index].members[member].structure);
    }
    const Operand named = check(body, item.value);
    if (named.kind == OperandKind::error) return;
    if (named.kind != OperandKind::structure || named.place.members.empty()) {
        note(c.error(Diag::memory_form, c[item.value].span), c[item.value].span,
             "write buffer<T>[n], an image, a structure with its arguments, or the name of a structure");
        return;
    }
    set_base(body, index, item, named.place, named.structure);
    declare_base(body, index);
}

void declare_base(Body& body, ir::StructureId index) {
    const ir::Structure structure = body.program().structures[index];
    if (structure.base.empty()) return;
    if (structure.base.size() == 1 && structure.members[structure.base[0]].name == structure.base_name) return;
    Symbol symbol;
    symbol.kind = SymbolKind::structure;
    symbol.place.members = structure.base;
    const ir::Program& program = body.program();
    symbol.structure = program.structures.id_of(ir::structure_at(program, program.structures[index], structure.base));
    declare(body, {structure.base_name, structure.base_span}, symbol);
}

ir::ExprId domain_of_base(Body& body, ir::StructureId index) {
    const ir::Structure& structure = body.program().structures[index];
    Operand base;
    base.kind = OperandKind::structure;
    base.place.members = structure.base;
    const Span span = structure.base_span;
    return structure_operation(body, ir::Op::domain, ir::physical_type(body.program(), structure), base, span);
}

bool check_own_memory(Context& c, ir::StructureId index) {
    const ir::Structure& structure = c.program.structures[index];
    if (structure.base.empty()) return true;
    for (const ir::Stage& stage : structure.via) {
        const bool reads_it = std::ranges::any_of(
            stage.structures, [&](const ir::Place& place) { return is_within(place, structure.base); });
        if (!reads_it) continue;
        const ir::Translator& translator = c.program.translators[stage.translator];
        Diagnostic& diagnostic =
            c.error(Diag::memory_translates, structure.base_span, {c.text(structure.base_name), structure.display});
        note(diagnostic, translator.span, translator.display + " reads it");
        note(diagnostic, structure.base_span, "keep what translates in a structure of its own, beside the elements");
        return false;
    }
    return true;
}

}  // namespace gliftc::sema
