#include "ir/evaluate.h"
#include "ir/implied_type.h"
#include "ir/printer.h"
#include "ir/spelling.h"

#include <algorithm>
#include <cmath>

namespace gliftc::ir {

std::string Printer::list(const Operands& operands, std::size_t from) {
    std::string text;
    for (std::size_t i = from; i < operands.size(); ++i) text += (i > from ? ", " : "") + expr(operands[i]);
    return text;
}

/// Makes equal names unique: sum, sum.2, sum.3.
std::string Printer::unique(std::string text) {
    if (text.empty()) text = "unnamed";
    if (unsigned count = ++taken_[text]; count > 1) text += "." + std::to_string(count);
    return text;
}

std::string Printer::local(LocalId id) {
    if (!id) return "?";
    auto [found, is_new] = locals_.try_emplace(id);
    if (is_new) found->second = unique(name(p.locals[id].name));
    return found->second;
}

std::string Printer::function_name(FunctionId id) {
    auto [found, is_new] = functions_.try_emplace(id);
    if (is_new) found->second = "@" + unique(name(p.functions[id].name));
    return found->second;
}

std::string Printer::type(TypeId id) {
    const Type& type = p.types[id];
    switch (type.kind) {
    case TypeKind::struct_: {
        auto [found, is_new] = structs_.try_emplace(type.struct_);
        if (is_new) found->second = unique(p.structs[type.struct_].display);
        return found->second;
    }
    case TypeKind::enum_: {
        auto [found, is_new] = enums_.try_emplace(type.enum_);
        if (is_new) found->second = unique(name(p.enums[type.enum_].name));
        return found->second;
    }
    case TypeKind::array: return this->type(type.element) + "[" + std::to_string(type.count) + "]";
    case TypeKind::optional: return this->type(type.element) + "?";
    default: return to_text(p, id);
    }
}

std::string Printer::place(const Place& place) {
    const bool is_known = kernel_ && place.root < kernel_->params.size();
    std::string text = is_known ? name(kernel_->params[place.root].name) : "@" + std::to_string(place.root);
    const Structure* structure = is_known ? &p.structures[kernel_->params[place.root].structure] : nullptr;
    for (std::uint32_t member : place.members) {
        text += "." + (structure ? name(structure->members[member].name) : std::to_string(member));
        if (structure) structure = &p.structures[structure->members[member].structure];
    }
    return text;
}

std::string Printer::binding(std::uint32_t slot) {
    return pass_ ? pass_->bindings[slot].name : "binding" + std::to_string(slot);
}

std::string Printer::operand(ExprId id) {
    const Expr& node = p.exprs[id];
    const bool is_compound = node.op == Op::binary || node.op == Op::unary || node.op == Op::select;
    return is_compound && !needs_type(node) ? "(" + expr(id) + ")" : expr(id);
}

/// Whether the type has to be added to the operation's text: it is neither implied (ir/implied_type.h) nor part of the
/// text. Never without a pass: only the text of passes is read back.
bool Printer::needs_type(const Expr& node) {
    if (pass_ == nullptr) return false;
    switch (node.op) {
    case Op::local:
    case Op::construct:
    case Op::convert:
    case Op::swizzle:
    case Op::parameter:
    case Op::builtin: return false;
    case Op::constant: {
        const bool is_special = p.types.is_floating(node.type) && !std::isfinite(node.number);
        return is_special && node.type != p.types.float_;
    }
    case Op::call:
        if (std::ranges::find(pass_->functions, node.function) == pass_->functions.end()) return true;
        break;
    default: break;
    }
    return implied_type(p, pass_, node, [&](const Type& type) { return p.types.find(type); }) != node.type;
}

std::string Printer::expr(ExprId id) {
    if (!id) return "<absent>";
    const Expr& node = p.exprs[id];
    return needs_type(node) ? "(" + bare(id) + ": " + type(node.type) + ")" : bare(id);
}

std::string Printer::constant(const Expr& node) {
    const Types& types = p.types;
    const std::string text = to_text(p, Value{node.type, {Lane{node.bits, node.number}}});
    switch (types.kind(node.type)) {
    case TypeKind::uint: return text + "u";
    case TypeKind::int64: return text + "l";
    case TypeKind::uint64: return text + "ul";
    case TypeKind::half: return std::isfinite(node.number) ? text + "h" : text;
    case TypeKind::double_: return std::isfinite(node.number) ? text + "d" : text;
    case TypeKind::enum_: return type(node.type) + "." + text;
    default: return text;
    }
}

std::string Printer::call(const Expr& node) {
    std::string text = function_name(node.function) + "(" + list(node.operands);
    for (const Place& at : node.places) text += (text.back() == '(' ? "" : ", ") + ("&" + place(at));
    return text + ")";
}

std::string Printer::bare(ExprId id) {
    const Expr& node = p.exprs[id];
    const auto& o = node.operands;
    switch (node.op) {
    case Op::constant: return constant(node);
    case Op::local: return local(node.local);
    case Op::construct:
    case Op::convert: return type(node.type) + "(" + list(o) + ")";
    case Op::unary: {
        const std::string text = operand(o[0]);
        const bool is_literal = p.exprs[o[0]].op == Op::constant;
        return std::string(spelling(node.unary)) + (is_literal ? "(" + text + ")" : text);
    }
    case Op::binary: return operand(o[0]) + " " + std::string(spelling(node.binary)) + " " + operand(o[1]);
    case Op::select: return operand(o[0]) + " ? " + operand(o[1]) + " : " + operand(o[2]);
    case Op::swizzle: {
        std::string text = operand(o[0]) + ".";
        for (std::uint32_t i = 0; i < p.types.components(node.type); ++i) text += "xyzw"[node.lanes[i]];
        return text;
    }
    case Op::index: return operand(o[0]) + "[" + expr(o[1]) + "]";
    case Op::field:
        return operand(o[0]) + "." + name(p.structs[p.types[p.exprs[o[0]].type].struct_].fields[node.slot].name);
    case Op::call: return call(node);
    case Op::intrinsic: return std::string(name_of(node.intrinsic)) + "(" + list(o) + ")";
    case Op::none: return "none";
    case Op::some: return "some(" + expr(o[0]) + ")";
    case Op::has_value: return "has_value(" + expr(o[0]) + ")";
    case Op::value: return "value(" + expr(o[0]) + ")";
    case Op::member: return place(node.place) + ".member" + std::to_string(node.slot);
    case Op::memory_extent: return place(node.place) + ".memory" + std::to_string(node.slot);
    case Op::host_state: return place(node.place) + ".host" + std::to_string(node.slot);
    case Op::domain: return place(node.place) + ".domain";
    case Op::element: return place(node.place);
    case Op::address: return place(node.place) + ".address";
    case Op::near: return place(node.place) + "[near " + list(o) + "]";
    case Op::read: return place(node.place) + "[" + list(o) + "]";
    case Op::sample: return place(node.place) + ".sample(" + list(o) + ")";
    case Op::gather: return place(node.place) + ".gather(" + list(o) + ")";
    case Op::compare: return place(node.place) + ".compare(" + list(o) + ")";
    case Op::position: return "position";
    case Op::window: return "window";
    case Op::front_facing: return "front_facing";
    case Op::state: return "state" + std::to_string(node.slot);
    case Op::translate: return place(node.place) + ".translate(" + list(o) + ")";
    case Op::invocation: return std::string(spelling(node.invocation));
#define HOST_OPERATION(name) case Op::name:
#include "ir/operations.def"
        return host(node);
    case Op::guarded_load: return "guarded_load(" + binding(node.slot) + ", " + list(o) + ")";
#define MEMORY_OPERATION(name) case Op::name:
#include "ir/operations.def"
        return memory(node);
    case Op::row_item: return operand(o[0]) + ".row[" + expr(o[1]) + "]";
    case Op::row_load: return binding(node.slot) + ".row[" + list(node.operands) + "]";
    }
    return "?";
}

std::string Printer::memory(const Expr& node) {
    switch (node.op) {
    case Op::parameter: return "$" + (pass_ ? pass_->parameters[node.slot].name : std::to_string(node.slot));
    case Op::load: return binding(node.slot) + "[" + list(node.operands) + "]";
    case Op::image_load: return "image_load(" + binding(node.slot) + ", " + list(node.operands) + ")";
    case Op::image_sample: return "image_sample(" + binding(node.slot) + ", " + list(node.operands) + ")";
    case Op::image_gather: return "image_gather(" + binding(node.slot) + ", " + list(node.operands) + ")";
    case Op::image_compare: return "image_compare(" + binding(node.slot) + ", " + list(node.operands) + ")";
    default: return "%" + std::string(spelling(node.builtin));
    }
}

std::string Printer::host(const Expr& node) {
    const auto& o = node.operands;
    switch (node.op) {
    case Op::host_read: return "host_read " + place(node.place) + "[" + list(o) + "]";
    case Op::device_read: return "device_read " + place(node.place) + "[" + list(o) + "]";
    case Op::device_value: return "value of " + list(o);
    case Op::await_value: return "await " + list(o);
    case Op::slice: return place(node.place) + "[slice " + list(o) + "]";
    case Op::structure_value: return node.local ? local(node.local) : place(node.place);
    case Op::pipeline_call: return name(p.pipelines[node.pipeline()].name) + "(" + list(o) + ")";
    case Op::device_property: return "device.property" + std::to_string(node.slot);
    default: return "count(" + (node.local ? local(node.local) : place(node.place)) + ")";
    }
}

}  // namespace gliftc::ir
