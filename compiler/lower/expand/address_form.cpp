// Expander: affine translators. A kernel that reads neighbours translates many addresses of one structure, so the
// translator's code is expanded once, with a local for the address (AddressForm); for each address the few resulting
// nodes are copied, which is much less work.
#include "ir/walk.h"
#include "lower/expand/expand.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

Pair Expander::through_form(const Place& place, const Stage& stage, ExprId address, const std::string& name) {
    if (!varies_in_all(address)) return expanded(place, stage, address, name);
    const AddressForm& form = form_of(place, stage, build.type(address));
    return form.is_known ? made_again(form, address, name) : expanded(place, stage, address, name);
}

/// Whether no component of the address seems to be uniform (the same for all invocations). The definition of a local is
/// not searched for uniform components; operations other than constructions, sums and differences of vectors count as
/// having one. With a uniform component, expanding the translator anew can give better code than a copy of its form:
/// see expand_call() for calls with constant or uniform arguments.
bool Expander::varies_in_all(ExprId address) {
    const Expr& node = p.exprs[address];
    if (is_uniform(cx, address)) return false;
    if (node.op == Op::local || !p.types.is_vector(node.type)) return true;
    const auto varies = [&](ExprId operand) { return varies_in_all(operand); };
    if (node.op == Op::construct) return std::ranges::all_of(node.operands, varies);
    const bool is_sum = node.op == Op::binary && (node.binary == BinaryOp::add || node.binary == BinaryOp::subtract);
    return is_sum && std::ranges::any_of(node.operands, varies);
}

const AddressForm& Expander::form_of(const Place& place, const Stage& stage, TypeId address) {
    for (const auto& form : cx.address_forms)
        if (form->stage == &stage && form->place == place) return *form;
    AddressForm& form = *cx.address_forms.emplace_back(std::make_unique<AddressForm>());
    form.place = place;
    form.stage = &stage;
    find_form(form, address);
    return form;
}

void Expander::find_form(AddressForm& form, TypeId address) {
    if (!inline_sizes_.of(translate_of(*form.stage))) return;
    form.address = build.local(cx.new_local(Name{}, address, span_));
    const ExprId first{p.exprs.size()};
    const std::size_t bindings = cx.pass.bindings.size();
    auto* outer = std::exchange(namings_, &form.names);
    const Block block = collect([&] {
        const Pair result = expanded(form.place, *form.stage, form.address, "form");
        form.value = result.value;
        form.has = result.has;
    });
    namings_ = outer;
    const bool is_value = block.empty() && cx.pass.bindings.size() == bindings;
    form.is_known = is_value && (!form.has || build.is_constant(form.has)) && collect_nodes(form, first);
}

/// Collects the nodes of the form. True if the address is a scalar, or the nodes use only its components, not the
/// vector as a whole. A use of the whole vector may come from folding uint2(a.x, a.y) to a, which folds for a local
/// `a`, but not for every address that is put in its place.
bool Expander::collect_nodes(AddressForm& form, ExprId first) {
    const bool is_vector = p.types.is_vector(build.type(form.address));
    bool is_known = !is_vector || form.value != form.address;
    IdSet<Expr> seen;
    for_each_node(p, form.value, seen, [&](ExprId id) {
        if (id.index >= first.index) form.nodes.push_back(id);
        const Expr& node = p.exprs[id];
        const bool is_component = node.op == Op::swizzle && !p.types.is_vector(node.type);
        if (is_vector && !is_component && std::ranges::find(node.operands, form.address) != node.operands.end())
            is_known = false;
    });
    std::ranges::sort(form.nodes);
    std::erase_if(form.names, [&](const AddressForm::Naming& naming) { return !seen.contains(naming.value); });
    return is_known;
}

Pair Expander::made_again(const AddressForm& form, ExprId address, const std::string& name) {
    const std::uint32_t first = form.nodes.empty() ? 0 : form.nodes.front().index;
    if (!form.nodes.empty()) made_again_.resize(form.nodes.back().index - first + 1);
    const auto now = [&](ExprId id) {
        if (id == form.address) return address;
        return form.nodes.empty() || id.index < first ? id : made_again_[id.index - first];
    };
    for (ExprId id : form.nodes) {
        const Expr& node = p.exprs[id];
        Operands operands;
        for (ExprId operand : node.operands) operands.push_back(now(operand));
        made_again_[id.index - first] = operands.empty() ? p.exprs.add(node) : build.again(node, std::move(operands));
    }
    for (const AddressForm::Naming& naming : form.names) {
        const std::string& text = (*p.names)[naming.name];
        cx.name(now(naming.value), naming.is_prefixed ? name + "_" + text : text);
    }
    return {now(form.value), form.has};
}

}  // namespace gliftc::lower
