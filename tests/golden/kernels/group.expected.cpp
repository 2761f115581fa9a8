// Made by gliftc from group.glift. Changes are lost when it is made again.
#include "group.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace group_ {

using namespace glift::types;

namespace {
struct block_sums_direct_parameters {
    uint value_extent;
};
static_assert(offsetof(block_sums_direct_parameters, value_extent) == 0);
struct block_sums_general_parameters {
    uint size;
    uint value_origin;
    uint sums_origin;
    uint sums_size;
};
static_assert(offsetof(block_sums_general_parameters, size) == 0);
static_assert(offsetof(block_sums_general_parameters, value_origin) == 4);
static_assert(offsetof(block_sums_general_parameters, sums_origin) == 8);
static_assert(offsetof(block_sums_general_parameters, sums_size) == 12);
struct block_sums_wide_parameters {
    uint size;
    uint value_origin;
    uint sums_origin;
    uint sums_size;
    std::uint64_t value_data_address;
    std::uint64_t sums_data_address;
};
static_assert(offsetof(block_sums_wide_parameters, size) == 0);
static_assert(offsetof(block_sums_wide_parameters, value_origin) == 4);
static_assert(offsetof(block_sums_wide_parameters, sums_origin) == 8);
static_assert(offsetof(block_sums_wide_parameters, sums_size) == 12);
static_assert(offsetof(block_sums_wide_parameters, value_data_address) == 16);
static_assert(offsetof(block_sums_wide_parameters, sums_data_address) == 24);
}  // namespace

extern const glift::Kernel block_sums_kernel;

void block_sums(const glift::Commands& commands, const glift::Range<Values>& value, const glift::Range<Values>& sums) {
    glift::Iteration iteration(block_sums_kernel);
    iteration.each("value", value);
    iteration.any("sums", sums);
    const glift::Memory memories[] = {value->data(), sums->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {value, sums});
    if (commands.needs_wide(block_sums_kernel, memories, iteration.size())) {
        const block_sums_wide_parameters parameters = {
            .size = value.size(),
            .value_origin = value.origin(),
            .sums_origin = sums.origin(),
            .sums_size = sums.size(),
            .value_data_address = 0u,
            .sums_data_address = 0u,
        };
        iteration.count(sums, offsetof(block_sums_wide_parameters, sums_size));
        commands.dispatch(block_sums_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(block_sums_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && value->same_state(sums.structure())) {
        const block_sums_direct_parameters parameters = {
            .value_extent = value->extent(),
        };
        commands.dispatch(block_sums_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const block_sums_general_parameters parameters = {
            .size = value.size(),
            .value_origin = value.origin(),
            .sums_origin = sums.origin(),
            .sums_size = sums.size(),
        };
        iteration.count(sums, offsetof(block_sums_general_parameters, sums_size));
        commands.dispatch(block_sums_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(block_sums_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

}  // namespace group_
