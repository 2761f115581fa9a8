// Made by gliftc from any.glift. Changes are lost when it is made again.
#include "any.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace any {

using namespace glift::types;

namespace {
struct gather_direct_parameters {
    uint index_extent;
    uint values_extent;
};
static_assert(offsetof(gather_direct_parameters, index_extent) == 0);
static_assert(offsetof(gather_direct_parameters, values_extent) == 4);
struct gather_general_parameters {
    uint size;
    uint index_origin;
    uint values_origin;
    uint values_size;
    uint g_origin;
};
static_assert(offsetof(gather_general_parameters, size) == 0);
static_assert(offsetof(gather_general_parameters, index_origin) == 4);
static_assert(offsetof(gather_general_parameters, values_origin) == 8);
static_assert(offsetof(gather_general_parameters, values_size) == 12);
static_assert(offsetof(gather_general_parameters, g_origin) == 16);
struct gather_wide_parameters {
    uint size;
    uint index_origin;
    uint values_origin;
    uint values_size;
    uint g_origin;
    std::uint64_t index_data_address;
    std::uint64_t values_data_address;
    std::uint64_t g_data_address;
};
static_assert(offsetof(gather_wide_parameters, size) == 0);
static_assert(offsetof(gather_wide_parameters, index_origin) == 4);
static_assert(offsetof(gather_wide_parameters, values_origin) == 8);
static_assert(offsetof(gather_wide_parameters, values_size) == 12);
static_assert(offsetof(gather_wide_parameters, g_origin) == 16);
static_assert(offsetof(gather_wide_parameters, index_data_address) == 24);
static_assert(offsetof(gather_wide_parameters, values_data_address) == 32);
static_assert(offsetof(gather_wide_parameters, g_data_address) == 40);
}  // namespace

extern const glift::Kernel gather_kernel;

void gather(const glift::Commands& commands, const glift::Range<Values>& values, const glift::Range<Indices>& index,
    const glift::Range<Values>& g) {
    glift::Iteration iteration(gather_kernel);
    iteration.each("index", index);
    iteration.each("g", g);
    iteration.any("values", values);
    const glift::Memory memories[] = {index->data(), values->data(), g->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {values, index, g});
    if (commands.needs_wide(gather_kernel, memories, iteration.size())) {
        const gather_wide_parameters parameters = {
            .size = index.size(),
            .index_origin = index.origin(),
            .values_origin = values.origin(),
            .values_size = values.size(),
            .g_origin = g.origin(),
            .index_data_address = 0u,
            .values_data_address = 0u,
            .g_data_address = 0u,
        };
        iteration.count(values, offsetof(gather_wide_parameters, values_size));
        commands.dispatch(gather_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(gather_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && values->same_state(g.structure())) {
        const gather_direct_parameters parameters = {
            .index_extent = index->extent(),
            .values_extent = values->extent(),
        };
        commands.dispatch(gather_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const gather_general_parameters parameters = {
            .size = index.size(),
            .index_origin = index.origin(),
            .values_origin = values.origin(),
            .values_size = values.size(),
            .g_origin = g.origin(),
        };
        iteration.count(values, offsetof(gather_general_parameters, values_size));
        commands.dispatch(gather_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(gather_general_parameters, size)}), .sharing = iteration.sharing()});
    }
}

}  // namespace any
