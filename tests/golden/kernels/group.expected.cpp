// Made by gliftc from group.glift. Changes are lost when it is made again.
#include "group.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace group_ {

using namespace glift::types;

extern const glift::Kernel block_sums_kernel;

void block_sums(const glift::Commands& commands, const glift::Range<Values>& value, const glift::Range<Values>& sums) {
    glift::Iteration iteration(block_sums_kernel);
    iteration.each("value", value);
    iteration.any("sums", sums);
    const glift::Memory memories[] = {value->data(), sums->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {value, sums});
    if (iteration.can_be_direct(commands, memories) && value->same_state(sums.structure())) {
        const struct {
            uint value_extent;
        } parameters = {value->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint value_origin;
            uint sums_origin;
            uint sums_size;
            std::uint64_t addresses[2];
        } parameters = {value.size(), value.origin(), sums.origin(), sums.size(), {}};
        static_assert(sizeof parameters == 32);
        iteration.count(sums, 12);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

}  // namespace group_
