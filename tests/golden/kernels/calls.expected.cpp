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

namespace {
struct push_even_direct_parameters {
    uint x_extent;
    uint bag_capacity;
    uint bag_items_extent;
    glift::Bool x_extent_value_0;
};
static_assert(offsetof(push_even_direct_parameters, x_extent) == 0);
static_assert(offsetof(push_even_direct_parameters, bag_capacity) == 4);
static_assert(offsetof(push_even_direct_parameters, bag_items_extent) == 8);
static_assert(offsetof(push_even_direct_parameters, x_extent_value_0) == 12);
struct push_even_general_parameters {
    uint size;
    uint x_origin;
    uint lost_origin;
    uint lost_size;
    uint bag_capacity;
    uint bag_items_extent;
};
static_assert(offsetof(push_even_general_parameters, size) == 0);
static_assert(offsetof(push_even_general_parameters, x_origin) == 4);
static_assert(offsetof(push_even_general_parameters, lost_origin) == 8);
static_assert(offsetof(push_even_general_parameters, lost_size) == 12);
static_assert(offsetof(push_even_general_parameters, bag_capacity) == 16);
static_assert(offsetof(push_even_general_parameters, bag_items_extent) == 20);
struct push_even_wide_parameters {
    uint size;
    uint x_origin;
    uint lost_origin;
    uint lost_size;
    uint bag_capacity;
    uint bag_items_extent;
    std::uint64_t x_data_address;
    std::uint64_t bag_seen_data_address;
    std::uint64_t bag_top_data_address;
    std::uint64_t bag_items_data_address;
    std::uint64_t lost_data_address;
};
static_assert(offsetof(push_even_wide_parameters, size) == 0);
static_assert(offsetof(push_even_wide_parameters, x_origin) == 4);
static_assert(offsetof(push_even_wide_parameters, lost_origin) == 8);
static_assert(offsetof(push_even_wide_parameters, lost_size) == 12);
static_assert(offsetof(push_even_wide_parameters, bag_capacity) == 16);
static_assert(offsetof(push_even_wide_parameters, bag_items_extent) == 20);
static_assert(offsetof(push_even_wide_parameters, x_data_address) == 24);
static_assert(offsetof(push_even_wide_parameters, bag_seen_data_address) == 32);
static_assert(offsetof(push_even_wide_parameters, bag_top_data_address) == 40);
static_assert(offsetof(push_even_wide_parameters, bag_items_data_address) == 48);
static_assert(offsetof(push_even_wide_parameters, lost_data_address) == 56);
}  // namespace

extern const glift::Kernel push_even_kernel;

void push_even(const glift::Commands& commands, const glift::Range<Line>& x, const Bag& bag,
    const glift::Range<Line>& lost) {
    glift::Iteration iteration(push_even_kernel);
    iteration.each("x", x);
    iteration.any("lost", lost);
    const glift::Memory memories[] = {x->data(), bag.seen().data(), bag.top().data(), bag.items().data(), lost->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {x, {}, lost});
    if (commands.needs_wide(push_even_kernel, memories, iteration.size())) {
        const push_even_wide_parameters parameters = {
            .size = x.size(),
            .x_origin = x.origin(),
            .lost_origin = lost.origin(),
            .lost_size = lost.size(),
            .bag_capacity = bag.capacity(),
            .bag_items_extent = bag.items().extent(),
            .x_data_address = 0u,
            .bag_seen_data_address = 0u,
            .bag_top_data_address = 0u,
            .bag_items_data_address = 0u,
            .lost_data_address = 0u,
        };
        iteration.count(lost, offsetof(push_even_wide_parameters, lost_size));
        commands.dispatch(push_even_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(push_even_wide_parameters, size)}), .sharing = iteration.sharing()});
    } else if (iteration.is_whole() && x->same_state(lost.structure())) {
        const push_even_direct_parameters parameters = {
            .x_extent = x->extent(),
            .bag_capacity = bag.capacity(),
            .bag_items_extent = bag.items().extent(),
            .x_extent_value_0 = 0u < x->extent(),
        };
        commands.dispatch(push_even_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const push_even_general_parameters parameters = {
            .size = x.size(),
            .x_origin = x.origin(),
            .lost_origin = lost.origin(),
            .lost_size = lost.size(),
            .bag_capacity = bag.capacity(),
            .bag_items_extent = bag.items().extent(),
        };
        iteration.count(lost, offsetof(push_even_general_parameters, lost_size));
        commands.dispatch(push_even_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(push_even_general_parameters, size)}),
            .sharing = iteration.sharing()});
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
