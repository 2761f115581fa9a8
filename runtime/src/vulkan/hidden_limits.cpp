#include "hidden_limits.h"

#include "spirv_module.h"
#include "unknown_bit.h"

#include <algorithm>
#include <unordered_map>

namespace glift::detail {

namespace {

using namespace spirv;

constexpr std::int32_t highest_begin = -2;  // loops from -1 to 0 are right

class HidingLimits {
public:
    explicit HidingLimits(SpirvWords spirv) : spirv_(spirv), next_id_(spirv[spirv_bound_word]) {
        for_each_instruction(spirv, [&](std::uint32_t op, SpirvWords w) {
            bit_.read(op, w);
            read(op, w);
        });
    }

    std::vector<std::uint32_t> hidden() {
        const bool may_go_wrong =
            std::ranges::any_of(constants_, [](const auto& c) { return c.second <= highest_begin; });
        if (!may_go_wrong || !bit_.exists()) return {spirv_.begin(), spirv_.end()};
        std::vector<std::uint32_t> module(spirv_.begin(), spirv_.begin() + spirv_header_words);
        bool is_declared = false;
        for_each_instruction(spirv_, [&](std::uint32_t op, SpirvWords w) {
            if (op == function && !is_declared) bit_.declare(module, next_id_), is_declared = true;
            const std::size_t limit = limit_of(op, w);
            const std::uint32_t unknown = limit == 0 ? 0 : hide(module, w[limit]);
            const std::size_t at = module.size();
            module.insert(module.end(), w.begin(), w.end());
            if (limit != 0) module[at + limit] = unknown;
        });
        module[spirv_bound_word] = next_id_;
        return module;
    }

private:
    void read(std::uint32_t op, SpirvWords w) {
        switch (op) {
        case type_int:
            if (w[2] == 32 && w[3] == 1) int_ = w[1];
            break;
        case constant:
            if (w[1] == int_) constants_.emplace(w[2], static_cast<std::int32_t>(w[3]));
            break;
        default: break;
        }
    }

    bool is(std::uint32_t id, std::int32_t value) const {
        const auto found = constants_.find(id);
        return found != constants_.end() && found->second == value;
    }

    /// The index of the operand that is the constant, if the instruction compares with one so that 0 and 1 differ:
    /// `x < 1`, `x >= 1`, `x <= 0`, `x > 0`, or with the constant first; else 0.
    std::size_t limit_of(std::uint32_t op, SpirvWords w) const {
        const bool of_one = op == s_less_than || op == s_greater_than_equal;  // with the constant last
        const bool of_zero = op == s_less_than_equal || op == s_greater_than;
        if (!of_one && !of_zero) return 0;
        if (is(w[4], of_one ? 1 : 0)) return 4;
        return is(w[3], of_one ? 0 : 1) ? 3 : 0;
    }

    std::uint32_t hide(std::vector<std::uint32_t>& module, std::uint32_t limit) {
        const std::uint32_t bit = bit_.emit(module, next_id_), result = next_id_++;
        append(module, bitwise_or, {int_, result, limit, bit});
        return result;
    }

    SpirvWords spirv_;
    std::uint32_t next_id_, int_ = 0;
    UnknownBit bit_;
    std::unordered_map<std::uint32_t, std::int32_t> constants_;  ///< of ints
};

}  // namespace

std::vector<std::uint32_t> with_hidden_limits(std::span<const std::uint32_t> spirv) {
    return HidingLimits(spirv).hidden();
}

}  // namespace glift::detail
