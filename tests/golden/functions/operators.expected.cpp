// Made by gliftc from operators.glift. Changes are lost when it is made again.
#include "operators.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace operators {

using namespace glift::types;

namespace {
struct use_both_direct_parameters {
    uint a_extent;
    uint affine_modulus;
};
static_assert(offsetof(use_both_direct_parameters, a_extent) == 0);
static_assert(offsetof(use_both_direct_parameters, affine_modulus) == 4);
struct use_both_general_parameters {
    uint size;
    uint a_origin;
    uint affine_modulus;
};
static_assert(offsetof(use_both_general_parameters, size) == 0);
static_assert(offsetof(use_both_general_parameters, a_origin) == 4);
static_assert(offsetof(use_both_general_parameters, affine_modulus) == 8);
struct use_both_wide_parameters {
    uint size;
    uint a_origin;
    uint affine_modulus;
    std::uint64_t a_data_address;
};
static_assert(offsetof(use_both_wide_parameters, size) == 0);
static_assert(offsetof(use_both_wide_parameters, a_origin) == 4);
static_assert(offsetof(use_both_wide_parameters, affine_modulus) == 8);
static_assert(offsetof(use_both_wide_parameters, a_data_address) == 16);
}  // namespace

extern const glift::Kernel use_both_kernel;

void use_both(const glift::Commands& commands, const glift::Range<Line>& a, [[maybe_unused]] Max max, Affine affine) {
    glift::Iteration iteration(use_both_kernel);
    iteration.each("a", a);
    const glift::Memory memories[] = {a->data()};
    if (commands.needs_wide(use_both_kernel, memories, iteration.size())) {
        const use_both_wide_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .affine_modulus = affine.modulus,
            .a_data_address = 0u,
        };
        commands.dispatch(use_both_kernel, {.form = glift::FormName::wide, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(use_both_wide_parameters, size)})});
    } else if (iteration.is_whole()) {
        const use_both_direct_parameters parameters = {
            .a_extent = a->extent(),
            .affine_modulus = affine.modulus,
        };
        commands.dispatch(use_both_kernel, {.form = glift::FormName::direct, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size()});
    } else {
        const use_both_general_parameters parameters = {
            .size = a.size(),
            .a_origin = a.origin(),
            .affine_modulus = affine.modulus,
        };
        commands.dispatch(use_both_kernel, {.form = glift::FormName::general, .memories = memories,
            .parameters = glift::bytes_of(parameters), .size = iteration.size(),
            .patches = iteration.patches({offsetof(use_both_general_parameters, size)})});
    }
}

}  // namespace operators
