// Made by gliftc from devices.glift. Changes are lost when it is made again.
#include "devices.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace devices {

using namespace glift::types;

namespace {
struct on_any_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_any_direct_parameters, to_extent) == 0);
struct on_any_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_any_general_parameters, size) == 0);
static_assert(offsetof(on_any_general_parameters, to_origin) == 4);
struct on_any_wide_parameters {
    uint size;
    uint to_origin;
    std::uint64_t to_data_address;
};
static_assert(offsetof(on_any_wide_parameters, size) == 0);
static_assert(offsetof(on_any_wide_parameters, to_origin) == 4);
static_assert(offsetof(on_any_wide_parameters, to_data_address) == 8);
}  // namespace

extern const glift::Kernel on_any_kernel;

void on_any(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_any_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(on_any_kernel, memories, iteration.size())) {
        const on_any_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_data_address = 0u,
        };
        commands.dispatch(on_any_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(on_any_wide_parameters, size)})});
    } else if (iteration.is_whole()) {
        const on_any_direct_parameters parameters = {
            .to_extent = to->extent(),
        };
        commands.dispatch(on_any_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const on_any_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
        };
        commands.dispatch(on_any_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(on_any_general_parameters, size)})});
    }
}

namespace {
struct on_host_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_host_direct_parameters, to_extent) == 0);
struct on_host_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_host_general_parameters, size) == 0);
static_assert(offsetof(on_host_general_parameters, to_origin) == 4);
struct on_host_wide_parameters {
    uint size;
    uint to_origin;
    std::uint64_t to_data_address;
};
static_assert(offsetof(on_host_wide_parameters, size) == 0);
static_assert(offsetof(on_host_wide_parameters, to_origin) == 4);
static_assert(offsetof(on_host_wide_parameters, to_data_address) == 8);
}  // namespace

extern const glift::Kernel on_host_kernel;

void on_host(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_host_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(on_host_kernel, memories, iteration.size())) {
        const on_host_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_data_address = 0u,
        };
        commands.dispatch(on_host_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(on_host_wide_parameters, size)})});
    } else if (iteration.is_whole()) {
        const on_host_direct_parameters parameters = {
            .to_extent = to->extent(),
        };
        commands.dispatch(on_host_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const on_host_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
        };
        commands.dispatch(on_host_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(on_host_general_parameters, size)})});
    }
}

namespace {
struct on_gpu_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_gpu_direct_parameters, to_extent) == 0);
struct on_gpu_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_gpu_general_parameters, size) == 0);
static_assert(offsetof(on_gpu_general_parameters, to_origin) == 4);
struct on_gpu_wide_parameters {
    uint size;
    uint to_origin;
    std::uint64_t to_data_address;
};
static_assert(offsetof(on_gpu_wide_parameters, size) == 0);
static_assert(offsetof(on_gpu_wide_parameters, to_origin) == 4);
static_assert(offsetof(on_gpu_wide_parameters, to_data_address) == 8);
}  // namespace

extern const glift::Kernel on_gpu_kernel;

void on_gpu(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_gpu_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(on_gpu_kernel, memories, iteration.size())) {
        const on_gpu_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_data_address = 0u,
        };
        commands.dispatch(on_gpu_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(on_gpu_wide_parameters, size)})});
    } else if (iteration.is_whole()) {
        const on_gpu_direct_parameters parameters = {
            .to_extent = to->extent(),
        };
        commands.dispatch(on_gpu_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const on_gpu_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
        };
        commands.dispatch(on_gpu_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(on_gpu_general_parameters, size)})});
    }
}

namespace {
struct on_wide_subgroups_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_wide_subgroups_direct_parameters, to_extent) == 0);
struct on_wide_subgroups_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_wide_subgroups_general_parameters, size) == 0);
static_assert(offsetof(on_wide_subgroups_general_parameters, to_origin) == 4);
struct on_wide_subgroups_wide_parameters {
    uint size;
    uint to_origin;
    std::uint64_t to_data_address;
};
static_assert(offsetof(on_wide_subgroups_wide_parameters, size) == 0);
static_assert(offsetof(on_wide_subgroups_wide_parameters, to_origin) == 4);
static_assert(offsetof(on_wide_subgroups_wide_parameters, to_data_address) == 8);
}  // namespace

extern const glift::Kernel on_wide_subgroups_kernel;

void on_wide_subgroups(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_wide_subgroups_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(on_wide_subgroups_kernel, memories, iteration.size())) {
        const on_wide_subgroups_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_data_address = 0u,
        };
        commands.dispatch(on_wide_subgroups_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(on_wide_subgroups_wide_parameters,
            size)})});
    } else if (iteration.is_whole()) {
        const on_wide_subgroups_direct_parameters parameters = {
            .to_extent = to->extent(),
        };
        commands.dispatch(on_wide_subgroups_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const on_wide_subgroups_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
        };
        commands.dispatch(on_wide_subgroups_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(on_wide_subgroups_general_parameters,
            size)})});
    }
}

namespace {
struct on_vulkan_direct_parameters {
    uint to_extent;
};
static_assert(offsetof(on_vulkan_direct_parameters, to_extent) == 0);
struct on_vulkan_general_parameters {
    uint size;
    uint to_origin;
};
static_assert(offsetof(on_vulkan_general_parameters, size) == 0);
static_assert(offsetof(on_vulkan_general_parameters, to_origin) == 4);
struct on_vulkan_wide_parameters {
    uint size;
    uint to_origin;
    std::uint64_t to_data_address;
};
static_assert(offsetof(on_vulkan_wide_parameters, size) == 0);
static_assert(offsetof(on_vulkan_wide_parameters, to_origin) == 4);
static_assert(offsetof(on_vulkan_wide_parameters, to_data_address) == 8);
}  // namespace

extern const glift::Kernel on_vulkan_kernel;

void on_vulkan(const glift::Commands& commands, const glift::Range<Line>& to) {
    glift::Iteration iteration(on_vulkan_kernel);
    iteration.each("to", to);
    const glift::Memory memories[] = {to->data()};
    if (commands.needs_wide(on_vulkan_kernel, memories, iteration.size())) {
        const on_vulkan_wide_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
            .to_data_address = 0u,
        };
        commands.dispatch(on_vulkan_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(on_vulkan_wide_parameters, size)})});
    } else if (iteration.is_whole()) {
        const on_vulkan_direct_parameters parameters = {
            .to_extent = to->extent(),
        };
        commands.dispatch(on_vulkan_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const on_vulkan_general_parameters parameters = {
            .size = to.size(),
            .to_origin = to.origin(),
        };
        commands.dispatch(on_vulkan_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(on_vulkan_general_parameters, size)})});
    }
}

// devices.glift:28: by_gpu
void by_gpu(const glift::Commands& commands, const Line& to) {
    // devices.glift:29
    on_gpu(commands, to);
}

// devices.glift:32: fill
void fill(const glift::Commands& commands, const Line& to, bool many) {
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
