#include "lower/transform/common_bindings.h"

#include "lower/analysis/aliasing.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

bool are_of_one_memory(const PassBinding& a, const PassBinding& b) {
    return a.place == b.place && a.memory == b.memory && a.shape == b.shape && a.compare == b.compare &&
           a.is_workspace == b.is_workspace;
}

/// Whether the bindings are of one memory and have the same access (read, write or both), on which the barriers around
/// the pass depend.
bool are_same(const PassBinding& a, const PassBinding& b) { return are_of_one_memory(a, b) && a.access == b.access; }

}  // namespace

bool have_common_bindings(std::span<Pass* const> forms) {
    return std::ranges::all_of(
        forms, [&](const Pass* pass) { return std::ranges::equal(pass->bindings, forms[0]->bindings, are_same); });
}

std::vector<PassBinding> union_of_bindings(std::span<Pass* const> forms) {
    std::vector<PassBinding> all;
    for (const Pass* pass : forms) {
        for (const PassBinding& binding : pass->bindings) {
            const auto is_it = [&](const PassBinding& have) { return are_of_one_memory(have, binding); };
            const auto found = std::ranges::find_if(all, is_it);
            if (found == all.end()) all.push_back(binding);
            else if (found->access != binding.access) found->access = Access::read_write;
        }
    }
    return all;
}

void add_bindings(Context& cx, const std::vector<PassBinding>& bindings) {
    for (PassBinding binding : bindings) {
        binding.in_rows = binding.sampled = false;  // found out anew for each form
        binding.address_parameter = no_parameter;
        binding.one_place = first_of_place(cx, binding);
        cx.pass.bindings.push_back(std::move(binding));
    }
}

}  // namespace gliftc::lower
