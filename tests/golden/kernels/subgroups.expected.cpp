// Made by gliftc from subgroups.glift. Changes are lost when it is made again.
#include "subgroups.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace subgroups {

using namespace glift::types;

namespace {
struct best_of_subgroup_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(best_of_subgroup_direct_parameters, from_extent) == 0);
struct best_of_subgroup_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(best_of_subgroup_general_parameters, size) == 0);
static_assert(offsetof(best_of_subgroup_general_parameters, from_origin) == 4);
static_assert(offsetof(best_of_subgroup_general_parameters, to_origin) == 8);
struct best_of_subgroup_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(best_of_subgroup_wide_parameters, size) == 0);
static_assert(offsetof(best_of_subgroup_wide_parameters, from_origin) == 4);
static_assert(offsetof(best_of_subgroup_wide_parameters, to_origin) == 8);
static_assert(offsetof(best_of_subgroup_wide_parameters, from_data_address) == 16);
static_assert(offsetof(best_of_subgroup_wide_parameters, to_data_address) == 24);
}  // namespace

extern const glift::Kernel best_of_subgroup_kernel;

void best_of_subgroup(const glift::Commands& commands, const glift::Range<Values>& from,
    const glift::Range<Values>& to) {
    glift::Iteration iteration(best_of_subgroup_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(best_of_subgroup_kernel, memories, iteration.size(), iteration.sharing())) {
        const best_of_subgroup_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(best_of_subgroup_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(best_of_subgroup_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && from->same_state(to.structure())
        && iteration.sharing() != glift::Sharing::one_place) {
        const best_of_subgroup_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(best_of_subgroup_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const best_of_subgroup_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(best_of_subgroup_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(best_of_subgroup_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct turn_subgroups_direct_parameters {
    uint from_extent;
};
static_assert(offsetof(turn_subgroups_direct_parameters, from_extent) == 0);
struct turn_subgroups_general_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
};
static_assert(offsetof(turn_subgroups_general_parameters, size) == 0);
static_assert(offsetof(turn_subgroups_general_parameters, from_origin) == 4);
static_assert(offsetof(turn_subgroups_general_parameters, to_origin) == 8);
struct turn_subgroups_wide_parameters {
    uint size;
    uint from_origin;
    uint to_origin;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(turn_subgroups_wide_parameters, size) == 0);
static_assert(offsetof(turn_subgroups_wide_parameters, from_origin) == 4);
static_assert(offsetof(turn_subgroups_wide_parameters, to_origin) == 8);
static_assert(offsetof(turn_subgroups_wide_parameters, from_data_address) == 16);
static_assert(offsetof(turn_subgroups_wide_parameters, to_data_address) == 24);
}  // namespace

extern const glift::Kernel turn_subgroups_kernel;

void turn_subgroups(const glift::Commands& commands, const glift::Range<Values>& from, const glift::Range<Values>& to) {
    glift::Iteration iteration(turn_subgroups_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (commands.needs_wide(turn_subgroups_kernel, memories, iteration.size(), iteration.sharing())) {
        const turn_subgroups_wide_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(turn_subgroups_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(turn_subgroups_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && from->same_state(to.structure())
        && iteration.sharing() != glift::Sharing::one_place) {
        const turn_subgroups_direct_parameters parameters = {
            .from_extent = from->extent(),
        };
        commands.dispatch(turn_subgroups_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const turn_subgroups_general_parameters parameters = {
            .size = from.size(),
            .from_origin = from.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(turn_subgroups_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(turn_subgroups_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

}  // namespace subgroups
