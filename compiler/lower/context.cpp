#include "lower/context.h"

namespace gliftc::lower {

using namespace ir;

std::uint32_t Context::parameter(ParameterSource source, const std::string& name, TypeId type, std::uint32_t param) {
    for (std::uint32_t i = 0; i < pass.parameters.size(); ++i)
        if (pass.parameters[i].source == source && pass.parameters[i].param == param) return i;
    PassParameter parameter;
    parameter.name = name;
    parameter.type = type;
    parameter.source = source;
    parameter.param = param;
    pass.parameters.push_back(std::move(parameter));
    return static_cast<std::uint32_t>(pass.parameters.size() - 1);
}

ExprId Context::parameter_expr(std::uint32_t slot) {
    Expr node;
    node.op = Op::parameter;
    node.type = pass.parameters[slot].type;
    node.slot = slot;
    return p.exprs.add(std::move(node));
}

LocalId Context::new_local(std::string_view name, TypeId type, Span span, bool is_mutable) {
    return new_local(p.names->intern(name), type, span, is_mutable);
}

LocalId Context::new_local(Name name, TypeId type, Span span, bool is_mutable) {
    Local local;
    local.name = name;
    local.type = type;
    local.span = span;
    local.is_mutable = is_mutable;
    return p.locals.add(local);
}

std::unique_ptr<NumberMemory> Context::take_number_memory() {
    if (spare_number_memory.empty()) spare_number_memory.push_back(std::make_unique<NumberMemory>(first_expr));
    std::unique_ptr<NumberMemory> memory = std::move(spare_number_memory.back());
    spare_number_memory.pop_back();
    memory->restart();
    return memory;
}

const Structure& Context::structure_at(const Place& place) const {
    const Structure* structure = &p.structures[kernel.params[place.root].structure];
    for (std::uint32_t member : place.members) structure = &p.structures[structure->members[member].structure];
    return *structure;
}

std::string Context::name_of(const Place& place) const {
    const KernelParam& param = kernel.params[place.root];
    std::string name = (*p.names)[param.name];
    const Structure* structure = &p.structures[param.structure];
    for (std::uint32_t member : place.members) {
        name += "_" + (*p.names)[structure->members[member].name];
        structure = &p.structures[structure->members[member].structure];
    }
    return name;
}

namespace {

/// The uniform_size of a node.
std::uint32_t uniform_size_of_node(Context& cx, const Expr& node) {
    switch (node.op) {
#define SHAPE_OPERATION(name) case Op::name:
#include "ir/operations.def"
    case Op::constant:
    case Op::none: return 1;
    case Op::local: {
        for (const KernelParam& param : cx.kernel.params)
            if (param.pattern == Pattern::value && param.local == node.local) return 1;
        const ExprId* found = cx.definitions.find(node.local);
        return found != nullptr ? uniform_size(cx, *found) : 0;
    }
    case Op::construct:
    case Op::convert:
    case Op::unary:
    case Op::binary:
    case Op::select:
    case Op::swizzle:
    case Op::index:
    case Op::field:
    case Op::intrinsic:
    case Op::some:
    case Op::has_value:
    case Op::value:
    case Op::call: {
        if (!node.places.empty() || (node.op == Op::call && cx.made_functions.contains(node.function))) return 0;
        if (node.op == Op::intrinsic && (is_collective(node.intrinsic) || signature_of(node.intrinsic)[0] == '@'))
            return 0;
        std::uint32_t size = 1;
        for (ExprId operand : node.operands) {
            const std::uint32_t part = uniform_size(cx, operand);
            if (part == 0 || size + part > largest_uniform) return 0;
            size += part;
        }
        return size;
    }
#define STRUCTURE_OPERATION(name) case Op::name:
#define GUARDED_OPERATION(name) case Op::name:
#define HOST_OPERATION(name) case Op::name:
#define MEMORY_OPERATION(name) case Op::name:
#define CPU_OPERATION(name) case Op::name:
#include "ir/operations.def"
        return 0;
    }
    return 0;
}

}  // namespace

std::uint32_t uniform_size(Context& cx, ExprId id) {
    if (const std::uint32_t* found = cx.uniform_sizes.find(id)) return *found;
    const std::uint32_t size = uniform_size_of_node(cx, cx.p.exprs[id]);
    cx.uniform_sizes.emplace(id, size);
    return size;
}

bool is_trivial(const Context& cx, ExprId id) {
    const Expr& node = cx.p.exprs[id];
    switch (node.op) {
    case Op::constant:
    case Op::none:
    case Op::parameter:
    case Op::member:
    case Op::memory_extent:
    case Op::host_state:
    case Op::domain:
    case Op::builtin: return true;
    case Op::local: return !cx.p.locals[node.local].is_mutable;
    case Op::swizzle:
    case Op::has_value:
    case Op::value:
    case Op::field: return is_trivial(cx, node.operands[0]);
    case Op::construct: return cx.build.is_constant(id);
    default: return false;
    }
}

}  // namespace gliftc::lower
