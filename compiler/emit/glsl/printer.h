// What the parts of the GLSL printer share: the text of the shader so far, and the helpers, types and extensions that
// it has turned out to need.
#pragma once

#include "emit/glsl/emit.h"
#include "emit/glsl/names.h"
#include "ir/empty.h"

#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace gliftc::glsl {

/// The precedence of an expression's outermost operator, from the loosest to the tightest of GLSL.
enum class Level : std::uint8_t {
    ternary,
    logical_or,
    logical_and,
    bit_or,
    bit_xor,
    bit_and,
    equality,
    relation,
    shift,
    sum,
    term,
    unary,
    postfix,
};

struct Text {
    std::string text;
    Level level = Level::postfix;
};

/// Functions, and the constants `skips_branches` and `adds_floats`, that are printed before the functions of the source
/// if they are used. Their definitions are in helpers.cpp, division.cpp and subgroups.cpp.
enum class Helper : std::uint8_t {
    quotient,
    remainder,
    modulo,
    to_int,
    to_uint,
    to_int64,
    to_uint64,
    to_half,
    nearest_half,
    ordered_dot,
    cross_product,
    blend,
    angle,
    smooth_step,
    fraction,
    sign_of,
    negative,
    magnitude,
    reflection,
    matrix_vector,
    vector_matrix,
    matrix_matrix,
    matrix_scalar_quotient,
    pack_unorm,
    unpack_unorm,
    extract_bits,
    insert_bits,
    far_index,
    whole_vector,
    split_float,
    divide,
    divide_by,
    quick_divide,
    quick_divide_by,
    square_root,
    shuffled,
    shuffled_xor,
    shuffled_up,
    shuffled_down,
    broadcast,
    broadcast_first,
    skips_branches,
    adds_floats,
};

/// A helper for certain types of operands.
struct HelperUse {
    Helper helper;
    ir::TypeId a, b;
    bool operator==(const HelperUse&) const = default;
};
/// A function that updates a float in one binding by atomic operations on its bits.
struct AtomicUse {
    std::uint32_t binding;
    ir::Combine combine;
    std::string name;  ///< of the function
};

/// Names of what shaders with a status record declare beside the bindings; see status.cpp.
struct StatusNames {
    std::string block, limit, rounds, another_round, report;
};

/// Names of what shaders that print declare: the buffer of messages, a function, and a local of each message.
struct MessageNames {
    std::string block, begin, place;
};

/// Names of the macros that shaders with atomic operations on coherent memory define; see order.cpp.
struct OrderNames {
    std::string load, store, both, exchange;
};

/// Bounds of a local: low <= value < high.
struct Bounds {
    std::int64_t low, high;
};

struct Printer {
    Printer(const ir::Program& program, const Sources& sources, const ir::Pass& pass, const Options& options)
        : program(program), sources(sources), pass(pass), options(options) {}

    /// The description of the draw; null: the pass does not draw.
    const ir::Raster* raster() const {
        const bool draws = pass.kernel && program.kernels[pass.kernel].raster;
        return draws ? &*program.kernels[pass.kernel].raster : nullptr;
    }
    /// The statements of the shader's main function.
    const std::vector<ir::StmtId>& body() const {
        const bool is_fragment = raster() != nullptr && options.part == ir::Part::fragment;
        return is_fragment ? fragment_for(pass, ir::Devices::shaders)->body
                           : variant_for(pass, ir::Devices::shaders).body;
    }

    const ir::Program& program;
    const Sources& sources;
    const ir::Pass& pass;
    Options options;

    Scopes names;
    std::vector<std::string> binding_names;  ///< as expressions: f_data; of buffers in the general form their addresses
    std::vector<std::string> block_names;    ///< by binding: the name of a buffer's GLSL block
    std::vector<std::string> row_names;  ///< by binding: the buffer as vectors of four; empty: it is not accessed so
    std::vector<std::string> row_block_names;
    std::vector<std::string> parameter_names;
    std::vector<std::string> member_names;  ///< names in the block of parameters; empty: those of parameter_names
    StatusNames status;                     ///< named only where the pass has a status record
    MessageNames messages;                  ///< named only where the pass prints
    OrderNames order, image_order;          ///< named only where atomic operations order coherent memory
    std::string fences;                     ///< name of specialisation constant 102 (order.cpp); empty: not needed
    Table<std::string, ir::Struct> struct_names;
    Table<std::vector<std::string>, ir::Struct> field_names;
    std::unordered_map<ir::FunctionId, std::string> function_names;
    std::string function_prefix;  ///< put before these names, in files that shaders include beside others
    std::unordered_map<ir::LocalId, std::string> local_names;
    std::unordered_map<ir::LocalId, Bounds> bounds;
    std::unordered_set<ir::LocalId> choices;  ///< locals that may hold a choice between constants (signs.h)
    bool has_quick_quotients = false;         ///< of the statements that are being printed (quick_quotients.h)
    bool in_range_is_known = false;           ///< the shader has returned already if in_range is false

    std::set<std::string> extensions;
    std::vector<ir::TypeId> struct_types;  ///< structs and optionals used, each after those in it
    std::vector<HelperUse> helpers;        ///< each after those it calls
    std::vector<AtomicUse> atomics;
    std::map<std::pair<ir::EnumId, std::uint32_t>, std::string> enumerators;  ///< used: (enum, index) → name

    std::string out;  ///< statements being printed
    int indent = 0;
    Span last_line;  ///< of the latest line mark
    std::uint32_t last_line_number = 0;
};

// types.cpp
std::string type_text(Printer& p, ir::TypeId type);
std::string declaration(Printer& p, ir::TypeId type, const std::string& name);  ///< float a[8]
std::string zero(Printer& p, ir::TypeId type);
std::string padding_values(const Printer& p, ir::TypeId type);  ///< ", 0u": arguments for padding after the fields
std::string struct_definition(Printer& p, ir::TypeId type);
std::string struct_definitions(Printer& p);
std::string literal(Printer& p, ir::TypeId type, std::uint64_t bits, double number);
std::string optional_name(Printer& p, ir::TypeId type);

// expressions.cpp
Text print(Printer& p, ir::ExprId expr);
std::string print(Printer& p, ir::ExprId expr, Level least);          ///< in parentheses if looser than `least`
std::string print_any(Printer& p, ir::ExprId expr);                   ///< where any expression can stand: an argument
std::string print_as(Printer& p, ir::ExprId expr, ir::TypeId shape);  ///< a scalar made a vector where `shape` is one
std::string print_place(Printer& p, ir::ExprId expr);                 ///< the lvalue that an atomic operation changes
std::string print_negated(Printer& p, ir::ExprId condition);  ///< `!condition`, or a < b for !(a >= b) and the like
std::string join_arguments(Printer& p, const ir::Operands& arguments);
bool is_constant(const Printer& p, ir::ExprId expr);  ///< a literal, or constructed from literals only

// guards.cpp: operations whose result the language defines for all operands, but GLSL only for some
bool divisor_is_safe(const Printer& p, ir::ExprId divisor);
bool shift_is_safe(const Printer& p, ir::ExprId amount, std::uint32_t width);
std::string guarded_index(Printer& p, ir::ExprId index, std::uint32_t count);
/// An upper bound of a value, 2^32 - 1 if none is known or if it is not a uint.
std::uint64_t largest(const Printer& p, ir::ExprId value);

// blocks.cpp: structs and arrays have another type in a GLSL block (buffer, parameters) than in a variable
/// Whether the value is read from a block, not from a variable.
bool lies_in_block(const ir::Program& program, ir::ExprId id);
/// Whether the type contains a bool, which is a uint in a block. The flag of an optional does not count.
bool holds_bool(const ir::Program& program, ir::TypeId id);
/// Whether the type contains an array of bools: glslang does not convert these between blocks and variables, so that
/// they are copied bool by bool.
bool holds_bool_array(const ir::Program& program, ir::TypeId id);
inline bool may_hold_bool_array(const ir::Program& program, ir::TypeId id) {
    const ir::TypeKind kind = program.types.kind(id);
    return (kind == ir::TypeKind::array || kind == ir::TypeKind::struct_) && holds_bool_array(program, id);
}
/// The value of the lvalue `place`, rebuilt by constructors from its members and elements, since its type in a block
/// differs from that of variables.
std::string remade(Printer& p, const std::string& place, ir::TypeId id);
/// Prints `place = value;`, or an assignment for each part if the type contains an array of bools.
void print_store(Printer& p, const std::string& place, const std::string& value, ir::TypeId type);

// memory.cpp
Text print_load(Printer& p, const ir::Expr& expr);
void print_store(Printer& p, const ir::Stmt& stmt);
/// An element of a buffer, as an lvalue. In the general form the text `index` becomes the left operand of `*`: looser
/// operators in it must be in parentheses.
std::string element_text(const Printer& p, std::uint32_t slot, const std::string& index);
std::string element_text(Printer& p, std::uint32_t slot, ir::ExprId index);
/// The coordinates of a texel, which are signed.
std::string texel_text(Printer& p, ir::ExprId id);
std::string bindings_text(Printer& p);
std::string parameter_members(Printer& p);
std::string parameters_text(Printer& p);
/// For parameters in a buffer: replaces the names in p.parameter_names by the expressions that read them. If
/// specialisation constant 103 is true, the shader copies scalars and vectors to variables when it begins
/// (print_parameter_copies). The runtime sets it on CPUs: lavapipe, which does not know that nobody writes the buffer,
/// would read a parameter again for each lane wherever it is used. On GPUs parameters are read in place, since copies
/// would take registers.
void name_parameter_reads(Printer& p);
void print_parameter_copies(Printer& p);
/// Whether the binding's elements are floats that are combined by atomic operations on integers: the shader declares
/// them as ints or uints.
bool stored_as_bits(const Printer& p, const ir::PassBinding& binding);

// atomics.cpp
std::string atomic_text(Printer& p, const ir::Stmt& stmt);
std::string atomic_definitions(Printer& p);

// intrinsics.cpp
Text print_intrinsic(Printer& p, const ir::Expr& expr);

// helpers.cpp
std::string need(Printer& p, Helper helper, ir::TypeId a, ir::TypeId b = {});  ///< notes the use; gives the name
std::vector<std::string> helper_list(Printer& p);                              ///< definitions, each once
std::string helper_definitions(Printer& p);

// order.cpp
void name_order(Printer& p);
std::string ordered_atomic(Printer& p, const char* name, const ir::Expr& expr);
std::string subgroup_barrier(Printer& p, const std::string& memory);
std::string order_definitions(const Printer& p);

// division.cpp
std::string division_definition(Printer& p, const HelperUse& use);
/// Whether the expression is a constant power of two, or a vector of such constants. Of floats it may be negative, and
/// its exponent is from -60 to 60 (halves: -14 to 14), so that its reciprocal is exact and quotients by it need no
/// correction.
bool is_power_of_two(const Printer& p, ir::ExprId expr);
bool corrects_division(const Printer& p, ir::TypeId type);
/// The quotient of floats, or halves, correctly rounded.
Text print_quotient(Printer& p, const ir::Expr& expr);
bool is_quick_quotient(const Printer& p, const ir::Expr& expr);  ///< a quotient that has short code, too
std::string quotient_of(Printer& p, ir::TypeId type, const std::string& a, const std::string& b);

// subgroups.cpp
Text print_subgroup(Printer& p, const ir::Expr& expr);
std::string subgroup_definition(Printer& p, const HelperUse& use);
void need_inner_of_subgroup(Printer& p, const HelperUse& use);

// raster.cpp: inputs and outputs of the shaders of a draw
void name_interface(Printer& p);
std::string interface_text(Printer& p);
void print_part_start(Printer& p);
/// Whether the shader uses the binding, and so declares it. A compute shader declares all bindings of its pass.
bool is_used(const Printer& p, std::size_t binding);

// status.cpp: how a shader reports errors
void name_status(Printer& p);
std::string status_definitions(Printer& p);
std::string place_parameters(const Printer& p);  ///< `uint line` or `uint line, uint file`: of functions that report
std::string place_arguments(const Printer& p, Span span);
/// `another_round(0u, 9u)`, the condition that a loop tests before each round; empty: rounds are not counted. `place`:
/// the arguments for place_parameters.
std::string round_test(const Printer& p, std::uint32_t idle_rounds, const std::string& place);
std::string round_test(const Printer& p, const ir::Stmt& loop);
void print_round_start(Printer& p);
std::string report_text(Printer& p, const ir::Stmt& stmt);

// messages.cpp: how a shader prints
void name_messages(Printer& p);
std::string message_definitions(const Printer& p);
void print_message(Printer& p, const ir::Stmt& stmt);

// statements.cpp
void print_body(Printer& p, const std::vector<ir::StmtId>& body);
/// Assigns the value of a let whose local is declared already.
void print_value_of_let(Printer& p, const ir::Stmt& stmt);
void print_statement(Printer& p, ir::StmtId stmt);
void line(Printer& p, std::string text);  ///< one line at the current indent, broken where too long
void mark_line(Printer& p, Span span);
std::string file_name(std::string_view path);

// emit.cpp: the parts of a shader that a file of library functions has, too
void name_structs(Printer& p);
std::string callees_text(Printer& p);            ///< names and prints the functions of the pass
std::string enumerators_text(const Printer& p);  ///< of a shader; library.cpp has its own
std::string extensions_text(Printer& p);

}  // namespace gliftc::glsl
