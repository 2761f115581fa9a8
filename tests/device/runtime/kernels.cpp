#include "kernels.h"

#include "add_in_place.h"
#include "image_step.h"
#include "mark_grid.h"
#include "number_lanes.h"
#include "report.h"
#include "scale_direct.h"
#include "scale_general.h"
#include "store_value.h"

#include <algorithm>
#include <cmath>

namespace kernels {

using glift::Access;
using glift::Binding;
using glift::HostCall;
using glift::MemoryKind;

namespace {

template <class T> T* data(const HostCall& call, std::size_t k) { return reinterpret_cast<T*>(call.memories[k].data); }
template <class T> const T& parameters(const HostCall& call) { return *static_cast<const T*>(call.parameters); }

void host_scale(const HostCall& call) {
    const auto& p = parameters<ScaleParameters>(call);
    for (std::uint32_t i = 0; i < call.size[0]; ++i) data<float>(call, 1)[i] = p.factor * data<float>(call, 0)[i];
}

void host_add(const HostCall& call) {
    const auto& p = parameters<AddParameters>(call);
    for (std::uint32_t i = 0; i < call.size[0]; ++i)
        data<std::uint32_t>(call, 0)[i] = data<std::uint32_t>(call, 0)[i] * 2 + p.amount;
}

void host_store(const HostCall& call) {
    std::fill_n(data<std::uint32_t>(call, 0), call.size[0], parameters<AddParameters>(call).amount);
}

void host_mark(const HostCall& call) {
    auto* g = data<std::uint32_t>(call, 0);
    for (std::uint32_t z = 0; z < call.size[2]; ++z) {
        for (std::uint32_t y = 0; y < call.size[1]; ++y) {
            for (std::uint32_t x = 0; x < call.size[0]; ++x) g[(z * call.size[1] + y) * call.size[0] + x] += 1 + y;
        }
    }
}

void host_image_step(const HostCall& call) {
    const std::uint32_t width = call.size[0];
    for (std::uint32_t y = 0; y < call.size[1]; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const float* row = data<float>(call, 0) + y * width;
            data<float>(call, 1)[y * width + x] = 0.5f * (row[x] + row[std::min(x + 1, width - 1)]) + 1.0f;
        }
    }
}

void host_report(const HostCall& call) {
    for (std::uint32_t i = 0; i < call.size[0]; ++i) {
        if (i < 10) {
            data<std::uint32_t>(call, 0)[i] = i;
        } else if (i == 10) {
            *call.status = {glift::StatusRecord::out_of_range, 21, 1, 0, {i, 0, 0, 0}};
        }
    }
}

const Binding scale_bindings[] = {
    {.name = "f.data", .kind = MemoryKind::buffer, .access = Access::read, .address_offset = 8},
    {.name = "g.data", .kind = MemoryKind::buffer, .access = Access::write, .address_offset = 16}};
const Binding in_place[] = {{.name = "g.data", .kind = MemoryKind::buffer, .access = Access::read_write}};
const Binding marked[] = {
    {.name = "g.data", .kind = MemoryKind::buffer, .access = Access::read_write, .address_offset = 24}};
const Binding out_only[] = {{.name = "g.data", .kind = MemoryKind::buffer, .access = Access::write}};
const Binding image_bindings[] = {{.name = "f.data",
                                   .kind = MemoryKind::image2d,
                                   .access = Access::read,
                                   .sampled = true,
                                   .sampler = {glift::Filter::linear, glift::AddressMode::clamp_to_edge}},
                                  {.name = "g.data", .kind = MemoryKind::image2d, .access = Access::write}};

}  // namespace

const glift::Kernel scale = {
    .name = "scale",
    .file = "scale.glift",
    .line = 3,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = scale_bindings,
    .direct = {.spirv = scale_direct, .host = host_scale, .parameter_bytes = 8, .push_constants = true},
    .general = {.spirv = scale_general, .host = host_scale, .parameter_bytes = 24}};

const glift::Kernel add_in_place = {
    .name = "add_in_place",
    .file = "add.glift",
    .line = 4,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = in_place,
    .direct = {.spirv = ::add_in_place, .host = host_add, .parameter_bytes = 8, .push_constants = true}};

const glift::Kernel store_value = {
    .name = "store_value",
    .file = "store.glift",
    .line = 5,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = out_only,
    .direct = {.spirv = ::store_value, .host = host_store, .parameter_bytes = 8, .push_constants = true}};

const glift::Kernel number_lanes = {
    .name = "number_lanes",
    .file = "lanes.glift",
    .line = 9,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = 0,
    .bindings = out_only,
    .direct = {.spirv = ::number_lanes, .host = host_store, .parameter_bytes = 8, .push_constants = true}};

const glift::Kernel mark_grid = {
    .name = "mark_grid",
    .file = "mark.glift",
    .line = 6,
    .rank = 3,
    .group = {1, 1, 1},
    .loop_rounds = 0,
    .bindings = marked,
    .direct = {.host = host_mark, .parameter_bytes = 24},
    .general = {.spirv = ::mark_grid, .host = host_mark, .parameter_bytes = 32, .base_offset = 12}};

const glift::Kernel image_step = {
    .name = "image_step",
    .file = "image.glift",
    .line = 7,
    .rank = 2,
    .group = {8, 8, 1},
    .loop_rounds = 0,
    .bindings = image_bindings,
    .direct = {.spirv = ::image_step, .host = host_image_step, .parameter_bytes = 8, .push_constants = true}};

const glift::Kernel report = {
    .name = "report",
    .file = "report.glift",
    .line = 8,
    .rank = 1,
    .group = {64, 1, 1},
    .loop_rounds = UINT64_MAX,
    .bindings = in_place,
    .direct = {.spirv = ::report, .host = host_report, .parameter_bytes = 4, .push_constants = true},
    .reports = true};

glift::Memory buffer(const glift::Device& device, const char* name, std::uint64_t bytes) {
    return device.allocate({.name = name, .bytes = bytes});
}

void run_scale(const glift::Commands& commands, const glift::Memory& f, const glift::Memory& g, std::uint32_t size,
               float factor) {
    const glift::Memory memories[] = {f, g};
    const ScaleParameters block = {size, factor};
    const std::array<std::uint32_t, 4> axes = {size, 1, 1, 1};
    if (commands.can_be_direct(scale, memories, axes))
        commands.dispatch(scale, {.form = glift::FormName::direct,
                                  .memories = memories,
                                  .parameters = bytes_of(block).first(8),
                                  .size = axes});
    else
        commands.dispatch(
            scale,
            {.form = glift::FormName::general, .memories = memories, .parameters = bytes_of(block), .size = axes});
}

void run_add(const glift::Commands& commands, const glift::Memory& g, std::uint32_t size, std::uint32_t amount) {
    const AddParameters block = {size, amount};
    commands.dispatch(
        add_in_place,
        {.form = glift::FormName::direct, .memories = {&g, 1}, .parameters = bytes_of(block), .size = {size, 1, 1, 1}});
}

void run_lanes(const glift::Commands& commands, const glift::Memory& g, std::uint32_t size) {
    const AddParameters block = {size, 0};
    commands.dispatch(
        number_lanes,
        {.form = glift::FormName::direct, .memories = {&g, 1}, .parameters = bytes_of(block), .size = {size, 1, 1, 1}});
}

void run_store(const glift::Commands& commands, const glift::Memory& g, std::uint32_t size, std::uint32_t value) {
    const AddParameters block = {size, value};
    commands.dispatch(
        store_value,
        {.form = glift::FormName::direct, .memories = {&g, 1}, .parameters = bytes_of(block), .size = {size, 1, 1, 1}});
}

}  // namespace kernels
