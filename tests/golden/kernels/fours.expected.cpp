// Made by gliftc from fours.glift. Changes are lost when it is made again.
#include "fours.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace fours {

using namespace glift::types;

namespace {
struct sum_fours_direct_parameters {
    uint a_extent;
    uint shift;
};
static_assert(offsetof(sum_fours_direct_parameters, a_extent) == 0);
static_assert(offsetof(sum_fours_direct_parameters, shift) == 4);
struct sum_fours_general_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint to_origin;
    uint to_size;
    uint shift;
};
static_assert(offsetof(sum_fours_general_parameters, size) == 0);
static_assert(offsetof(sum_fours_general_parameters, from_origin) == 4);
static_assert(offsetof(sum_fours_general_parameters, from_size) == 8);
static_assert(offsetof(sum_fours_general_parameters, to_origin) == 12);
static_assert(offsetof(sum_fours_general_parameters, to_size) == 16);
static_assert(offsetof(sum_fours_general_parameters, shift) == 20);
struct sum_fours_wide_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint to_origin;
    uint to_size;
    uint shift;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(sum_fours_wide_parameters, size) == 0);
static_assert(offsetof(sum_fours_wide_parameters, from_origin) == 4);
static_assert(offsetof(sum_fours_wide_parameters, from_size) == 8);
static_assert(offsetof(sum_fours_wide_parameters, to_origin) == 12);
static_assert(offsetof(sum_fours_wide_parameters, to_size) == 16);
static_assert(offsetof(sum_fours_wide_parameters, shift) == 20);
static_assert(offsetof(sum_fours_wide_parameters, from_data_address) == 24);
static_assert(offsetof(sum_fours_wide_parameters, to_data_address) == 32);
}  // namespace

extern const glift::Kernel sum_fours_kernel;

void sum_fours(const glift::Commands& commands, const glift::Range<Values>& a, const glift::Range<Values>& from,
    uint shift, const glift::Range<Values>& to) {
    glift::Iteration iteration(sum_fours_kernel);
    iteration.each("a", a);
    iteration.any("from", from);
    iteration.any("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {a, from, to});
    if (commands.needs_wide(sum_fours_kernel, memories, iteration.size())) {
        const sum_fours_wide_parameters parameters = {
            .size = a.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .to_origin = to.origin(),
            .to_size = to.size(),
            .shift = shift,
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        iteration.count(from, offsetof(sum_fours_wide_parameters, from_size));
        iteration.count(to, offsetof(sum_fours_wide_parameters, to_size));
        commands.dispatch(sum_fours_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(sum_fours_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && a->same_state(from.structure()) && from->same_state(to.structure())) {
        const sum_fours_direct_parameters parameters = {
            .a_extent = a->extent(),
            .shift = shift,
        };
        commands.dispatch(sum_fours_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const sum_fours_general_parameters parameters = {
            .size = a.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .to_origin = to.origin(),
            .to_size = to.size(),
            .shift = shift,
        };
        iteration.count(from, offsetof(sum_fours_general_parameters, from_size));
        iteration.count(to, offsetof(sum_fours_general_parameters, to_size));
        commands.dispatch(sum_fours_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(sum_fours_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void sum_fours(const glift::Commands& commands, const glift::Range<Values>& from, uint shift,
    const glift::Range<Values>& to) {
    sum_fours(commands, from, from, shift, to);
}

}  // namespace fours
