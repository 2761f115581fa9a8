#include "ir/variants.h"

#include "ir/pass.h"

namespace gliftc::ir {

namespace {

/// Whether the variant is for these devices, is a whole kernel or a vertex part, and does not need blocks all of whose
/// elements are visited.
bool runs_on(const Variant& variant, Devices devices) {
    return variant.part != Part::fragment && !variant.block &&
           (variant.devices == Devices::any || variant.devices == devices);
}

template <class Bodies, class P> Bodies all_bodies(P& pass) {
    Bodies bodies{&pass.prologue};
    for (auto& variant : pass.variants) {
        if (variant.block) bodies.push_back(&*variant.block);
        bodies.push_back(&variant.body);
    }
    return bodies;
}

}  // namespace

const Variant& variant_for(const Pass& pass, Devices devices) {
    const Variant* found = &pass.plain();
    for (const Variant& variant : pass.variants)
        if (runs_on(variant, devices) && !variant.assumes.interior && variant.assumes.bounds.empty()) found = &variant;
    return *found;
}

const Variant* fragment_for(const Pass& pass, Devices devices) {
    const Variant* found = nullptr;
    for (const Variant& variant : pass.variants)
        if (variant.part == Part::fragment && (variant.devices == Devices::any || variant.devices == devices))
            found = &variant;
    return found;
}

const Variant* interior_variant_for(const Pass& pass, Devices devices) {
    const Variant* found = nullptr;
    for (const Variant& variant : pass.variants)
        if (runs_on(variant, devices) && variant.assumes.interior && variant.assumes.bounds.empty()) found = &variant;
    return found;
}

std::vector<StmtId> statements_of(const Variant& variant) {
    std::vector<StmtId> all = variant.block.value_or(std::vector<StmtId>());
    all.insert(all.end(), variant.body.begin(), variant.body.end());
    return all;
}

const Variant* block_variant_for(const Pass& pass, Devices devices) {
    for (const Variant& variant : pass.variants)
        if (variant.block && variant.devices == devices && variant.assumes.bounds.empty()) return &variant;
    return nullptr;
}

const Variant* bounded_variant_of(const Pass& pass, const Variant& variant) {
    for (const Variant& each : pass.variants)
        if (each.devices == variant.devices && !each.assumes.bounds.empty() &&
            each.assumes.interior.has_value() == variant.assumes.interior.has_value() &&
            each.block.has_value() == variant.block.has_value())
            return &each;
    return nullptr;
}

std::vector<std::vector<StmtId>*> bodies_of(Pass& pass) { return all_bodies<std::vector<std::vector<StmtId>*>>(pass); }

std::vector<const std::vector<StmtId>*> bodies_of(const Pass& pass) {
    return all_bodies<std::vector<const std::vector<StmtId>*>>(pass);
}

}  // namespace gliftc::ir
