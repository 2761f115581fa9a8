// Made by gliftc from subgroups.glift. Changes are lost when it is made again.
#include "subgroups.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace subgroups {

using namespace glift::types;

extern const glift::Kernel best_of_subgroup_kernel;

void best_of_subgroup(const glift::Commands& commands, const glift::Range<Values>& from,
    const glift::Range<Values>& to) {
    glift::Iteration iteration(best_of_subgroup_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.can_be_direct(commands, memories) && from->same_state(to.structure())) {
        const struct {
            uint from_extent;
        } parameters = {from->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint from_origin;
            uint to_origin;
            std::uint64_t addresses[2];
        } parameters = {from.size(), from.origin(), to.origin(), {}};
        static_assert(sizeof parameters == 32);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel turn_subgroups_kernel;

void turn_subgroups(const glift::Commands& commands, const glift::Range<Values>& from, const glift::Range<Values>& to) {
    glift::Iteration iteration(turn_subgroups_kernel);
    iteration.each("from", from);
    iteration.each("to", to);
    const glift::Memory memories[] = {from->data(), to->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {from, to});
    if (iteration.can_be_direct(commands, memories) && from->same_state(to.structure())) {
        const struct {
            uint from_extent;
        } parameters = {from->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint from_origin;
            uint to_origin;
            std::uint64_t addresses[2];
        } parameters = {from.size(), from.origin(), to.origin(), {}};
        static_assert(sizeof parameters == 32);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

}  // namespace subgroups
