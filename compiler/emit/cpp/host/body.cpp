#include "emit/cpp/host/body.h"

#include "base/concat.h"
#include "emit/cpp/mentions.h"
#include "ir/levels.h"
#include "ir/spelling.h"

#include <algorithm>

namespace gliftc::host {

namespace {

/// Arguments for load_row, store_row, load_rows and store_rows of glift/host, which access rows of four consecutive
/// scalars: the buffer, and the index of the (first) row, counted in such rows.
std::string row_arguments(Body& body, std::uint32_t binding, ir::ExprId index) {
    body.used_bindings.insert(binding);
    return body.binding_names[binding] + ", " + cpp::print_any(body.p, index);
}

using cpp::Level;
using cpp::Text;
using ir::Expr;
using ir::Op;
using ir::Stmt;
using ir::StmtOp;

/// `glift::host::load_texel<glift::Format::r32f, float>(f_data`, to be followed by more arguments.
std::string image_call(Body& body, const char* name, std::uint32_t binding) {
    body.used_bindings.insert(binding);
    const ir::PassBinding& b = body.pass.bindings[binding];
    return std::string("glift::host::") + name + "<glift::Format::" + std::string(cpp::format_name(b.format)) + ", " +
           cpp::type_text(body.p.globals, b.element) + ">(" + body.binding_names[binding];
}

/// A texel as an lvalue, for atomic and coherent accesses.
std::string texel_text(Body& body, std::uint32_t binding, ir::ExprId at) {
    return image_call(body, "texel", binding) + ", " + cpp::print_any(body.p, at) + ")";
}

std::string compare_call(Body& body, const Expr& expr) {
    body.used_bindings.insert(expr.slot);
    const ir::PassBinding& binding = body.pass.bindings[expr.slot];
    const char* const function = binding.shape == ir::MemoryShape::imagecube ? "compare_cube" : "compare_linear";
    return std::string("glift::host::") + function +
           "<glift::Format::" + std::string(cpp::format_name(binding.format)) +
           ", glift::Compare::" + std::string(ir::spelling(*binding.compare)) + ">(" + body.binding_names[expr.slot] +
           ", " + cpp::join_arguments(body.p, expr.operands) + ")";
}

Text print_outer(Body& body, const Expr& expr) {
    cpp::Printer& p = body.p;
    switch (expr.op) {
    case Op::parameter: body.used_parameters.insert(expr.slot); return {body.parameter_names[expr.slot]};
    case Op::row_item:
        return {body.item_pointers.at({p.program.exprs[expr.operands[0]].local, expr.operands[1]}) + "[i]"};
    case Op::row_load:
    case Op::load: {
        if (is_row(p.program.types, body.pass.bindings[expr.slot], expr.type))
            return {"glift::host::load_row(" + row_arguments(body, expr.slot, expr.operands[0]) + ")"};
        std::string text = element_text(body, expr.slot, expr.operands[0]);
        if (body.pass.bindings[expr.slot].coherent) text = "glift::host::memory::read(" + text + ")";
        if (cpp::is_bool_vector(p.program, expr.type)) text = cpp::type_text(p.globals, expr.type) + "(" + text + ")";
        return {text};
    }
    case Op::image_load:
        if (body.pass.bindings[expr.slot].coherent)
            return {"glift::host::memory::read(" + texel_text(body, expr.slot, expr.operands[0]) + ")"};
        return {image_call(body, "load_texel", expr.slot) + ", " + cpp::join_arguments(p, expr.operands) + ")"};
    case Op::image_sample: {
        const ir::PassBinding& binding = body.pass.bindings[expr.slot];
        const bool is_cube = binding.shape == ir::MemoryShape::imagecube;
        const char* function = is_cube          ? (binding.linear ? "sample_cube_linear" : "sample_cube_nearest")
                               : binding.linear ? "sample_linear"
                                                : "sample_nearest";
        return {image_call(body, function, expr.slot) + ", " + cpp::join_arguments(p, expr.operands) + ")"};
    }
    case Op::image_gather:
        return {image_call(body, "gather", expr.slot) + ", " + cpp::join_arguments(p, expr.operands) + ")"};
    case Op::image_compare: return {compare_call(body, expr)};
    case Op::builtin:
        switch (expr.builtin) {
        case ir::Builtin::global_id: return {body.first_only ? "(group_id * " + body.group_text + ")" : "global_id"};
        case ir::Builtin::local_id: return {body.first_only ? "uint3()" : "local_id"};
        case ir::Builtin::group_id: return {"group_id"};
        case ir::Builtin::group_count: return {"group_count"};
        case ir::Builtin::local_index: return {body.first_only ? "0u" : "local_index"};
        case ir::Builtin::subgroup_size: return {"1u"};
        case ir::Builtin::subgroup_lane: return {"0u"};
        case ir::Builtin::subgroup_index: return {body.first_only ? "0u" : "local_index"};
        case ir::Builtin::subgroup_count:
            return {std::to_string(body.pass.group[0] * body.pass.group[1] * body.pass.group[2]) + "u"};
        case ir::Builtin::corner: return {"corner"};
        case ir::Builtin::instance: return {"instance"};
        case ir::Builtin::fragment_place: return {"glift::host::fragment_place(fragments, *call.targets, pixel)"};
        case ir::Builtin::is_front: return {"fragments.is_front"};
        case ir::Builtin::skips_branches:
        case ir::Builtin::adds_floats: return {"true"};
        }
        break;
#define VALUE_OPERATION(name) case Op::name:
#define SHAPE_OPERATION(name) case Op::name:
#define STRUCTURE_OPERATION(name) case Op::name:
#define GUARDED_OPERATION(name) case Op::name:
#define HOST_OPERATION(name) case Op::name:
#include "ir/operations.def"
        break;
    }
    ir::misplaced(expr.op, "emit/cpp/host: a lowered pass");
}

std::string_view combine_name(ir::Combine combine) {
    switch (combine) {
    case ir::Combine::replace: return "atomic_replace";
    case ir::Combine::min: return "atomic_min";
    case ir::Combine::max: return "atomic_max";
    case ir::Combine::add: return "atomic_add";
    case ir::Combine::bit_and: return "atomic_bit_and";
    case ir::Combine::bit_or: return "atomic_bit_or";
    case ir::Combine::bit_xor: return "atomic_bit_xor";
    }
    return "";
}

/// glift::host::print(call, 0u, {address, glift::host::floatBitsToUint(x)});
std::string print_text(Body& body, const Stmt& stmt) {
    const Expr& words = body.p.program.exprs[stmt.value];
    std::string list;
    for (std::size_t i = 0; i < body.p.program.types[words.type].count; ++i) {
        list += i == 0 ? "" : ", ";
        if (words.op == Op::construct) list += cpp::print_any(body.p, words.operands[i]);
        else list += cpp::print_any(body.p, stmt.value) + "[" + std::to_string(i) + "]";
    }
    return concat("glift::host::print(call, ", std::to_string(body.pass.message_of(stmt)), "u, {", list, "});");
}

/// glift::host::report_outside(call, {.line = 9, .binding = 0}, f_address);
std::string report_text(Body& body, const Stmt& stmt) {
    const std::vector<std::uint32_t>& files = body.pass.files;
    const auto file = std::find(files.begin(), files.end(), stmt.span.file);
    std::string record = ".line = " + std::to_string(stmt.span ? body.p.globals.sources.line_of(stmt.span) : 0) +
                         ", .binding = " + (stmt.slot == ir::no_binding ? "UINT32_MAX" : std::to_string(stmt.slot));
    if (stmt.span && file != files.end() && file != files.begin())
        record += ", .file = " + std::to_string(file - files.begin());
    return "glift::host::report_outside(call, {" + record + "}, " + cpp::print_any(body.p, stmt.target) + ");";
}

/// Prints a copy_row: the copy of consecutive elements of a buffer to a local array.
void print_copy(Body& body, const Stmt& stmt) {
    cpp::Printer& p = body.p;
    body.used_bindings.insert(stmt.slot);
    const Expr& to = p.program.exprs[stmt.target];
    const std::string from = body.binding_names[stmt.slot] + " + " + cpp::print(p, stmt.value, Level::postfix);
    const std::string at =
        cpp::print(p, to.operands[0], Level::postfix) + ".values + " + cpp::print(p, to.operands[1], Level::postfix);
    p.out.line(
        concat("glift::host::copy_row<", std::to_string(p.program.exprs[stmt.limit].bits), ">(", from, ", ", at, ");"));
}

// long: a case for each statement
void print_outer(Body& body, const Stmt& stmt) {
    cpp::Printer& p = body.p;
    if (stmt.op == StmtOp::print) return p.out.line(print_text(body, stmt));
    switch (stmt.op) {
    case StmtOp::row_store:
    case StmtOp::store: {
        std::string member;
        const ir::TypeId type = ir::for_each_step(p.program, body.pass, stmt, [&](std::uint32_t slot, ir::StructId of) {
            member += "." + p.globals.field_names[of][slot];
        });
        std::string value = cpp::print_any(p, stmt.value);
        if (is_row(p.program.types, body.pass.bindings[stmt.slot], p.program.exprs[stmt.value].type))
            return p.out.line("glift::host::store_row(" + row_arguments(body, stmt.slot, stmt.target) + ", " + value +
                              ");");
        if (cpp::is_bool_vector(p.program, type)) value = cpp::storage_text(p.globals, type) + "(" + value + ")";
        const std::string place = element_text(body, stmt.slot, stmt.target) + member;
        if (body.pass.bindings[stmt.slot].coherent)
            return p.out.line("glift::host::memory::write(" + place + ", " + value + ");");
        p.out.line(place + " = " + value + ";");
        return;
    }
    case StmtOp::image_store:
        if (body.pass.bindings[stmt.slot].coherent)
            return p.out.line("glift::host::memory::write(" + texel_text(body, stmt.slot, stmt.target) + ", " +
                              cpp::print_any(p, stmt.value) + ");");
        p.out.line(image_call(body, "store_texel", stmt.slot) + ", " + cpp::print_any(p, stmt.target) + ", " +
                   cpp::print_any(p, stmt.value) + ");");
        return;
    case StmtOp::atomic: {
        const ir::PassBinding& binding = body.pass.bindings[stmt.slot];
        const std::string value = cpp::print_any(p, stmt.value);
        if (const auto updates = body.update_names.find(stmt.slot); updates != body.update_names.end()) {
            body.updated_bindings.insert(stmt.slot);
            p.out.line(updates->second + ".add(" + cpp::print_any(p, stmt.target) + ", " + value + ");");
        } else if (binding.shape == ir::MemoryShape::buffer) {
            const std::string element = element_text(body, stmt.slot, stmt.target);
            p.out.line("glift::host::" + std::string(combine_name(stmt.combine)) + "(" + element + ", " + value + ");");
        } else {
            p.out.line("glift::host::" + std::string(combine_name(stmt.combine)) + "(" +
                       texel_text(body, stmt.slot, stmt.target) + ", " + value + ");");
        }
        return;
    }
    case StmtOp::row_update:
        return p.out.line(concat(body.row_updates.at({stmt.slot, stmt.target}), ".add(", cpp::print_any(p, stmt.target),
                                 ", lane, ", cpp::print_any(p, stmt.value), ");"));
    case StmtOp::column_update:
        body.updated_bindings.insert(stmt.slot);
        return p.out.line(concat(body.update_names.at(stmt.slot), ".add(", cpp::print_any(p, stmt.limit), ", ",
                                 cpp::print_any(p, stmt.target), ", ", cpp::print_any(p, stmt.value), ");"));
    case StmtOp::report: return p.out.line(report_text(body, stmt));
    case StmtOp::load_rows:
        return p.out.line(concat("glift::host::load_rows(", row_arguments(body, stmt.slot, stmt.value), ", ",
                                 cpp::print_any(p, stmt.target), ");"));
    case StmtOp::store_rows:
        return p.out.line(concat("glift::host::store_rows(", row_arguments(body, stmt.slot, stmt.target), ", ",
                                 cpp::print_any(p, stmt.value), ");"));
    case StmtOp::copy_row: return print_copy(body, stmt);
    case StmtOp::cut:
    case StmtOp::keep:
    case StmtOp::discard:
    case StmtOp::invocations:
#define VALUE_STATEMENT(name) case StmtOp::name:
#define STRUCTURE_STATEMENT(name) case StmtOp::name:
#define HOST_STATEMENT(name) case StmtOp::name:
#include "ir/statements.def"
        break;
    }
    ir::misplaced(stmt.op, "emit/cpp/host: a lowered pass");
}

void print_local_function(Body& body, ir::FunctionId id) {
    cpp::Printer& p = body.p;
    const ir::Function& function = p.program.functions[id];
    const std::string name = p.local_functions[id] = p.names.declare((*p.program.names)[function.name]);
    p.names.enter();
    std::string parameters;
    for (ir::LocalId local : function.params) {
        const std::string type = cpp::type_text(p.globals, p.program.locals[local].type);
        parameters += (parameters.empty() ? "" : ", ") + (cpp::unused_mark(p.program, function.body, local) + type) +
                      " " + cpp::declare_local(p, local);
    }
    cpp::mark_line(p, function.span);
    p.out.open("const auto " + name + " = [&](" + parameters + ") -> " + cpp::type_text(p.globals, function.result));
    auto print_return = std::exchange(p.print_return, nullptr);
    cpp::print_statements(p, function.body);
    p.print_return = print_return;
    p.out.close(";");
    p.names.leave();
}

}  // namespace

Body::Body(cpp::Globals& globals, const ir::Pass& pass, std::span<const char* const> taken) : pass(pass), p(globals) {
    for (const char* name : cpp::locals_of_kernels) p.names.declare(name);
    for (const char* name : taken) p.names.declare(name);
    for (const ir::PassBinding& binding : pass.bindings) binding_names.push_back(p.names.declare(binding.name));
    for (const ir::PassParameter& parameter : pass.parameters)
        parameter_names.push_back(p.names.declare(parameter.name));
    p.outer_expression = [this](const Expr& expr) { return print_outer(*this, expr); };
    p.outer_place = [this](const Expr& load) {
        return load.op == Op::image_load ? texel_text(*this, load.slot, load.operands[0])
                                         : element_text(*this, load.slot, load.operands[0]);
    };
    p.outer_statement = [this](const Stmt& stmt) { print_outer(*this, stmt); };
}

std::string element_text(Body& body, std::uint32_t binding, ir::ExprId index) {
    if (const auto row = body.row_pointers.find({binding, index}); row != body.row_pointers.end())
        return row->second + "[i]";
    body.used_bindings.insert(binding);
    return body.binding_names[binding] + "[" + cpp::print_any(body.p, index) + "]";
}

void print_local_functions(Body& body) {
    for (ir::FunctionId id : body.pass.functions) {
        if (!cpp::is_pure(body.p.program, id)) print_local_function(body, id);
    }
}

void declare_used(Body& body, cpp::Writer& out, const std::string& name) {
    const std::vector<std::string> members = cpp::block_names(body.p.globals, body.pass);
    if (!body.used_parameters.empty())
        out.line("const auto& parameters = *static_cast<const " + name + "_parameters*>(call.parameters);");
    for (std::uint32_t i = 0; i < body.pass.parameters.size(); ++i) {
        if (!body.used_parameters.contains(i)) continue;
        const ir::PassParameter& parameter = body.pass.parameters[i];
        std::string value = "parameters." + members[i];
        const std::string type = cpp::type_text(body.p.globals, parameter.type);
        if (cpp::is_bool_vector(body.p.program, parameter.type)) value = type + "(" + value + ")";
        out.line("const " + type + " " + body.parameter_names[i] + " = " + value + ";");
    }
    for (std::uint32_t i = 0; i < body.pass.bindings.size(); ++i) {
        if (!body.used_bindings.contains(i)) continue;
        const ir::PassBinding& binding = body.pass.bindings[i];
        const std::string memory = "call.memories[" + std::to_string(i) + "]";
        if (binding.shape != ir::MemoryShape::buffer) {
            out.line("const glift::HostMemory& " + body.binding_names[i] + " = " + memory + ";");
            continue;
        }
        const std::string type = cpp::storage_text(body.p.globals, binding.element);
        const std::string element = binding.access == ir::Access::read ? "const " + type : type;
        out.line(element + "* " + body.binding_names[i] + " = glift::host::elements<" + element + ">(" + memory + ");");
    }
}

bool returns_early(const ir::Program& program, const std::vector<ir::StmtId>& body) {
    bool found = false;
    ir::for_each_statement(program, body, [&](const Stmt& stmt) { found = found || stmt.op == StmtOp::return_; });
    return found;
}

}  // namespace gliftc::host
