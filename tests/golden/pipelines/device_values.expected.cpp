// Made by gliftc from device_values.glift. Changes are lost when it is made again.
#include "device_values.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace device_values {

using namespace glift::types;

namespace {
struct scale_direct_parameters {
    uint a_extent;
    uint by;
};
static_assert(offsetof(scale_direct_parameters, a_extent) == 0);
static_assert(offsetof(scale_direct_parameters, by) == 4);
struct scale_general_parameters {
    uint size;
    uint a_origin;
    uint by;
};
static_assert(offsetof(scale_general_parameters, size) == 0);
static_assert(offsetof(scale_general_parameters, a_origin) == 4);
static_assert(offsetof(scale_general_parameters, by) == 8);
struct scale_wide_parameters {
    uint size;
    uint a_origin;
    uint by;
    std::uint64_t a_data_address;
};
static_assert(offsetof(scale_wide_parameters, size) == 0);
static_assert(offsetof(scale_wide_parameters, a_origin) == 4);
static_assert(offsetof(scale_wide_parameters, by) == 8);
static_assert(offsetof(scale_wide_parameters, a_data_address) == 16);
}  // namespace

extern const glift::Kernel scale_kernel;

void scale(const glift::Commands& commands, const glift::Range<Line>& a, uint by) {
    glift::Iteration iteration(scale_kernel);
    iteration.each("a", a);
    const glift::Memory memories[] = {a->data()};
    if (commands.needs_wide(scale_kernel, memories, iteration.size())) {
        const scale_wide_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .by = by,
            .a_data_address = 0u,
        };
        commands.dispatch(scale_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(scale_wide_parameters, size)})});
    } else if (iteration.is_whole()) {
        const scale_direct_parameters parameters = {
            .a_extent = a->extent(),
            .by = by,
        };
        commands.dispatch(scale_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const scale_general_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .by = by,
        };
        commands.dispatch(scale_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(scale_general_parameters, size)})});
    }
}

namespace {
struct value_a0d1f05f_2_direct_parameters {
    uint element_index;
    uint element_2_index;
    uint result_extent;
    uint by;
};
static_assert(offsetof(value_a0d1f05f_2_direct_parameters, element_index) == 0);
static_assert(offsetof(value_a0d1f05f_2_direct_parameters, element_2_index) == 4);
static_assert(offsetof(value_a0d1f05f_2_direct_parameters, result_extent) == 8);
static_assert(offsetof(value_a0d1f05f_2_direct_parameters, by) == 12);
struct value_a0d1f05f_2_general_parameters {
    uint size;
    uint element_index;
    uint element_2_index;
    uint result_origin;
    uint by;
};
static_assert(offsetof(value_a0d1f05f_2_general_parameters, size) == 0);
static_assert(offsetof(value_a0d1f05f_2_general_parameters, element_index) == 4);
static_assert(offsetof(value_a0d1f05f_2_general_parameters, element_2_index) == 8);
static_assert(offsetof(value_a0d1f05f_2_general_parameters, result_origin) == 12);
static_assert(offsetof(value_a0d1f05f_2_general_parameters, by) == 16);
struct value_a0d1f05f_2_wide_parameters {
    uint size;
    uint element_index;
    uint element_2_index;
    uint result_origin;
    uint by;
    std::uint64_t element_data_address;
    std::uint64_t element_2_data_address;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, size) == 0);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, element_index) == 4);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, element_2_index) == 8);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, result_origin) == 12);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, by) == 16);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, element_data_address) == 24);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, element_2_data_address) == 32);
static_assert(offsetof(value_a0d1f05f_2_wide_parameters, result_data_address) == 40);
}  // namespace

extern const glift::Kernel value_a0d1f05f_2_kernel;

GLIFT_SHARED void value_a0d1f05f_2(const glift::Commands& commands, const glift::DeviceScalar<uint>& element,
    const glift::DeviceScalar<uint>& element_2, uint by, const glift::Range<::std_transfer::Box_1_uint>& result) {
    glift::Iteration iteration(value_a0d1f05f_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {element.memory, element_2.memory, result->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {{}, {}, result});
    if (commands.needs_wide(value_a0d1f05f_2_kernel, memories, iteration.size())) {
        const value_a0d1f05f_2_wide_parameters parameters = {
            .size = result.size(),
            .element_index = element.index(),
            .element_2_index = element_2.index(),
            .result_origin = result.origin(),
            .by = by,
            .element_data_address = 0u,
            .element_2_data_address = 0u,
            .result_data_address = 0u,
        };
        commands.dispatch(value_a0d1f05f_2_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_a0d1f05f_2_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const value_a0d1f05f_2_direct_parameters parameters = {
            .element_index = element.index(),
            .element_2_index = element_2.index(),
            .result_extent = result->extent(),
            .by = by,
        };
        commands.dispatch(value_a0d1f05f_2_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const value_a0d1f05f_2_general_parameters parameters = {
            .size = result.size(),
            .element_index = element.index(),
            .element_2_index = element_2.index(),
            .result_origin = result.origin(),
            .by = by,
        };
        commands.dispatch(value_a0d1f05f_2_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_a0d1f05f_2_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct value_324e3ecf_2_direct_parameters {
    uint n_index;
    uint result_extent;
};
static_assert(offsetof(value_324e3ecf_2_direct_parameters, n_index) == 0);
static_assert(offsetof(value_324e3ecf_2_direct_parameters, result_extent) == 4);
struct value_324e3ecf_2_general_parameters {
    uint size;
    uint n_index;
    uint result_origin;
};
static_assert(offsetof(value_324e3ecf_2_general_parameters, size) == 0);
static_assert(offsetof(value_324e3ecf_2_general_parameters, n_index) == 4);
static_assert(offsetof(value_324e3ecf_2_general_parameters, result_origin) == 8);
struct value_324e3ecf_2_wide_parameters {
    uint size;
    uint n_index;
    uint result_origin;
    std::uint64_t n_data_address;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_324e3ecf_2_wide_parameters, size) == 0);
static_assert(offsetof(value_324e3ecf_2_wide_parameters, n_index) == 4);
static_assert(offsetof(value_324e3ecf_2_wide_parameters, result_origin) == 8);
static_assert(offsetof(value_324e3ecf_2_wide_parameters, n_data_address) == 16);
static_assert(offsetof(value_324e3ecf_2_wide_parameters, result_data_address) == 24);
}  // namespace

extern const glift::Kernel value_324e3ecf_2_kernel;

GLIFT_SHARED void value_324e3ecf_2(const glift::Commands& commands, const glift::DeviceScalar<uint>& n,
    const glift::Range<::std_transfer::Box_1_bool>& result) {
    glift::Iteration iteration(value_324e3ecf_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {n.memory, result->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {{}, result});
    if (commands.needs_wide(value_324e3ecf_2_kernel, memories, iteration.size())) {
        const value_324e3ecf_2_wide_parameters parameters = {
            .size = result.size(),
            .n_index = n.index(),
            .result_origin = result.origin(),
            .n_data_address = 0u,
            .result_data_address = 0u,
        };
        commands.dispatch(value_324e3ecf_2_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_324e3ecf_2_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const value_324e3ecf_2_direct_parameters parameters = {
            .n_index = n.index(),
            .result_extent = result->extent(),
        };
        commands.dispatch(value_324e3ecf_2_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const value_324e3ecf_2_general_parameters parameters = {
            .size = result.size(),
            .n_index = n.index(),
            .result_origin = result.origin(),
        };
        commands.dispatch(value_324e3ecf_2_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_324e3ecf_2_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct scale_device_by_direct_parameters {
    uint by_index;
    uint a_extent;
};
static_assert(offsetof(scale_device_by_direct_parameters, by_index) == 0);
static_assert(offsetof(scale_device_by_direct_parameters, a_extent) == 4);
struct scale_device_by_general_parameters {
    uint size;
    uint by_index;
    uint a_origin;
};
static_assert(offsetof(scale_device_by_general_parameters, size) == 0);
static_assert(offsetof(scale_device_by_general_parameters, by_index) == 4);
static_assert(offsetof(scale_device_by_general_parameters, a_origin) == 8);
struct scale_device_by_wide_parameters {
    uint size;
    uint by_index;
    uint a_origin;
    std::uint64_t by_data_address;
    std::uint64_t a_data_address;
};
static_assert(offsetof(scale_device_by_wide_parameters, size) == 0);
static_assert(offsetof(scale_device_by_wide_parameters, by_index) == 4);
static_assert(offsetof(scale_device_by_wide_parameters, a_origin) == 8);
static_assert(offsetof(scale_device_by_wide_parameters, by_data_address) == 16);
static_assert(offsetof(scale_device_by_wide_parameters, a_data_address) == 24);
}  // namespace

extern const glift::Kernel scale_device_by_kernel;

GLIFT_SHARED void scale_device_by(const glift::Commands& commands, const glift::Range<Line>& a,
    const glift::DeviceScalar<uint>& by) {
    glift::Iteration iteration(scale_device_by_kernel);
    iteration.each("a", a);
    const glift::Memory memories[] = {by.memory, a->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {a, {}});
    if (commands.needs_wide(scale_device_by_kernel, memories, iteration.size())) {
        const scale_device_by_wide_parameters parameters = {
            .size = a.size(),
            .by_index = by.index(),
            .a_origin = a.origin(),
            .by_data_address = 0u,
            .a_data_address = 0u,
        };
        commands.dispatch(scale_device_by_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(scale_device_by_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const scale_device_by_direct_parameters parameters = {
            .by_index = by.index(),
            .a_extent = a->extent(),
        };
        commands.dispatch(scale_device_by_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const scale_device_by_general_parameters parameters = {
            .size = a.size(),
            .by_index = by.index(),
            .a_origin = a.origin(),
        };
        commands.dispatch(scale_device_by_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(scale_device_by_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct value_true_2_direct_parameters {
    uint result_extent;
};
static_assert(offsetof(value_true_2_direct_parameters, result_extent) == 0);
struct value_true_2_general_parameters {
    uint size;
    uint result_origin;
};
static_assert(offsetof(value_true_2_general_parameters, size) == 0);
static_assert(offsetof(value_true_2_general_parameters, result_origin) == 4);
struct value_true_2_wide_parameters {
    uint size;
    uint result_origin;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_true_2_wide_parameters, size) == 0);
static_assert(offsetof(value_true_2_wide_parameters, result_origin) == 4);
static_assert(offsetof(value_true_2_wide_parameters, result_data_address) == 8);
}  // namespace

extern const glift::Kernel value_true_2_kernel;

GLIFT_SHARED void value_true_2(const glift::Commands& commands,
    const glift::Range<::std_transfer::Box_1_bool>& result) {
    glift::Iteration iteration(value_true_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {result->data()};
    if (commands.needs_wide(value_true_2_kernel, memories, iteration.size())) {
        const value_true_2_wide_parameters parameters = {
            .size = result.size(),
            .result_origin = result.origin(),
            .result_data_address = 0u,
        };
        commands.dispatch(value_true_2_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_true_2_wide_parameters, size)})});
    } else if (iteration.is_whole()) {
        const value_true_2_direct_parameters parameters = {
            .result_extent = result->extent(),
        };
        commands.dispatch(value_true_2_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const value_true_2_general_parameters parameters = {
            .size = result.size(),
            .result_origin = result.origin(),
        };
        commands.dispatch(value_true_2_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_true_2_general_parameters, size)})});
    }
}

namespace {
struct value_0u_2_direct_parameters {
    uint result_extent;
};
static_assert(offsetof(value_0u_2_direct_parameters, result_extent) == 0);
struct value_0u_2_general_parameters {
    uint size;
    uint result_origin;
};
static_assert(offsetof(value_0u_2_general_parameters, size) == 0);
static_assert(offsetof(value_0u_2_general_parameters, result_origin) == 4);
struct value_0u_2_wide_parameters {
    uint size;
    uint result_origin;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_0u_2_wide_parameters, size) == 0);
static_assert(offsetof(value_0u_2_wide_parameters, result_origin) == 4);
static_assert(offsetof(value_0u_2_wide_parameters, result_data_address) == 8);
}  // namespace

extern const glift::Kernel value_0u_2_kernel;

GLIFT_SHARED void value_0u_2(const glift::Commands& commands, const glift::Range<::std_transfer::Box_1_uint>& result) {
    glift::Iteration iteration(value_0u_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {result->data()};
    if (commands.needs_wide(value_0u_2_kernel, memories, iteration.size())) {
        const value_0u_2_wide_parameters parameters = {
            .size = result.size(),
            .result_origin = result.origin(),
            .result_data_address = 0u,
        };
        commands.dispatch(value_0u_2_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_0u_2_wide_parameters, size)})});
    } else if (iteration.is_whole()) {
        const value_0u_2_direct_parameters parameters = {
            .result_extent = result->extent(),
        };
        commands.dispatch(value_0u_2_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size()});
    } else {
        const value_0u_2_general_parameters parameters = {
            .size = result.size(),
            .result_origin = result.origin(),
        };
        commands.dispatch(value_0u_2_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_0u_2_general_parameters, size)})});
    }
}

namespace {
struct value_53ad928e_2_direct_parameters {
    uint condition_index;
    uint times_index;
    uint result_extent;
};
static_assert(offsetof(value_53ad928e_2_direct_parameters, condition_index) == 0);
static_assert(offsetof(value_53ad928e_2_direct_parameters, times_index) == 4);
static_assert(offsetof(value_53ad928e_2_direct_parameters, result_extent) == 8);
struct value_53ad928e_2_general_parameters {
    uint size;
    uint condition_index;
    uint times_index;
    uint result_origin;
};
static_assert(offsetof(value_53ad928e_2_general_parameters, size) == 0);
static_assert(offsetof(value_53ad928e_2_general_parameters, condition_index) == 4);
static_assert(offsetof(value_53ad928e_2_general_parameters, times_index) == 8);
static_assert(offsetof(value_53ad928e_2_general_parameters, result_origin) == 12);
struct value_53ad928e_2_wide_parameters {
    uint size;
    uint condition_index;
    uint times_index;
    uint result_origin;
    std::uint64_t condition_data_address;
    std::uint64_t times_data_address;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_53ad928e_2_wide_parameters, size) == 0);
static_assert(offsetof(value_53ad928e_2_wide_parameters, condition_index) == 4);
static_assert(offsetof(value_53ad928e_2_wide_parameters, times_index) == 8);
static_assert(offsetof(value_53ad928e_2_wide_parameters, result_origin) == 12);
static_assert(offsetof(value_53ad928e_2_wide_parameters, condition_data_address) == 16);
static_assert(offsetof(value_53ad928e_2_wide_parameters, times_data_address) == 24);
static_assert(offsetof(value_53ad928e_2_wide_parameters, result_data_address) == 32);
}  // namespace

extern const glift::Kernel value_53ad928e_2_kernel;

GLIFT_SHARED void value_53ad928e_2(const glift::Commands& commands, const glift::DeviceScalar<glift::Bool>& condition,
    const glift::DeviceScalar<uint>& times, const glift::Range<::std_transfer::Box_1_uint>& result) {
    glift::Iteration iteration(value_53ad928e_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {condition.memory, times.memory, result->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {{}, {}, result});
    if (commands.needs_wide(value_53ad928e_2_kernel, memories, iteration.size())) {
        const value_53ad928e_2_wide_parameters parameters = {
            .size = result.size(),
            .condition_index = condition.index(),
            .times_index = times.index(),
            .result_origin = result.origin(),
            .condition_data_address = 0u,
            .times_data_address = 0u,
            .result_data_address = 0u,
        };
        commands.dispatch(value_53ad928e_2_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_53ad928e_2_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const value_53ad928e_2_direct_parameters parameters = {
            .condition_index = condition.index(),
            .times_index = times.index(),
            .result_extent = result->extent(),
        };
        commands.dispatch(value_53ad928e_2_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const value_53ad928e_2_general_parameters parameters = {
            .size = result.size(),
            .condition_index = condition.index(),
            .times_index = times.index(),
            .result_origin = result.origin(),
        };
        commands.dispatch(value_53ad928e_2_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_53ad928e_2_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct value_b207683c_2_direct_parameters {
    uint running_index;
    uint element_index;
    uint times_index;
    uint result_extent;
};
static_assert(offsetof(value_b207683c_2_direct_parameters, running_index) == 0);
static_assert(offsetof(value_b207683c_2_direct_parameters, element_index) == 4);
static_assert(offsetof(value_b207683c_2_direct_parameters, times_index) == 8);
static_assert(offsetof(value_b207683c_2_direct_parameters, result_extent) == 12);
struct value_b207683c_2_general_parameters {
    uint size;
    uint running_index;
    uint element_index;
    uint times_index;
    uint result_origin;
};
static_assert(offsetof(value_b207683c_2_general_parameters, size) == 0);
static_assert(offsetof(value_b207683c_2_general_parameters, running_index) == 4);
static_assert(offsetof(value_b207683c_2_general_parameters, element_index) == 8);
static_assert(offsetof(value_b207683c_2_general_parameters, times_index) == 12);
static_assert(offsetof(value_b207683c_2_general_parameters, result_origin) == 16);
struct value_b207683c_2_wide_parameters {
    uint size;
    uint running_index;
    uint element_index;
    uint times_index;
    uint result_origin;
    std::uint64_t running_data_address;
    std::uint64_t element_data_address;
    std::uint64_t times_data_address;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_b207683c_2_wide_parameters, size) == 0);
static_assert(offsetof(value_b207683c_2_wide_parameters, running_index) == 4);
static_assert(offsetof(value_b207683c_2_wide_parameters, element_index) == 8);
static_assert(offsetof(value_b207683c_2_wide_parameters, times_index) == 12);
static_assert(offsetof(value_b207683c_2_wide_parameters, result_origin) == 16);
static_assert(offsetof(value_b207683c_2_wide_parameters, running_data_address) == 24);
static_assert(offsetof(value_b207683c_2_wide_parameters, element_data_address) == 32);
static_assert(offsetof(value_b207683c_2_wide_parameters, times_data_address) == 40);
static_assert(offsetof(value_b207683c_2_wide_parameters, result_data_address) == 48);
}  // namespace

extern const glift::Kernel value_b207683c_2_kernel;

GLIFT_SHARED void value_b207683c_2(const glift::Commands& commands, const glift::DeviceScalar<glift::Bool>& running,
    const glift::DeviceScalar<uint>& element, const glift::DeviceScalar<uint>& times,
    const glift::Range<::std_transfer::Box_1_bool>& result) {
    glift::Iteration iteration(value_b207683c_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {running.memory, element.memory, times.memory, result->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {{}, {}, {}, result});
    if (commands.needs_wide(value_b207683c_2_kernel, memories, iteration.size())) {
        const value_b207683c_2_wide_parameters parameters = {
            .size = result.size(),
            .running_index = running.index(),
            .element_index = element.index(),
            .times_index = times.index(),
            .result_origin = result.origin(),
            .running_data_address = 0u,
            .element_data_address = 0u,
            .times_data_address = 0u,
            .result_data_address = 0u,
        };
        commands.dispatch(value_b207683c_2_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_b207683c_2_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const value_b207683c_2_direct_parameters parameters = {
            .running_index = running.index(),
            .element_index = element.index(),
            .times_index = times.index(),
            .result_extent = result->extent(),
        };
        commands.dispatch(value_b207683c_2_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const value_b207683c_2_general_parameters parameters = {
            .size = result.size(),
            .running_index = running.index(),
            .element_index = element.index(),
            .times_index = times.index(),
            .result_origin = result.origin(),
        };
        commands.dispatch(value_b207683c_2_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_b207683c_2_general_parameters,
            size)}), .sharing = iteration.sharing()});
    }
}

namespace {
struct value_7992094a_2_direct_parameters {
    uint running_index;
    uint times_index;
    uint result_extent;
};
static_assert(offsetof(value_7992094a_2_direct_parameters, running_index) == 0);
static_assert(offsetof(value_7992094a_2_direct_parameters, times_index) == 4);
static_assert(offsetof(value_7992094a_2_direct_parameters, result_extent) == 8);
struct value_7992094a_2_general_parameters {
    uint size;
    uint running_index;
    uint times_index;
    uint result_origin;
};
static_assert(offsetof(value_7992094a_2_general_parameters, size) == 0);
static_assert(offsetof(value_7992094a_2_general_parameters, running_index) == 4);
static_assert(offsetof(value_7992094a_2_general_parameters, times_index) == 8);
static_assert(offsetof(value_7992094a_2_general_parameters, result_origin) == 12);
struct value_7992094a_2_wide_parameters {
    uint size;
    uint running_index;
    uint times_index;
    uint result_origin;
    std::uint64_t running_data_address;
    std::uint64_t times_data_address;
    std::uint64_t result_data_address;
};
static_assert(offsetof(value_7992094a_2_wide_parameters, size) == 0);
static_assert(offsetof(value_7992094a_2_wide_parameters, running_index) == 4);
static_assert(offsetof(value_7992094a_2_wide_parameters, times_index) == 8);
static_assert(offsetof(value_7992094a_2_wide_parameters, result_origin) == 12);
static_assert(offsetof(value_7992094a_2_wide_parameters, running_data_address) == 16);
static_assert(offsetof(value_7992094a_2_wide_parameters, times_data_address) == 24);
static_assert(offsetof(value_7992094a_2_wide_parameters, result_data_address) == 32);
}  // namespace

extern const glift::Kernel value_7992094a_2_kernel;

GLIFT_SHARED void value_7992094a_2(const glift::Commands& commands, const glift::DeviceScalar<glift::Bool>& running,
    const glift::DeviceScalar<uint>& times, const glift::Range<::std_transfer::Box_1_uint>& result) {
    glift::Iteration iteration(value_7992094a_2_kernel);
    iteration.each("result", result);
    const glift::Memory memories[] = {running.memory, times.memory, result->data()};
    if (iteration.is_shared(memories)) iteration.share(memories, {{}, {}, result});
    if (commands.needs_wide(value_7992094a_2_kernel, memories, iteration.size())) {
        const value_7992094a_2_wide_parameters parameters = {
            .size = result.size(),
            .running_index = running.index(),
            .times_index = times.index(),
            .result_origin = result.origin(),
            .running_data_address = 0u,
            .times_data_address = 0u,
            .result_data_address = 0u,
        };
        commands.dispatch(value_7992094a_2_kernel,
            {.form = glift::FormName::wide, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_7992094a_2_wide_parameters, size)}),
            .sharing = iteration.sharing()});
    } else if (iteration.is_whole()) {
        const value_7992094a_2_direct_parameters parameters = {
            .running_index = running.index(),
            .times_index = times.index(),
            .result_extent = result->extent(),
        };
        commands.dispatch(value_7992094a_2_kernel,
            {.form = glift::FormName::direct, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .sharing = iteration.sharing()});
    } else {
        const value_7992094a_2_general_parameters parameters = {
            .size = result.size(),
            .running_index = running.index(),
            .times_index = times.index(),
            .result_origin = result.origin(),
        };
        commands.dispatch(value_7992094a_2_kernel,
            {.form = glift::FormName::general, .memories = memories, .parameters = glift::bytes_of(parameters),
            .size = iteration.size(), .patches = iteration.patches({offsetof(value_7992094a_2_general_parameters,
            size)}), .sharing = iteration.sharing()});
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
