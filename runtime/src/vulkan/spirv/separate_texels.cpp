#include "separate_texels.h"

#include "spirv_module.h"
#include "vulkan/unknown_bit.h"

#include <unordered_map>

namespace glift::detail {

namespace {

using namespace spirv;

class SeparatingTexels {
public:
    explicit SeparatingTexels(SpirvWords spirv) : spirv_(spirv), next_id_(spirv[spirv_bound_word]) {
        for_each_instruction(spirv, [&](std::uint32_t op, SpirvWords w) {
            bit_.read(op, w);
            read(op, w);
        });
    }

    std::vector<std::uint32_t> separated() {
        if (!writes_ || !bit_.exists()) return {spirv_.begin(), spirv_.end()};
        std::vector<std::uint32_t> module(spirv_.begin(), spirv_.begin() + spirv_header_words);
        for_each_instruction(spirv_, [&](std::uint32_t op, SpirvWords w) {
            if (op == function) bit_.declare(module, next_id_);
            const std::uint32_t type = written_type(op, w);
            const std::uint32_t texel = type == 0 ? 0 : separate(module, type, w[texel_operand]);
            const std::size_t at = module.size();
            module.insert(module.end(), w.begin(), w.end());
            if (texel != 0) module[at + texel_operand] = texel;
        });
        module[spirv_bound_word] = next_id_;
        return module;
    }

private:
    static constexpr std::size_t texel_operand = 3;

    void read(std::uint32_t op, SpirvWords w) {
        switch (op) {
        case type_int: vectors_.emplace(w[1], 0); break;
        case type_vector:
            if (const auto scalar = vectors_.find(w[2]); scalar != vectors_.end() && w[3] == 4) scalar->second = w[1];
            break;
        case type_image: texels_of_types_.emplace(w[1], w[2]); break;
        case load:
            if (const auto type = texels_of_types_.find(w[1]); type != texels_of_types_.end())
                texels_of_images_.emplace(w[2], type->second);
            break;
        case image_write: writes_ = writes_ || written_type(op, w) != 0; break;
        default: break;
        }
    }

    /// The scalar type of the integer texel of four components that the instruction writes; 0: it writes none.
    std::uint32_t written_type(std::uint32_t op, SpirvWords w) const {
        if (op != image_write) return 0;
        const auto texel = texels_of_images_.find(w[1]);
        if (texel == texels_of_images_.end()) return 0;
        const auto vector = vectors_.find(texel->second);
        return vector == vectors_.end() || vector->second == 0 ? 0 : texel->second;
    }

    std::uint32_t sum(std::vector<std::uint32_t>& module, std::uint32_t type, std::uint32_t a, std::uint32_t b) {
        const std::uint32_t result = next_id_++;
        append(module, i_add, {type, result, a, b});
        return result;
    }

    /// (x, y + bit, z + 2 bit, w + 3 bit)
    std::uint32_t separate(std::vector<std::uint32_t>& module, std::uint32_t type, std::uint32_t texel) {
        const std::uint32_t bit = bit_.emit(module, next_id_);
        std::uint32_t zero = bit;
        for (std::uint32_t k = 1; k < 4; ++k) {
            if (k != 1) zero = sum(module, bit_.type(), zero, bit);
            const std::uint32_t part = next_id_++;
            append(module, composite_extract, {type, part, texel, k});
            const std::uint32_t separate_part = sum(module, type, part, zero), changed = next_id_++;
            append(module, composite_insert, {vectors_.at(type), changed, separate_part, texel, k});
            texel = changed;
        }
        return texel;
    }

    SpirvWords spirv_;
    std::uint32_t next_id_;
    UnknownBit bit_;
    bool writes_ = false;
    std::unordered_map<std::uint32_t, std::uint32_t> vectors_;  ///< of four components, by integer type; 0: none
    std::unordered_map<std::uint32_t, std::uint32_t> texels_of_types_;   ///< scalar types of texels, by image type
    std::unordered_map<std::uint32_t, std::uint32_t> texels_of_images_;  ///< the same, by loaded image
};

}  // namespace

std::vector<std::uint32_t> with_separate_texels(std::span<const std::uint32_t> spirv) {
    return SeparatingTexels(spirv).separated();
}

}  // namespace glift::detail
