// Made by gliftc from guards.glift. Changes are lost when it is made again.
#include "guards.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace guards {

using namespace glift::types;

extern const glift::Kernel double_tiles_kernel;

void double_tiles(const glift::Commands& commands, const glift::Range<Values>& tile, const glift::Range<Values>& from,
    const glift::Range<Values>& to) {
    glift::Iteration iteration(double_tiles_kernel);
    iteration.each("tile", tile);
    iteration.any("from", from);
    iteration.any("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {tile, from, to});
    if (iteration.can_be_direct(commands, memories) && tile->same_state(from.structure())
        && from->same_state(to.structure())) {
        const struct {
            uint tile_extent;
        } parameters = {tile->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint from_origin;
            uint from_size;
            uint to_origin;
            uint to_size;
            std::uint64_t addresses[2];
        } parameters = {tile.size(), from.origin(), from.size(), to.origin(), to.size(), {}};
        static_assert(sizeof parameters == 40);
        iteration.count(from, 8);
        iteration.count(to, 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

void double_tiles(const glift::Commands& commands, const glift::Range<Values>& from, const glift::Range<Values>& to) {
    double_tiles(commands, from, from, to);
}

extern const glift::Kernel add_far_kernel;

void add_far(const glift::Commands& commands, const glift::Range<Values>& tile, const glift::Range<Values>& from,
    uint far_, const glift::Range<Values>& to) {
    glift::Iteration iteration(add_far_kernel);
    iteration.each("tile", tile);
    iteration.any("from", from);
    iteration.any("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {tile, from, to});
    if (iteration.can_be_direct(commands, memories) && tile->same_state(from.structure())
        && from->same_state(to.structure())) {
        const struct {
            uint tile_extent;
            uint far_;
        } parameters = {tile->extent(), far_};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint from_origin;
            uint from_size;
            uint to_origin;
            uint to_size;
            uint far_;
            std::uint64_t addresses[2];
        } parameters = {tile.size(), from.origin(), from.size(), to.origin(), to.size(), far_, {}};
        static_assert(sizeof parameters == 40);
        iteration.count(from, 8);
        iteration.count(to, 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

void add_far(const glift::Commands& commands, const glift::Range<Values>& from, uint far_,
    const glift::Range<Values>& to) {
    add_far(commands, from, from, far_, to);
}

}  // namespace guards
