// Made by gliftc from predicates.glift. Changes are lost when it is made again.
#include "predicates.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace predicates {

using namespace glift::types;

namespace {
struct shift_direct_parameters {
    uint x_extent;
    uint by;
};
static_assert(offsetof(shift_direct_parameters, x_extent) == 0);
static_assert(offsetof(shift_direct_parameters, by) == 4);
struct shift_general_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint x_origin;
    uint to_origin;
    uint by;
};
static_assert(offsetof(shift_general_parameters, size) == 0);
static_assert(offsetof(shift_general_parameters, from_origin) == 4);
static_assert(offsetof(shift_general_parameters, from_size) == 8);
static_assert(offsetof(shift_general_parameters, x_origin) == 12);
static_assert(offsetof(shift_general_parameters, to_origin) == 16);
static_assert(offsetof(shift_general_parameters, by) == 20);
struct shift_wide_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint x_origin;
    uint to_origin;
    uint by;
    std::uint64_t from_data_address;
    std::uint64_t x_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(shift_wide_parameters, size) == 0);
static_assert(offsetof(shift_wide_parameters, from_origin) == 4);
static_assert(offsetof(shift_wide_parameters, from_size) == 8);
static_assert(offsetof(shift_wide_parameters, x_origin) == 12);
static_assert(offsetof(shift_wide_parameters, to_origin) == 16);
static_assert(offsetof(shift_wide_parameters, by) == 20);
static_assert(offsetof(shift_wide_parameters, from_data_address) == 24);
static_assert(offsetof(shift_wide_parameters, x_data_address) == 32);
static_assert(offsetof(shift_wide_parameters, to_data_address) == 40);
}  // namespace

extern const glift::Kernel shift_kernel;

void shift(const glift::Commands& commands, const glift::Range<Line>& x, const glift::Range<Line>& from, uint by,
    const glift::Range<Line>& to) {
    glift::Iteration iteration(shift_kernel);
    iteration.each("x", x);
    iteration.each("to", to);
    iteration.any("from", from);
    const glift::Memory memories[] = {from->data(), x->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {x, from, to});
    if (commands.needs_wide(shift_kernel, memories, iteration.size(), iteration.sharing())) {
        const shift_wide_parameters parameters = {
            .size = x.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .x_origin = x.origin(),
            .to_origin = to.origin(),
            .by = by,
            .from_data_address = 0u,
            .x_data_address = 0u,
            .to_data_address = 0u,
        };
        iteration.count(from, offsetof(shift_wide_parameters, from_size));
        commands.dispatch(shift_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(shift_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && x->same_state(from.structure()) && from->same_state(to.structure())
        && iteration.sharing() != glift::Sharing::one_place) {
        const shift_direct_parameters parameters = {
            .x_extent = x->extent(),
            .by = by,
        };
        commands.dispatch(shift_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const shift_general_parameters parameters = {
            .size = x.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .x_origin = x.origin(),
            .to_origin = to.origin(),
            .by = by,
        };
        iteration.count(from, offsetof(shift_general_parameters, from_size));
        commands.dispatch(shift_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(shift_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct pick_direct_parameters {
    uint x_extent;
};
static_assert(offsetof(pick_direct_parameters, x_extent) == 0);
struct pick_general_parameters {
    uint size;
    uint x_origin;
    uint to_origin;
};
static_assert(offsetof(pick_general_parameters, size) == 0);
static_assert(offsetof(pick_general_parameters, x_origin) == 4);
static_assert(offsetof(pick_general_parameters, to_origin) == 8);
struct pick_wide_parameters {
    uint size;
    uint x_origin;
    uint to_origin;
    std::uint64_t x_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(pick_wide_parameters, size) == 0);
static_assert(offsetof(pick_wide_parameters, x_origin) == 4);
static_assert(offsetof(pick_wide_parameters, to_origin) == 8);
static_assert(offsetof(pick_wide_parameters, x_data_address) == 16);
static_assert(offsetof(pick_wide_parameters, to_data_address) == 24);
}  // namespace

extern const glift::Kernel pick_kernel;

void pick(const glift::Commands& commands, const glift::Range<Line>& x, const glift::Range<Line>& to) {
    glift::Iteration iteration(pick_kernel);
    iteration.each("x", x);
    iteration.each("to", to);
    const glift::Memory memories[] = {x->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {x, to});
    if (commands.needs_wide(pick_kernel, memories, iteration.size(), iteration.sharing())) {
        const pick_wide_parameters parameters = {
            .size = x.size(),
            .x_origin = x.origin(),
            .to_origin = to.origin(),
            .x_data_address = 0u,
            .to_data_address = 0u,
        };
        commands.dispatch(pick_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(pick_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && x->same_state(to.structure())
        && iteration.sharing() != glift::Sharing::one_place) {
        const pick_direct_parameters parameters = {
            .x_extent = x->extent(),
        };
        commands.dispatch(pick_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const pick_general_parameters parameters = {
            .size = x.size(),
            .x_origin = x.origin(),
            .to_origin = to.origin(),
        };
        commands.dispatch(pick_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(pick_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

}  // namespace predicates
