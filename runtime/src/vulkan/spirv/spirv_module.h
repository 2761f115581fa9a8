// SPIR-V modules as words: opcodes, a function that visits all instructions of a module, and a function that appends an
// instruction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace glift::detail {

/// Numbers of the SPIR-V specification, under its names or similar ones (OpUndef is `undefined`).
namespace spirv {

enum Op : std::uint32_t {
    undefined = 1,
    line = 8,
    extension = 10,
    ext_inst = 12,
    entry_point = 15,
    execution_mode = 16,
    capability = 17,
    type_void = 19,
    type_int = 21,
    type_float = 22,
    type_vector = 23,
    type_image = 25,
    type_struct = 30,
    type_pointer = 32,
    type_forward_pointer = 39,
    constant_true = 41,
    constant = 43,
    constant_composite = 44,
    spec_constant_op = 52,
    function = 54,
    function_parameter = 55,
    function_end = 56,
    function_call = 57,
    variable = 59,
    image_texel_pointer = 60,
    load = 61,
    store = 62,
    copy_memory = 63,
    access_chain = 65,
    in_bounds_access_chain = 66,
    decorate = 71,
    member_decorate = 72,
    vector_extract_dynamic = 77,
    vector_insert_dynamic = 78,
    vector_shuffle = 79,
    composite_construct = 80,
    composite_extract = 81,
    composite_insert = 82,
    copy_object = 83,
    transpose = 84,
    image_write = 99,
    convert_f_to_u = 109,
    convert_s_to_f = 111,
    convert_u_to_f = 112,
    u_convert = 113,
    s_convert = 114,
    f_convert = 115,
    bitcast = 124,
    s_negate = 126,
    f_negate = 127,
    i_add = 128,
    f_add = 129,
    f_sub = 131,
    f_mul = 133,
    f_div = 136,
    f_rem = 140,
    f_mod = 141,
    vector_times_scalar = 142,
    dot = 148,
    select = 169,
    s_greater_than = 173,
    s_greater_than_equal = 175,
    s_less_than = 177,
    s_less_than_equal = 179,
    shift_right_logical = 194,
    bitwise_or = 197,
    bit_count = 205,
    atomic_exchange = 229,
    atomic_i_add = 234,
    atomic_xor = 242,
    phi = 245,
    label = 248,
    return_value = 254,
    no_line = 317,
    execution_mode_id = 331,
    group_non_uniform_elect = 333,
    group_non_uniform_quad_swap = 366,
    copy_logical = 400,
    atomic_f_add = 6035,
};

enum Capability : std::uint32_t { group_non_uniform = 61, group_non_uniform_quad = 68, atomic_float32_add = 6033 };
enum Decoration : std::uint32_t { built_in = 11, binding = 33, offset = 35 };
enum BuiltIn : std::uint32_t { workgroup_id = 26, local_invocation_id = 27, global_invocation_id = 28 };
enum StorageClass : std::uint32_t {
    uniform = 2,
    private_storage = 6,
    function_storage = 7,
    push_constant = 9,
    storage_buffer = 12
};

}  // namespace spirv

constexpr std::size_t spirv_header_words = 5, spirv_generator_word = 2, spirv_bound_word = 3;

using SpirvWords = std::span<const std::uint32_t>;

inline std::uint32_t op_of(SpirvWords instruction) { return instruction[0] & 0xffffu; }

/// Calls visit(op, words) for each instruction; the first word holds the operation and the number of words.
template <class Visit> void for_each_instruction(SpirvWords module, Visit&& visit) {
    for (std::size_t at = spirv_header_words; at < module.size(); at += module[at] >> 16)
        visit(module[at] & 0xffffu, module.subspan(at, module[at] >> 16));
}

/// Words [first, last) of an instruction.
struct WordRange {
    std::size_t first = 0, last = 0;
};

/// The operands of an instruction that are values of the shader. Those of a phi include the labels between the values.
/// The range is empty for instructions that have no such operands, and for those not listed here, whose operands no
/// rewriting of modules needs.
inline WordRange value_operands(SpirvWords w) {
    using namespace spirv;
    const std::uint32_t op = op_of(w);
    switch (op) {
    case ext_inst: return {5, w.size()};
    case function_call: return {4, w.size()};
    case store: return {2, 3};
    case return_value: return {1, 2};
    case composite_extract: return {3, 4};
    case vector_shuffle:
    case composite_insert: return {3, 5};
    case vector_extract_dynamic:
    case vector_insert_dynamic:
    case composite_construct:
    case copy_object:
    case transpose:
    case phi:
    case copy_logical: return {3, w.size()};
    default: {
        const bool is_arithmetic = (op >= convert_f_to_u && op <= bitcast) || (op >= s_negate && op <= bit_count);
        return is_arithmetic ? WordRange{3, w.size()} : WordRange{};
    }
    }
}

inline std::uint32_t first_word(std::uint32_t op, std::size_t words) {
    return static_cast<std::uint32_t>(words) << 16 | op;
}

inline void append(std::vector<std::uint32_t>& module, std::uint32_t op,
                   std::initializer_list<std::uint32_t> operands) {
    module.push_back(first_word(op, operands.size() + 1));
    module.insert(module.end(), operands);
}

}  // namespace glift::detail
