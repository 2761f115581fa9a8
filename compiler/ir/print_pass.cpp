// Prints a pass as text, inputs first, then bodies. read.h reads it back, and has the grammar.
#include "ir/printer.h"
#include "ir/spelling.h"
#include "ir/walk.h"

namespace gliftc::ir {

namespace {

std::string three(const std::array<std::uint32_t, 3>& numbers) {
    return std::to_string(numbers[0]) + " " + std::to_string(numbers[1]) + " " + std::to_string(numbers[2]);
}

}  // namespace

void Printer::declare_struct(StructId id) {
    const Struct& of = p.structs[id];
    for (const StructField& field : of.fields) declare_types(field.type);
    std::string text = "struct " + type(p.types.find({.kind = TypeKind::struct_, .struct_ = id})) + " {";
    for (std::size_t i = 0; i < of.fields.size(); ++i)
        text += std::string(i ? ", " : " ") + name(of.fields[i].name) + ": " + type(of.fields[i].type);
    line(text + " }");
}

void Printer::declare_enum(EnumId id) {
    const Enum& of = p.enums[id];
    std::string text = "enum " + type(p.types.find({.kind = TypeKind::enum_, .enum_ = id})) + " {";
    for (std::size_t i = 0; i < of.values.size(); ++i)
        text += std::string(i ? ", " : " ") + name(of.enumerators[i]) + " = " + std::to_string(of.values[i]);
    line(text + " }");
}

/// Declares the structs and enums that a type consists of, each once.
void Printer::declare_types(TypeId id) {
    if (!id || !declared_.insert(id).second) return;
    const Type type = p.types[id];
    if (type.element) declare_types(type.element);
    if (type.kind == TypeKind::struct_) declare_struct(type.struct_);
    if (type.kind == TypeKind::enum_) declare_enum(type.enum_);
}

void Printer::declare_used_types() {
    const Pass& pass = *pass_;
    const auto of_body = [&](const std::vector<StmtId>& body) {
        for_each_expression(p, body, [&](ExprId id) { declare_types(p.exprs[id].type); });
        for_each_statement(p, body, [&](const Stmt& stmt) {
            if (stmt.local) declare_types(p.locals[stmt.local].type);
        });
    };
    for (const PassBinding& of : pass.bindings) declare_types(of.element);
    for (const PassParameter& of : pass.parameters) {
        declare_types(of.type);
        if (of.value) for_each_node(p, of.value, [&](ExprId id) { declare_types(p.exprs[id].type); });
    }
    if (kernel_)
        for (const KernelParam& of : kernel_->params)
            if (of.pattern == Pattern::value) declare_types(p.locals[of.local].type);
    for (LocalId of : pass.shared) declare_types(p.locals[of].type);
    for (FunctionId of : pass.functions) {
        for (LocalId param : p.functions[of].params) declare_types(p.locals[param].type);
        declare_types(p.functions[of].result);
        of_body(p.functions[of].body);
    }
    for (const auto* body : bodies_of(pass)) of_body(*body);
}

void Printer::dispatch_lines() {
    const Pass& pass = *pass_;
    std::string text = "group " + three(pass.group) + ", rank " + std::to_string(pass.rank);
    if (pass.items != 1) text += ", items " + std::to_string(pass.items);
    line(text + (kernel_ && kernel_->grouped() ? ", declared" : ""));
    if (pass.loop_rounds)
        line("loops " + (pass.loop_rounds == ~0ull ? std::string("unbounded") : std::to_string(pass.loop_rounds)));
    if (pass.has_reports) line("reports");
    if (!pass.exact) line("inexact");
}

void Printer::kernel_parameters() {
    if (!kernel_) return;
    for (const KernelParam& of : kernel_->params) {
        if (of.pattern == Pattern::value) line("value " + local(of.local) + ": " + type(p.locals[of.local].type));
        else line("structure " + name(of.name));
    }
    if (!kernel_->raster) return;
    for (LocalId of : given_locals(*kernel_->raster))
        if (of) line("given " + local(of) + ": " + type(p.locals[of].type));
}

void Printer::bindings() {
    for (std::uint32_t i = 0; i < pass_->bindings.size(); ++i) {
        const PassBinding& of = pass_->bindings[i];
        std::string text = "binding " + of.name + ": " + std::string(spelling(of.shape)) + "<" + type(of.element) +
                           "> " + std::string(spelling(of.access));
        if (of.format != Format::none) text += " " + std::string(spelling(of.format));
        for (auto [flag, word] : {std::pair{of.sampled, " sampled"},
                                  {of.linear, " linear"},
                                  {of.atomic, " atomic"},
                                  {of.ordered, " ordered"},
                                  {of.coherent, " coherent"},
                                  {of.in_rows, " in_rows"}})
            if (flag) text += word;
        if (of.compare) text += " compare " + std::string(spelling(*of.compare));
        if (of.one_place < i) text += " one_place " + pass_->bindings[of.one_place].name;
        text += of.is_workspace ? " of workspace" : " of " + place(of.place) + " " + std::to_string(of.memory);
        if (of.address_parameter < pass_->parameters.size())
            text += " at $" + pass_->parameters[of.address_parameter].name;
        line(text);
    }
}

void Printer::parameters() {
    const auto given = [&](const PassParameter& of) -> std::string {
        switch (of.source) {
        case ParameterSource::uniform: return expr(of.value);
        case ParameterSource::origin: return "origin " + name(kernel_->params[of.param].name);
        case ParameterSource::size: return "size";
        case ParameterSource::range_size: return "range_size " + name(kernel_->params[of.param].name);
        case ParameterSource::index: return "index " + name(kernel_->params[of.param].name);
        case ParameterSource::base: return "base";
        case ParameterSource::address: return "address " + pass_->bindings[of.param].name;
        }
        return "?";
    };
    for (const PassParameter& of : pass_->parameters)
        line("parameter " + of.name + ": " + type(of.type) + " = " + given(of));
}

std::string Printer::title(const Variant& variant) {
    std::string text = variant.part == Part::vertex ? "vertex" : variant.part == Part::fragment ? "fragment" : "body";
    if (variant.devices == Devices::shaders) text += ", on shaders";
    if (variant.devices == Devices::host) text += ", on host";
    const auto& [elements, interior, bounds, row] = variant.assumes;
    if (elements != std::array{pass_->items, 1u, 1u}) text += ", takes " + three(elements);
    const auto parameter = [&](std::uint32_t slot) { return "$" + pass_->parameters.at(slot).name; };
    if (interior) text += ", inside " + std::to_string(interior->radius) + " of " + parameter(interior->domain);
    if (interior && interior->origin != no_parameter) text += " from " + parameter(interior->origin);
    const auto limit = [&](ExprId id) { return id ? expr(id) : std::string("any"); };
    for (const Bounds& of : bounds)
        text += ", bounds(" + expr(of.value) + ", " + limit(of.low) + ", " + limit(of.high) + ")";
    if (row != 0) text += ", rows of " + std::to_string(row);
    if (variant.order == RowOrder::any) text += ", any order";
    return variant.order == RowOrder::in_blocks ? text + ", in blocks" : text;
}

void Printer::pass(const std::vector<ExprId>& facts) {
    const Pass& pass = *pass_;
    line("pass " + name(kernel_->name) + " " + std::string(spelling(pass.form)) + (pass.is_wide ? " wide" : "") + " {");
    ++indent_;
    dispatch_lines();
    declare_used_types();
    kernel_parameters();
    bindings();
    parameters();
    for (LocalId of : pass.shared) line("shared " + local(of) + ": " + type(p.locals[of].type));
    if (pass.address) line("address " + local(pass.address) + ": " + type(p.locals[pass.address].type));
    if (pass.in_range) line("in_range " + local(pass.in_range));
    for (FunctionId of : pass.functions) function(of);
    for (ExprId fact : facts) line("fact " + expr(fact));
    if (!pass.prologue.empty()) nested("prologue", pass.prologue);
    for (const Variant& variant : pass.variants) {
        if (variant.block) nested("block", *variant.block);
        if (pass.variants.size() > 1 || !variant.body.empty()) nested(title(variant), variant.body);
    }
    --indent_;
    line("}");
}

}  // namespace gliftc::ir
