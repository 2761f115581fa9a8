#include "ir/effects.h"
#include "ir/levels.h"
#include "ir/walk.h"
#include "lower/analysis/unroll.h"
#include "lower/expand/blocks.h"
#include "lower/expand/expand.h"

namespace gliftc::lower {

using namespace ir;

std::vector<StmtId> Expander::kernel_body() { return expanded_body(cx.kernel.body); }

std::vector<StmtId> Expander::expanded_body(const std::vector<StmtId>& written) {
    Frame frame;
    for (std::uint32_t i = 0; i < cx.kernel.params.size(); ++i) frame.places.push_back({i, {}});
    frame_ = &frame;
    Block body;
    top_ = out_ = &body;
    Block of_block;
    if (cx.kernel.space) of_block = collect([&] { enter_block(); });
    block_.is_of_kernel = cx.kernel.space.has_value();
    read_arguments();
    expand_body(written);
    if (cx.kernel.space) {
        Block visited = visited_block(std::move(body));
        of_block.insert(of_block.end(), visited.begin(), visited.end());
        prelude_ = std::move(of_block);
    } else {
        prelude_.insert(prelude_.end(), body.begin(), body.end());
    }
    top_ = out_ = nullptr;
    frame_ = nullptr;
    return std::move(prelude_);
}

ExprId Expander::iteration_size() {
    Frame frame;
    for (std::uint32_t i = 0; i < cx.kernel.params.size(); ++i) frame.places.push_back({i, {}});
    ExprId size;
    size_statements = collect([&] {
        size = inside(std::move(frame), [&]() -> ExprId {
            const bool is_known = cx.is_direct() && !cx.kernel.raster && !cx.kernel.space;
            for (std::uint32_t i = 0; is_known && i < cx.kernel.params.size(); ++i) {
                if (follows_iteration(cx.kernel.params[i].pattern)) return domain_of({i, {}});
            }
            const std::uint32_t size = cx.parameter(ParameterSource::size, "size", iteration_type(cx), 0);
            if (cx.kernel.space) cx.pass.parameters[size].value = visited_size();
            return cx.parameter_expr(size);
        });
    });
    return size;
}

Expander::Block Expander::nested(const std::vector<StmtId>& body) {
    return collect([&] { expand_body(body); });
}

/// Expands the body of a loop, and counts the loop in Leaving::loops meanwhile.
Expander::Block Expander::looped(const std::vector<StmtId>& body) {
    if (frame_->leaving == nullptr) return nested(body);
    ++frame_->leaving->loops;
    Block made = nested(body);
    --frame_->leaving->loops;
    return made;
}

void Expander::expand_body(const std::vector<StmtId>& body) {
    if (frame_->leaving != nullptr) return expand_leaving(body);
    for (StmtId id : body) expand_statement(id);
}

void Expander::expand_statement(StmtId id) {
    const Stmt& stmt = p.stmts[id];
    Span outer = span_;
    if (stmt.span) span_ = stmt.span;
    switch (stmt.op) {
    case StmtOp::let: expand_let(stmt); break;
    case StmtOp::assign: expand_assign(stmt); break;
    case StmtOp::if_: expand_if(stmt); break;
    case StmtOp::for_: expand_for(stmt); break;
    case StmtOp::while_: expand_while(stmt); break;
    case StmtOp::return_: expand_return(stmt); break;
    case StmtOp::block: {
        Stmt copy = statement(StmtOp::block, stmt.span);
        copy.body = nested(stmt.body);
        append(std::move(copy));
        break;
    }
    case StmtOp::evaluate: {
        Stmt copy = statement(StmtOp::evaluate, stmt.span);
        copy.value = value_of(stmt.value);
        // A call or atomic operation that was expanded as statements leaves its result in a local, which nothing reads.
        const Op source = p.exprs[stmt.value].op;
        const bool is_call = source == Op::call || source == Op::intrinsic;
        if (copy.value && !(is_call && p.exprs[copy.value].op == Op::local)) append(std::move(copy));
        break;
    }
    case StmtOp::print: print(stmt); break;
    case StmtOp::break_:
    case StmtOp::continue_:
    case StmtOp::barrier:
    case StmtOp::subgroup_barrier:
    case StmtOp::store:
    case StmtOp::image_store:
    case StmtOp::atomic:
    case StmtOp::discard:
    case StmtOp::report: append(stmt); break;
    case StmtOp::set_element: set_element(stmt); break;
    case StmtOp::write: write(stmt); break;
#define HOST_STATEMENT(name) case StmtOp::name:
#define CPU_STATEMENT(name) case StmtOp::name:
#include "ir/statements.def"
        misplaced(stmt.op, "lower");
    }
    span_ = outer;
}

void Expander::zero_by_loops(const std::string& name, ExprId target) {
    const TypeId type = build.type(target);
    if (p.types.kind(type) != TypeKind::array) {
        Stmt zeroed = statement(StmtOp::assign, span_);
        zeroed.target = target;
        zeroed.value = build.zero(type);
        append(std::move(zeroed));
        return;
    }
    Stmt loop = statement(StmtOp::for_, span_);
    loop.local = cx.new_local(name, p.types.uint, span_);
    loop.value = build.uint(0);
    loop.limit = build.uint(p.types[type].count);
    loop.unrolled = p.types[type].count <= unroll_limit;
    const ExprId element = build.index(target, build.local(loop.local));
    loop.body = collect([&] { zero_by_loops(name, element); });
    append(std::move(loop));
}

void Expander::expand_let(const Stmt& stmt) {
    const Local local = p.locals[stmt.local];
    if (is_empty(p, local.type)) {  // a type without data: uses need no local
        if (stmt.value) expand_effects(stmt.value);
        return;
    }
    const std::string name = prefixed((*p.names)[local.name]);
    if (p.types.kind(local.type) == TypeKind::optional) {
        Pair value =
            stmt.value ? expand(stmt.value) : Pair{build.zero(p.types[local.type].element), build.truth(false)};
        if (local.is_mutable) {
            TypeId inner = p.types[local.type].element;
            LocalId has = variable(name + "_found", p.types.bool_, value.has);
            frame_->locals[stmt.local] = {build.local(variable(name, inner, value.value)), build.local(has)};
        } else {
            frame_->locals[stmt.local] = {named(name, value.value), named(name + "_found", value.has)};
        }
        return;
    }
    ExprId value = stmt.value ? value_of(stmt.value) : ExprId{};
    if (!local.is_mutable && value && build.is_constant(value)) {
        frame_->locals[stmt.local] = {value, {}};
        return;
    }
    if (!local.is_mutable && value && guarded_load_of(value)) {
        note_name(value, local.name);
        frame_->locals[stmt.local] = {value, {}};
        return;
    }
    if (!local.is_mutable && value) {
        frame_->locals[stmt.local] = {build.local(let(name, value, local.span)), {}};
        return;
    }
    const ExprId made = build.local(variable(name, local.type, value));
    frame_->locals[stmt.local] = {made, {}};
    // Zeroed by a loop: an assignment of one zero value would become a store for each element, which drivers take long
    // to compile (Mesa's llvmpipe 2 s for 256 elements).
    if (!value && is_long_array(p, local.type)) {
        p.stmts[out_->back()].uninitialized = true;
        zero_by_loops(name + "_at", made);
    }
}

/// Expands the target of an assignment: a local or a part of one. Indices in it are expanded as values.
ExprId Expander::expand_target(ExprId id) {
    const Expr& node = p.exprs[id];
    if (node.op == Op::local) return expand_local(node).value;
    Expr copy = node;
    copy.operands[0] = expand_target(node.operands[0]);
    if (node.op == Op::index) copy.operands[1] = value_of(node.operands[1]);
    return p.exprs.add(std::move(copy));
}

void Expander::expand_assign(const Stmt& stmt) {
    const Expr& whole = p.exprs[stmt.target];
    if (whole.op == Op::local && p.types.kind(whole.type) == TypeKind::optional) {
        const Pair* found = frame_->locals.find(whole.local);
        if (found == nullptr) return;
        Pair target = *found, value = expand(stmt.value);
        // Whether there is a new value may depend on the old one, which the first assignment overwrites.
        if (mentions(p, value.has, p.exprs[target.value].local))
            value.has =
                build.local(let(prefixed((*p.names)[p.locals[whole.local].name]) + "_found", value.has, stmt.span));
        assign(p.exprs[target.value].local, value.value);
        assign(p.exprs[target.has].local, value.has);
        return;
    }
    TypeId type = build.type(stmt.target);
    if (is_empty(p, type)) {
        for (ExprId part = stmt.target; p.exprs[part].op != Op::local; part = p.exprs[part].operands[0])
            if (p.exprs[part].op == Op::index) expand_effects(p.exprs[part].operands[1]);
        return expand_effects(stmt.value);
    }
    Stmt copy = statement(StmtOp::assign, stmt.span);
    copy.target = expand_target(stmt.target);
    copy.value = stored(expand(stmt.value), type);
    append(std::move(copy));
}

void Expander::expand_if(const Stmt& stmt) {
    ExprId condition = value_of(stmt.value);
    if (build.is_true(condition)) return expand_body(stmt.body);
    if (build.is_false(condition)) return expand_body(stmt.otherwise);
    Block yes = nested(stmt.body), no = nested(stmt.otherwise);
    append_if(condition, std::move(yes), std::move(no));
}

void Expander::expand_for(const Stmt& stmt) {
    ExprId first = value_of(stmt.value), limit = value_of(stmt.limit);
    const Local variable_ = p.locals[stmt.local];
    std::optional<Rounds> rounds = rounds_of(p, first, limit);
    const bool leaves = leaves_loop(p, stmt.body) || (frame_->leaving != nullptr && returns(p, stmt.body));
    if (rounds && rounds->count <= near_unroll_limit && has_near_depending_on_loop(p, stmt) && !leaves) {
        for (std::uint64_t i = 0; i < rounds->count; ++i) {
            frame_->locals[stmt.local] = {build.integer(variable_.type, rounds->first + i), {}};
            expand_body(stmt.body);
        }
        return;
    }
    // The limit is evaluated once.
    if (!is_trivial(cx, limit) && !is_uniform(cx, limit)) limit = build.local(let("end", limit, stmt.span));
    Stmt copy = statement(StmtOp::for_, stmt.span);
    copy.local = cx.new_local((*p.names)[variable_.name], variable_.type, variable_.span);
    copy.value = first;
    copy.limit = limit;
    frame_->locals[stmt.local] = {build.local(copy.local), {}};
    copy.body = looped(stmt.body);
    copy.unrolled = rounds && rounds->count <= unroll_limit && indexes_array_by_loop(p, copy);
    append(std::move(copy));
}

void Expander::expand_while(const Stmt& stmt) {
    ExprId condition;
    Block before = collect([&] { condition = value_of(stmt.value); });
    Stmt copy = statement(StmtOp::while_, stmt.span);
    if (before.empty()) {
        copy.value = condition;
        copy.body = looped(stmt.body);
    } else {
        // The condition needs statements: they begin the body, and a break follows.
        copy.value = build.truth(true);
        copy.body = std::move(before);
        Block leave = collect([&] {
            Block stop = collect([&] { append(statement(StmtOp::break_, stmt.span)); });
            append_if(build.negate(condition), std::move(stop), {});
        });
        copy.body.append(leave);
        Block body = looped(stmt.body);
        copy.body.append(body);
    }
    append(std::move(copy));
}

void Expander::expand_return(const Stmt& stmt) {
    if (frame_->leaving != nullptr) return expand_leave(stmt);
    Stmt copy = statement(StmtOp::return_, stmt.span);
    if (stmt.value) copy.value = stored(expand(stmt.value), frame_->result);
    append(std::move(copy));
}

}  // namespace gliftc::lower
