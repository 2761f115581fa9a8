// Reads and assignments of a kernel's iterator parameters, whose names mean the current element (each, instance,
// target), the window around it (near) or its address (at). Also writes by address, `s[a] = x`, of scatter and coherent
// structures in kernels and functions.
#include "sema/bodies/body.h"
#include "sema/kernels/raster.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

ir::ExprId element_of(Body& body, std::uint32_t param, Span span) {
    ir::ExprId id = add(body.program(), ir::Op::element,
                        body.program().structures[body.kernel->params[param].structure].element, span);
    body.program().exprs[id].place.root = param;
    return id;
}

void emit_set_element(Body& body, std::uint32_t param, ir::ExprId value, Span span) {
    ir::StmtId id = add(body.program(), ir::StmtOp::set_element, span);
    body.program().stmts[id].place.root = param;
    body.program().stmts[id].value = value;
    emit(body, id);
}

ir::ExprId combined(Body& body, const ast::Stmt& stmt, ir::ExprId before) {
    ir::TypeId type = body.program().exprs[before].type;
    return stmt.op ? check_compound(body, stmt, before) : check_value(body, stmt.value, type);
}

void assign_element(Body& body, const ast::Stmt& stmt, const Symbol& symbol) {
    const ir::KernelParam& param = body.kernel->params[symbol.slot];
    if (stmt.op && param.direction == ir::Direction::out) {
        note(body.context.error(Diag::out_read, stmt.span, {body.context.text(param.name)}), param.span,
             "keep the value in a 'var' and assign it once, or declare 'inout', which reads the stored value");
        return;
    }
    ir::ExprId value = combined(body, stmt, element_of(body, symbol.slot, stmt.span));
    if (!is_error(body, value)) emit_set_element(body, symbol.slot, value, stmt.span);
}

/// `g.x = v`, where g is an element that is 'out', and x a field, or a field of a field: writes that alone. False: it
/// is something else.
bool assign_field(Body& body, const ast::Stmt& stmt, Symbol& symbol, ast::ExprId root) {
    Context& c = body.context;
    const ir::KernelParam& param = body.kernel->params[symbol.slot];
    if (param.direction != ir::Direction::out || stmt.op) return false;
    std::vector<ast::ExprId> steps;
    for (ast::ExprId at = stmt.target; at != root; at = c[at].operands[0]) steps.insert(steps.begin(), at);
    ir::TypeId type = c.program.structures[param.structure].element;
    std::vector<std::uint32_t> path;
    for (ast::ExprId step : steps) {
        if (c[step].kind != ast::ExprKind::member || c.types().kind(type) != ir::TypeKind::struct_) return false;
        const std::vector<ir::StructField>& fields = c.program.structs[c.types()[type].struct_].fields;
        const auto field = std::ranges::find(fields, c[step].name, &ir::StructField::name);
        if (field == fields.end()) return false;
        path.push_back(static_cast<std::uint32_t>(field - fields.begin()));
        type = field->type;
    }
    const ir::ExprId value = check_value(body, stmt.value, type);
    if (is_error(body, value)) return true;
    emit_set_element(body, symbol.slot, value, stmt.span);
    c.program.stmts[body.block->back()].path = std::move(path);
    return true;
}

/// `g.x = v` and `g[i] = v`, where g is the current element: reads it, modifies the copy, writes it back.
void assign_part(Body& body, const ast::Stmt& stmt, Symbol& symbol, ast::ExprId root) {
    const ir::KernelParam& param = body.kernel->params[symbol.slot];
    if (assign_field(body, stmt, symbol, root)) return;
    if (param.direction != ir::Direction::inout) {
        note(body.context.error(Diag::out_read, stmt.span, {body.context.text(param.name)}), param.span,
             "'inout' reads and writes; of what is 'out', '=' may give fields of structs their values");
        return;
    }
    ir::LocalId copy =
        emit_temporary(body, body.context.text(param.name), element_of(body, symbol.slot, stmt.span), stmt.span);
    body.program().locals[copy].is_mutable = true;
    open_scope(body);
    Symbol local;
    local.kind = SymbolKind::local;
    local.local = copy;
    local.type = body.program().locals[copy].type;
    declare(body, {body.context[root].name, stmt.span}, local);
    ir::ExprId target = check_value(body, stmt.target);
    ir::ExprId value = is_error(body, target) ? target : combined(body, stmt, target);
    close_scope(body);
    if (is_error(body, value)) return;
    ir::StmtId assign = add(body.program(), ir::StmtOp::assign, stmt.span);
    body.program().stmts[assign].target = target;
    body.program().stmts[assign].value = value;
    emit(body, assign);
    emit_set_element(body, symbol.slot, make_local(body.program(), copy, stmt.span), stmt.span);
}

/// What to write in place of `name[address] op= value`.
std::string instead_of_compound(ast::BinaryOp op, ir::Combine declared) {
    if (declared != ir::Combine::replace) return "the parameter's own operation combines: write '='";
    const auto declare = [&](const char* word) {
        return std::string("declare it 'scatter<…, ") + word + ">', which combines, and write '='";
    };
    if (op == ast::BinaryOp::add) return declare("add");
    if (op == ast::BinaryOp::subtract) return declare("add") + " and the negative value";
    if (op == ast::BinaryOp::bit_and) return declare("and");
    if (op == ast::BinaryOp::bit_or) return declare("or");
    if (op == ast::BinaryOp::bit_xor) return declare("xor");
    return "scatter only writes; 'scatter<…, add>' combines, also by 'min', 'max', 'and', 'or', 'xor'";
}

void write_scatter(Body& body, const ast::Stmt& stmt, const Symbol& symbol) {
    Context& c = body.context;
    const ir::Structure structure = body.program().structures[symbol.structure];
    const ast::Expr& target = c[stmt.target];
    if (target.kind != ast::ExprKind::index || c[target.operands[0]].kind != ast::ExprKind::name) {
        note(c.error(Diag::not_assignable, target.span), symbol.writing.span,
             "a scatter parameter is written as name[address] = value");
        return;
    }
    if (target.operands.size() != 2) {
        c.error(Diag::index_count, target.span, {std::to_string(target.operands.size() - 1)});
        return;
    }
    if (stmt.op) {
        note(c.error(Diag::scatter_read, stmt.span, {c.text(c[target.operands[0]].name)}), symbol.writing.span,
             instead_of_compound(*stmt.op, symbol.writing.combine));
        return;
    }
    ir::ExprId address = check_value(body, target.operands[1], structure.domain_type);
    ir::ExprId value = check_value(body, stmt.value, structure.element);
    if (is_error(body, address) || is_error(body, value)) return;
    ir::StmtId id = add(body.program(), ir::StmtOp::write, stmt.span);
    ir::Stmt& write = body.program().stmts[id];
    write.place = symbol.place;
    write.target = address;
    write.value = value;
    write.combine = symbol.writing.combine;
    emit(body, id);
}

void write_coherent(Body& body, const ast::Stmt& stmt, const Symbol& symbol) {
    Context& c = body.context;
    const ir::Structure structure = body.program().structures[symbol.structure];
    const ast::Expr& target = c[stmt.target];
    if (target.kind != ast::ExprKind::index || c[target.operands[0]].kind != ast::ExprKind::name) {
        note(c.error(Diag::not_assignable, target.span), symbol.span,
             "elements of coherent memory are written whole: name[address] = value");
        return;
    }
    const std::string& name = c.text(c[target.operands[0]].name);
    if (target.operands.size() != 2) {
        c.error(Diag::index_count, target.span, {std::to_string(target.operands.size() - 1)});
        return;
    }
    if (stmt.op) {
        note(c.error(Diag::coherent_compound, stmt.span, {name}), stmt.span,
             "atomicAdd(" + name + "[address], x) and the other atomics do both at once");
        return;
    }
    ir::ExprId address = check_value(body, target.operands[1], structure.domain_type);
    ir::ExprId value = check_value(body, stmt.value, structure.element);
    if (is_error(body, address) || is_error(body, value)) return;
    ir::StmtId id = add(body.program(), ir::StmtOp::write, stmt.span);
    ir::Stmt& write = body.program().stmts[id];
    write.place = symbol.place;
    write.target = address;
    write.value = value;
    emit(body, id);
}

}  // namespace

Operand iterator_value(Body& body, const Operand& iterator) {
    Context& c = body.context;
    const ir::KernelParam& param = body.kernel->params[iterator.slot];
    const std::string& name = c.text(param.name);
    if (body.kernel->raster && !is_in_part(body, part_of(param.pattern), name, iterator.span))
        return error_operand(iterator.span);
    switch (param.pattern) {
    case ir::Pattern::instance:
    case ir::Pattern::each:
        if (param.direction == ir::Direction::out) {
            note(c.error(Diag::out_read, iterator.span, {name}), param.span,
                 "keep the value in a 'var' and assign it once, or declare 'inout', which reads the stored value");
            return error_operand(iterator.span);
        }
        return value_operand(body, element_of(body, iterator.slot, iterator.span), iterator.span);
    case ir::Pattern::at: {
        ir::ExprId id =
            add(body.program(), ir::Op::address, body.program().structures[param.structure].domain_type, iterator.span);
        body.program().exprs[id].place.root = iterator.slot;
        return value_operand(body, id, iterator.span);
    }
    case ir::Pattern::near:
        note(c.error(Diag::not_a_value, iterator.span, {"the iterator '" + name + "'"}), iterator.span,
             "the current element is " + name + "[0]");
        return error_operand(iterator.span);
    case ir::Pattern::target:
        note(c.error(Diag::target_read, iterator.span, {name}), param.span,
             "what is there already is blended or tested with what is drawn: inout target<S, over>");
        return error_operand(iterator.span);
    case ir::Pattern::scatter:
    case ir::Pattern::any:
    case ir::Pattern::coherent:
    case ir::Pattern::argument:
    case ir::Pattern::calls:
    case ir::Pattern::value: c.error(Diag::not_a_value, iterator.span, {"the iterator '" + name + "'"}); break;
    }
    return error_operand(iterator.span);
}

bool check_iterator_assignment(Body& body, const ast::Stmt& stmt) {
    Context& c = body.context;
    ast::ExprId root = stmt.target;
    while (c[root].kind == ast::ExprKind::member || c[root].kind == ast::ExprKind::index) root = c[root].operands[0];
    if (c[root].kind != ast::ExprKind::name) return false;
    Symbol* symbol = find_symbol(body, c[root].name);
    if (!symbol) return false;
    bool is_read_place = symbol->kind == SymbolKind::structure;
    if (symbol->kind != SymbolKind::iterator && !is_read_place) return false;
    symbol->used = true;
    if (is_read_place && symbol->writing.is(ir::Pattern::coherent)) {
        write_coherent(body, stmt, *symbol);
        return true;
    }
    if (is_read_place && symbol->writing.is(ir::Pattern::scatter)) {
        write_scatter(body, stmt, *symbol);
        return true;
    }
    const ir::KernelParam* param = symbol->kind == SymbolKind::iterator ? &body.kernel->params[symbol->slot] : nullptr;
    if (param && param->pattern == ir::Pattern::target) {
        assign_target(body, stmt, *symbol, root);
        return true;
    }
    bool writable = param && param->direction != ir::Direction::in && param->pattern != ir::Pattern::near &&
                    param->pattern != ir::Pattern::at && param->pattern != ir::Pattern::instance;
    if (!writable) {
        Diagnostic& diagnostic = c.error(Diag::in_written, c[stmt.target].span, {c.text(c[root].name)});
        if (param) note(diagnostic, param->span, "declared 'in' here");
        else if (symbol->writing.is(ir::Pattern::calls))
            note(diagnostic, symbol->writing.span, "functions that write are called through it");
        else if (body.container && !symbol->place.members.empty() && !body.kernel)
            note(diagnostic, c[root].span,
                 "a function says which members it writes, and how: 'with scatter<" + c.text(c[root].name) +
                     ">' or 'with coherent<" + c.text(c[root].name) + ">'");
        return true;
    }
    if (root == stmt.target) assign_element(body, stmt, *symbol);
    else assign_part(body, stmt, *symbol, root);
    return true;
}

}  // namespace gliftc::sema
