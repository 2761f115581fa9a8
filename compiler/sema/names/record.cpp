#include "sema/names/record.h"

#include "sema/bodies/body.h"
#include "sema/index.h"

namespace gliftc::sema {

namespace {

/// The index, if it takes entries for the span; else null.
Index* index_for(const Context& c, Span span) {
    Index* index = c.settings.index;
    return index != nullptr && span && span.file == index->file ? index : nullptr;
}

/// The span of the function's name in a call; empty if the function is given by another expression.
Span called_name(const Context& c, const ast::Expr& call) {
    if (call.kind != ast::ExprKind::call) return {};
    const ast::Expr& written = c[call.operands[0]];
    const ast::Expr& callee = written.kind == ast::ExprKind::generic ? c[written.operands[0]] : written;
    if (callee.kind == ast::ExprKind::member) return callee.name_span;
    return callee.kind == ast::ExprKind::name ? callee.span : Span{};
}

ir::TypeId type_of_iterator(Body& body, const Operand& operand) {
    const ir::TypeId whole = body.types().of_structure(operand.structure);
    if (body.kernel == nullptr || body.kernel->params[operand.slot].pattern == ir::Pattern::near) return whole;
    if (body.kernel->params[operand.slot].pattern == ir::Pattern::at)
        return body.program().structures[operand.structure].domain_type;
    return body.program().structures[operand.structure].element;
}

}  // namespace

void record_use(const Context& c, Span name, Span declared) {
    if (Index* index = index_for(c, name); index != nullptr && declared) index->uses.push_back({name, declared, false});
}

void record_uses(const Context& c, Span name, const std::vector<ast::DeclId>& declared) {
    if (index_for(c, name) == nullptr) return;
    for (ast::DeclId decl : declared) record_use(c, name, c[decl].name.span);
}

void record_choice(const Context& c, const ast::Expr& call, ast::DeclId chosen) {
    const Span name = called_name(c, call);
    if (Index* index = index_for(c, name)) index->uses.push_back({name, c[chosen].name.span, true});
}

void record_field(const Context& c, Span name, ir::StructId owner, std::size_t index) {
    const auto decl = c.struct_decl.find(owner);
    if (index_for(c, name) == nullptr || decl == c.struct_decl.end()) return;
    record_use(c, name, std::get<ast::Struct>(c[decl->second].body).fields[index].name.span);
}

void record_enumerator(const Context& c, Span name, const ir::Enum& owner, std::size_t index) {
    const auto& names = c.scopes[owner.module].names;
    const auto found = names.find(owner.name);
    if (index_for(c, name) == nullptr || found == names.end()) return;
    if (const auto* written = std::get_if<ast::Enum>(&c[found->second[0]].body))
        record_use(c, name, written->enumerators[index].name.span);
}

void record_component(const Context& c, ir::StructureId whole, ast::Identifier field) {
    const ir::Type& element = c.program.types[c.program.structures[whole].element];
    if (element.kind != ir::TypeKind::struct_) return;
    const auto& fields = c.program.structs[element.struct_].fields;
    for (std::size_t i = 0; i < fields.size(); ++i)
        if (fields[i].name == field.name) record_field(c, field.span, element.struct_, i);
}

void record_type(const Context& c, Span span, ir::TypeId type) {
    if (Index* index = index_for(c, span); index != nullptr && type != ir::TypeId{} && type != c.program.types.error)
        index->types.push_back({span, type, {}});
}

void record_operand(Body& body, const ast::Expr& expr, const Operand& operand) {
    Index* index = index_for(body.context, expr.span);
    if (index == nullptr) return;
    switch (operand.kind) {
    case OperandKind::error:
    case OperandKind::memory: break;
    case OperandKind::value: record_type(body.context, expr.span, operand.type); break;
    case OperandKind::iterator: record_type(body.context, expr.span, type_of_iterator(body, operand)); break;
    case OperandKind::structure: {
        const ir::TypeId type = operand.is_slice ? operand.type : body.types().of_structure(operand.structure);
        record_type(body.context, expr.span, type);
        break;
    }
    case OperandKind::meta:
        if (operand.meta.kind == MetaKind::type) record_type(body.context, expr.span, operand.meta.type);
        if (operand.meta.kind == MetaKind::module) index->types.push_back({expr.span, {}, operand.meta.module});
        break;
    }
}

}  // namespace gliftc::sema
