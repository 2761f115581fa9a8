// Abstract interpretation of translators and extents over symbolic numbers (lower/analysis/symbolic.h): gives the
// physical address and the extent of the memory, which lower/analysis/contained.cpp compares to drop bounds checks.
#pragma once

#include "ir/ir.h"
#include "lower/analysis/symbolic.h"

#include <unordered_map>
#include <vector>

namespace gliftc::lower {

/// What is known of a condition.
struct Truth {
    std::optional<bool> known;                     ///< its value; none: not known
    std::vector<symbolic::Sum> if_true, if_false;  ///< sums >= 0 if it is true; sums >= 0 if it is false
};

/// One scalar of a value: a number, or a condition, for which `sum` is 0 or 1 if it is known, else an unknown.
struct Part {
    symbolic::Sum sum;
    Truth truth;
};
using Parts = std::vector<Part>;

inline Part part_of(symbolic::Sum sum) { return {std::move(sum), {}}; }
inline Part part_of(bool known) { return {symbolic::number(known ? 1 : 0), {known, {}, {}}}; }

inline Truth inverse(const Truth& truth) {
    Truth result{std::nullopt, truth.if_false, truth.if_true};
    if (truth.known) result.known = !*truth.known;
    return result;
}

/// Operations whose results may be unknowns, besides binary operators and intrinsics. Their numbers are distinct from
/// those that operation_of gives.
enum Operation : std::uint32_t { not_zero = 1000, choice, leaf, conversion, logical_inversion, minus, bit_inversion };
inline std::uint32_t operation_of(ir::BinaryOp op) { return static_cast<std::uint32_t>(op); }
inline std::uint32_t operation_of(ir::Intrinsic intrinsic) { return 100 + static_cast<std::uint32_t>(intrinsic); }

/// The interpreter for the code of one structure. The structure's constructor arguments are unknowns unless set_member
/// says what they are.
class BoundsInterpreter {
public:
    BoundsInterpreter(const ir::Program& program, ir::StructureId structure)
        : p(program), whole_(&program.structures[structure]), s(whole_) {}

    /// The value of an expression over the structure (Place::root 0 is the structure), such as a memory's extent.
    Parts of_structure(ir::ExprId id);
    /// The extent within which physical addresses must lie: that of a buffer or image, or the domain of the structure
    /// that is the memory.
    Parts extent_of_memory();
    /// The physical address that the structure's own translators give for a virtual address, which is symbolic and may
    /// stand for many; none if all of these are unmapped.
    std::optional<Parts> translated(Parts address);
    /// Sets component `lane` of constructor argument `slot`.
    void set_member(std::uint32_t slot, std::uint32_t lane, const symbolic::Sum& sum) { members_[{slot, lane}] = sum; }
    Parts member(std::uint32_t slot, ir::TypeId type);

    symbolic::Symbols symbols;

private:
    struct Frame {
        std::unordered_map<ir::LocalId, Parts> locals;
        std::optional<Parts> returned;
        bool has_left = false;    ///< all paths have returned: none reaches the current statement
        bool is_followed = true;  ///< false: code could not be followed, so the result is unknown
    };

    /// As of_structure, for sizes of memories and arguments of members: the runtime computes them exactly (widen.h) and
    /// makes no structure for which they are too large, so their arithmetic is not taken to wrap around.
    Parts of_size(ir::ExprId id);
    Parts of_domain();
    /// Fills sizes_, once: when of_structure is first called. set_member must be called before that.
    void find_sizes();
    Parts of(ir::ExprId id);
    Parts of_construct(const ir::Expr& node);
    Parts of_binary(const ir::Expr& node);
    Parts of_comparison(const ir::Expr& node);
    Parts of_convert(const ir::Expr& node);
    Parts of_unary(const ir::Expr& node);
    Parts of_select(const ir::Expr& node);
    Parts of_index(const ir::Expr& node);
    Parts of_intrinsic(const ir::Expr& node);
    Parts of_lanes(ir::BinaryOp op, const Parts& a, const Parts& b, std::size_t count);
    Part of_all(ir::Intrinsic which, const Parts& conditions);
    Parts of_call(const ir::Expr& node);
    Parts of_leaf(const ir::Expr& node);
    Parts of_state_leaf(const ir::Expr& node);
    Parts of_member_leaf(const ir::Expr& node);
    Parts call(ir::FunctionId id, std::vector<Parts> arguments);

    Part calculated(const ir::Expr& node, ir::TypeId scalar, const Part& a, const Part& b);
    symbolic::Sum difference(const symbolic::Sum& a, const symbolic::Sum& b);
    symbolic::Sum quotient(const symbolic::Sum& a, const symbolic::Sum& b);
    symbolic::Sum exact_quotient(const symbolic::Sum& a, const symbolic::Sum& by);
    symbolic::Sum remainder(const symbolic::Sum& a, const symbolic::Sum& b);
    std::optional<symbolic::Sum> least_of(const symbolic::Sum& a, const symbolic::Sum& b);
    symbolic::Sum smaller(const symbolic::Sum& a, const symbolic::Sum& b);
    symbolic::Sum larger(const symbolic::Sum& a, const symbolic::Sum& b);
    symbolic::Sum at_least_one(const symbolic::Sum& sum);
    symbolic::Sum of_bits(const ir::Expr& node, const symbolic::Sum& a, const symbolic::Sum& b);
    symbolic::Sum bits_together(ir::BinaryOp op, const symbolic::Sum& a, const symbolic::Sum& b);
    std::optional<symbolic::Sum> bits_of(const symbolic::Sum& sum);
    symbolic::Sum opaque(std::uint32_t operation, std::vector<symbolic::Sum> operands, ir::TypeId scalar);
    Truth compared(ir::BinaryOp op, const symbolic::Sum& a, const symbolic::Sum& b);
    Part chosen(const Part& condition, const Part& yes, const Part& no);
    Part joined(const Part& a, const Part& b);
    Parts joined(const Parts& a, const Parts& b);
    bool fits(const symbolic::Sum& sum);
    Parts unknown(ir::TypeId type);
    Part unknown_scalar(ir::TypeId scalar);
    ir::TypeId scalar_at(ir::TypeId type, std::size_t lane) const;

    void run(const std::vector<ir::StmtId>& body);
    void run_if(const ir::Stmt& stmt);
    void run_for(const ir::Stmt& stmt);
    void assign(ir::ExprId target, const Parts& value);
    void assume(const std::vector<symbolic::Sum>& facts);
    void give_up();

    const ir::Program& p;
    const ir::Structure* whole_;       ///< the structure given to the constructor
    const ir::Structure* s;            ///< the structure whose expressions are being followed: whole_ or a member of it
    std::vector<std::uint32_t> path_;  ///< from member to member, from `whole_` to `s`
    const ir::Stage* stage_ = nullptr;
    Frame* frame_ = nullptr;
    std::map<std::pair<std::uint32_t, std::uint32_t>, symbolic::Sum> members_;
    /// Sizes of memories, and arguments of the members that the structure makes: sums that fit (see `fits`).
    std::vector<symbolic::Sum> sizes_;
    bool has_sizes_ = false;
    bool is_checked_ = false;  ///< the expression that is being followed is a size (of_size)
    /// For the unknown that is the result of a bit operation: a number with all bits set that may be set in the result.
    std::unordered_map<symbolic::Unknown, symbolic::Sum> bits_;
    unsigned depth_ = 0;
};

}  // namespace gliftc::lower
