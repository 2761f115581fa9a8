#include "fixed_parameters.h"

#include "spirv_module.h"

#include <optional>
#include <unordered_map>

namespace glift::detail {

namespace {

using namespace spirv;

using Words = SpirvWords;

/// The parts of a module that are needed to find the loads of its parameters.
struct Module {
    struct Vector {
        std::uint32_t component, count;
    };
    std::unordered_map<std::uint32_t, Vector> vectors;  ///< by type: vectors of 32-bit scalars; a scalar has count 1
    std::unordered_map<std::uint32_t, std::uint32_t> constants;  ///< constants of one word: their value
    std::unordered_map<std::uint32_t, std::uint32_t> pointees;   ///< pointer types: the type they point to
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> members;
    std::unordered_map<std::uint64_t, std::uint32_t> offsets;  ///< of (struct, member)
    std::unordered_map<std::uint32_t, std::uint32_t> bindings;
    std::uint32_t block = 0, block_type = 0;                  ///< the parameters' variable and struct
    std::unordered_map<std::uint32_t, std::uint32_t> chains;  ///< pointers into the block: their byte offset

    explicit Module(Words spirv) {
        for_each_instruction(spirv, [&](std::uint32_t op, Words w) { read(op, w); });
    }

private:
    void read(std::uint32_t op, Words w) {
        switch (op) {
        case type_int:
        case type_float:
            if (w[2] == 32) vectors[w[1]] = {w[1], 1};
            break;
        case type_vector:
            if (vectors.contains(w[2])) vectors[w[1]] = {w[2], w[3]};
            break;
        case type_struct: members[w[1]].assign(w.begin() + 2, w.end()); break;
        case type_pointer: pointees[w[1]] = w[3]; break;
        case constant:
            if (w.size() == 4) constants[w[2]] = w[3];
            break;
        case decorate:
            if (w[2] == spirv::binding) bindings[w[1]] = w[3];
            break;
        case member_decorate:
            if (w[3] == spirv::offset) offsets[std::uint64_t{w[1]} << 32 | w[2]] = w[4];
            break;
        case variable: read_variable(w); break;
        case access_chain:
            if (w[3] == block && block) read_chain(w);
            break;
        default: break;
        }
    }

    void read_variable(Words w) {
        const bool is_buffer = w[3] == storage_buffer || w[3] == uniform;
        const bool is_block = w[3] == push_constant || (is_buffer && bindings.contains(w[2]) && bindings[w[2]] == 0);
        if (!is_block) return;
        block = w[2];
        block_type = pointees[w[1]];
    }

    /// Notes an access chain to a member of the block, or to a component of a vector member. Other chains are not
    /// noted, so that loads through them stay.
    void read_chain(Words w) {
        if (w.size() < 5 || w.size() > 6 || !constants.contains(w[4])) return;
        const std::uint32_t member = constants[w[4]];
        const auto offset = offsets.find(std::uint64_t{block_type} << 32 | member);
        if (offset == offsets.end()) return;
        std::uint32_t component = 0;
        if (w.size() == 6) {
            if (!constants.contains(w[5]) || !vectors.contains(members[block_type].at(member))) return;
            component = constants[w[5]];
        }
        chains[w[2]] = offset->second + 4 * component;
    }
};

class Rewriter {
public:
    Rewriter(Words spirv, std::span<const FixedWord> fixed)
        : spirv_(spirv), module_(spirv), bound_(spirv[spirv_bound_word]) {
        for (const FixedWord& word : fixed) values_[word.offset] = word.value;
    }

    std::vector<std::uint32_t> run() {
        std::vector<std::uint32_t> functions, result(spirv_.begin(), spirv_.begin() + spirv_header_words);
        bool inside = false;
        for_each_instruction(spirv_, [&](std::uint32_t op, Words w) {
            inside = inside || op == function;
            auto& out = inside ? functions : result;
            const auto known = op == load ? constant_for(w) : std::nullopt;
            if (known) out.insert(out.end(), {first_word(copy_object, 4), w[1], w[2], *known});
            else out.insert(out.end(), w.begin(), w.end());
        });
        result.insert(result.end(), constants_.begin(), constants_.end());
        result.insert(result.end(), functions.begin(), functions.end());
        result[spirv_bound_word] = bound_;
        return result;
    }

private:
    /// The id of a new constant to replace the load with; nullopt unless all words that it loads are known to be fixed.
    std::optional<std::uint32_t> constant_for(Words load) {
        const auto chain = module_.chains.find(load[3]);
        const auto type = module_.vectors.find(load[1]);
        if (chain == module_.chains.end() || type == module_.vectors.end()) return std::nullopt;
        for (std::uint32_t k = 0; k < type->second.count; ++k)
            if (!values_.contains(chain->second + 4 * k)) return std::nullopt;
        std::vector<std::uint32_t> parts;
        for (std::uint32_t k = 0; k < type->second.count; ++k) {
            parts.push_back(bound_++);
            constants_.insert(constants_.end(), {first_word(constant, 4), type->second.component, parts.back(),
                                                 values_[chain->second + 4 * k]});
        }
        if (parts.size() == 1) return parts[0];
        constants_.insert(
            constants_.end(),
            {first_word(constant_composite, static_cast<std::uint32_t>(3 + parts.size())), load[1], bound_});
        constants_.insert(constants_.end(), parts.begin(), parts.end());
        return bound_++;
    }

    Words spirv_;
    Module module_;
    std::uint32_t bound_;
    std::unordered_map<std::uint32_t, std::uint32_t> values_;  ///< by byte offset
    std::vector<std::uint32_t> constants_;                     ///< declarations
};

}  // namespace

std::vector<std::uint32_t> with_fixed_parameters(std::span<const std::uint32_t> spirv,
                                                 std::span<const FixedWord> fixed) {
    if (fixed.empty()) return {spirv.begin(), spirv.end()};
    return Rewriter(spirv, fixed).run();
}

}  // namespace glift::detail
