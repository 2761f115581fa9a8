#include "float_atomics.h"

#include "spirv_module.h"

#include <string_view>
#include <unordered_set>

namespace glift::detail {

using namespace spirv;

namespace {

/// What an OpExtension names. Its text ends with at least one zero byte.
std::string_view extension_name(SpirvWords w) { return reinterpret_cast<const char*>(&w[1]); }

}  // namespace

std::vector<std::uint32_t> without_float_atomics(std::span<const std::uint32_t> spirv) {
    std::unordered_set<std::uint32_t> texels;  // pointers to texels
    bool is_used_by_images = false;
    for_each_instruction(spirv, [&](std::uint32_t op, SpirvWords w) {
        if (op == image_texel_pointer) texels.insert(w[2]);
        is_used_by_images |= op == atomic_f_add && texels.contains(w[3]);
    });
    std::vector<std::uint32_t> module(spirv.begin(), spirv.begin() + spirv_header_words);
    for_each_instruction(spirv, [&](std::uint32_t op, SpirvWords w) {
        const bool is_declaration = (op == capability && w[1] == atomic_float32_add) ||
                                    (op == extension && extension_name(w) == "SPV_EXT_shader_atomic_float_add");
        if (is_declaration && !is_used_by_images) return;
        if (op == atomic_f_add && !texels.contains(w[3])) return append(module, copy_object, {w[1], w[2], w[6]});
        module.insert(module.end(), w.begin(), w.end());
    });
    return module;
}

}  // namespace glift::detail
