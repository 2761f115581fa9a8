// The status record, in which a shader reports errors to the runtime, and the count of the rounds (iterations) of its
// loops.
//
// Some devices (lavapipe) end the loops of an invocation after a number of rounds, silently. They run the lanes of a
// subgroup in lockstep, so a round of one lane is a round of all: the count is the subgroup's (in draws the
// invocation's). Each test of a loop's condition adds one to the count, plus the number of rounds that loops inside
// that loop may run with no lane active (idle_rounds). Specialisation constant 101 is the device's limit; where it is 0
// nothing is counted and the driver's compiler can remove the code that counts.
#include "emit/glsl/printer.h"
#include "ir/walk.h"

#include <algorithm>

namespace gliftc::glsl {

namespace {

/// The smallest subgroup size of the devices that limit the rounds of loops (lavapipe).
constexpr std::uint32_t smallest_subgroup = 4;

bool names_files(const Printer& p) { return p.pass.files.size() > 1; }

std::string place_assigned(const Printer& p) {
    std::string line = p.status.block + ".line = line;";
    return names_files(p) ? "{\n        " + line + "\n        " + p.status.block + ".file = file;\n    }" : line;
}

std::string report_definition(const Printer& p) {
    const std::string& status = p.status.block;
    std::string text = "// Reports an access outside a structure, unless another error is reported already.\n";
    text += "void " + p.status.report + "(" + place_parameters(p) + ", uint memory, uint rank, uvec4 address) {\n";
    text += "    if (atomicCompSwap(" + status + ".code, 0u, 2u) != 0u) return;\n    " + status + ".line = line;\n";
    if (names_files(p)) text += "    " + status + ".file = file;\n";
    text += "    " + status + ".memory = memory;\n    " + status + ".rank = rank;\n";
    return text + "    for (int i = 0; i < 4; ++i) " + status + ".address[i] = address[i];\n}\n\n";
}

std::string record_text(const Printer& p) {
    std::string binding = std::to_string(p.pass.bindings.size() + 1);
    return "layout(scalar, set = 0, binding = " + binding +
           ") buffer Status {\n    uint code, line, rank, memory, address[4], file;\n} " + p.status.block + ";\n\n";
}

/// The variable that counts rounds. The shaders of a draw have no workgroup memory: each invocation counts for itself.
std::string rounds_place(const Printer& p) {
    return p.raster() ? p.status.rounds : p.status.rounds + "[gl_SubgroupID]";
}

std::string count_text(const Printer& p) {
    const StatusNames& s = p.status;
    std::uint32_t group = p.pass.group[0] * p.pass.group[1] * p.pass.group[2];
    std::uint32_t subgroups = std::max(1u, (group + smallest_subgroup - 1) / smallest_subgroup);
    std::string text = "// After this many iterations in all, the device ends the loops of an invocation; 0: never.\n"
                       "layout(constant_id = 101) const uint " +
                       s.limit + " = 0u;\n";
    if (p.raster()) text += "uint " + s.rounds + ";\n\n";
    else text += "shared uint " + s.rounds + "[" + s.limit + " == 0u ? 1u : " + std::to_string(subgroups) + "u];\n\n";
    text += "// Counts an iteration of a loop. False where the limit is reached; the first loop that reaches it is "
            "reported.\n";
    if (!p.raster()) text += "// A subgroup has one count: devices with a limit run its lanes in lockstep.\n";
    text += "// `idle_rounds`: iterations of loops inside the caller's that may run with no lane active: they count.\n";
    text += "bool " + s.another_round + "(uint idle_rounds, " + place_parameters(p) + ") {\n";
    text += "    if (" + s.limit + " == 0u) return true;\n";
    text += "    uint rounds = " + rounds_place(p) + " + 1u + idle_rounds;\n";
    text += "    " + rounds_place(p) + " = rounds;\n";
    text += "    if (rounds < " + s.limit + ") return true;\n";
    text += "    if (atomicCompSwap(" + s.block + ".code, 0u, 1u) == 0u) " + place_assigned(p) + "\n";
    return text + "    return false;\n}\n\n";
}

}  // namespace

void name_status(Printer& p) {
    if (!p.pass.has_status()) return;
    p.names.declare("Status");
    p.status.block = p.names.declare("status");
    if (p.pass.has_reports) p.status.report = p.names.declare("report_outside");
    if (!p.pass.counts_rounds()) return;
    p.status.limit = p.names.declare("loop_round_limit");
    p.status.rounds = p.names.declare("loop_rounds");
    p.status.another_round = p.names.declare("another_round");
}

std::string status_definitions(Printer& p) {
    if (!p.pass.has_status()) return "";
    if (p.pass.counts_rounds() && !p.raster()) p.extensions.insert("GL_KHR_shader_subgroup_basic");
    return record_text(p) + (p.pass.has_reports ? report_definition(p) : "") +
           (p.pass.counts_rounds() ? count_text(p) : "");
}

std::string place_parameters(const Printer& p) { return names_files(p) ? "uint line, uint file" : "uint line"; }

std::string place_arguments(const Printer& p, Span span) {
    std::string line = std::to_string(span ? p.sources.line_of(span) : 0) + "u";
    if (!names_files(p)) return line;
    auto file = std::find(p.pass.files.begin(), p.pass.files.end(), span.file);
    std::size_t index = span && file != p.pass.files.end() ? static_cast<std::size_t>(file - p.pass.files.begin()) : 0;
    return line + ", " + std::to_string(index) + "u";
}

namespace {

std::uint32_t loops_in(const Printer& p, const std::vector<ir::StmtId>& body);

/// The number of loops in the function that a node calls; 0 if the node is no call.
std::uint32_t loops_in_callee(const Printer& p, ir::ExprId id) {
    const ir::Expr& node = p.program.exprs[id];
    return node.op == ir::Op::call ? loops_in(p, p.program.functions[node.function].body) : 0;
}

/// The number of loops in the statements and in the functions that they call.
std::uint32_t loops_in(const Printer& p, const std::vector<ir::StmtId>& body) {
    std::uint32_t loops = 0;
    for_each_statement(p.program, body, [&](const ir::Stmt& stmt) {
        loops += stmt.op == ir::StmtOp::for_ || stmt.op == ir::StmtOp::while_;
    });
    for_each_expression(p.program, body, [&](ir::ExprId id) { loops += loops_in_callee(p, id); });
    return loops;
}

/// The number of loops in the functions that an expression, if there is one, calls.
std::uint32_t loops_called(const Printer& p, ir::ExprId id) {
    std::uint32_t loops = 0;
    if (id) for_each_node(p.program, id, [&](ir::ExprId each) { loops += loops_in_callee(p, each); });
    return loops;
}

bool leaves(const Printer& p, const ir::Stmt& stmt) {
    using ir::StmtOp;
    if (stmt.op == StmtOp::break_ || stmt.op == StmtOp::continue_ || stmt.op == StmtOp::return_) return true;
    const auto one_leaves = [&](ir::StmtId id) { return leaves(p, p.program.stmts[id]); };
    return std::ranges::any_of(stmt.body, one_leaves) || std::ranges::any_of(stmt.otherwise, one_leaves);
}

/// How many rounds of the loops in a body the device may run with no lane active: one for each loop that a condition or
/// an earlier break, continue or return may leave out, one for each loop inside another loop (when the outer one ends),
/// and one for each loop in a called function and each addition by compare-and-swap.
std::uint32_t idle_rounds(const Printer& p, const std::vector<ir::StmtId>& body, bool may_be_left_out) {
    std::uint32_t rounds = 0;
    for (ir::StmtId id : body) {
        const ir::Stmt& stmt = p.program.stmts[id];
        const bool is_loop = stmt.op == ir::StmtOp::for_ || stmt.op == ir::StmtOp::while_;
        if (is_loop)
            rounds += (may_be_left_out ? 1 : 0) + loops_called(p, stmt.value) + loops_called(p, stmt.limit) +
                      loops_in(p, stmt.body);
        else if (stmt.op == ir::StmtOp::if_)
            rounds +=
                loops_called(p, stmt.value) + idle_rounds(p, stmt.body, true) + idle_rounds(p, stmt.otherwise, true);
        else if (stmt.op == ir::StmtOp::block) rounds += idle_rounds(p, stmt.body, may_be_left_out);
        else rounds += loops_in(p, {id});
        may_be_left_out = may_be_left_out || leaves(p, stmt);
    }
    return rounds;
}

}  // namespace

std::string round_test(const Printer& p, std::uint32_t idle_rounds, const std::string& place) {
    if (p.status.another_round.empty()) return "";
    return p.status.another_round + "(" + std::to_string(idle_rounds) + "u, " + place + ")";
}

std::string round_test(const Printer& p, const ir::Stmt& loop) {
    std::uint32_t rounds = idle_rounds(p, loop.body, false);
    if (loop.op == ir::StmtOp::while_) rounds += loops_called(p, loop.value);
    return round_test(p, rounds, place_arguments(p, loop.span));
}

std::string report_text(Printer& p, const ir::Stmt& stmt) {
    std::uint32_t rank = p.program.types.components(p.program.exprs[stmt.target].type);
    static constexpr const char* zeros[] = {"", ", 0u, 0u, 0u", ", 0u, 0u", ", 0u", ""};
    std::string address = print_any(p, stmt.target);
    if (rank < 4) address = "uvec4(" + address + zeros[rank] + ")";
    std::string memory = stmt.slot == ir::no_binding ? "0xffffffffu" : std::to_string(stmt.slot) + "u";
    return p.status.report + "(" + place_arguments(p, stmt.span) + ", " + memory + ", " + std::to_string(rank) + "u, " +
           address + ");";
}

void print_round_start(Printer& p) {
    if (p.pass.counts_rounds())
        line(p, "if (" + p.status.limit + " != 0u) " + rounds_place(p) + " = " +
                    std::to_string(idle_rounds(p, p.body(), false)) + "u;");
}

}  // namespace gliftc::glsl
