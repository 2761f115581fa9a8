#include "ir/chain.h"
#include "ir/levels.h"
#include "ir/walk.h"
#include "lower/expand/expand.h"

namespace gliftc::lower {

using namespace ir;

Place Expander::resolved(const Place& place) const {
    Place result = frame_->places[place.root];
    result.members.append(place.members);
    return result;
}

/// In the direct form, parameters that are assumed to have equal state (KernelParam::alike) are represented by the
/// first one.
std::uint32_t Expander::canonical_root(std::uint32_t root) const {
    return cx.is_direct() ? cx.kernel.params[root].alike : root;
}

Place Expander::canonical(const Place& place) const {
    const Structure& whole = cx.structure_at({place.root, {}});
    const std::uint32_t root = canonical_root(place.root);
    const Place made{place.root, made_at(p, whole, {place.members.begin(), place.members.end()})};
    if (is_of_one_whole(place.root)) return seen_from(p, cx.kernel, made, root).value_or(made);
    return {root, made.members};
}

/// Whether the parameter is assumed to be of the structure that the parameter which represents it is of, too.
bool Expander::is_of_one_whole(std::uint32_t root) const {
    const auto& params = cx.kernel.params;
    return cx.is_direct() && have_one_whole(p, params[root], params[params[root].alike]);
}

std::string Expander::prefixed(std::string_view name) const {
    return frame_->prefix.empty() ? std::string(name) : frame_->prefix + "_" + std::string(name);
}

LocalId Expander::let(const std::string& name, ExprId value, Span span) {
    LocalId local = cx.new_local(name, build.type(value), span);
    cx.definitions[local] = value;
    Stmt stmt = statement(StmtOp::let, span_);
    stmt.local = local;
    stmt.value = value;
    append(std::move(stmt));
    return local;
}

ExprId Expander::named(const std::string& name, ExprId value) {
    if (is_trivial(cx, value)) return value;
    if (is_uniform(cx, value)) {
        cx.name(value, name);
        return value;
    }
    return build.local(let(name, value, span_));
}

void Expander::note_name(ExprId value, Name name) {
    if (const ExprId load = guarded_load_of(value)) value = load;
    if (namings_ != nullptr) namings_->push_back({value, name, !frame_->prefix.empty()});
    else cx.name(value, prefixed((*p.names)[name]));
}

/// The guarded_load that is the value of a local; absent if `value` is anything else.
ExprId Expander::guarded_load_of(ExprId value) const {
    const Expr& node = p.exprs[value];
    const ExprId* definition = node.op == Op::local ? cx.definitions.find(node.local) : nullptr;
    return definition != nullptr && p.exprs[*definition].op == Op::guarded_load ? *definition : ExprId{};
}

LocalId Expander::variable(const std::string& name, TypeId type, ExprId value) {
    LocalId local = cx.new_local(name, type, span_, true);
    Stmt stmt = statement(StmtOp::let, span_);
    stmt.local = local;
    stmt.value = value;
    append(std::move(stmt));
    return local;
}

void Expander::assign(LocalId local, ExprId value) {
    Stmt stmt = statement(StmtOp::assign, span_);
    stmt.target = build.local(local);
    stmt.value = value;
    append(std::move(stmt));
}

void Expander::append_if(ExprId condition, Block yes, Block no) {
    Stmt stmt = statement(StmtOp::if_, span_);
    stmt.value = condition;
    stmt.body = std::move(yes);
    stmt.otherwise = std::move(no);
    append(std::move(stmt));
}

Pair Expander::of_optional(ExprId whole) {
    if (p.exprs[whole].op == Op::none) return {build.zero(p.types[build.type(whole)].element), build.truth(false)};
    if (p.exprs[whole].op == Op::some) return {p.exprs[whole].operands[0], build.truth(true)};
    if (!is_trivial(cx, whole)) whole = build.local(let(prefixed("found"), whole, span_));
    Expr has;
    has.op = Op::has_value;
    has.type = p.types.bool_;
    has.operands = {whole};
    Expr value;
    value.op = Op::value;
    value.type = p.types[build.type(whole)].element;
    value.operands = {whole};
    return {p.exprs.add(std::move(value)), p.exprs.add(std::move(has))};
}

ExprId Expander::stored(const Pair& pair, TypeId type) {
    if (p.types.kind(type) != TypeKind::optional || !pair.has) return pair.value;
    const Expr& has = p.exprs[pair.has];
    const Expr& value = p.exprs[pair.value];
    if (has.op == Op::has_value && value.op == Op::value && has.operands[0] == value.operands[0])
        return has.operands[0];
    Expr some;
    some.op = Op::some;
    some.type = type;
    some.operands = {pair.value};
    return build.select(pair.has, p.exprs.add(std::move(some)), build.zero(type));
}

/// Whether the expression, which is not lowered yet, does more than give a value: it contains a call that is expanded
/// as statements, an atomic operation, or an operation on values of several invocations.
static bool has_effect(const Program& p, ExprId id) {
    bool found = false;
    for_each_node(p, id, [&](ExprId part) {
        const Expr& node = p.exprs[part];
        if (node.op == Op::call) found = found || p.functions[node.function].is_statements();
        if (node.op == Op::intrinsic)
            found = found || signature_of(node.intrinsic)[0] == '@' || is_collective(node.intrinsic);
    });
    return found;
}

/// Whether this is an atomic operation on an element of workgroup memory.
static bool is_workgroup_atomic(const Program& p, const Expr& node) {
    return node.op == Op::intrinsic && signature_of(node.intrinsic)[0] == '@' &&
           place_of(p, node.operands[0]).op != Op::read;
}

/// The result is a local, so that simplifications cannot leave out the operation.
Pair Expander::workgroup_atomic(ExprId id, const Expr& node) {
    const Pair result = expand_again(id, node);
    if (node.type == p.types.void_) return result;
    return {build.local(let(prefixed("before"), result.value, node.span)), {}};
}

void Expander::expand_effects(ExprId id) {
    if (!has_effect(p, id)) return;
    const Pair value = expand(id);
    for (ExprId part : {value.value, value.has}) {
        if (!part || numbers_.is_pure(part)) continue;
        Stmt alone = statement(StmtOp::evaluate, span_);
        alone.value = part;
        append(std::move(alone));
    }
}

/// An expression of an empty type (ir/empty.h): its value is known, but its effects must happen.
Pair Expander::expand_empty(ExprId id) {
    const Expr node = p.exprs[id];
    if (!has_effect(p, id)) return {build.zero(node.type), {}};
    if (node.op == Op::call && p.functions[node.function].is_statements()) return expand_call(node);
    if (node.op == Op::select) {
        const ExprId condition = value_of(node.operands[0]);
        Block yes = collect([&] { expand_effects(node.operands[1]); });
        Block no = collect([&] { expand_effects(node.operands[2]); });
        append_if(condition, std::move(yes), std::move(no));
    } else {
        for (ExprId operand : node.operands) expand_effects(operand);
    }
    return {build.zero(node.type), {}};
}

// long: one switch over the operations
Pair Expander::expand(ExprId id) {
    if (p.exprs.size() - cx.first_expr.index > most_nodes) throw KernelTooLarge{span_};
    const Expr& node = p.exprs[id];
    if (is_empty(p, node.type)) return expand_empty(id);
    switch (node.op) {
    case Op::constant: return {id, {}};
    case Op::local: return expand_local(node);
    case Op::select: return expand_select(node);
    case Op::binary:
        if (node.binary == BinaryOp::logical_and || node.binary == BinaryOp::logical_or) return expand_logical(node);
        return expand_again(id, node);
    case Op::none: return {build.zero(p.types[node.type].element), build.truth(false)};
    case Op::some: return {value_of(node.operands[0]), build.truth(true)};
    case Op::has_value: return {expand(node.operands[0]).has, {}};
    case Op::value: return {expand(node.operands[0]).value, {}};
    case Op::call: return expand_call(node);
    case Op::element: return {element(resolved(node.place).root, node.span), {}};
    case Op::address: return {centre_address(resolved(node.place).root), {}};
    case Op::near: return {near(node), {}};
    case Op::read: {
        Place place = resolved(node.place);
        if (node.type != cx.structure_at(place).element) return {several(node), {}};
        ExprId address = value_of(node.operands[0]);
        if (checks_range(place)) address = named(cx.name_of(place) + "_address", address);
        check_range(place, address, Access::read, node.span);
        ExprId value = read(place, address, cx.name_of(place));
        if (!is_coherent(place)) return {value, {}};
        return {build.local(let(cx.name_of(place) + "_seen", value, node.span)), {}};  // load here, not at the use
    }
    case Op::intrinsic:
        if (signature_of(node.intrinsic)[0] == '@' && place_of(p, node.operands[0]).op == Op::read) return atomic(node);
        if (is_workgroup_atomic(p, node)) return workgroup_atomic(id, node);
        return expand_again(id, node);
    case Op::sample: return {sample(node), {}};
    case Op::gather: return {gather(node), {}};
    case Op::compare: return {compare(node), {}};
    case Op::member: return {expand_member(node), {}};
    case Op::host_state:
    case Op::memory_extent: {
        Expr extent = node;
        extent.place = canonical(resolved(node.place));
        return {p.exprs.add(std::move(extent)), {}};
    }
    case Op::domain: return {domain_of(resolved(node.place)), {}};
    case Op::position: return {cx.kernel.space ? relative_address() : build.local(cx.pass.address), {}};
    case Op::window: return {window(), {}};
    case Op::front_facing: return {build.builtin(Builtin::is_front, p.types.bool_), {}};
    case Op::state: {
        Frame frame;
        frame.places = {frame_->structure};
        ExprId state = frame_->stage->scalars[node.slot];
        return inside(std::move(frame), [&] { return expand(state); });
    }
    case Op::translate: {
        Place place = resolved(node.place);
        ExprId address = named(cx.name_of(place) + "_address", value_of(node.operands[0]));
        const ExprId at = from_origin(place, address);
        const Pair physical = linked(place, at, cx.name_of(place));
        ExprId guard = is_total(cx.structure_at(place)) ? inside_domain(place, address) : ExprId{};
        ExprId has = build.both(guard, translated(place, at, cx.name_of(place)).has);
        const TypeId seen = p.types[node.type].element;  // the type in the language: 32 bits even in wide passes
        return {build.convert(seen, physical.value), has ? has : build.truth(true)};
    }
    case Op::invocation: return {expand_invocation(node), {}};
    case Op::construct:
    case Op::convert:
    case Op::unary:
    case Op::swizzle:
    case Op::index:
    case Op::field: return expand_again(id, node);
#define MEMORY_OPERATION(name) case Op::name:
#include "ir/operations.def"
        return {id, {}};
#define HOST_OPERATION(name) case Op::name:
#define GUARDED_OPERATION(name) case Op::name:
#define CPU_OPERATION(name) case Op::name:
#include "ir/operations.def"
        misplaced(node.op, "lower");
    }
    return {build.zero(node.type), {}};
}

Pair Expander::expand_local(const Expr& node) {
    if (const Pair* found = frame_->locals.find(node.local)) return *found;
    // Not in the frame: a value parameter of the kernel, workgroup memory of the kernel or of a function, and in a draw
    // what its parts pass to or get from the rasteriser (place, varyings, clip distances, colours, depth).
    return {without_empty(build.local(node.local)), {}};
}

/// A value parameter or constructor argument without its empty parts (ir/empty.h), which are not in the parameter
/// block: if its type has such parts, the value is constructed anew from its other parts and zeros of the empty types.
ExprId Expander::without_empty(ExprId whole) {
    const TypeId id = build.type(whole);
    const Type type = p.types[id];
    if (is_empty(p, id)) return build.zero(id);
    if (!holds_empty(p, id) || type.kind == TypeKind::optional) return whole;
    Operands parts;
    std::size_t count = type.kind == TypeKind::array ? type.count : p.structs[type.struct_].fields.size();
    for (std::uint32_t i = 0; i < count; ++i)
        parts.push_back(
            without_empty(type.kind == TypeKind::array ? build.index(whole, build.uint(i)) : build.field(whole, i)));
    return build.construct(id, std::move(parts));
}

Pair Expander::expand_again(ExprId id, const Expr& node) {
    Operands operands;
    bool same = true;
    for (ExprId operand : node.operands) {
        const ExprId value = stored(expand(operand), build.type(operand));
        same = same && value == operand;
        operands.push_back(value);
    }
    const bool divides =
        node.op == Op::binary && (node.binary == BinaryOp::divide || node.binary == BinaryOp::remainder);
    if (divides) operands[1] = divisor(operands[1]);
    ExprId result =
        same && !node.operands.empty() && build.is_constant(id) ? id : build.again(node, std::move(operands));
    if (p.types.kind(node.type) == TypeKind::optional) return of_optional(result);
    return {result, {}};
}

Pair Expander::expand_select(const Expr& node) {
    ExprId condition = value_of(node.operands[0]);
    if (build.is_true(condition)) return expand(node.operands[1]);
    if (build.is_false(condition)) return expand(node.operands[2]);
    Pair a, b;
    Block yes = collect([&] { a = expand(node.operands[1]); });
    Block no = collect([&] { b = expand(node.operands[2]); });
    return merged(condition, std::move(yes), a, std::move(no), b, node.type);
}

Pair Expander::expand_logical(const Expr& node) {
    bool is_and = node.binary == BinaryOp::logical_and;
    ExprId left = value_of(node.operands[0]);
    if (is_and ? build.is_false(left) : build.is_true(left)) return {left, {}};
    ExprId right;
    Block block = collect([&] { right = value_of(node.operands[1]); });
    if (is_speculatable(block)) {
        out_->insert(out_->end(), block.begin(), block.end());
        return {build.binary(node.binary, left, right), {}};
    }
    LocalId result = variable(prefixed(is_and ? "both" : "either"), p.types.bool_, left);
    Block inner = std::move(block);
    Block last = collect([&] { assign(result, right); });
    inner.insert(inner.end(), last.begin(), last.end());
    ExprId known = build.local(result);
    append_if(is_and ? known : build.negate(known), std::move(inner), {});
    return {build.local(result), {}};
}

/// A constructor argument of a structure; a constant if the structure that makes it passes a constant.
ExprId Expander::expand_member(const Expr& node) {
    Place place = canonical(resolved(node.place));
    if (!place.members.empty()) {
        Place owner{place.root, {place.members.begin(), place.members.end() - 1}};
        const MemberStructure& member = cx.structure_at(owner).members[place.members.back()];
        if (!member.by_reference && node.slot < member.arguments.size()) {
            if (auto value = evaluate(p, member.arguments[node.slot])) {
                // It is computed in 64 bits (widen.h). What fits has the type that the source says.
                const auto fits = [](const Lane& lane) { return lane.bits <= 0xffffffffu; };
                if (p.types.scalar_of(node.type) == p.types.uint && std::ranges::all_of(value->lanes, fits))
                    value->type = node.type;
                return materialize(p, *value, node.span);
            }
        }
    }
    Expr leaf = node;
    leaf.place = place;
    return without_empty(p.exprs.add(std::move(leaf)));
}

ExprId Expander::expand_invocation(const Expr& node) {
    const auto& group = cx.pass.group;
    TypeId uint = p.types.uint, uint3 = p.types.vector(uint, 3);
    ExprId id = build.builtin(Builtin::group_id, uint3), count = build.builtin(Builtin::group_count, uint3);
    auto part = [&](ExprId vector, std::uint32_t lane) { return build.component(vector, lane); };
    switch (node.invocation) {
    case Invocation::local_index: return build.builtin(Builtin::local_index, uint);
    case Invocation::group_index: {
        // Linear over the grid. In one dimension too: there the workgroups may continue in rows along y.
        ExprId row = build.add(build.multiply(part(id, 1), part(count, 0)), part(id, 0));
        if (cx.pass.rank < 3) return row;
        return build.add(build.multiply(part(id, 2), build.multiply(part(count, 0), part(count, 1))), row);
    }
    case Invocation::group_count: {
        ExprId total = build.uint(1);
        for (std::uint32_t axis = 0; axis < std::min(cx.pass.rank, 3u); ++axis) {
            const std::uint32_t width = group[axis] * cx.pass.items;
            ExprId size = build.component(cx.size, axis);
            // The third and the fourth axis are one axis of the dispatch.
            if (axis == 2 && cx.pass.rank == 4) size = build.multiply(size, build.component(cx.size, 3));
            ExprId up = build.add(size, build.uint(width - 1));
            total = build.multiply(total, build.binary(BinaryOp::divide, up, build.uint(width)));
        }
        return total;
    }
    case Invocation::group_size: return build.uint(std::uint64_t{group[0]} * group[1] * group[2]);
    case Invocation::subgroup_size: return build.builtin(Builtin::subgroup_size, uint);
    case Invocation::subgroup_lane: return build.builtin(Builtin::subgroup_lane, uint);
    case Invocation::subgroup_index: return build.builtin(Builtin::subgroup_index, uint);
    case Invocation::subgroup_count: return build.builtin(Builtin::subgroup_count, uint);
    }
    return build.uint(0);
}

}  // namespace gliftc::lower
