#include "exact_sums.h"

#include "spirv_module.h"
#include "vulkan/unknown_bit.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace glift::detail {

namespace {

using namespace spirv;

constexpr std::uint32_t negative_zero = 0x80000000u;

using Module = std::vector<std::uint32_t>;

/// The values of a module that a driver may know to be constant once it has unrolled loops and inlined functions.
class Known {
public:
    explicit Known(SpirvWords spirv) : known_(spirv[spirv_bound_word]), variable_of_(spirv[spirv_bound_word]) {
        // In a loop, a store may make loads known that stand before it: the module is read until nothing is added.
        do {
            has_changed_ = false;
            for_each_instruction(spirv, [&](std::uint32_t op, SpirvWords w) { read(op, w); });
        } while (has_changed_);
    }

    bool contains(std::uint32_t id) const { return known_[id]; }

private:
    void mark(std::uint32_t id) {
        has_changed_ = has_changed_ || !known_[id];
        known_[id] = true;
    }
    void mark_if(std::uint32_t id, bool is_known) {
        if (is_known) mark(id);
    }

    void read(std::uint32_t op, SpirvWords w) {
        switch (op) {
        case undefined:
        case function_parameter: return mark(w[2]);
        case function_call:
            return mark_if(w[2], std::ranges::all_of(w.subspan(4), [&](auto id) { return holds_known(id); }));
        case variable:
            if (w[3] != function_storage && w[3] != private_storage) return;
            variable_of_[w[2]] = w[2];
            return mark_if(w[2], w.size() > 4);
        case access_chain:
        case in_bounds_access_chain: variable_of_[w[2]] = place(w[3]); return;
        case load: return mark_if(w[2], known_[place(w[3])]);
        case store: return store_to(w[1], known_[w[2]]);
        case copy_memory: return store_to(w[1], known_[place(w[2])]);
        case select: return mark_if(w[2], known_[w[4]] || known_[w[5]]);
        case phi:
            for (std::size_t i = 3; i < w.size(); i += 2) mark_if(w[2], known_[w[i]]);
            return;
        case return_value: return;
        default: break;
        }
        if (op >= constant_true && op <= spec_constant_op) return mark(w[2]);
        const WordRange values = value_operands(w);
        const SpirvWords operands = w.subspan(values.first, values.last - values.first);
        if (!operands.empty()) mark_if(w[2], std::ranges::all_of(operands, [&](auto id) { return known_[id]; }));
    }

    /// The variable of this shader that a pointer leads into; for a function's parameter that is a pointer, the
    /// parameter itself; 0: other memory.
    std::uint32_t place(std::uint32_t pointer) const {
        const std::uint32_t of = variable_of_[pointer];
        return of == 0 && known_[pointer] ? pointer : of;
    }
    /// Whether an argument is known: a value itself; for a pointer, what the variable that it leads into holds.
    bool holds_known(std::uint32_t argument) const {
        const std::uint32_t variable = variable_of_[argument];
        return known_[variable == 0 ? argument : variable];
    }
    void store_to(std::uint32_t pointer, bool is_known) {
        if (const std::uint32_t to = place(pointer); to != 0) mark_if(to, is_known);
    }

    std::vector<bool> known_;                 ///< by id: values that may be known, and variables that hold such values
    std::vector<std::uint32_t> variable_of_;  ///< pointers into this shader's variables: the variable
    bool has_changed_ = false;
};

class Keeping {
public:
    explicit Keeping(SpirvWords spirv) : spirv_(spirv), next_id_(spirv[spirv_bound_word]) {
        for_each_instruction(spirv, [&](std::uint32_t op, SpirvWords w) {
            bit_.read(op, w);
            read(op, w);
        });
    }

    Module kept() {
        if (!bit_.exists() || float_ == 0) return {spirv_.begin(), spirv_.end()};
        const Known known(spirv_);
        Module module(spirv_.begin(), spirv_.begin() + spirv_header_words);
        for_each_instruction(spirv_, [&](std::uint32_t op, SpirvWords w) {
            if (op == function && sign_ == 0) write_constants(module);
            const bool adds = (op == f_add || op == f_sub) && known.contains(w[3]) && known.contains(w[4]);
            const std::uint32_t left = adds ? hide(module, w[1], w[3]) : 0;
            const std::size_t at = module.size();
            module.insert(module.end(), w.begin(), w.end());
            if (adds) module[at + 3] = left;
        });
        module[spirv_bound_word] = next_id_;
        return module;
    }

private:
    void read(std::uint32_t op, SpirvWords w) {
        switch (op) {
        case type_float:
            if (w[2] == 32) float_ = w[1];
            break;
        case type_vector: vectors_.emplace(w[1], Vector{w[2], w[3]}); break;
        default: break;
        }
    }

    void write_constants(Module& module) {
        bit_.declare(module, next_id_);
        sign_ = fresh();
        append(module, constant, {bit_.type(), sign_, negative_zero});
    }

    /// A -0, or a vector of them, that the driver cannot know to be -0: its bits are or-ed with an unknown bit.
    std::uint32_t unknown_zero(Module& module, std::uint32_t type) {
        if (const auto vector = vectors_.find(type); vector != vectors_.end()) {
            const std::uint32_t part = unknown_zero(module, vector->second.component), result = fresh();
            module.push_back(first_word(composite_construct, vector->second.count + 3));
            module.insert(module.end(), {type, result});
            module.insert(module.end(), vector->second.count, part);
            return result;
        }
        const std::uint32_t bit = bit_.emit(module, next_id_), bits = fresh(), single = fresh();
        append(module, bitwise_or, {bit_.type(), bits, bit, sign_});
        append(module, bitcast, {float_, single, bits});
        if (type == float_) return single;
        const std::uint32_t result = fresh();
        append(module, f_convert, {type, result, single});
        return result;
    }

    std::uint32_t hide(Module& module, std::uint32_t type, std::uint32_t operand) {
        const std::uint32_t zero = unknown_zero(module, type), result = fresh();
        append(module, f_add, {type, result, operand, zero});
        return result;
    }

    std::uint32_t fresh() { return next_id_++; }

    struct Vector {
        std::uint32_t component, count;
    };
    SpirvWords spirv_;
    std::uint32_t next_id_, float_ = 0, sign_ = 0;
    UnknownBit bit_;
    std::unordered_map<std::uint32_t, Vector> vectors_;
};

}  // namespace

std::vector<std::uint32_t> with_kept_sums(std::span<const std::uint32_t> spirv) { return Keeping(spirv).kept(); }

}  // namespace glift::detail
