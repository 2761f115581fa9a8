// A zero that a driver's compiler cannot know to be zero: the top bit of x of the invocation's global number or, where
// a module does not have that, of the workgroup's number. One-dimensional passes are folded before they have 2^31
// invocations along x (limit_along_x in groups.h), so the bit is not set. The exception is a pass in two or more
// dimensions with rows of 2^31 invocations. (The lowest bit of x * (x + 1) would not do: NVIDIA's driver knows that it
// is 0.)
#pragma once

#include "vulkan/spirv/spirv_module.h"

namespace glift::detail {

class UnknownBit {
public:
    /// To be called for each instruction of the module, before anything is written.
    void read(std::uint32_t op, SpirvWords w) {
        using namespace spirv;
        switch (op) {
        case decorate:
            if (w.size() != 4 || w[2] != built_in) return;
            if (w[3] == global_invocation_id || (w[3] == workgroup_id && input_ == 0)) input_ = w[1];
            return;
        case type_int:
            if (w[2] == 32 && w[3] == 0) uint_ = w[1];
            return;
        case type_vector:
            if (w[2] == uint_ && w[3] == 3) uint3_ = w[1];
            return;
        default: return;
        }
    }

    /// Whether the module has the number of the invocation or the workgroup. Modules of draws have neither.
    bool exists() const { return input_ != 0 && uint3_ != 0; }
    /// The id of the type of unsigned integers of 32 bits.
    std::uint32_t type() const { return uint_; }

    /// Declares the constant that `emit` needs, if that was not done. To be called before the module's first function.
    void declare(std::vector<std::uint32_t>& module, std::uint32_t& next_id) {
        if (shift_ != 0) return;
        shift_ = next_id++;
        append(module, spirv::constant, {uint_, shift_, 31});
    }

    /// Computes the bit, as a uint, and returns its id.
    std::uint32_t emit(std::vector<std::uint32_t>& module, std::uint32_t& next_id) const {
        const std::uint32_t all = next_id++, first = next_id++, bit = next_id++;
        append(module, spirv::load, {uint3_, all, input_});
        append(module, spirv::composite_extract, {uint_, first, all, 0});
        append(module, spirv::shift_right_logical, {uint_, bit, first, shift_});
        return bit;
    }

private:
    std::uint32_t input_ = 0, uint_ = 0, uint3_ = 0, shift_ = 0;
};

}  // namespace glift::detail
