// Made by gliftc from calls.glift. Changes are lost when it is made again.
#include "calls.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace calls {

using namespace glift::types;

namespace {

// calls.glift:26: limit
inline uint limit(const Bag& self) {
    return self.capacity();
}

}  // namespace

extern const glift::Kernel push_even_kernel;

void push_even(const glift::Commands& commands, const glift::Range<Line>& x, const Bag& bag,
    const glift::Range<Line>& lost) {
    glift::Iteration iteration(push_even_kernel);
    iteration.each("x", x);
    iteration.any("lost", lost);
    const glift::Memory memories[] = {x->data(), bag.seen().data(), bag.top().data(), bag.items().data(), lost->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {x, {}, lost});
    if (iteration.can_be_direct(commands, memories) && x->same_state(lost.structure())) {
        const struct {
            uint x_extent;
            uint bag_capacity;
            uint bag_items_extent;
            glift::Bool x_extent_value_0;
        } parameters = {x->extent(), bag.capacity(), bag.items().extent(), 0u < x->extent()};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint x_origin;
            uint lost_origin;
            uint lost_size;
            uint bag_capacity;
            uint bag_items_extent;
            std::uint64_t addresses[5];
        } parameters = {x.size(), x.origin(), lost.origin(), lost.size(), bag.capacity(), bag.items().extent(), {}};
        static_assert(sizeof parameters == 64);
        iteration.count(lost, 12);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

Bag::Bag(const glift::Commands& commands, uint capacity)
    : device_(commands.device()),
      capacity_(capacity),
      items_(Line(commands, capacity_)),
      top_(Line(commands, 1u)),
      seen_(Line(commands, 32u)) {}

bool Bag::same_state(const Bag& other) const {
    return capacity_ == other.capacity_ && items_.get().same_state(other.items_.get())
        && top_.get().same_state(other.top_.get()) && seen_.get().same_state(other.seen_.get());
}

uint Bag::limit() const {
    return ::calls::limit(*this);
}

}  // namespace calls
