#include "emit/cpp/host/updates.h"

#include "ir/walk.h"

#include <algorithm>

namespace gliftc::host {

using ir::Stmt;
using ir::StmtId;
using ir::StmtOp;

const char* operation_name(ir::Combine combine) {
    switch (combine) {
    case ir::Combine::replace: break;
    case ir::Combine::min: return "Min";
    case ir::Combine::max: return "Max";
    case ir::Combine::add: return "Add";
    case ir::Combine::bit_and: return "BitAnd";
    case ir::Combine::bit_or: return "BitOr";
    case ir::Combine::bit_xor: return "BitXor";
    }
    return "";
}

std::map<std::uint32_t, ir::Combine> combined_bindings(const ir::Program& program, const ir::Pass& pass) {
    std::map<std::uint32_t, ir::Combine> found;
    const auto note = [&](const Stmt& stmt) {
        const bool is_update =
            stmt.op == StmtOp::atomic || stmt.op == StmtOp::row_update || stmt.op == StmtOp::column_update;
        if (!is_update) return;
        if (pass.ordered_sum(stmt.slot) != nullptr ||
            is_combined_by_threads(program.types, pass.bindings[stmt.slot], pass.is_wide))
            found.emplace(stmt.slot, stmt.combine);
    };
    for (const std::vector<StmtId>* body : bodies_of(pass)) ir::for_each_statement(program, *body, note);
    for (ir::FunctionId function : pass.functions)
        ir::for_each_statement(program, program.functions[function].body, note);
    return found;
}

std::vector<Stmt> row_updates(const ir::Program& program, const std::vector<StmtId>& body) {
    std::vector<Stmt> found;
    ir::for_each_statement(program, body, [&](const Stmt& stmt) {
        const auto is_same = [&](const Stmt& other) { return other.slot == stmt.slot && other.target == stmt.target; };
        if (stmt.op == StmtOp::row_update && std::ranges::none_of(found, is_same)) found.push_back(stmt);
    });
    return found;
}

}  // namespace gliftc::host
