// Made by gliftc from operators.glift. Changes are lost when it is made again.
#include "operators.glift.internal.hpp"

#include <glift/host/math.h>

#include <cstddef>
#include <optional>

namespace operators {

using namespace glift::types;

extern const glift::Kernel use_both_kernel;

void use_both(const glift::Commands& commands, const glift::Range<Line>& a, [[maybe_unused]] Max max, Affine affine) {
    glift::Iteration iteration(use_both_kernel);
    iteration.each("a", a);
    const glift::Memory memories[] = {a->data()};
    if (iteration.can_be_direct(commands, memories)) {
        const struct {
            uint a_extent;
            uint affine_modulus;
        } parameters = {a->extent(), affine.modulus};
        static_assert(sizeof parameters == 8);
        iteration.dispatch(commands, glift::FormName::direct, memories, glift::bytes_of(parameters));
    } else {
        const struct {
            uint size;
            uint a_origin;
            uint affine_modulus;
            std::uint64_t addresses[1];
        } parameters = {a.size(), a.origin(), affine.modulus, {}};
        static_assert(sizeof parameters == 24);
        iteration.dispatch(commands, glift::FormName::general, memories, glift::bytes_of(parameters), {0});
    }
}

}  // namespace operators
