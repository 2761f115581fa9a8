// Made by gliftc from device_values.glift. Changes are lost when it is made again.
#include "device_values.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace device_values {

using namespace glift::types;

extern const glift::Kernel scale_kernel;

void scale(const glift::Commands& commands, const glift::Range<Line>& a, uint by) {
    glift::Iteration iteration(scale_kernel);
    iteration.each("a", a);
    const glift::Memory memories[] = {a->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint a_extent;
            uint by;
        } parameters = {a->extent(), by};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint a_origin;
            uint by;
            std::uint64_t addresses[1];
        } parameters = {a.size(), a.origin(), by, {}};
        static_assert(sizeof parameters == 24);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel value_a0d1f05f_2_kernel;

GLIFT_SHARED void value_a0d1f05f_2(const glift::Commands& commands, const glift::DeviceScalar<uint>& element,
    const glift::DeviceScalar<uint>& element_2, uint by, const glift::Range<::std_transfer::Box_1_uint>& result) {
    glift::Iteration iteration(value_a0d1f05f_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {element.memory, element_2.memory, result->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {{}, {}, result});
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint element_index;
            uint element_2_index;
            uint result_extent;
            uint by;
        } parameters = {element.index(), element_2.index(), result->extent(), by};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint element_index;
            uint element_2_index;
            uint result_origin;
            uint by;
            std::uint64_t addresses[3];
        } parameters = {result.size(), element.index(), element_2.index(), result.origin(), by, {}};
        static_assert(sizeof parameters == 48);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel value_324e3ecf_2_kernel;

GLIFT_SHARED void value_324e3ecf_2(const glift::Commands& commands, const glift::DeviceScalar<uint>& n,
    const glift::Range<::std_transfer::Box_1_bool>& result) {
    glift::Iteration iteration(value_324e3ecf_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {n.memory, result->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {{}, result});
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint n_index;
            uint result_extent;
        } parameters = {n.index(), result->extent()};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint n_index;
            uint result_origin;
            std::uint64_t addresses[2];
        } parameters = {result.size(), n.index(), result.origin(), {}};
        static_assert(sizeof parameters == 32);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel scale_device_by_kernel;

GLIFT_SHARED void scale_device_by(const glift::Commands& commands, const glift::Range<Line>& a,
    const glift::DeviceScalar<uint>& by) {
    glift::Iteration iteration(scale_device_by_kernel);
    iteration.each("a", a);
    const glift::Memory memories[] = {by.memory, a->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {a, {}});
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint by_index;
            uint a_extent;
        } parameters = {by.index(), a->extent()};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint by_index;
            uint a_origin;
            std::uint64_t addresses[2];
        } parameters = {a.size(), by.index(), a.origin(), {}};
        static_assert(sizeof parameters == 32);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel value_true_2_kernel;

GLIFT_SHARED void value_true_2(const glift::Commands& commands,
    const glift::Range<::std_transfer::Box_1_bool>& result) {
    glift::Iteration iteration(value_true_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {result->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint result_extent;
        } parameters = {result->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint result_origin;
            std::uint64_t addresses[1];
        } parameters = {result.size(), result.origin(), {}};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel value_0u_2_kernel;

GLIFT_SHARED void value_0u_2(const glift::Commands& commands, const glift::Range<::std_transfer::Box_1_uint>& result) {
    glift::Iteration iteration(value_0u_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {result->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint result_extent;
        } parameters = {result->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint result_origin;
            std::uint64_t addresses[1];
        } parameters = {result.size(), result.origin(), {}};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel value_53ad928e_2_kernel;

GLIFT_SHARED void value_53ad928e_2(const glift::Commands& commands, const glift::DeviceScalar<glift::Bool>& condition,
    const glift::DeviceScalar<uint>& times, const glift::Range<::std_transfer::Box_1_uint>& result) {
    glift::Iteration iteration(value_53ad928e_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {condition.memory, times.memory, result->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {{}, {}, result});
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint condition_index;
            uint times_index;
            uint result_extent;
        } parameters = {condition.index(), times.index(), result->extent()};
        static_assert(sizeof parameters == 12);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint condition_index;
            uint times_index;
            uint result_origin;
            std::uint64_t addresses[3];
        } parameters = {result.size(), condition.index(), times.index(), result.origin(), {}};
        static_assert(sizeof parameters == 40);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel value_b207683c_2_kernel;

GLIFT_SHARED void value_b207683c_2(const glift::Commands& commands, const glift::DeviceScalar<glift::Bool>& running,
    const glift::DeviceScalar<uint>& element, const glift::DeviceScalar<uint>& times,
    const glift::Range<::std_transfer::Box_1_bool>& result) {
    glift::Iteration iteration(value_b207683c_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {running.memory, element.memory, times.memory, result->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {{}, {}, {}, result});
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint running_index;
            uint element_index;
            uint times_index;
            uint result_extent;
        } parameters = {running.index(), element.index(), times.index(), result->extent()};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint running_index;
            uint element_index;
            uint times_index;
            uint result_origin;
            std::uint64_t addresses[4];
        } parameters = {result.size(), running.index(), element.index(), times.index(), result.origin(), {}};
        static_assert(sizeof parameters == 56);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel value_7992094a_2_kernel;

GLIFT_SHARED void value_7992094a_2(const glift::Commands& commands, const glift::DeviceScalar<glift::Bool>& running,
    const glift::DeviceScalar<uint>& times, const glift::Range<::std_transfer::Box_1_uint>& result) {
    glift::Iteration iteration(value_7992094a_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {running.memory, times.memory, result->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {{}, {}, result});
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint running_index;
            uint times_index;
            uint result_extent;
        } parameters = {running.index(), times.index(), result->extent()};
        static_assert(sizeof parameters == 12);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint running_index;
            uint times_index;
            uint result_origin;
            std::uint64_t addresses[3];
        } parameters = {result.size(), running.index(), times.index(), result.origin(), {}};
        static_assert(sizeof parameters == 40);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

// device_values.glift:14: value
GLIFT_SHARED glift::DeviceScalar<uint> value_a0d1f05f(const glift::Commands& commands,
    glift::DeviceScalar<uint> element, glift::DeviceScalar<uint> element_2, uint by) {
    // device_values.glift:14
    ::std_transfer::Box_1_uint result(commands.always().uninitialized(), 1u);
    value_a0d1f05f_2(commands.always(), element, element_2, by, result);
    return result.element_in_place(commands.always(), 0u);
}

// device_values.glift:16: value
GLIFT_SHARED glift::DeviceScalar<glift::Bool> value_324e3ecf(const glift::Commands& commands,
    glift::DeviceScalar<uint> n) {
    // device_values.glift:16
    ::std_transfer::Box_1_bool result(commands.always().uninitialized(), 1u);
    value_324e3ecf_2(commands.always(), n, result);
    return result.element_in_place(commands.always(), 0u);
}

// device_values.glift:22: value
GLIFT_SHARED glift::DeviceScalar<glift::Bool> value_true(const glift::Commands& commands) {
    // device_values.glift:22
    ::std_transfer::Box_1_bool result(commands.always().uninitialized(), 1u);
    value_true_2(commands.always(), result);
    return result.element_in_place(commands.always(), 0u);
}

// device_values.glift:15: value
GLIFT_SHARED glift::DeviceScalar<uint> value_0u(const glift::Commands& commands) {
    // device_values.glift:15
    ::std_transfer::Box_1_uint result(commands.always().uninitialized(), 1u);
    value_0u_2(commands.always(), result);
    return result.element_in_place(commands.always(), 0u);
}

// device_values.glift:18: value
GLIFT_SHARED glift::DeviceScalar<uint> value_53ad928e(const glift::Commands& commands,
    glift::DeviceScalar<glift::Bool> condition, glift::DeviceScalar<uint> times) {
    // device_values.glift:18
    ::std_transfer::Box_1_uint result(commands.always().uninitialized(), 1u);
    value_53ad928e_2(commands.always(), condition, times, result);
    return result.element_in_place(commands.always(), 0u);
}

// device_values.glift:22: value
GLIFT_SHARED glift::DeviceScalar<glift::Bool> value_b207683c(const glift::Commands& commands,
    glift::DeviceScalar<glift::Bool> running, glift::DeviceScalar<uint> element, glift::DeviceScalar<uint> times) {
    // device_values.glift:22
    ::std_transfer::Box_1_bool result(commands.always().uninitialized(), 1u);
    value_b207683c_2(commands.always(), running, element, times, result);
    return result.element_in_place(commands.always(), 0u);
}

// device_values.glift:24: value
GLIFT_SHARED glift::DeviceScalar<uint> value_7992094a(const glift::Commands& commands,
    glift::DeviceScalar<glift::Bool> running, glift::DeviceScalar<uint> times) {
    // device_values.glift:24
    ::std_transfer::Box_1_uint result(commands.always().uninitialized(), 1u);
    value_7992094a_2(commands.always(), running, times, result);
    return result.element_in_place(commands.always(), 0u);
}

// device_values.glift:13: choose
glift::DeviceScalar<uint> choose(const glift::Commands& commands, const Line& a, const Line& counts, uint by) {
    const glift::PipelineMark _mark("choose", "device_values.glift:13");
    // device_values.glift:14
    const glift::DeviceScalar<uint> n = value_a0d1f05f(commands, counts.element_in_place(commands, 0u),
        counts.element_in_place(commands, 1u), by);
    // device_values.glift:15
    glift::DeviceScalar<uint> times = value_0u(commands);
    // device_values.glift:16
    const glift::DeviceScalar<glift::Bool> condition = value_324e3ecf(commands, n);
    {
        const glift::Commands commands_ = commands.where(condition);
        // device_values.glift:17
        scale_device_by(commands_, a.first(n), n);
        // device_values.glift:18
        times = value_53ad928e(commands_, condition, times);
    }
    {
        const glift::Commands commands_ = commands.where_not(condition);
        // device_values.glift:20
        scale(commands_, a, by);
    }
    // device_values.glift:22
    glift::DeviceScalar<glift::Bool> running = value_true(commands);
    for (uint round = 0u; round < 4u; ++round) {
        running = value_b207683c(commands, running, counts.element_in_place(commands, 2u), times);
        {
            const glift::Commands commands_ = commands.where(running);
            // device_values.glift:23
            scale(commands_, a, 2u);
            // device_values.glift:24
            times = value_7992094a(commands_, running, times);
        }
    }
    // device_values.glift:26
    return times;
}

}  // namespace device_values
