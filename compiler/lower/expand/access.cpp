// Expander: reads, writes and atomic operations on elements. Makes the address, the guard (the condition under which
// the access is allowed), and the load, store or atomic operation.
#include "ir/chain.h"
#include "ir/walk.h"
#include "lower/analysis/aliasing.h"
#include "lower/expand/expand.h"
#include "lower/expand/memory.h"

#include <algorithm>
#include <cstdlib>
#include <ranges>

namespace gliftc::lower {

using namespace ir;

std::uint32_t Expander::binding(const Place& of_structure, Access access, std::optional<Compare> compare,
                                bool by_direction) {
    const Structure& structure = cx.structure_at(of_structure);
    const Structure& root = root_structure(p, structure);
    const std::vector<std::uint32_t> fields = fields_in(p, structure, root);
    if (!root.apart) return bound(of_structure, root.via_memory, fields, access, compare, by_direction);
    const auto own = std::ranges::find(root.memories, fields, &Memory::fields);
    return bound(of_structure, static_cast<std::uint32_t>(own - root.memories.begin()), {}, access);
}

/// The binding of one of the memories of the root of the structure at the place; `fields` lead to the part of each
/// element that is accessed.
std::uint32_t Expander::bound(const Place& of_structure, std::uint32_t memory, const std::vector<std::uint32_t>& fields,
                              Access access, std::optional<Compare> compare, bool by_direction) {
    auto& bindings = cx.pass.bindings;
    Place place = root_of(p, cx.structure_at(of_structure), of_structure);
    place.members = made_at(p, cx.structure_at({place.root, {}}), {place.members.begin(), place.members.end()});
    // Elements have a binding for each parameter; what translates their addresses has one for all that are of one
    // whole.
    const bool is_of_elements = place == root_of(p, cx.structure_at({place.root, {}}), {place.root, {}});
    if (!is_of_elements && is_of_one_whole(place.root)) place = canonical(place);
    const Memory& of = cx.structure_at(place).memories[memory];
    const MemoryShape shape =
        of.shape == MemoryShape::imagecube && !by_direction ? MemoryShape::image2darray : of.shape;
    for (std::uint32_t i = 0; i < bindings.size(); ++i) {
        if (bindings[i].place != place || bindings[i].memory != memory) continue;
        if (bindings[i].compare != compare || bindings[i].shape != shape) continue;
        if (bindings[i].access != access) bindings[i].access = Access::read_write;
        auto& known = bindings[i].fields;  // what both accesses have in common
        known.erase(std::ranges::mismatch(known, fields).in1, known.end());
        return i;
    }
    PassBinding made;
    made.name = cx.name_of(place) + "_" + (*p.names)[of.name] + (compare ? "_compared" : by_direction ? "_cube" : "");
    made.place = place;
    made.memory = memory;
    made.shape = shape;
    made.element = of.element;
    made.fields = fields;
    made.format = of.format;
    made.coherent = is_coherent(of_structure);
    made.access = made.coherent ? Access::read_write : access;
    // Devices cannot filter integers, and need not support filtering of depths.
    made.linear = of.linear && of.format != Format::d32 && p.types.scalar_of(of.element) == p.types.float_;
    if (compare) {
        made.linear = true;
        made.compare = compare;
    }
    made.one_place = first_of_place(cx, made);
    bindings.push_back(std::move(made));
    return static_cast<std::uint32_t>(bindings.size() - 1);
}

/// Loads, once and at the start of the body, the kernel's arguments that are values in device memory
/// (Pattern::argument).
void Expander::read_arguments() {
    for (std::uint32_t i = 0; i < cx.kernel.params.size(); ++i) {
        const KernelParam& param = cx.kernel.params[i];
        if (param.pattern != Pattern::argument) continue;
        const std::string name = cx.name_of({i, {}});
        const ExprId index = cx.parameter_expr(cx.parameter(ParameterSource::index, name + "_index", p.types.uint, i));
        const ExprId value = load_from(cx, binding({i, {}}, Access::read), index);
        frame_->locals[param.local] = {build.local(let(name, value, param.span)), {}};
    }
}

/// Whether the elements of the structure at the place lie in memory that the pass accesses as coherent by the parameter
/// that the place begins at: the parameter is `coherent`, and they are its elements; or it is `calls`, and a function
/// called through it has coherent access to them.
bool Expander::is_coherent(const Place& place) const {
    const auto is_memory_of = [&](const Place& shared) {
        return root_of(p, cx.structure_at(place), place) == root_of(p, cx.structure_at(shared), shared);
    };
    if (cx.kernel.params[place.root].pattern == Pattern::coherent) return is_memory_of({place.root, {}});
    return std::ranges::any_of(cx.kernel.effects, [&](const Effect& effect) {
        return effect.pattern == Pattern::coherent && effect.place.root == place.root && is_memory_of(effect.place);
    });
}

/// The target of an atomic operation: a copy of `part`, which is an element or a part of one (field, component, array
/// item), with the load `element` in place of the read of that element.
ExprId Expander::part_of(ExprId part, ExprId element) {
    Expr node = p.exprs[part];
    if (node.op == Op::read) return element;
    node.operands[0] = part_of(node.operands[0], element);
    for (std::size_t i = 1; i < node.operands.size(); ++i) node.operands[i] = value_of(node.operands[i]);
    return p.exprs.add(std::move(node));
}

/// An atomic operation on an element of a structure that is accessed as coherent. Outside the domain and at an unmapped
/// address it does nothing and gives zero, if it has a result.
Pair Expander::atomic(const Expr& node) {
    const Expr target = place_of(p, node.operands[0]);
    Place place = resolved(target.place);
    const std::string name = cx.name_of(place);
    ExprId address = named(name + "_address", value_of(target.operands[0]));
    Expr made = node;
    for (std::size_t i = 1; i < node.operands.size(); ++i) made.operands[i] = value_of(node.operands[i]);
    check_range(place, address, Access::read_write, node.span);
    Pair physical = written(place, named(name + "_virtual", from_origin(place, address)), name);
    ExprId inside = build.both(inside_domain(place, address), physical.has);
    const std::uint32_t slot = binding(place, Access::read_write);
    cx.pass.bindings[slot].atomic = true;
    made.operands[0] = part_of(node.operands[0], projected(place, load_from(cx, slot, physical.value)));
    if (node.type == p.types.void_) {
        Stmt stmt = statement(StmtOp::evaluate, node.span);
        stmt.value = p.exprs.add(std::move(made));
        append_if(inside ? inside : build.truth(true), collect([&] { append(std::move(stmt)); }), {});
        return {};
    }
    if (!inside || build.is_true(inside))
        return {build.local(let(name + "_before", p.exprs.add(std::move(made)), node.span)), {}};
    LocalId before = variable(name + "_before", node.type, build.zero(node.type));
    append_if(inside, collect([&] { assign(before, p.exprs.add(std::move(made))); }), {});
    return {build.local(before), {}};
}

/// The element of a structure, made of its fields.
template <class FieldOf> ExprId Expander::gathered(const Place& place, FieldOf&& field_of) {
    const Structure& structure = cx.structure_at(place);
    return gathered_fields(place, structure.element, fields_in(p, structure, root_structure(p, structure)), field_of);
}

/// An element of a structure whose chain of memories (ir/chain.h) ends in a view: evaluates the view at `address` if
/// `condition` holds (absent: always), else gives `otherwise`.
ExprId Expander::computed(const Place& place, ExprId address, ExprId condition, ExprId otherwise,
                          const std::string& name) {
    const Place root = root_of(p, cx.structure_at(place), place);
    if (!condition || build.is_true(condition)) return projected(place, view(root, address));
    LocalId value = variable(name, build.type(otherwise), otherwise);
    append_if(condition, collect([&] { assign(value, projected(place, view(root, address))); }), {});
    return build.local(value);
}

/// What the structure at the place has of an element of `link`, a structure of its chain: that element or, if there are
/// components, a field of it.
ExprId Expander::projected(const Place& place, const Structure& link, ExprId element) {
    return build.field_along(element, fields_in(p, cx.structure_at(place), link));
}

ExprId Expander::projected(const Place& place, ExprId element) {
    return projected(place, root_structure(p, cx.structure_at(place)), element);
}

ExprId Expander::load(const Place& place, ExprId physical) {
    if (!is_apart(place)) return projected(place, load_from(cx, binding(place, Access::read), physical));
    return gathered(place, [&](std::uint32_t memory, const std::string&, const auto&) {
        return load_from(cx, bound(place, memory, {}, Access::read), physical);
    });
}

/// Whether the fields of the elements lie in memories of their own.
bool Expander::is_apart(const Place& place) const { return bool(root_structure(p, cx.structure_at(place)).apart); }

/// An element, or the part of it that the fields `above` lead to, made of its fields, which lie in memories of their
/// own. field_of(memory, name, path) gives the field in that memory: `path` leads to it from the part, `name` is its
/// name behind the part's.
template <class FieldOf> ExprId Expander::gathered_fields(const Place& place, TypeId whole,
                                                          const std::vector<std::uint32_t>& above, FieldOf&& field_of) {
    const Structure& root = root_structure(p, cx.structure_at(place));
    std::uint32_t next = 0;
    while (!std::ranges::equal(above, root.memories[next].fields | std::views::take(above.size()))) ++next;
    std::vector<std::uint32_t> path;
    const auto gather = [&](auto&& self, TypeId type, const std::string& name) -> ExprId {
        if (p.types.kind(type) != TypeKind::struct_) return field_of(next++, name, path);
        const std::vector<StructField> fields = p.structs[p.types[type].struct_].fields;
        Operands parts;
        for (std::uint32_t i = 0; i < fields.size(); ++i) {
            path.push_back(i);
            parts.push_back(self(self, fields[i].type, name + "_" + (*p.names)[fields[i].name]));
            path.pop_back();
        }
        return build.construct(type, std::move(parts));
    };
    return gather(gather, whole, "");
}

/// The value of reads at unmapped addresses: that of the first structure with an `otherwise` in the chain of memories
/// (ir/chain.h), else zero.
ExprId Expander::otherwise_of(const Place& place) {
    const std::optional<Place> says = says_otherwise(p, cx.structure_at(place), place);
    if (!says) return build.zero(cx.structure_at(place).element);
    Frame frame;
    frame.places = {canonical(*says)};
    const Structure& link = cx.structure_at(*says);
    return projected(place, link, inside(std::move(frame), [&] { return value_of(link.otherwise); }));
}

/// As otherwise_of, for reads of the current element and its neighbours. In kernels with a group, invocations beyond
/// the range get zero.
ExprId Expander::otherwise_around(const Place& place) {
    const ExprId otherwise = otherwise_of(place);
    if (!cx.kernel.grouped() || !says_otherwise(p, cx.structure_at(place), place)) return otherwise;
    return build.select(build.local(cx.pass.in_range), otherwise, build.zero(build.type(otherwise)));
}

/// Loads the element if `guard` and the translation's condition `physical.has` hold (absent: true), else gives
/// `otherwise`. `safe_address` must be a physical address in the memory; absent: address zero.
ExprId Expander::guarded_load(const Place& place, const Pair& physical, ExprId guard, ExprId safe_address,
                              ExprId otherwise, const std::string& name) {
    ExprId condition = build.both(guard, physical.has);
    if (is_computed(p, cx.structure_at(place))) return computed(place, physical.value, condition, otherwise, name);
    if (!condition || build.is_true(condition)) return load(place, physical.value);
    if (build.is_false(condition)) return otherwise;
    condition = named(name + "_inside", condition);
    const ExprId at =
        is_trivial(cx, physical.value) ? physical.value : build.local(let(name + "_at", physical.value, span_));
    const Structure& structure = cx.structure_at(place);
    const ExprId safe = safe_address ? safe_address : build.zero(build.type(at));
    const auto guarded = [&](std::uint32_t slot, ExprId else_value, const std::string& called) {
        Expr node;
        node.op = Op::guarded_load;
        node.type = cx.pass.bindings[slot].element;
        node.slot = slot;
        node.operands = {condition, at, safe, else_value};
        return build.local(let(called, p.exprs.add(std::move(node)), span_));
    };
    if (is_apart(place))
        return gathered(place, [&](std::uint32_t memory, const std::string& field, const auto& path) {
            return guarded(bound(place, memory, {}, Access::read), build.field_along(otherwise, path), name + field);
        });
    if (!fields_in(p, structure, root_structure(p, structure)).empty())
        return guarded_field(place, {at, condition}, safe, otherwise, name);
    return guarded(binding(place, Access::read), otherwise, name);
}

/// As guarded_load, of a field of what the memory holds (a component): as the pass "guard" does it for whole elements.
ExprId Expander::guarded_field(const Place& place, const Pair& at, ExprId safe, ExprId otherwise,
                               const std::string& name) {
    const TypeId type = cx.structure_at(place).element;
    if (cx.kernel.grouped() || !(p.types.is_scalar(type) || p.types.is_vector(type))) {
        const LocalId value = variable(name, type, otherwise);
        append_if(at.has, collect([&] { assign(value, load(place, at.value)); }), {});
        return build.local(value);
    }
    const ExprId there = build.local(let(name, load(place, build.select(at.has, at.value, safe)), span_));
    return build.select(at.has, there, otherwise);
}

ExprId Expander::view(const Place& place, ExprId address) {
    const Structure& structure = cx.structure_at(place);
    Frame frame;
    frame.places = {place};
    frame.prefix = cx.name_of(place);
    std::vector<Pair> arguments{{address, {}}};
    return within([&] {
        if (inline_sizes_.of(structure.at)) return inlined(structure.at, std::move(arguments), std::move(frame)).value;
        return call_instance(structure.at, std::move(arguments), std::move(frame)).value;
    });
}

/// The element of a view at `address`, that of the current element or of a neighbour. In kernels with a group,
/// invocations beyond the range get zero.
ExprId Expander::view_around(const Place& place, ExprId address) {
    if (!cx.kernel.grouped()) return view(place, address);
    TypeId type = cx.structure_at(place).element;
    LocalId value = variable(cx.name_of(place) + "_value", type, build.zero(type));
    append_if(build.local(cx.pass.in_range), collect([&] { assign(value, view(place, address)); }), {});
    return build.local(value);
}

ExprId Expander::element(std::uint32_t root, Span) {
    Place place{root, {}};
    if (cx.structure_at(place).at) return view_around(place, centre_address(root));
    ExprId guard = cx.kernel.grouped() ? build.local(cx.pass.in_range) : ExprId{};
    ExprId value = guarded_load(place, centre(root), guard, {}, otherwise_around(place), cx.name_of(place) + "_value");
    const bool is_read_only = cx.kernel.params[root].direction == Direction::in && !may_be_written_elsewhere(cx, root);
    if (is_read_only || p.exprs[value].op == Op::local) return value;
    // The memory may also be written: a `let` keeps the load from moving past a store.
    return build.local(let(cx.name_of(place) + "_value", value, span_));
}

ExprId Expander::read(const Place& place, ExprId address, const std::string& name) {
    const Structure& structure = cx.structure_at(place);
    address = named(name + "_address", address);
    ExprId virtual_address = named(name + "_virtual", from_origin(place, address));
    if (structure.at) return view(place, virtual_address);
    Pair physical = translated(place, virtual_address, name);
    ExprId guard = is_total(structure) ? inside_domain(place, address) : ExprId{};
    ExprId value = guarded_load(place, physical, guard, {}, otherwise_of(place), name + "_value");
    if (cx.kernel.params[place.root].direction == Direction::in || p.exprs[value].op == Op::local) return value;
    return build.local(let(name + "_value", value, span_));
}

std::optional<std::vector<std::int64_t>> Expander::offset_of(const Expr& node) {
    ExprId offset = value_of(node.operands[0]);
    if (!build.is_constant(offset)) {
        auto& report = cx.diagnostics.report(Diag::near_offset, node.span,
                                             {(*p.names)[cx.kernel.params[resolved(node.place).root].name]});
        report.notes.push_back({{},
                                "make the offset a constant, or loop over constant bounds without break or continue; "
                                "for offsets known only when the kernel runs, take the structure as any<…>"});
        return std::nullopt;
    }
    auto value = evaluate(p, offset);
    if (!value) return std::nullopt;
    std::vector<std::int64_t> result;
    result.reserve(value->lanes.size());
    const KernelParam& param = cx.kernel.params[resolved(node.place).root];
    Radius reached = param.radius;
    for (std::size_t axis = 0; axis < value->lanes.size(); ++axis) {
        const auto part = static_cast<std::int64_t>(value->lanes[axis].bits);
        result.push_back(part);
        if (std::abs(part) <= static_cast<std::int64_t>(param.radius.along[axis])) continue;
        reached.along[axis] = static_cast<std::uint32_t>(std::abs(part));
        const auto axes = static_cast<std::uint32_t>(value->lanes.size());
        auto& report = cx.diagnostics.report(
            Diag::near_radius, node.span,
            {std::to_string(part), (*p.names)[param.name], std::to_string(param.radius.along[axis])});
        if (param.radius.is_even()) reached.along.fill(reached.along[axis]);
        report.notes.push_back(
            {param.span, "declare the radius that the kernel reaches: near<…, " + to_text(reached, axes) + ">"});
        return std::nullopt;
    }
    return result;
}

/// The condition that the neighbour at `offset` is in the domain, if the current element is in it: only those sides of
/// the domain are tested towards which the offset points.
ExprId Expander::near_guard(std::uint32_t root, const std::vector<std::int64_t>& offset) {
    ExprId address = centre_address(root), domain = domain_of({root, {}}), guard;
    for (std::uint32_t axis = 0; axis < offset.size(); ++axis) {
        if (offset[axis] == 0) continue;
        ExprId at = build.component(address, axis);
        ExprId inside =
            offset[axis] < 0
                ? build.binary(BinaryOp::greater_equal, at, build.uint(static_cast<std::uint64_t>(-offset[axis])))
                : build.binary(BinaryOp::less, build.add(at, build.uint(static_cast<std::uint64_t>(offset[axis]))),
                               build.component(domain, axis));
        if (axis == 1 && offset[axis] > 0)
            row_guards.push_back({inside, at, build.component(domain, axis), offset[axis]});
        guard = build.both(guard, inside);
    }
    return guard;
}

namespace {

std::string offset_name(const std::vector<std::int64_t>& offset) {
    std::string name;
    for (std::size_t axis = 0; axis < offset.size(); ++axis) {
        if (offset[axis] == 0) continue;
        name +=
            std::string("_") + "xyzw"[axis] + (offset[axis] < 0 ? "m" : "p") + std::to_string(std::abs(offset[axis]));
    }
    return name;
}

}  // namespace

/// Notes that a near parameter needs guards. An interior variant is made only if the domains of all such parameters are
/// equal.
void Expander::note_near_guard(std::uint32_t root) {
    has_near_guards = true;
    if (near_root == root) return;
    if (near_root) {
        near_domains_agree = near_domains_agree && numbers_.of(near_domain) == numbers_.of(domain_of({root, {}}));
        return;
    }
    near_root = root;
    near_domain = domain_of({root, {}});
}

/// The fields that a path of members leads to, if all of them are components; else none.
std::vector<std::uint32_t> Expander::fields_along(const Place& place) const {
    std::vector<std::uint32_t> fields;
    const Structure* at = &cx.structure_at({place.root, {}});
    for (std::uint32_t member : place.members) {
        if (!at->members[member].is_component) return {};
        at = &p.structures[at->members[member].structure];
        fields.push_back(*at->field);
    }
    return fields;
}

/// A component of a neighbour is read as a field of it.
ExprId Expander::near(const Expr& node) {
    Place place = resolved(node.place);
    const std::vector<std::uint32_t> fields = fields_along(place);
    if (!fields.empty()) place.members = {};
    const auto offset = offset_of(node);
    if (!offset) return build.zero(node.type);
    if (++near_reads > most_near_reads) throw TooManyNearReads{node.span, place.root};
    return build.field_along(near_at(place, *offset, node.span), fields);
}

ExprId Expander::near_at(const Place& place, const std::vector<std::int64_t>& offset, Span span) {
    if (Halo* halo = halo_of(place.root)) return in_halo(*halo, offset);
    const bool is_centre = std::ranges::all_of(offset, [](std::int64_t part) { return part == 0; });
    const ExprId value = is_centre ? element(place.root, span) : neighbour(place, offset);
    const bool may_copy =
        near_offsets && cx.kernel.space && (is_centre || (is_at_multiples() && !may_map_outside(place.root)));
    if (may_copy) (*near_offsets)[place.root].insert(offset);
    if (out_ == top_) near_values.push_back({place.root, offset, value});
    return value;
}

ExprId Expander::neighbour(const Place& place, const std::vector<std::int64_t>& offset) {
    TypeId address_type = build.type(centre_address(place.root));
    Operands parts;
    for (std::int64_t part : offset) parts.push_back(build.uint(static_cast<std::uint32_t>(part)));
    ExprId step = parts.size() == 1 ? parts[0] : build.construct(address_type, std::move(parts));
    ExprId address = build.add(centre_address(place.root), step);
    const Structure& structure = cx.structure_at(place);
    if (structure.at) return view_around(place, address);
    std::string name = cx.name_of(place) + offset_name(offset);
    if (const std::optional<Pair> found = beside(place, offset))
        return guarded_load(place, *found, {}, {}, otherwise_around(place), name);
    Pair middle = centre(place.root);
    Pair physical = translated(place, address, name);
    bool asks = is_total(structure);
    physical.has = without_inside(place.root, physical.has, address, asks);
    ExprId guard;
    if (asks) note_near_guard(place.root);
    if (asks && guards_ != Guards::interior) guard = near_guard(place.root, offset);
    if (cx.kernel.grouped()) guard = build.both(build.local(cx.pass.in_range), guard);
    ExprId other = middle.has || cx.kernel.grouped() ? ExprId{} : middle.value;
    return guarded_load(place, physical, guard, other, otherwise_around(place), name);
}

void Expander::store(const Place& place, const Pair& physical, ExprId guard, const Stmt& stmt, ExprId value) {
    const Structure& structure = cx.structure_at(place);
    const bool is_buffer = root_memory(p, structure).shape == MemoryShape::buffer;
    const bool is_atomic = stmt.combine != Combine::replace;
    const Access access = is_atomic ? Access::read_write : Access::write;
    const auto stored_to = [&](std::uint32_t slot, ExprId what) {
        Stmt made = statement(is_atomic ? StmtOp::atomic : is_buffer ? StmtOp::store : StmtOp::image_store, stmt.span);
        made.slot = slot;
        if (is_atomic) {
            PassBinding& of = cx.pass.bindings[made.slot];
            of.atomic = true;
            of.ordered = of.ordered || (of.element == p.types.float_ && stmt.combine != Combine::add);
        }
        made.target = index_of(cx, made.slot, physical.value);
        made.value = what;
        made.combine = stmt.combine;
        return made;
    };
    const ExprId condition = build.both(guard, physical.has);
    if (condition && build.is_false(condition)) return;
    std::vector<std::uint32_t> written = fields_in(p, structure, root_structure(p, structure));
    written.insert(written.end(), stmt.path.begin(), stmt.path.end());
    const Block stores = collect([&] {
        if (is_apart(place)) {
            const ExprId whole = named(cx.name_of(place) + "_stored", value);
            gathered_fields(place, build.type(whole), written,
                            [&](std::uint32_t memory, const std::string&, const auto& path) {
                                const ExprId field = build.field_along(whole, path);
                                append(stored_to(bound(place, memory, {}, access), field));
                                return field;
                            });
            return;
        }
        Stmt made = stored_to(binding(place, access), value);
        made.path = written;
        append(std::move(made));
    });
    append_where(condition, stores);
}

void Expander::set_element(const Stmt& stmt) {
    Place place = resolved(stmt.place);
    TypeId type = cx.structure_at(place).element;
    for (std::uint32_t field : stmt.path) type = p.structs[p.types[type].struct_].fields[field].type;
    ExprId value = stored(expand(stmt.value), type);
    ExprId guard = cx.kernel.grouped() ? build.local(cx.pass.in_range) : ExprId{};
    store(place, written_centre(place.root), guard, stmt, value);
}

void Expander::write(const Stmt& stmt) {
    Place place = resolved(stmt.place);
    const Structure& structure = cx.structure_at(place);
    if (build.type(stmt.value) != structure.element) return write_several(stmt);
    std::string name = cx.name_of(place);
    ExprId address = named(name + "_address", value_of(stmt.target));
    ExprId value = stored(expand(stmt.value), structure.element);
    check_range(place, address, stmt.combine == Combine::replace ? Access::write : Access::read_write, stmt.span);
    Pair physical = written(place, named(name + "_virtual", from_origin(place, address)), name);
    store(place, physical, inside_domain(place, address), stmt, value);
}

}  // namespace gliftc::lower
