// Expander: a partial translator that maps no address outside its domain tests whether an address is in the domain.
// These functions remove that test where the address is known to be inside (the current element) or is tested by the
// caller (neighbours).
#include "lower/expand/expand.h"

namespace gliftc::lower {

using namespace ir;

/// Whether the condition is all(lessThan(address, domain)), or address < domain, with the domain of parameter `root`.
bool Expander::is_asking_inside(std::uint32_t root, ExprId condition, ExprId address) {
    const Expr* test = &p.exprs[condition];
    if (test->op == Op::intrinsic && test->intrinsic == Intrinsic::all) {
        test = &p.exprs[test->operands[0]];
        if (test->op != Op::intrinsic || test->intrinsic != Intrinsic::lessThan) return false;
    } else if (test->op != Op::binary || test->binary != BinaryOp::less) {
        return false;
    }
    ExprId left = test->operands[0], right = test->operands[1];
    return numbers_.of(left) == numbers_.of(address) && numbers_.of(right) == numbers_.of(domain_of({root, {}}));
}

/// The condition without those of its conjuncts that test whether the address is in the domain; absent if no other
/// conjunct is left. Sets `asked` if there was such a test.
ExprId Expander::without_inside(std::uint32_t root, ExprId condition, ExprId address, bool& asked) {
    if (!condition) return condition;
    if (is_asking_inside(root, condition, address)) {
        asked = true;
        return {};
    }
    const Expr node = p.exprs[condition];
    if (node.op != Op::binary || node.binary != BinaryOp::logical_and) return condition;
    ExprId left = without_inside(root, node.operands[0], address, asked);
    ExprId right = without_inside(root, node.operands[1], address, asked);
    return build.both(left, right);
}

/// Whether the structure of a near parameter may map addresses outside its domain: its first translator is partial and
/// may map them, as Edge<N, Boundary.repeat> of std.edge does. A partial translator is known to map none of them only
/// if it compares the whole address with the domain in one comparison and then gives `none`.
bool Expander::may_map_outside(std::uint32_t root) {
    const Place place{root, {}};
    if (is_total(cx.structure_at(place))) return false;
    const auto [found, is_new] = may_map_outside_.try_emplace(root, true);
    if (is_new) found->second = !is_none_outside(place);
    return found->second;
}

/// Whether the structure at `place` maps no address outside its domain. Expands the translation of an address that is
/// assumed to lie outside, to see whether the result is `none`; the statements and bindings that this makes are
/// discarded.
bool Expander::is_none_outside(const Place& place) {
    const ExprId address = build.local(cx.new_local("address", build.type(centre_address(place.root)), span_));
    std::vector<Fact> outside{{numbers_.of(inside_domain(place, address)), false}};
    if (!p.types.is_vector(build.type(address))) {
        // The function inside() of std.address compares scalars as vectors of one component: all(lessThan(…)).
        const ExprId less = build.intrinsic(Intrinsic::lessThan, p.types.bool_, {address, domain_of(place)});
        outside.push_back({numbers_.of(build.intrinsic(Intrinsic::all, p.types.bool_, {less})), false});
    }
    const std::vector<Fact> known = std::exchange(known_, std::move(outside));
    const std::size_t bindings = cx.pass.bindings.size();
    Pair physical;
    collect([&] { physical = inside(Frame{}, [&] { return translated(place, address, "outside"); }); });
    cx.pass.bindings.erase(cx.pass.bindings.begin() + static_cast<std::ptrdiff_t>(bindings), cx.pass.bindings.end());
    known_ = known;
    if (!physical.has) return false;
    if (build.is_false(physical.has)) return true;
    bool asked = false;
    without_inside(place.root, physical.has, address, asked);
    return asked;
}

}  // namespace gliftc::lower
