// Made by gliftc from guards.glift. Changes are lost when it is made again.
#include "guards.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace guards {

using namespace glift::types;

namespace {
struct double_tiles_direct_parameters {
    uint tile_extent;
};
static_assert(offsetof(double_tiles_direct_parameters, tile_extent) == 0);
struct double_tiles_general_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint to_origin;
    uint to_size;
};
static_assert(offsetof(double_tiles_general_parameters, size) == 0);
static_assert(offsetof(double_tiles_general_parameters, from_origin) == 4);
static_assert(offsetof(double_tiles_general_parameters, from_size) == 8);
static_assert(offsetof(double_tiles_general_parameters, to_origin) == 12);
static_assert(offsetof(double_tiles_general_parameters, to_size) == 16);
struct double_tiles_wide_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint to_origin;
    uint to_size;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(double_tiles_wide_parameters, size) == 0);
static_assert(offsetof(double_tiles_wide_parameters, from_origin) == 4);
static_assert(offsetof(double_tiles_wide_parameters, from_size) == 8);
static_assert(offsetof(double_tiles_wide_parameters, to_origin) == 12);
static_assert(offsetof(double_tiles_wide_parameters, to_size) == 16);
static_assert(offsetof(double_tiles_wide_parameters, from_data_address) == 24);
static_assert(offsetof(double_tiles_wide_parameters, to_data_address) == 32);
}  // namespace

extern const glift::Kernel double_tiles_kernel;

void double_tiles(const glift::Commands& commands, const glift::Range<Values>& tile, const glift::Range<Values>& from,
    const glift::Range<Values>& to) {
    glift::Iteration iteration(double_tiles_kernel);
    iteration.each("tile", tile);
    iteration.any("from", from);
    iteration.any("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {tile, from, to});
    if (commands.needs_wide(double_tiles_kernel, memories, iteration.size())) {
        const double_tiles_wide_parameters parameters = {
            .size = tile.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .to_origin = to.origin(),
            .to_size = to.size(),
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        iteration.count(from, offsetof(double_tiles_wide_parameters, from_size));
        iteration.count(to, offsetof(double_tiles_wide_parameters, to_size));
        commands.dispatch(double_tiles_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(double_tiles_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && tile->same_state(from.structure()) && from->same_state(to.structure())) {
        const double_tiles_direct_parameters parameters = {
            .tile_extent = tile->extent(),
        };
        commands.dispatch(double_tiles_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const double_tiles_general_parameters parameters = {
            .size = tile.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .to_origin = to.origin(),
            .to_size = to.size(),
        };
        iteration.count(from, offsetof(double_tiles_general_parameters, from_size));
        iteration.count(to, offsetof(double_tiles_general_parameters, to_size));
        commands.dispatch(double_tiles_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(double_tiles_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void double_tiles(const glift::Commands& commands, const glift::Range<Values>& from, const glift::Range<Values>& to) {
    double_tiles(commands, from, from, to);
}

namespace {
struct add_far_direct_parameters {
    uint tile_extent;
    uint far_;
};
static_assert(offsetof(add_far_direct_parameters, tile_extent) == 0);
static_assert(offsetof(add_far_direct_parameters, far_) == 4);
struct add_far_general_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint to_origin;
    uint to_size;
    uint far_;
};
static_assert(offsetof(add_far_general_parameters, size) == 0);
static_assert(offsetof(add_far_general_parameters, from_origin) == 4);
static_assert(offsetof(add_far_general_parameters, from_size) == 8);
static_assert(offsetof(add_far_general_parameters, to_origin) == 12);
static_assert(offsetof(add_far_general_parameters, to_size) == 16);
static_assert(offsetof(add_far_general_parameters, far_) == 20);
struct add_far_wide_parameters {
    uint size;
    uint from_origin;
    uint from_size;
    uint to_origin;
    uint to_size;
    uint far_;
    std::uint64_t from_data_address;
    std::uint64_t to_data_address;
};
static_assert(offsetof(add_far_wide_parameters, size) == 0);
static_assert(offsetof(add_far_wide_parameters, from_origin) == 4);
static_assert(offsetof(add_far_wide_parameters, from_size) == 8);
static_assert(offsetof(add_far_wide_parameters, to_origin) == 12);
static_assert(offsetof(add_far_wide_parameters, to_size) == 16);
static_assert(offsetof(add_far_wide_parameters, far_) == 20);
static_assert(offsetof(add_far_wide_parameters, from_data_address) == 24);
static_assert(offsetof(add_far_wide_parameters, to_data_address) == 32);
}  // namespace

extern const glift::Kernel add_far_kernel;

void add_far(const glift::Commands& commands, const glift::Range<Values>& tile, const glift::Range<Values>& from,
    uint far_, const glift::Range<Values>& to) {
    glift::Iteration iteration(add_far_kernel);
    iteration.each("tile", tile);
    iteration.any("from", from);
    iteration.any("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {tile, from, to});
    if (commands.needs_wide(add_far_kernel, memories, iteration.size())) {
        const add_far_wide_parameters parameters = {
            .size = tile.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .to_origin = to.origin(),
            .to_size = to.size(),
            .far_ = far_,
            .from_data_address = 0u,
            .to_data_address = 0u,
        };
        iteration.count(from, offsetof(add_far_wide_parameters, from_size));
        iteration.count(to, offsetof(add_far_wide_parameters, to_size));
        commands.dispatch(add_far_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(add_far_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && tile->same_state(from.structure()) && from->same_state(to.structure())) {
        const add_far_direct_parameters parameters = {
            .tile_extent = tile->extent(),
            .far_ = far_,
        };
        commands.dispatch(add_far_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const add_far_general_parameters parameters = {
            .size = tile.size(),
            .from_origin = from.origin(),
            .from_size = from.size(),
            .to_origin = to.origin(),
            .to_size = to.size(),
            .far_ = far_,
        };
        iteration.count(from, offsetof(add_far_general_parameters, from_size));
        iteration.count(to, offsetof(add_far_general_parameters, to_size));
        commands.dispatch(add_far_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(add_far_general_parameters, size)}),
            .sharing = iteration.sharing()});
    }
}

void add_far(const glift::Commands& commands, const glift::Range<Values>& from, uint far_,
    const glift::Range<Values>& to) {
    add_far(commands, from, from, far_, to);
}

}  // namespace guards
