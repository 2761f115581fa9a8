// Expander: translation of addresses, by the stages of `via` one after the other. The physical address of a parameter's
// current element (its "centre") is computed once, before the kernel's body.
#include "ir/chain.h"
#include "ir/effects.h"
#include "lower/expand/expand.h"

namespace gliftc::lower {

using namespace ir;

/// The address in the structure's own memory, which may be a structure: applies its translators.
Pair Expander::linked(const Place& place, ExprId address, const std::string& name) {
    Pair at{address, {}};
    for (const Stage& stage : cx.structure_at(place).via) {
        const bool is_affine = p.translators[stage.translator].properties.affine;
        Pair next = is_affine ? through_form(place, stage, at.value, name) : expanded(place, stage, at.value, name);
        at = {next.value, build.both(at.has, next.has)};
    }
    return at;
}

/// The address in the memory of the root of the structure at `place` (ir/chain.h): translates by the structure, then by
/// the structure that is its memory, and so on. asks(link, address) gives the condition that the memory of the
/// structure at `link` has the address.
template <class Asks> Pair Expander::chained(const Place& place, ExprId address, const std::string& name, Asks&& asks) {
    Place link = place;
    std::string at_link = name;
    Pair at{address, {}};
    while (true) {
        const Structure& structure = cx.structure_at(link);
        const Pair next = linked(link, at.value, at_link);
        at = {next.value, build.both(at.has, next.has)};
        const bool leads_to_view = structure.kind == StructureKind::computed && structure.base.empty();
        if (!is_contained(p, structure) && !leads_to_view) {
            // Not in kernels over blocks: some components depend on the block alone, a local of the vector would not.
            if (!cx.kernel.space) at.value = named(at_link + "_place", at.value);
            at.has = build.both(at.has, asks(link, at.value));
        }
        if (structure.base.empty()) return at;
        link = base_of(structure, link);
        at_link = name + "_" + link_name(link);
    }
}

Pair Expander::translated(const Place& place, ExprId address, const std::string& name) {
    return chained(place, address, name, [&](const Place& link, ExprId at) { return inside_memory(link, at); });
}

/// The physical address for a write: as translated(), but where the memory is a structure, addresses beyond its domain
/// count as unmapped, even if its translator maps them for reads (as an edge mode does).
Pair Expander::written(const Place& place, ExprId address, const std::string& name) {
    return chained(place, address, name, [&](const Place& link, ExprId at) {
        const Structure& structure = cx.structure_at(link);
        return structure.base.empty() ? inside_memory(link, at) : inside_domain(base_of(structure, link), at);
    });
}

/// The physical address for a write of the current element.
Pair Expander::written_centre(std::uint32_t root) {
    const Place place{root, {}};
    // `link` skips structures whose memory is a structure with the same addresses and domain: the element's address is
    // in that one's domain, too.
    Place link = place;
    while (cx.structure_at(link).via.empty() && !cx.structure_at(link).base.empty()) {
        const Place base = base_of(cx.structure_at(link), link);
        if (numbers_.of(domain_of(link)) != numbers_.of(domain_of(base))) break;
        link = base;
    }
    if (!leads_through_partial(p, cx.structure_at(link))) return centre(root);
    return written(place, centre_address(root), cx.name_of(place));
}

/// The name that the source gives to the structure at a place, which is the memory of another one.
std::string Expander::link_name(const Place& link) const {
    const Place owner{link.root, {link.members.begin(), link.members.end() - 1}};
    return (*p.names)[cx.structure_at(owner).members[link.members.back()].name];
}

/// The condition that a physical address lies in the memory; if the memory is a structure, in its domain. Absent: this
/// is proved for all addresses, or the memory is a structure that has no domain or is not total (ir::is_total), so that
/// its partial translator decides itself what lies outside.
ExprId Expander::inside_memory(const Place& place, ExprId physical) {
    const Structure& structure = cx.structure_at(place);
    if (!structure.base.empty()) {
        const Place base = base_of(structure, place);
        const bool asks = is_total(cx.structure_at(base)) && cx.structure_at(base).domain;
        return asks ? less_where_unknown(structure, physical, domain_of(base)) : ExprId{};
    }
    Expr extent;
    extent.op = Op::memory_extent;
    extent.type = build.type(physical);
    extent.place = canonical(place);
    extent.slot = structure.via_memory;
    return less_where_unknown(structure, physical, p.exprs.add(std::move(extent)));
}

/// The condition that an address is below an extent, tested only along the axes for which that is not proved
/// (Structure::contained_axes); absent: it is proved for all axes.
ExprId Expander::less_where_unknown(const Structure& structure, ExprId address, ExprId extent) {
    if (structure.contained_axes == 0) return all_less(address, extent);
    ExprId inside;
    for (std::uint32_t axis = 0; axis < p.types.components(build.type(address)); ++axis) {
        if (structure.contained_axes >> axis & 1) continue;
        inside = build.both(
            inside, build.binary(BinaryOp::less, build.component(address, axis), build.component(extent, axis)));
    }
    return inside;
}

ExprId Expander::all_less(ExprId address, ExprId extent) {
    if (!p.types.is_vector(build.type(address))) return build.binary(BinaryOp::less, address, extent);
    TypeId truths = p.types.with_scalar(build.type(address), p.types.bool_);
    return build.intrinsic(Intrinsic::all, p.types.bool_,
                           {build.intrinsic(Intrinsic::lessThan, truths, {address, extent})});
}

/// The function to translate with. In wide passes scalar physical addresses may exceed 2^32; components of vectors do
/// not.
FunctionId Expander::translate_of(const Stage& stage) const {
    return cx.is_wide() && stage.wide ? stage.wide : p.translators[stage.translator].translate;
}

Pair Expander::expanded(const Place& place, const Stage& stage, ExprId address, const std::string& name) {
    const FunctionId translate = translate_of(stage);
    address = build.convert(p.locals[p.functions[translate].params[0]].type, address);
    Frame frame;
    frame.stage = &stage;
    frame.structure = place;
    frame.prefix = name;
    for (const Place& member : stage.structures) {
        Place nested = place;
        nested.members.append(member.members);
        frame.places.push_back(std::move(nested));
    }
    std::vector<Pair> arguments{{address, {}}};
    return within([&] {
        return inline_sizes_.of(translate) ? inlined(translate, std::move(arguments), std::move(frame))
                                           : call_instance(translate, std::move(arguments), std::move(frame));
    });
}

bool Expander::is_total(const Structure& structure) { return ir::is_total(p, structure); }

/// Whether the place is a parameter with a range of its own size (any, scatter, coherent, target), in the forms in
/// which ranges need not be whole structures: addresses in the kernel are then relative to the range's origin.
bool Expander::is_range(const Place& place) const {
    if (cx.is_direct() || !place.members.empty()) return false;
    return has_own_range(cx.kernel.params[place.root].pattern);
}

ExprId Expander::range_size(std::uint32_t root) {
    TypeId type = cx.structure_at({root, {}}).domain_type;
    return cx.parameter_expr(cx.parameter(ParameterSource::range_size, cx.name_of({root, {}}) + "_size", type, root));
}

/// The virtual address in the structure, for an address that is relative to the range's origin.
ExprId Expander::from_origin(const Place& place, ExprId address) {
    if (!is_range(place)) return address;
    TypeId type = cx.structure_at(place).domain_type;
    std::uint32_t slot = cx.parameter(ParameterSource::origin, cx.name_of(place) + "_origin", type, place.root);
    return build.add(cx.parameter_expr(slot), address);
}

ExprId Expander::domain_of(const Place& place) {
    if (is_range(place)) return range_size(place.root);
    const Structure& structure = cx.structure_at(place);
    if (structure.domain) {
        Frame frame;
        frame.places = {canonical(place)};
        ExprId domain = inside(std::move(frame), [&] { return value_of(structure.domain); });
        if (!is_trivial(cx, domain)) {
            const Name name = p.names->intern(cx.name_of(place) + "_domain");
            if (namings_ != nullptr) namings_->push_back({domain, name, false});
            else cx.names.emplace(domain, name);
        }
        return domain;
    }
    Expr leaf;
    leaf.op = Op::domain;
    leaf.type = structure.domain_type;
    leaf.place = canonical(place);
    return p.exprs.add(std::move(leaf));
}

ExprId Expander::inside_domain(const Place& place, ExprId address) { return all_less(address, domain_of(place)); }

ExprId Expander::centre_address(std::uint32_t root) {
    if (cx.kernel.space) return address_in_block(root);
    ExprId address = own_address(root);
    if (cx.is_direct()) return address;
    if (auto found = addresses_.find(root); found != addresses_.end()) return found->second;
    std::string name = cx.name_of({root, {}});
    std::uint32_t slot = cx.parameter(ParameterSource::origin, name + "_origin", build.type(address), root);
    Block made = collect([&] {
        addresses_[root] =
            build.local(let(name + "_address", build.add(cx.parameter_expr(slot), address), cx.kernel.span));
    });
    prelude_.insert(prelude_.end(), made.begin(), made.end());
    return addresses_[root];
}

/// The physical address of a parameter's current element, and the condition that it has one. Both are put into named
/// locals before the kernel's body, unless they are short or uniform (see named()).
Pair Expander::centre(std::uint32_t root) {
    // Structures with equal state share addresses, unless translation reads tables: each may have another table, but
    // for components of one structure.
    const std::uint32_t shared = canonical_root(root);
    const bool is_there = !cx.kernel.raster || cx.kernel.params[shared].pattern == cx.kernel.params[root].pattern;
    const bool shares = is_of_one_whole(root) || !translates_by_tables(p, cx.structure_at({root, {}}));
    if (shares && is_there) root = shared;
    if (auto found = centres_.find(root); found != centres_.end()) return found->second;
    ExprId address = centre_address(root);
    std::string name = cx.name_of({root, {}});
    Pair result;
    Frame frame;
    Span outer = span_;
    span_ = cx.kernel.params[root].span;
    Block made = collect([&] {
        inside(std::move(frame), [&] {
            // Except in kernels with a group and in draws, the current element is known to be in the domain.
            const bool is_inside = !cx.kernel.grouped() && cx.structure_at({root, {}}).domain && !cx.kernel.raster;
            if (is_inside) known_.push_back({numbers_.of(inside_domain({root, {}}, address))});
            Pair at = translated({root, {}}, address, name);
            if (is_inside) known_.pop_back();
            bool asked = false;
            at.has = without_inside(root, at.has, address, asked);
            if (cx.kernel.space) at.has = without_block_tests(at.has);
            result.value = named(name + "_at", at.value);
            if (at.has) result.has = named(name + "_found", at.has);
            return 0;
        });
    });
    span_ = outer;
    prelude_.insert(prelude_.end(), made.begin(), made.end());
    centres_[root] = result;
    return result;
}

}  // namespace gliftc::lower
