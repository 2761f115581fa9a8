#include "lower/analysis/loops.h"

#include "ir/walk.h"
#include "lower/analysis/unroll.h"

#include <algorithm>

#include <limits>

namespace gliftc::lower {

using namespace ir;

namespace {

constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t largest_subgroup = 128;  // lanes: Vulkan allows no more
constexpr std::uint64_t bits_of_a_word = 32;

std::uint64_t plus(std::uint64_t a, std::uint64_t b) { return a > unknown - b ? unknown : a + b; }
std::uint64_t times(std::uint64_t a, std::uint64_t b) { return a != 0 && b > unknown / a ? unknown : a * b; }

class Loops {
public:
    explicit Loops(Context& context) : cx(context) {}

    std::uint64_t rounds(const std::vector<StmtId>& body) {
        std::uint64_t total = 0;
        for (StmtId id : body) total = plus(total, rounds(cx.p.stmts[id]));
        return total;
    }

private:
    std::uint64_t rounds(const Stmt& stmt) {
        std::uint64_t total = 0;
        for_each_root(stmt, [&](ExprId root) {
            for_each_node(cx.p, root, [&](ExprId id) {
                if (cx.p.exprs[id].op == Op::call) total = plus(total, of_function(cx.p.exprs[id].function));
            });
        });
        std::uint64_t inside = plus(rounds(stmt.body), rounds(stmt.otherwise));
        if (stmt.op == StmtOp::while_) inside = note(stmt, unknown);
        if (stmt.op == StmtOp::for_) {
            // The last test, which fails, counts as an iteration, too: devices may go through the inner loops once more
            // then, with no lane active (emit/glsl/status.cpp).
            auto known = rounds_of(cx.p, stmt.value, stmt.limit);
            std::uint64_t count = known ? known->count : most(stmt.limit);
            inside = note(stmt, plus(times(count, plus(inside, 1)), plus(1, loops_in(stmt.body))));
        }
        return plus(total, inside);
    }

    /// The number of loops in the statements and in the functions that they call.
    std::uint64_t loops_in(const std::vector<StmtId>& body) const {
        std::uint64_t loops = 0;
        for_each_statement(cx.p, body,
                           [&](const Stmt& stmt) { loops += stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_; });
        for_each_expression(cx.p, body, [&](ExprId id) {
            if (cx.p.exprs[id].op == Op::call) loops += loops_in(cx.p.functions[cx.p.exprs[id].function].body);
        });
        return loops;
    }

    /// An upper bound of a uint expression; `unknown` if none is known.
    std::uint64_t most(ExprId id) {
        const Expr& node = cx.p.exprs[id];
        if (is_bit_count_as_uint(node)) return bits_of_a_word;
        if (node.type != cx.p.types.uint) return unknown;
        if (node.op == Op::constant) return node.bits;
        if (node.op == Op::builtin) return most(node.builtin);
        if (node.op == Op::select) return std::max(most(node.operands[1]), most(node.operands[2]));
        if (node.op == Op::binary) return most_of_binary(node);
        if (node.op == Op::intrinsic && node.intrinsic == Intrinsic::min)
            return std::min(most(node.operands[0]), most(node.operands[1]));
        return node.op == Op::local ? most(node.local) : unknown;
    }

    /// An upper bound of a local: that in Builder::limits, else that of the local's definition. Builder::limits is
    /// needed since quotients.cpp folds `x % n` to x where it knows that x is below n: the expression no longer shows
    /// the bound n.
    std::uint64_t most(LocalId local) {
        if (const auto known = cx.build.limits.find(local); known != cx.build.limits.end()) return known->second;
        const ExprId* definition = cx.definitions.find(local);
        return definition ? most(*definition) : unknown;
    }

    /// Whether the node is uint(bitCount(x)): bitCount gives an int that is never negative.
    bool is_bit_count_as_uint(const Expr& node) const {
        if (node.op != Op::convert || node.type != cx.p.types.uint) return false;
        const Expr& from = cx.p.exprs[node.operands[0]];
        return from.op == Op::intrinsic && from.intrinsic == Intrinsic::bitCount && from.type == cx.p.types.int_;
    }

    std::uint64_t most(Builtin builtin) {
        const auto& group = cx.pass.group;
        const std::uint64_t invocations = std::uint64_t{group[0]} * group[1] * group[2];
        switch (builtin) {
        case Builtin::local_index:
        case Builtin::subgroup_index: return invocations - 1;
        case Builtin::subgroup_count: return invocations;
        case Builtin::subgroup_size:
        case Builtin::subgroup_lane: return largest_subgroup;
        case Builtin::global_id:
        case Builtin::local_id:
        case Builtin::group_id:
        case Builtin::group_count:
        case Builtin::corner:
        case Builtin::instance:
        case Builtin::fragment_place:
        case Builtin::is_front:
        case Builtin::skips_branches:
        case Builtin::adds_floats: return unknown;
        }
        return unknown;
    }

    /// An upper bound of a binary operation. Sums and products that may wrap around have none.
    std::uint64_t most_of_binary(const Expr& node) {
        std::uint64_t a = most(node.operands[0]), b = most(node.operands[1]), result = unknown;
        if (node.binary == BinaryOp::bit_and) return std::min(a, b);
        if (node.binary == BinaryOp::add) result = plus(a, b);
        if (node.binary == BinaryOp::multiply) result = times(a, b);
        auto by = evaluate(cx.p, node.operands[1]);
        if (by && by->bits() != 0) {
            // A uint without a known bound is still below 2^32.
            const std::uint64_t most_of_a = std::min<std::uint64_t>(a, std::numeric_limits<std::uint32_t>::max());
            if (node.binary == BinaryOp::divide) result = most_of_a / by->bits();
            if (node.binary == BinaryOp::remainder) result = std::min(most_of_a, by->bits() - 1);
            if (node.binary == BinaryOp::shift_right) result = most_of_a >> (by->bits() & 31);
        }
        return result > std::numeric_limits<std::uint32_t>::max() ? unknown : result;
    }

    std::uint64_t note(const Stmt& stmt, std::uint64_t count) {
        if (count >= longest_) {
            longest_ = count;
            cx.pass.longest_loop = stmt.span;
        }
        return count;
    }

    std::uint64_t of_function(FunctionId id) {
        auto [found, is_new] = functions_.try_emplace(id, 0);
        if (is_new) {
            std::uint64_t count = rounds(cx.p.functions[id].body);
            functions_[id] = count;
            return count;
        }
        return found->second;
    }

    Context& cx;
    std::unordered_map<FunctionId, std::uint64_t> functions_;
    std::uint64_t longest_ = 0;
};

/// Adds the files that messages of a pass may name: those of its reports and, if it counts iterations, of its loops.
void add_files(const Program& program, const Pass& pass, std::vector<std::uint32_t>& files) {
    const auto add = [&](const std::vector<StmtId>& body) {
        for_each_statement(program, body, [&](const Stmt& stmt) {
            const bool is_loop = stmt.op == StmtOp::for_ || stmt.op == StmtOp::while_;
            if (!stmt.span || !(stmt.op == StmtOp::report || (is_loop && pass.counts_rounds()))) return;
            if (std::find(files.begin(), files.end(), stmt.span.file) == files.end()) files.push_back(stmt.span.file);
        });
    };
    for (const auto* body : bodies_of(pass)) add(*body);
    for (FunctionId function : pass.functions) add(program.functions[function].body);
}

/// Adds the messages that the pass prints, in the order of its bodies.
void add_messages(const Program& program, const Pass& pass, std::vector<std::uint32_t>& messages) {
    for (const auto* body : bodies_of(pass))
        for_each_statement(program, *body, [&](const Stmt& stmt) {
            if (stmt.op != StmtOp::print || std::ranges::find(messages, stmt.slot) != messages.end()) return;
            messages.push_back(stmt.slot);
        });
}

/// Whether conversions of the texels may differ between devices in the last bit: those between eight bits and floats.
bool rounds_freely(Format format) { return format == Format::r8 || format == Format::rg8 || format == Format::rgba8; }

bool is_exact(const Program& program, const Expr& intrinsic) {
    switch (exactness_of(intrinsic.intrinsic)) {
    case Exactness::exact: return true;
    case Exactness::exact_for_integers: return !program.types.is_floating(program.types.scalar_of(intrinsic.type));
    case Exactness::inexact: return false;
    }
    return false;
}

/// Adds the functions that the body calls, callees before callers; notes operations that are not exact.
void add_functions(Context& cx, const std::vector<StmtId>& body) {
    for_each_expression_of_trees(cx.p, body, [&](ExprId id) {
        const Expr& node = cx.p.exprs[id];
        if (node.op == Op::intrinsic && !is_exact(cx.p, node)) cx.pass.exact = false;
        if (node.op == Op::image_sample && cx.pass.bindings[node.slot].linear) cx.pass.exact = false;
        if (node.op == Op::image_compare) cx.pass.exact = false;
        if (node.op != Op::call) return;
        auto& functions = cx.pass.functions;
        if (std::find(functions.begin(), functions.end(), node.function) != functions.end()) return;
        add_functions(cx, cx.p.functions[node.function].body);
        if (std::find(functions.begin(), functions.end(), node.function) == functions.end())
            functions.push_back(node.function);
    });
}

/// Whether the body adds floats to elements by atomic operations whose order depends on the device.
bool adds_floats(const Context& cx, const std::vector<StmtId>& body) {
    bool found = false;
    for_each_statement(cx.p, body, [&](const Stmt& stmt) {
        if (stmt.op != StmtOp::atomic || stmt.combine != Combine::add) return;
        const PassUpdate* ordered = cx.pass.ordered_sum(stmt.slot);
        if (ordered != nullptr && ordered->is_exact) return;
        found = found || cx.p.types.is_floating(cx.p.types.scalar_of(cx.pass.bindings[stmt.slot].element));
    });
    return found;
}

bool has_reports(const Program& program, const std::vector<StmtId>& body) {
    bool found = false;
    for_each_statement(program, body, [&](const Stmt& stmt) { found = found || stmt.op == StmtOp::report; });
    return found;
}

}  // namespace

void summarize(Context& cx) {
    cx.pass.loop_rounds = Loops(cx).rounds(variant_for(cx.pass, Devices::shaders).body);
    if (const Variant* fragment = fragment_for(cx.pass, Devices::shaders)) {
        const Span longest_of_vertices = cx.pass.longest_loop;
        const std::uint64_t rounds = Loops(cx).rounds(fragment->body);
        if (rounds <= cx.pass.loop_rounds) cx.pass.longest_loop = longest_of_vertices;
        cx.pass.loop_rounds = std::max(cx.pass.loop_rounds, rounds);
    }
    // Devices round interpolated values differently, and the arithmetic of their own.
    if (cx.kernel.raster || cx.kernel.fast_math) cx.pass.exact = false;
    for (const auto* body : bodies_of(cx.pass)) add_functions(cx, *body);
    for (const auto* body : bodies_of(cx.pass)) cx.pass.exact = cx.pass.exact && !adds_floats(cx, *body);
    for (const auto* body : bodies_of(cx.pass)) cx.pass.has_reports = cx.pass.has_reports || has_reports(cx.p, *body);
    for (FunctionId function : cx.pass.functions)
        cx.pass.has_reports = cx.pass.has_reports || has_reports(cx.p, cx.p.functions[function].body);
    for (const PassBinding& binding : cx.pass.bindings) cx.pass.exact = cx.pass.exact && !rounds_freely(binding.format);
}

void agree(const Program& program, std::span<Pass* const> forms) {
    const Pass& longest = **std::ranges::max_element(forms, {}, &Pass::loop_rounds);
    const std::uint64_t rounds = longest.loop_rounds;
    const Span loop = longest.longest_loop;
    const bool has_reports = std::ranges::any_of(forms, &Pass::has_reports);
    const bool is_exact = std::ranges::all_of(forms, &Pass::exact);
    // All forms share one description of the kernel's bindings (glift::Kernel::bindings), of which descriptors are
    // made. So an image is bound as a combined image sampler in all forms, or as a storage image in all.
    for (std::size_t i = 0; i < forms[0]->bindings.size(); ++i) {
        const bool is_sampled = std::ranges::all_of(forms, [&](Pass* pass) { return pass->bindings[i].sampled; });
        for (Pass* pass : forms) pass->bindings[i].sampled = is_sampled;
    }
    std::vector<std::uint32_t> files{program.kernels[forms[0]->kernel].span.file}, messages;
    for (Pass* pass : forms) {
        pass->loop_rounds = rounds;
        pass->longest_loop = loop;
        pass->has_reports = has_reports;
        pass->exact = is_exact;
        if (pass->has_status()) add_files(program, *pass, files);
        add_messages(program, *pass, messages);
    }
    for (Pass* pass : forms) pass->messages = messages;
    for (Pass* pass : forms)
        if (pass->has_status()) pass->files = files;
}

}  // namespace gliftc::lower
