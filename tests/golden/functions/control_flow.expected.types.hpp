// Made by gliftc from control_flow.glift. Changes are lost when it is made again.
#pragma once

#include <glift/vector.h>

#include <cstddef>
#include <optional>

namespace control_flow {

#ifndef GLIFT_control_flow_HAS_Interval
#define GLIFT_control_flow_HAS_Interval
struct Interval {
    float low{};
    float high{};
    bool operator==(const Interval&) const = default;
    template <class See> void describe(See&& see) const {
        see.value("low", low);
        see.value("high", high);
    }
};
static_assert(offsetof(Interval, low) == 0);
static_assert(offsetof(Interval, high) == 4);
#endif

}  // namespace control_flow
