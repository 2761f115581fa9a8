#include "sema/bodies/closures.h"

#include "sema/bodies/free_names.h"
#include "sema/pipelines/values.h"
#include "sema/types/generics.h"
#include "syntax/print.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

/// What the free names of a closure mean where it is written.
struct Meanings {
    std::vector<ast::ExprId> captured;  ///< names of values, each once
    std::vector<std::pair<Name, Meta>> generics;
};

Meanings meanings_of(Body& body, ast::ExprId closure) {
    Meanings meanings;
    for (ast::ExprId id : free_names(body.context, closure)) {
        const Name name = body.context[id].name;
        if (find_symbol(body, name)) meanings.captured.push_back(id);
        else if (const Meta* bound = body.env.find(name)) meanings.generics.emplace_back(name, *bound);
    }
    return meanings;
}

bool is_iterator_value(const Body& body, const Operand& operand) {
    return operand.kind == OperandKind::iterator && body.kernel->params[operand.slot].pattern != ir::Pattern::near;
}

/// The value that a captured name has here; reports a name that has none.
ir::ExprId captured_value(Body& body, ast::ExprId name) {
    Context& c = body.context;
    const Operand operand = check(body, name);
    if (operand.kind == OperandKind::value || operand.kind == OperandKind::error) return to_value(body, operand);
    const std::string text = c.text(c[name].name);
    const bool is_value = is_iterator_value(body, operand);
    const std::string_view kind = operand.kind == OperandKind::iterator ? "an iterator"
                                  : operand.kind == OperandKind::memory ? "a memory"
                                                                        : "a structure";
    note(c.error(Diag::closure_capture, operand.span, {text, kind}), operand.span,
         "write 'let value = " + text + (is_value ? "" : "[a]") + ";' before the call, and use 'value'");
    return error_value(body, operand.span);
}

/// The arguments in the names of a closure type; none outside of generic declarations.
std::string arguments_text(const Body& body, const ir::Struct& record, const Meanings& meanings,
                           std::string (*text_of)(const Context&, const Meta&)) {
    if (body.env.bindings.empty()) return "";
    std::string text;
    const auto append = [&](const Meta& meta) { text += (text.empty() ? "<" : ", ") + text_of(body.context, meta); };
    for (const auto& [name, meta] : meanings.generics) append(meta);
    for (const ir::StructField& field : record.fields) append({.kind = MetaKind::type, .type = field.type});
    return text.empty() ? text : text + ">";
}

/// The type of a closure that captures these values.
ir::StructId type_of_closure(Body& body, ast::ExprId closure, const Meanings& meanings, const ir::Operands& values) {
    Context& c = body.context;
    Env& env = c.new_env(body.env.module);
    env.bindings = meanings.generics;
    const ast::DeclId decl = c[closure].decl;
    std::string key = std::to_string(env.module.index) + print(closure, c.tree, c.names) + key_of(c, {}, env);
    ir::Struct record;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const ir::TypeId type = c.program.exprs[values[i]].type;
        record.fields.push_back({c[meanings.captured[i]].name, type, {}});
        key += ":" + std::to_string(type.index);
    }
    if (const auto known = c.closure_types.find(key); known != c.closure_types.end()) return known->second;
    record.name = c[decl].name.name;
    record.display = c.text(record.name) + arguments_text(body, record, meanings, to_text);
    record.key = ir::module_text(c.program, env.module) + c.text(record.name) +
                 arguments_text(body, record, meanings, to_qualified_text);
    record.module = env.module;
    record.span = c[closure].span;
    const ir::StructId index = c.program.structs.add(std::move(record));
    c.closures[index] = {.written = decl, .env = &env, .calls = {}};
    c.closure_types.emplace(std::move(key), index);
    return index;
}

ast::ExprId known_type(Context& c, ir::TypeId type, Span span) {
    ast::Expr expr;
    expr.kind = ast::ExprKind::known_type;
    expr.value = type.index;
    expr.span = span;
    return c.tree.exprs.add(std::move(expr));
}

/// The declaration of a function that has the closure's body.
ast::DeclId call_declaration(Context& c, const ClosureType& closure, const std::vector<ir::TypeId>& types) {
    const ast::Decl& written = c[closure.written];
    const auto& body = std::get<ast::Function>(written.body);
    ast::Function function;
    function.params.push_back({.name = {c.names.intern("the closure"), written.name.span}});
    function.params.insert(function.params.end(), body.params.begin(), body.params.end());
    for (std::size_t i = 0; i < function.params.size(); ++i)
        function.params[i].type = known_type(c, types[i], function.params[i].name.span);
    function.result = known_type(c, types.back(), written.name.span);
    function.body = body.body;
    function.has_body = true;
    ast::Decl decl;
    decl.name = written.name;
    decl.span = written.span;
    decl.body = std::move(function);
    return c.tree.decls.add(std::move(decl));
}

/// Whether the parameters that have a type in the source have the types that the interface says.
bool takes(Context& c, const ClosureType& closure, Name function, const std::vector<ir::TypeId>& types,
           std::string& why) {
    const auto& params = std::get<ast::Function>(c[closure.written].body).params;
    const std::size_t passed = types.size() - 2;
    if (params.size() != passed) {
        why = "it has " + std::to_string(params.size()) + (params.size() == 1 ? " parameter" : " parameters") +
              ", and '" + c.text(function) + "' passes it " + std::to_string(passed);
        return false;
    }
    for (std::size_t i = 0; i < passed; ++i) {
        if (!params[i].type) continue;
        const ir::TypeId declared = type_of(c, *closure.env, params[i].type);
        if (declared == types[i + 1] || declared == c.types().error) continue;
        why = "its parameter '" + c.text(params[i].name.name) + "' is a " + c.text(declared) + ", and '" +
              c.text(function) + "' passes a " + c.text(types[i + 1]);
        return false;
    }
    return true;
}

}  // namespace

Operand check_closure(Body& body, ast::ExprId id) {
    const Span span = body.context[id].span;
    const Parts parts(body);
    const Meanings meanings = meanings_of(body, id);
    ir::Operands values;
    for (ast::ExprId name : meanings.captured) {
        values.push_back(captured_value(body, name));
        if (is_error(body, values.back())) return error_operand(span);
    }
    const ir::TypeId type = body.types().of_struct(type_of_closure(body, id, meanings, values));
    if (values.empty()) return value_operand(body, ir::zero(body.program(), type, span), span);
    return value_operand(body, add(body.program(), ir::Op::construct, type, span, std::move(values)), span);
}

const ClosureType* closure_of(const Context& c, ir::TypeId type) {
    if (c.closures.empty() || !type || c.program.types.kind(type) != ir::TypeKind::struct_) return nullptr;
    const auto found = c.closures.find(c.program.types[type].struct_);
    return found == c.closures.end() ? nullptr : &found->second;
}

bool give_call(Context& c, ir::TypeId type, Name function, const std::vector<ir::TypeId>& types, std::string& why) {
    const ir::StructId index = c.types()[type].struct_;
    ClosureType& closure = c.closures.at(index);
    if (types.size() < 2 || types[0] != type) {
        why = "the first parameter of '" + c.text(function) + "' is not Self";
        return false;
    }
    if (!takes(c, closure, function, types, why)) return false;
    const auto is_it = [&](const ClosureType::Call& call) { return call.name == function && call.types == types; };
    if (std::ranges::any_of(closure.calls, is_it)) return true;
    const ast::DeclId decl = call_declaration(c, closure, types);
    c.module_of[decl] = closure.env->module;
    c.closure_called[decl] = index;
    closure.calls.push_back({function, types, decl});
    return true;
}

ir::TypeId result_of_call(Context& c, ir::TypeId type, const std::vector<ir::TypeId>& params) {
    const ClosureType& closure = c.closures.at(c.types()[type].struct_);
    const auto& written = std::get<ast::Function>(c[closure.written].body);
    const ast::Stmt& result = c[written.body.empty() ? ast::StmtId{} : written.body[0]];
    if (written.params.size() != params.size() || result.kind != ast::StmtKind::return_ || !result.value) return {};
    const auto mark = c.diagnostics.mark();
    std::vector<ir::StmtId> statements;
    Body body{.context = c, .env = *closure.env, .kind = BodyKind::function, .block = &statements};
    open_scope(body);
    for (std::size_t i = 0; i < params.size(); ++i)
        declare_local(body, written.params[i].name, params[i], false, false);
    const ir::LocalId self = add_local(c.program, c.names.intern("the closure"), type, c[closure.written].span);
    declare_captured(body, c.types()[type].struct_, self);
    const ir::ExprId value = check_value(body, result.value);
    c.diagnostics.back_to(mark);
    return is_error(body, value) ? ir::TypeId{} : c.program.exprs[value].type;
}

std::string key_of_call(const Context& c, ast::DeclId id) {
    const ir::StructId index = c.closure_called.at(id);
    const auto& calls = c.closures.at(index).calls;
    const auto call = std::ranges::find(calls, id, &ClosureType::Call::decl);
    std::string key = c.program.structs[index].key;
    for (std::size_t i = 1; i < call->types.size(); ++i)
        key += (i == 1 ? "(" : ", ") + ir::to_qualified_text(c.program, call->types[i]);
    return key + ")";
}

void declare_captured(Body& body, ir::StructId type, ir::LocalId closure) {
    ir::Program& p = body.program();
    const std::vector<ir::StructField> fields = p.structs[type].fields;
    for (std::uint32_t i = 0; i < fields.size(); ++i) {
        const Span span = p.locals[closure].span;
        const ir::ExprId value = add(p, ir::Op::field, fields[i].type, span, {make_local(p, closure, span)});
        p.exprs[value].slot = i;
        const ir::LocalId local = declare_local(body, {fields[i].name, span}, fields[i].type, false, false);
        body.captured.push_back(local);
        body.lets[local] = value;
        const ir::StmtId let = add(p, ir::StmtOp::let, span);
        p.stmts[let].local = local;
        p.stmts[let].value = value;
        emit(body, let);
    }
}

bool report_closure(Context& c, ir::TypeId found, ir::TypeId wanted, Span span) {
    if (!found) return false;
    if (c.types().kind(found) == ir::TypeKind::device) found = c.types()[found].element;
    if (found == wanted || !closure_of(c, found)) return false;
    note(c.error(Diag::closure_unwanted, span, {c.text(wanted)}), span,
         "a parameter takes closures if its type is a generic parameter with an interface of one function, as "
         "'F: Function<float, float>'");
    return true;
}

}  // namespace gliftc::sema
