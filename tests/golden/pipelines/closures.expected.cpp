// Made by gliftc from closures.glift. Changes are lost when it is made again.
#include "closures.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace closures {

using namespace glift::types;

extern const glift::Kernel map_981bca7b_kernel;

GLIFT_SHARED void map_981bca7b(const glift::Commands& commands, const glift::Range<Line>& x, shift_closure_1 f) {
    glift::Iteration iteration(map_981bca7b_kernel);
    iteration.each("x", x);
    const glift::Memory memories[] = {x->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint x_extent;
            shift_closure_1 f;
        } parameters = {x->extent(), f};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint x_origin;
            shift_closure_1 f;
            std::uint64_t addresses[1];
        } parameters = {x.size(), x.origin(), f, {}};
        static_assert(sizeof parameters == 24);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel map_961e05ec_kernel;

GLIFT_SHARED void map_961e05ec(const glift::Commands& commands, const glift::Range<Line>& x,
    [[maybe_unused]] shift_closure_2 f) {
    glift::Iteration iteration(map_961e05ec_kernel);
    iteration.each("x", x);
    const glift::Memory memories[] = {x->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint x_extent;
        } parameters = {x->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint x_origin;
            std::uint64_t addresses[1];
        } parameters = {x.size(), x.origin(), {}};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel map_5c862ce9_kernel;

GLIFT_SHARED void map_5c862ce9(const glift::Commands& commands, const glift::Range<Line>& x, shift_again_closure_2 f) {
    glift::Iteration iteration(map_5c862ce9_kernel);
    iteration.each("x", x);
    const glift::Memory memories[] = {x->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint x_extent;
            shift_again_closure_2 f;
        } parameters = {x->extent(), f};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint x_origin;
            shift_again_closure_2 f;
            std::uint64_t addresses[1];
        } parameters = {x.size(), x.origin(), f, {}};
        static_assert(sizeof parameters == 24);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel value_cb2bb9f7_2_kernel;

GLIFT_SHARED void value_cb2bb9f7_2(const glift::Commands& commands, const glift::DeviceScalar<float>& first,
    const glift::Range<::std_transfer::Box_d44f8d20>& result) {
    glift::Iteration iteration(value_cb2bb9f7_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {first.memory, result->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {{}, result});
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint first_index;
            uint result_extent;
        } parameters = {first.index(), result->extent()};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint first_index;
            uint result_origin;
            std::uint64_t addresses[2];
        } parameters = {result.size(), first.index(), result.origin(), {}};
        static_assert(sizeof parameters == 32);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel map_a2dc23fc_kernel;

GLIFT_SHARED void map_a2dc23fc(const glift::Commands& commands, const glift::Range<Line>& x,
    const glift::DeviceScalar<shift_by_first_closure_1>& f) {
    glift::Iteration iteration(map_a2dc23fc_kernel);
    iteration.each("x", x);
    const glift::Memory memories[] = {f.memory, x->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {x, {}});
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint f_index;
            uint x_extent;
        } parameters = {f.index(), x->extent()};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint f_index;
            uint x_origin;
            std::uint64_t addresses[2];
        } parameters = {x.size(), f.index(), x.origin(), {}};
        static_assert(sizeof parameters == 32);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

// closures.glift:16: shift
void shift(const glift::Commands& commands, const Line& x, float by) {
    const glift::PipelineMark _mark("shift", "closures.glift:16");
    // closures.glift:17
    map_981bca7b(commands, x, shift_closure_1{by});
    // closures.glift:18
    map_961e05ec(commands, x, shift_closure_2{});
}

// closures.glift:25: shift_again
void shift_again(const glift::Commands& commands, const Line& x, float by) {
    const glift::PipelineMark _mark("shift_again", "closures.glift:25");
    // closures.glift:26
    map_981bca7b(commands, x, shift_closure_1{by});
    // closures.glift:27
    map_5c862ce9(commands, x, shift_again_closure_2{by});
}

// closures.glift:33: value
GLIFT_SHARED glift::DeviceScalar<shift_by_first_closure_1> value_cb2bb9f7(const glift::Commands& commands,
    glift::DeviceScalar<float> first) {
    // closures.glift:33
    ::std_transfer::Box_d44f8d20 result(commands.always().uninitialized(), 1u);
    value_cb2bb9f7_2(commands.always(), first, result);
    return result.element_in_place(commands.always(), 0u);
}

// closures.glift:31: shift_by_first
void shift_by_first(const glift::Commands& commands, const Line& x) {
    const glift::PipelineMark _mark("shift_by_first", "closures.glift:31");
    // closures.glift:32
    const glift::DeviceScalar<float> first = x.element_in_place(commands, 0u);
    // closures.glift:33
    const glift::DeviceScalar<shift_by_first_closure_1> f = value_cb2bb9f7(commands, first);
    map_a2dc23fc(commands, x, f);
}

}  // namespace closures
