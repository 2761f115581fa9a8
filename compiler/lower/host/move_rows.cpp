#include "lower/host/move_rows.h"

#include "ir/walk.h"

#include <optional>
#include <unordered_map>

namespace gliftc::lower {

using namespace ir;

namespace {

struct RowMove {
    bool is_load = false;
    ExprId array;  ///< the local array, which is copied as a whole
    std::uint32_t binding = 0;
    ExprId first;  ///< index of the first row in memory
};

/// The value factor * (the loop's variable) + offset.
struct Line {
    std::uint64_t factor = 0, offset = 0;
    bool operator==(const Line&) const = default;
};

/// Recognises a loop that copies one row in each iteration.
class Reader {
public:
    Reader(const Program& whole, const Pass& lowered, const Stmt& rounds)
        : program(whole), pass(lowered), loop(rounds) {}

    std::optional<RowMove> read();

private:
    bool take(const Stmt& stmt);
    bool take_load(const Stmt& let);
    bool take_number(const Stmt& assign);
    bool take_store(const Stmt& store);
    bool take_array(ExprId id, std::uint64_t number);
    bool take_row(ExprId vector, std::uint32_t binding, TypeId type);
    std::optional<Line> line_of(ExprId id) const;
    bool is_whole() const;

    const Program& program;
    const Pass& pass;
    const Stmt& loop;
    std::unordered_map<LocalId, ExprId> values_;
    RowMove move_;
    LocalId four_;               ///< in a loop that loads: the local that holds the row
    std::uint32_t numbers_ = 0;  ///< how many scalars of the row the statements so far have copied
};

std::optional<Line> Reader::line_of(ExprId id) const {
    const Expr& node = program.exprs[id];
    if (node.op == Op::constant) return Line{0, node.bits};
    if (node.op == Op::local && node.local == loop.local) return Line{1, 0};
    if (node.op == Op::local) {
        const auto value = values_.find(node.local);
        return value == values_.end() ? std::nullopt : line_of(value->second);
    }
    if (node.op != Op::binary) return std::nullopt;
    const std::optional<Line> a = line_of(node.operands[0]), b = line_of(node.operands[1]);
    if (!a || !b) return std::nullopt;
    if (node.binary == BinaryOp::add) return Line{a->factor + b->factor, a->offset + b->offset};
    if (node.binary == BinaryOp::multiply && b->factor == 0) return Line{a->factor * b->offset, a->offset * b->offset};
    return std::nullopt;
}

/// Accepts an access to row `first + i` of a binding, i being the loop's variable.
bool Reader::take_row(ExprId vector, std::uint32_t binding, TypeId type) {
    const Expr& sum = program.exprs[vector];
    if (move_.first || sum.op != Op::binary || sum.binary != BinaryOp::add || line_of(sum.operands[1]) != Line{1, 0} ||
        !is_row(program.types, pass.bindings[binding], type) || pass.bindings[binding].coherent)
        return false;
    bool is_same = true;
    for_each_node(program, sum.operands[0], [&](ExprId id) {
        const LocalId local = program.exprs[id].op == Op::local ? program.exprs[id].local : LocalId{};
        is_same = is_same && (!local || (local != loop.local && !values_.contains(local)));
    });
    move_.binding = binding;
    move_.first = sum.operands[0];
    return is_same;
}

/// Accepts an access to scalar `number` of row i of the array.
bool Reader::take_array(ExprId id, std::uint64_t number) {
    const Expr& element = program.exprs[id];
    if (element.op != Op::index || line_of(element.operands[1]) != Line{row_width, number}) return false;
    const Expr& array = program.exprs[element.operands[0]];
    if (array.op != Op::local || program.locals[array.local].storage == Storage::shared) return false;
    if (move_.array && program.exprs[move_.array].local != array.local) return false;
    move_.array = element.operands[0];
    return true;
}

bool Reader::take_load(const Stmt& let) {
    const Expr& load = program.exprs[let.value];
    move_.is_load = true;
    four_ = let.local;
    return take_row(load.operands[0], load.slot, load.type);
}

bool Reader::take_number(const Stmt& assign) {
    const Expr& number = program.exprs[assign.value];
    if (!move_.is_load || number.op != Op::swizzle || number.lanes[0] != numbers_ ||
        program.types.components(number.type) != 1)
        return false;
    const Expr& row = program.exprs[number.operands[0]];
    return row.op == Op::local && row.local == four_ && take_array(assign.target, numbers_++);
}

bool Reader::take_store(const Stmt& store) {
    const Expr& row = program.exprs[store.value];
    if (row.op != Op::construct || row.operands.size() != row_width || !take_row(store.target, store.slot, row.type))
        return false;
    for (ExprId number : row.operands)
        if (!take_array(number, numbers_++)) return false;
    return true;
}

bool Reader::take(const Stmt& stmt) {
    if (stmt.op == StmtOp::assign) return take_number(stmt);
    if (stmt.op == StmtOp::store) return take_store(stmt);
    if (stmt.op != StmtOp::let || !stmt.value || program.locals[stmt.local].is_mutable) return false;
    if (program.exprs[stmt.value].op == Op::load) return take_load(stmt);
    values_[stmt.local] = stmt.value;
    return line_of(stmt.value).has_value();
}

/// Whether the loop counts from 0 to the number of the array's rows and each iteration copies a whole row; array and
/// memory must have the same scalar type, which must not be bool.
bool Reader::is_whole() const {
    const std::optional<Line> first = line_of(loop.value), limit = line_of(loop.limit);
    if (!first || !limit || *first != Line{0, 0} || limit->factor != 0 || !move_.array || !move_.first) return false;
    const Type& type = program.types[program.exprs[move_.array].type];
    const TypeId number = program.types.scalar_of(pass.bindings[move_.binding].element);
    return numbers_ == row_width && type.element == number && number != program.types.bool_ &&
           type.count == limit->offset * row_width;
}

std::optional<RowMove> Reader::read() {
    for (StmtId id : loop.body)
        if (!take(program.stmts[id])) return std::nullopt;
    return is_whole() ? std::optional(move_) : std::nullopt;
}

/// The statement that replaces the loop.
StmtId moved(Context& cx, const Stmt& loop, const RowMove& move) {
    Stmt stmt = statement(move.is_load ? StmtOp::load_rows : StmtOp::store_rows, loop.span);
    stmt.slot = move.binding;
    stmt.target = move.is_load ? move.array : move.first;
    stmt.value = move.is_load ? move.first : move.array;
    return cx.add(std::move(stmt));
}

StmtId visited(Context& cx, StmtId id) {
    const Stmt& stmt = cx.p.stmts[id];
    if (stmt.op == StmtOp::for_)
        if (const std::optional<RowMove> move = Reader(cx.p, cx.pass, stmt).read()) return moved(cx, stmt, *move);
    return cx.build.again(
        id, {stmt.target, stmt.value, stmt.limit, move_rows(cx, stmt.body), move_rows(cx, stmt.otherwise)});
}

}  // namespace

std::vector<StmtId> move_rows(Context& cx, const std::vector<StmtId>& body) {
    std::vector<StmtId> result;
    result.reserve(body.size());
    for (StmtId id : body) result.push_back(visited(cx, id));
    return result;
}

}  // namespace gliftc::lower
