#include "requirements.h"

#include "spirv_module.h"

#include <algorithm>
#include <vector>

namespace glift::detail {

namespace {

struct Requirement {
    std::uint32_t capability;
    bool DeviceProperties::*property;
    const char* text;
};
constexpr Requirement requirements[] = {
    {9, &DeviceProperties::float16, "16-bit floats"},
    {10, &DeviceProperties::float64, "64-bit floats"},
    {11, &DeviceProperties::int64, "64-bit integers"},
    {12, &DeviceProperties::int64_atomics, "64-bit atomics"},
    {62, &DeviceProperties::subgroup_vote, "subgroup votes"},
    {63, &DeviceProperties::subgroup_arithmetic, "subgroup arithmetic"},
    {64, &DeviceProperties::subgroup_ballot, "subgroup ballots"},
    {65, &DeviceProperties::subgroup_shuffle, "subgroup shuffles"},
    {66, &DeviceProperties::subgroup_shuffle_relative, "relative subgroup shuffles"},
};

bool contains(const std::vector<std::uint32_t>& ids, std::uint32_t id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

}  // namespace

std::string lacking(std::span<const std::uint32_t> spirv, const DeviceProperties& properties) {
    std::string text;
    const auto add = [&](const char* what) { text += (text.empty() ? "" : ", ") + std::string(what); };
    std::vector<std::uint32_t> extended;  // types that need shaderSubgroupExtendedTypes
    bool exchanges_extended = false;
    for (std::size_t at = spirv_header_words; at < spirv.size();) {
        const std::uint32_t op = spirv[at] & 0xffffu, words = spirv[at] >> 16;
        if (words == 0) break;
        const auto word = [&](std::size_t k) { return spirv[at + k]; };
        if (op == spirv::capability) {
            for (const Requirement& r : requirements)
                if (r.capability == word(1) && !(properties.*r.property)) add(r.text);
        }
        if ((op == spirv::type_int && word(2) != 32) || (op == spirv::type_float && word(2) == 16))
            extended.push_back(word(1));
        if (op == spirv::type_vector && contains(extended, word(2))) extended.push_back(word(1));
        exchanges_extended |= op >= spirv::group_non_uniform_elect && op <= spirv::group_non_uniform_quad_swap &&
                              contains(extended, word(1));
        at += words;
    }
    if (exchanges_extended && !properties.subgroup_extended_types)
        add("subgroup operations on 16-bit and 64-bit types");
    return text;
}

bool uses_subgroups(std::span<const std::uint32_t> spirv) {
    bool uses = false;
    for_each_instruction(spirv, [&](std::uint32_t op, SpirvWords words) {
        uses |= op == spirv::capability && words[1] >= spirv::group_non_uniform &&
                words[1] <= spirv::group_non_uniform_quad;
    });
    return uses;
}

}  // namespace glift::detail
