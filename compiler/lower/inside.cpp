// Expander: a partial translator that maps nothing beyond the edge tests whether the address is in the domain. These
// functions remove that test where the address is known to be inside (the current element) or is tested by the caller
// (neighbours).
#include "lower/expand.h"

namespace gliftc::lower {

using namespace ir;

/// Whether the condition is all(lessThan(address, domain)), or address < domain, with the parameter's own domain.
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

/// The condition without those of its conjuncts that test whether the address is in the domain; sets `asked` if there
/// was one.
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
    return make.both(left, right);
}

/// Whether the structure of a near parameter has neighbours outside of its domain: its first translator is partial and
/// maps addresses that are not inside, as `Edge` does where it repeats a box.
bool Expander::maps_outside(std::uint32_t root) {
    const Place place{root, {}};
    if (is_total(cx.structure_at(place))) return false;
    const auto [found, is_new] = maps_outside_.try_emplace(root, true);
    if (!is_new) return found->second;
    const ExprId address = make.local(cx.new_local("address", make.type(centre_address(root)), span_));
    const std::vector<Fact> known = std::exchange(known_, {{numbers_.of(inside_domain(place, address)), false}});
    Pair physical;
    collect([&] { physical = inside(Frame{}, [&] { return translated(place, address, "outside"); }); });
    known_ = known;
    bool asked = physical.has && make.is_false(physical.has);
    without_inside(root, physical.has, address, asked);
    return found->second = !asked;
}

}  // namespace gliftc::lower
