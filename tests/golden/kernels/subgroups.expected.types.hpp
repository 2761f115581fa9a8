// Made by gliftc from subgroups.glift. Changes are lost when it is made again.
#pragma once

#include <glift/vector.h>

#include <cstddef>
#include <optional>

namespace subgroups {

#ifndef GLIFT_subgroups_HAS_Best
#define GLIFT_subgroups_HAS_Best
struct Best {
    float value{};
    glift::uint2 where{};
    glift::array<int, 2> list{};
    bool operator==(const Best&) const = default;
    template <class See> void describe(See&& see) const {
        see.value("value", value);
        see.value("where", where);
        see.value("list", list);
    }
};
static_assert(offsetof(Best, value) == 0);
static_assert(offsetof(Best, where) == 4);
static_assert(offsetof(Best, list) == 12);
#endif

}  // namespace subgroups
