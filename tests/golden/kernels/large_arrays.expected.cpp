// Made by gliftc from large_arrays.glift. Changes are lost when it is made again.
#include "large_arrays.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace large_arrays {

using namespace glift::types;

extern const glift::Kernel count_digits_kernel;

void count_digits(const glift::Commands& commands, const glift::Range<Values>& row, const glift::Range<Values>& from,
    const glift::Range<Values>& counts) {
    glift::Iteration iteration(count_digits_kernel);
    iteration.each("row", row);
    iteration.any("from", from);
    iteration.any("counts", counts);
    const glift::Memory memories[] = {from->data(), counts->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {row, from, counts});
    if (iteration.can_be_direct(commands, memories) && row->same_state(from.structure())
        && from->same_state(counts.structure())) {
        const struct {
            uint row_extent;
        } parameters = {row->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint from_origin;
            uint from_size;
            uint counts_origin;
            uint counts_size;
            std::uint64_t addresses[2];
        } parameters = {row.size(), from.origin(), from.size(), counts.origin(), counts.size(), {}};
        static_assert(sizeof parameters == 40);
        iteration.count(from, 8);
        iteration.count(counts, 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

void count_digits(const glift::Commands& commands, const glift::Range<Values>& from,
    const glift::Range<Values>& counts) {
    count_digits(commands, from, from, counts);
}

extern const glift::Kernel corners_kernel;

void corners(const glift::Commands& commands, const glift::Range<Values>& i, const glift::Range<Values>& to) {
    glift::Iteration iteration(corners_kernel);
    iteration.each("i", i);
    iteration.any("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.can_be_direct(commands, memories) && i->same_state(to.structure())) {
        const struct {
            uint i_extent;
        } parameters = {i->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint to_origin;
            uint to_size;
            std::uint64_t addresses[1];
        } parameters = {i.size(), to.origin(), to.size(), {}};
        static_assert(sizeof parameters == 24);
        iteration.count(to, 8);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

void corners(const glift::Commands& commands, const glift::Range<Values>& to) {
    corners(commands, to, to);
}

}  // namespace large_arrays
