// Made by gliftc from large_arrays.glift. Changes are lost when it is made again.
#include "large_arrays.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace large_arrays {

using namespace glift::types;

namespace {
struct count_digits_direct_parameters {
    uint row_extent;
};
static_assert(offsetof(count_digits_direct_parameters, row_extent) == 0);
struct count_digits_general_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint counts_origin;
    uint counts_size;
};
static_assert(offsetof(count_digits_general_parameters, size) == 0);
static_assert(offsetof(count_digits_general_parameters, from_origin) == 4);
static_assert(offsetof(count_digits_general_parameters, from_size) == 8);
static_assert(offsetof(count_digits_general_parameters, counts_origin) == 12);
static_assert(offsetof(count_digits_general_parameters, counts_size) == 16);
struct count_digits_wide_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint counts_origin;
    uint counts_size;
    std::uint64_t from_data_address;
    std::uint64_t counts_data_address;
};
static_assert(offsetof(count_digits_wide_parameters, size) == 0);
static_assert(offsetof(count_digits_wide_parameters, from_origin) == 4);
static_assert(offsetof(count_digits_wide_parameters, from_size) == 8);
static_assert(offsetof(count_digits_wide_parameters, counts_origin) == 12);
static_assert(offsetof(count_digits_wide_parameters, counts_size) == 16);
static_assert(offsetof(count_digits_wide_parameters, from_data_address) == 24);
static_assert(offsetof(count_digits_wide_parameters, counts_data_address) == 32);
}  // namespace

extern const glift::Kernel count_digits_kernel;

void count_digits(const glift::Commands& commands, const glift::Range<Values>& row, const glift::Range<Values>& from,
    const glift::Range<Values>& counts) {
    glift::Iteration iteration(count_digits_kernel);
    iteration.each("row", row);
    iteration.any("from", from);
    iteration.any("counts", counts);
    const glift::Memory memories[] = {from->data(), counts->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {row, from, counts});
    if (commands.needs_wide(count_digits_kernel, memories, iteration.size())) {
        const count_digits_wide_parameters parameters = {
            .size = row.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .counts_origin = counts.origin(),
            .counts_size = counts.size(),
            .from_data_address = 0u,
            .counts_data_address = 0u,
        };
        iteration.count(from, offsetof(count_digits_wide_parameters, from_size));
        iteration.count(counts, offsetof(count_digits_wide_parameters, counts_size));
        commands.dispatch(count_digits_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(count_digits_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && row->same_state(from.structure()) && from->same_state(counts.structure())) {
        const count_digits_direct_parameters parameters = {
            .row_extent = row->extent(),
        };
        commands.dispatch(count_digits_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const count_digits_general_parameters parameters = {
            .size = row.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .counts_origin = counts.origin(),
            .counts_size = counts.size(),
        };
        iteration.count(from, offsetof(count_digits_general_parameters, from_size));
        iteration.count(counts, offsetof(count_digits_general_parameters, counts_size));
        commands.dispatch(count_digits_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(count_digits_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void count_digits(const glift::Commands& commands, const glift::Range<Values>& from,
    const glift::Range<Values>& counts) {
    count_digits(commands, from, from, counts);
}

namespace {
struct corners_direct_parameters {
    uint i_extent;
};
static_assert(offsetof(corners_direct_parameters, i_extent) == 0);
struct corners_general_parameters {
    uint size;
    uint to_origin;
    uint to_size;
};
static_assert(offsetof(corners_general_parameters, size) == 0);
static_assert(offsetof(corners_general_parameters, to_origin) == 4);
static_assert(offsetof(corners_general_parameters, to_size) == 8);
struct corners_wide_parameters {
    uint size;
    uint to_origin;
    uint to_size;
    std::uint64_t to_data_address;
};
static_assert(offsetof(corners_wide_parameters, size) == 0);
static_assert(offsetof(corners_wide_parameters, to_origin) == 4);
static_assert(offsetof(corners_wide_parameters, to_size) == 8);
static_assert(offsetof(corners_wide_parameters, to_data_address) == 16);
}  // namespace

extern const glift::Kernel corners_kernel;

void corners(const glift::Commands& commands, const glift::Range<Values>& i, const glift::Range<Values>& to) {
    glift::Iteration iteration(corners_kernel);
    iteration.each("i", i);
    iteration.any("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(corners_kernel, memories, iteration.size())) {
        const corners_wide_parameters parameters = {
            .size = i.size(),
            .to_origin = to.origin(),
            .to_size = to.size(),
            .to_data_address = 0u,
        };
        iteration.count(to, offsetof(corners_wide_parameters, to_size));
        commands.dispatch(corners_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(corners_wide_parameters, size)})});
    } else if (iteration.is_whole() && i->same_state(to.structure())) {
        const corners_direct_parameters parameters = {
            .i_extent = i->extent(),
        };
        commands.dispatch(corners_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const corners_general_parameters parameters = {
            .size = i.size(),
            .to_origin = to.origin(),
            .to_size = to.size(),
        };
        iteration.count(to, offsetof(corners_general_parameters, to_size));
        commands.dispatch(corners_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(corners_general_parameters, size)})});
    }
}

void corners(const glift::Commands& commands, const glift::Range<Values>& to) {
    corners(commands, to, to);
}

}  // namespace large_arrays
