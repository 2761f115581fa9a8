#include "hidden_zeros.h"

#include "spirv_module.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace glift::detail {

namespace {

using namespace spirv;

// Instructions of GLSL.std.450. Those from unpack_snorm_2x16 to unpack_unorm_4x8 are all that unpack integers to
// floats.
constexpr std::uint32_t step = 48, unpack_snorm_2x16 = 60, unpack_unorm_4x8 = 64;
constexpr std::size_t value_of_atomic = 6;  ///< index of the value operand of is_atomic's operations
constexpr std::size_t initial_value = 4;    ///< index of a variable's initial value

using Words = SpirvWords;
using Module = std::vector<std::uint32_t>;

/// How an instruction uses a constant.
enum class Use : std::uint8_t {
    none,
    computes,   // arithmetic, which the driver simplifies for zeros: float constants with a zero are hidden
    passes_on,  // gives it or a part of it to other instructions, which may fold to zero: float constants are hidden
};

Use use_of(std::uint32_t op) {
    switch (op) {
    case f_negate:
    case f_add:
    case f_sub:
    case f_mul:
    case f_div:
    case f_rem:
    case f_mod:
    case ext_inst: return Use::computes;
    case transpose:
    case vector_extract_dynamic:
    case composite_extract:
    case vector_shuffle:
    case phi:
    case select:
    case composite_construct:
    case copy_object:
    case vector_insert_dynamic:
    case function_call:
    case composite_insert:
    case store:
    case return_value: return Use::passes_on;
    default: return op >= vector_times_scalar && op <= dot ? Use::computes : Use::none;
    }
}

/// The operands in which constants are hidden.
struct Operands {
    WordRange words;
    Use use = Use::none;
};

Operands operands_of(Words w) {
    const Use use = use_of(op_of(w));
    return use == Use::none ? Operands{} : Operands{value_operands(w), use};
}

class Hiding {
public:
    explicit Hiding(Words spirv) : spirv_(spirv), next_id_(spirv[spirv_bound_word]) {
        for_each_instruction(spirv, [&](std::uint32_t, Words w) { read(w); });
    }

    Module hidden();

private:
    void read(Words w);
    void read_constant(Words w);
    void read_composite(Words w);
    bool is_hidden(std::uint32_t id, Use use) const;
    bool is_table(Words w) const;
    std::uint32_t hide(Module& module, std::uint32_t id);
    std::uint32_t hide_scalar(Module& module, Words w);
    std::uint32_t with_bit(Module& module, std::uint32_t operand);
    std::uint32_t with_all_bits(Module& module, std::uint32_t operand);
    std::uint32_t bit_as(Module& module, std::uint32_t type);
    std::uint32_t zeros(Module& module, std::uint32_t type);
    std::uint32_t float_zeros(Module& module, std::uint32_t type);
    std::uint32_t repeated(Module& module, std::uint32_t type, std::uint32_t part, std::uint32_t count);
    void widen(Module& module, Words conversion);
    std::uint32_t as_integer(Module& module, Words atomic);
    void write_constants(Module& module);
    void write_function(Module& module);
    void write(Module& module, Words w);
    void begin(Module& module, const std::vector<std::uint32_t>& used);
    std::uint32_t fresh() { return next_id_++; }

    /// The number of components of a type of 32-bit or 64-bit integers, 1 for scalars; 0 for other types.
    std::uint32_t count_of(std::uint32_t type) const {
        const auto found = counts_.find(type);
        return found == counts_.end() ? 0 : found->second;
    }

    struct Constant {
        Words words;
        bool has_zero = false;   ///< is or contains a zero of either sign
        std::uint32_t bits = 0;  ///< id of a uint constant of the same bits; 0: this is +0 or not a 32-bit scalar
    };

    Words spirv_;
    std::uint32_t next_id_, uint_ = 0, uint2_ = 0, uint3_ = 0, invocation_ = 0, shift_ = 0;
    std::unordered_map<std::uint32_t, std::uint32_t> floats_;      ///< types: their width
    std::unordered_map<std::uint32_t, std::uint32_t> integers_;    ///< types: their width
    std::unordered_map<std::uint32_t, std::uint32_t> counts_;      ///< types of 32-bit and 64-bit integers: components
    std::unordered_map<std::uint32_t, std::uint32_t> components_;  ///< vector types in counts_: the component's type
    std::unordered_map<std::uint32_t, std::uint32_t> types_;       ///< values of types in counts_: their type
    std::unordered_map<std::uint32_t, Words> float_vectors_;       ///< vector types of floats: their declaration
    std::map<std::uint32_t, Constant> constants_;                  ///< ordered, so that the output is deterministic
    std::vector<Words> function_;                                  ///< the function being read
    std::unordered_map<std::uint32_t, std::uint32_t> replaced_;    ///< in function_: constants, and their new ids
    std::uint32_t bit_ = 0;                                        ///< in function_: the hidden zero, a uint
};

void Hiding::read_constant(Words w) {
    const auto type = floats_.find(w[1]);
    if (type == floats_.end()) return;
    const Words low = w.subspan(3, w.size() - 4);
    const std::uint32_t top = w.back(), magnitude = type->second == 16 ? top & 0x7fffu : top & 0x7fffffffu;
    const bool is_zero = magnitude == 0 && std::ranges::all_of(low, [](std::uint32_t word) { return word == 0; });
    const bool has_integer = type->second == 32 && top != 0;
    constants_.emplace(w[2], Constant{w, is_zero, has_integer ? fresh() : 0});
}

void Hiding::read_composite(Words w) {
    Constant made{w};
    bool is_any = false;
    for (std::uint32_t part : w.subspan(3)) {
        const auto found = constants_.find(part);
        if (found == constants_.end()) continue;
        is_any = true;
        made.has_zero = made.has_zero || found->second.has_zero;
    }
    if (is_any) constants_.emplace(w[2], made);
}

void Hiding::read(Words w) {
    const std::uint32_t op = op_of(w);
    switch (op) {
    case decorate:
        if (w.size() == 4 && w[2] == built_in && w[3] >= workgroup_id && w[3] <= global_invocation_id)
            invocation_ = w[1];
        break;
    case type_float: floats_.emplace(w[1], w[2]); break;
    case type_int:
        integers_.emplace(w[1], w[2]);
        if (w[2] >= 32) counts_.emplace(w[1], 1);
        if (w[2] == 32 && w[3] == 0) uint_ = w[1];
        break;
    case type_vector:
        if (count_of(w[2]) == 1) counts_.emplace(w[1], w[3]), components_.emplace(w[1], w[2]);
        if (floats_.contains(w[2])) float_vectors_.emplace(w[1], w);
        if (w[2] == uint_ && w[3] == 2) uint2_ = w[1];
        if (w[2] == uint_ && w[3] == 3) uint3_ = w[1];
        break;
    case constant: read_constant(w); break;
    case constant_composite: read_composite(w); break;
    default: break;
    }
    const bool declares_type = op >= type_void && op <= type_forward_pointer;  // its id comes first, then numbers
    const bool has_result = w.size() > 2 && op != decorate && op != store && !declares_type;
    if (has_result && count_of(w[1]) != 0) types_.emplace(w[2], w[1]);
}

bool Hiding::is_hidden(std::uint32_t id, Use use) const {
    const auto found = constants_.find(id);
    return found != constants_.end() && (use == Use::passes_on || found->second.has_zero);
}

/// Whether this is a variable of a function that is initialised with a constant of floats: an array or a matrix that is
/// indexed. Unrolling loops may turn its parts into constants.
bool Hiding::is_table(Words w) const {
    return op_of(w) == variable && w.size() == initial_value + 1 && constants_.contains(w[initial_value]);
}

std::uint32_t Hiding::hide_scalar(Module& module, Words w) {
    const Constant& constant = constants_.at(w[2]);
    std::uint32_t result = fresh();
    if (floats_.at(w[1]) == 32 && constant.bits != 0) {
        append(module, bitwise_or, {uint_, result, constant.bits, bit_});
        append(module, bitcast, {w[1], next_id_, result});
        return fresh();
    }
    append(module, convert_u_to_f, {w[1], result, bit_});
    const bool is_plus_zero = std::ranges::all_of(w.subspan(3), [](std::uint32_t word) { return word == 0; });
    if (is_plus_zero) return result;
    const std::uint32_t minus_zero = fresh();
    append(module, f_negate, {w[1], minus_zero, result});
    if (constant.has_zero) return minus_zero;
    append(module, f_add, {w[1], next_id_, w[2], minus_zero});  // the sum with -0 is the constant itself
    return fresh();
}

/// Emits the computation of a constant, its parts first; returns the id that replaces it in this function.
std::uint32_t Hiding::hide(Module& module, std::uint32_t id) {
    const auto found = constants_.find(id);
    if (found == constants_.end()) return id;
    if (const auto known = replaced_.find(id); known != replaced_.end()) return known->second;
    const Words w = found->second.words;
    std::uint32_t result = 0;
    if (op_of(w) == constant) {
        result = hide_scalar(module, w);
    } else {
        std::vector<std::uint32_t> parts;
        for (std::uint32_t part : w.subspan(3)) parts.push_back(hide(module, part));
        result = fresh();
        module.push_back(static_cast<std::uint32_t>(parts.size() + 3) << 16 | composite_construct);
        module.insert(module.end(), {w[1], result});
        module.insert(module.end(), parts.begin(), parts.end());
    }
    replaced_.emplace(id, result);
    return result;
}

/// The hidden zero as a value of an integer type. A value of 64 bits is composed of two uints, since Mesa gets
/// comparisons of converted 32-bit integers wrong.
std::uint32_t Hiding::bit_as(Module& module, std::uint32_t type) {
    if (type == uint_) return bit_;
    const std::uint32_t width = integers_.at(type);
    std::uint32_t from = bit_;
    if (width == 64) append(module, composite_construct, {uint2_, from = fresh(), bit_, bit_});
    const std::uint32_t result = fresh();
    append(module, width < 32 ? s_convert : bitcast, {type, result, from});
    return result;
}

/// The hidden zero as a value of an integer type or, in each component, of a vector of integers.
std::uint32_t Hiding::zeros(Module& module, std::uint32_t type) {
    const std::uint32_t count = count_of(type);
    if (count == 1) return bit_as(module, type);
    return repeated(module, type, bit_as(module, components_.at(type)), count);
}

/// The hidden zero as a value of a float type or, in each component, of a vector of floats.
std::uint32_t Hiding::float_zeros(Module& module, std::uint32_t type) {
    const auto vector = float_vectors_.find(type);
    const bool is_vector = vector != float_vectors_.end();
    const std::uint32_t part = fresh();
    append(module, convert_u_to_f, {is_vector ? vector->second[2] : type, part, bit_});
    return is_vector ? repeated(module, type, part, vector->second[3]) : part;
}

/// A vector with the same value in each component.
std::uint32_t Hiding::repeated(Module& module, std::uint32_t type, std::uint32_t part, std::uint32_t count) {
    const std::uint32_t result = fresh();
    module.push_back(first_word(composite_construct, count + 3));
    module.insert(module.end(), {type, result});
    module.insert(module.end(), count, part);
    return result;
}

/// Converts an integer to 32 or 64 bits and combines it with the hidden zero: Mesa 22.3 gets comparisons of a 64-bit
/// integer with constants wrong where it sees that the integer was converted.
void Hiding::widen(Module& module, Words conversion) {
    const std::uint32_t bits = zeros(module, conversion[1]), widened = fresh();
    append(module, op_of(conversion), {conversion[1], widened, conversion[3]});
    append(module, bitwise_or, {conversion[1], conversion[2], widened, bits});
}

/// Combines an integer that becomes a float with the hidden zero, since unrolling loops may make a constant of it.
/// Other operands are returned unchanged.
std::uint32_t Hiding::with_bit(Module& module, std::uint32_t operand) {
    const auto type = types_.find(operand);
    if (type == types_.end()) return operand;
    const std::uint32_t bits = zeros(module, type->second), result = fresh();
    append(module, bitwise_or, {type->second, result, operand, bits});
    return result;
}

/// The same for a uint whose bit fields become floats (unpacking). The negated hidden zero is or-ed into it: for all
/// that the compiler knows, that may change every bit.
std::uint32_t Hiding::with_all_bits(Module& module, std::uint32_t operand) {
    const std::uint32_t bits = fresh(), result = fresh();
    append(module, s_negate, {uint_, bits, bit_});
    append(module, bitwise_or, {uint_, result, operand, bits});
    return result;
}

/// The value operand of an atomic operation, or-ed with the hidden zero. Needed through physical addresses only: there
/// lavapipe (Mesa 22.3) treats an integer that was bitcast from a float as a float: it compares such values as floats,
/// and crashes on add, and, or, xor.
std::uint32_t Hiding::as_integer(Module& module, Words atomic) {
    const std::uint32_t type = atomic[1], bits = bit_as(module, type);
    const std::uint32_t result = fresh();
    append(module, bitwise_or, {type, result, atomic[value_of_atomic], bits});
    return result;
}

/// Emits, at the beginning of a function, the hidden zero: the top bit of x of the invocation's or workgroup's number,
/// which is not set (unknown_bit.h says why). Then emits the constants `used` that are replaced in the function.
void Hiding::begin(Module& module, const std::vector<std::uint32_t>& used) {
    const std::uint32_t all = fresh(), first = fresh();
    bit_ = fresh();
    append(module, load, {uint3_, all, invocation_});
    append(module, composite_extract, {uint_, first, all, 0});
    append(module, shift_right_logical, {uint_, bit_, first, shift_});
    for (std::uint32_t id : used) hide(module, id);
}

bool is_atomic(std::uint32_t op) { return op == atomic_exchange || (op >= atomic_i_add && op <= atomic_xor); }

bool is_widening(std::uint32_t op) { return op == s_convert || op == u_convert; }

/// The index of the operand that this instruction turns into a float, if the operand is an integer, which the caller
/// checks; 0: the instruction turns no integer into a float.
std::size_t place_of_integer(Words w) {
    const std::uint32_t op = op_of(w);
    if (op == convert_s_to_f || op == convert_u_to_f || op == bitcast) return 3;
    return op == ext_inst && w[4] >= unpack_snorm_2x16 && w[4] <= unpack_unorm_4x8 ? 5 : 0;
}

/// Whether the driver may know that the result is zero without knowing an operand: NIR compares ranges of values, so
/// that it knows step(1, -x) where x was an unsigned integer.
bool may_become_zero(Words w) { return op_of(w) == ext_inst && w[4] == step; }

void Hiding::write(Module& module, Words w) {
    if (is_widening(op_of(w)) && count_of(w[1]) != 0) return widen(module, w);
    const Operands values = operands_of(w);
    const std::size_t place = place_of_integer(w);
    const bool converts = place != 0 && types_.contains(w[place]) && !types_.contains(w[2]);
    const bool combines = is_atomic(op_of(w)) && integers_.contains(w[1]);
    const bool unpacks = converts && op_of(w) == ext_inst;
    const std::uint32_t operand = unpacks    ? with_all_bits(module, w[place])
                                  : converts ? with_bit(module, w[place])
                                  : combines ? as_integer(module, w)
                                             : 0;
    const std::size_t at = module.size();
    module.insert(module.end(), w.begin(), w.end());
    if (converts) module[at + place] = operand;
    if (combines) module[at + value_of_atomic] = operand;
    for (std::size_t i = values.words.first; i < values.words.last; ++i)
        if (is_hidden(w[i], values.use)) module[at + i] = replaced_.at(w[i]);
    if (may_become_zero(w)) {
        const std::uint32_t known = module[at + 2] = fresh();
        append(module, f_add, {w[1], w[2], known, float_zeros(module, w[1])});  // neither 0 nor 1 changes
    }
}

void Hiding::write_function(Module& module) {
    std::vector<std::uint32_t> used;
    std::vector<Words> tables;
    bool has_begun = true, is_in_block = false;
    for (Words w : function_) {
        if (is_table(w)) {
            used.push_back(w[initial_value]);
            tables.push_back(w);
        }
        const Operands values = operands_of(w);
        for (std::size_t i = values.words.first; i < values.words.last; ++i)
            if (is_hidden(w[i], values.use)) used.push_back(w[i]);
        const std::uint32_t op = op_of(w);
        if (!used.empty() || place_of_integer(w) != 0 || is_widening(op) || is_atomic(op) || may_become_zero(w))
            has_begun = false;
    }
    replaced_.clear();
    for (Words w : function_) {
        const std::uint32_t op = op_of(w);
        // Variables come first in a function's first block.
        if (is_in_block && !has_begun && op != variable && op != line && op != no_line) {
            begin(module, used);
            for (Words table : tables) append(module, store, {table[2], replaced_.at(table[initial_value])});
            has_begun = true;
        }
        is_in_block = is_in_block || op == label;
        if (is_table(w)) append(module, variable, {w[1], w[2], w[3]});
        else write(module, w);
    }
}

/// Declares the constants from which the hidden zeros and the hidden constants are computed, and the type of vectors of
/// two uints if the module lacks it.
void Hiding::write_constants(Module& module) {
    if (uint2_ == 0) append(module, type_vector, {uint2_ = fresh(), uint_, 2});
    shift_ = fresh();
    append(module, constant, {uint_, shift_, 31});
    for (const auto& [id, made] : constants_)
        if (made.bits != 0) append(module, constant, {uint_, made.bits, made.words.back()});
}

Module Hiding::hidden() {
    if (invocation_ == 0 || uint3_ == 0) return {spirv_.begin(), spirv_.end()};
    Module module(spirv_.begin(), spirv_.begin() + spirv_header_words);
    for_each_instruction(spirv_, [&](std::uint32_t op, Words w) {
        if (op == function) {
            if (shift_ == 0) write_constants(module);
            function_.clear();
        }
        if (shift_ == 0) module.insert(module.end(), w.begin(), w.end());
        else function_.push_back(w);
        if (op == function_end) write_function(module);
    });
    module[spirv_bound_word] = next_id_;
    return module;
}

}  // namespace

std::vector<std::uint32_t> with_hidden_zeros(std::span<const std::uint32_t> spirv) { return Hiding(spirv).hidden(); }

}  // namespace glift::detail
