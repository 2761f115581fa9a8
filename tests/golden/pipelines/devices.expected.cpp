// Made by gliftc from devices.glift. Changes are lost when it is made again.
#include "devices.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace devices {

using namespace glift::types;

extern const glift::Kernel on_any_kernel;

void on_any(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_any_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint to_extent;
        } parameters = {to->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint to_origin;
            std::uint64_t addresses[1];
        } parameters = {to.size(), to.origin(), {}};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel on_host_kernel;

void on_host(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_host_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint to_extent;
        } parameters = {to->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint to_origin;
            std::uint64_t addresses[1];
        } parameters = {to.size(), to.origin(), {}};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel on_gpu_kernel;

void on_gpu(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_gpu_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint to_extent;
        } parameters = {to->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint to_origin;
            std::uint64_t addresses[1];
        } parameters = {to.size(), to.origin(), {}};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel on_wide_subgroups_kernel;

void on_wide_subgroups(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_wide_subgroups_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint to_extent;
        } parameters = {to->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint to_origin;
            std::uint64_t addresses[1];
        } parameters = {to.size(), to.origin(), {}};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

extern const glift::Kernel on_vulkan_kernel;

void on_vulkan(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_vulkan_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint to_extent;
        } parameters = {to->extent()};
        static_assert(sizeof parameters == 4);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint to_origin;
            std::uint64_t addresses[1];
        } parameters = {to.size(), to.origin(), {}};
        static_assert(sizeof parameters == 16);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

// devices.glift:28: by_gpu
void by_gpu(const glift::Commands& commands, const Line& to) {
    const glift::PipelineMark _mark("by_gpu", "devices.glift:28");
    // devices.glift:29
    on_gpu(commands, to);
}

// devices.glift:32: fill
void fill(const glift::Commands& commands, const Line& to, bool many) {
    const glift::PipelineMark _mark("fill", "devices.glift:32");
    // devices.glift:33
    on_any(commands, to);
    // devices.glift:34
    if ((commands.device().properties().kind == glift::DeviceKind::gpu) && many) {
        // devices.glift:35
        by_gpu(commands, to);
    }
    // devices.glift:37
    if (commands.device().properties().subgroup_size % 8u == 0u) {
        // devices.glift:38
        on_wide_subgroups(commands, to);
    }
    // devices.glift:40
    if (commands.device().is_host()) {
        // devices.glift:41
        on_host(commands, to);
        // devices.glift:42
        return;
    }
    // devices.glift:44
    on_vulkan(commands, to);
}

}  // namespace devices
