#include "hidden_limits.h"

#include "spirv_module.h"
#include "vulkan/unknown_bit.h"

#include <algorithm>
#include <unordered_map>

namespace glift::detail {

namespace {

using namespace spirv;

constexpr std::int32_t highest_begin = -2;  // loops that begin at -1 are compiled correctly

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
        for_each_instruction(spirv_, [&](std::uint32_t op, SpirvWords w) {
            if (op == function) declare(module);
            const Comparison comparison = comparison_with_one(op, w);
            const std::uint32_t limit = comparison.place == 0 ? 0 : hidden_one(module);
            const std::size_t at = module.size();
            module.insert(module.end(), w.begin(), w.end());
            if (comparison.place == 0) return;
            module[at] = first_word(comparison.op, w.size());
            module[at + comparison.place] = limit;
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
        case copy_object:  // with_fixed_parameters replaces loads of fixed parameters by these
            if (const auto found = constants_.find(w[3]); found != constants_.end())
                constants_.emplace(w[2], found->second);
            break;
        default: break;
        }
    }

    bool is(std::uint32_t id, std::int32_t value) const {
        const auto found = constants_.find(id);
        return found != constants_.end() && found->second == value;
    }

    /// A comparison with 1, and the index of the operand that is the 1; index 0: there is no such comparison.
    struct Comparison {
        std::uint32_t op = 0;
        std::size_t place = 0;
    };

    /// An equivalent comparison with 1, if the instruction compares a value with 0 or 1 and gives different results for
    /// the values 0 and 1.
    Comparison comparison_with_one(std::uint32_t op, SpirvWords w) const {
        switch (op) {
        case s_less_than:  // x < 1, 0 < x
            if (is(w[4], 1)) return {s_less_than, 4};
            return is(w[3], 0) ? Comparison{s_less_than_equal, 3} : Comparison{};
        case s_less_than_equal:  // x <= 0, 1 <= x
            if (is(w[4], 0)) return {s_less_than, 4};
            return is(w[3], 1) ? Comparison{s_less_than_equal, 3} : Comparison{};
        case s_greater_than:  // x > 0, 1 > x
            if (is(w[4], 0)) return {s_greater_than_equal, 4};
            return is(w[3], 1) ? Comparison{s_greater_than, 3} : Comparison{};
        case s_greater_than_equal:  // x >= 1, 0 >= x
            if (is(w[4], 1)) return {s_greater_than_equal, 4};
            return is(w[3], 0) ? Comparison{s_greater_than, 3} : Comparison{};
        default: return {};
        }
    }

    void declare(std::vector<std::uint32_t>& module) {
        bit_.declare(module, next_id_);
        if (one_ != 0) return;
        one_ = next_id_++;
        append(module, constant, {int_, one_, 1});
    }

    /// 1, which the driver does not know: the unknown bit is added, not or-ed, since the driver knows that 1 | bit
    /// is 1.
    std::uint32_t hidden_one(std::vector<std::uint32_t>& module) {
        const std::uint32_t bit = bit_.emit(module, next_id_), result = next_id_++;
        append(module, i_add, {int_, result, one_, bit});
        return result;
    }

    SpirvWords spirv_;
    std::uint32_t next_id_, int_ = 0, one_ = 0;
    UnknownBit bit_;
    std::unordered_map<std::uint32_t, std::int32_t> constants_;  ///< values of ints, by id
};

}  // namespace

std::vector<std::uint32_t> with_hidden_limits(std::span<const std::uint32_t> spirv) {
    return HidingLimits(spirv).hidden();
}

}  // namespace glift::detail
