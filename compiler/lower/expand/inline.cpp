#include "ir/effects.h"
#include "ir/walk.h"
#include "lower/analysis/unroll.h"
#include "lower/expand/expand.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

/// A function that is only `let`s and a return, and has at most this many nodes, is inlined. Any function, small or
/// not, is inlined if it takes structures, if it gives an optional, or if a translator, or a view or a function of
/// blocks (ir::Blocks) that is itself inlined, calls it. But no call is inlined that InlineSizes refuses, or that is
/// nested deeper than depth_limit, or that is evaluated: here, if its arguments are constants, or by the host, if they
/// are uniform (expand_call).
constexpr std::size_t plain_call_limit = 40;
constexpr unsigned depth_limit = 64;
constexpr std::uint32_t largest_tree = 1024;  ///< a value gets a local if it has more nodes as a tree

bool is_short(const Program& p, const Function& function) {
    std::size_t size = 0;
    for (StmtId id : function.body) {
        const Stmt& stmt = p.stmts[id];
        if (stmt.op != StmtOp::let && stmt.op != StmtOp::return_) return false;
        for_each_root(stmt, [&](ExprId root) { for_each_node(p, root, [&](ExprId) { ++size; }); });
    }
    return size <= plain_call_limit;
}

}  // namespace

/// Whether the function, or one that it calls, has a `while`.
bool Expander::may_not_end(FunctionId function) {
    if (const auto found = endless_.find(function); found != endless_.end()) return found->second;
    bool may = false;
    const std::vector<StmtId>& body = p.functions[function].body;
    for_each_statement(p, body, [&](const Stmt& stmt) { may = may || stmt.op == StmtOp::while_; });
    for_each_expression(p, body, [&](ExprId id) {
        const Expr& node = p.exprs[id];
        may = may || (node.op == Op::call && may_not_end(node.function));
    });
    endless_.emplace(function, may);
    return may;
}

/// A copy of a function that may not end, for calls with uniform arguments under a condition: a call of the copy does
/// not count as uniform, so that the host does not evaluate it where the condition keeps it out.
FunctionId Expander::kept_in_kernel(FunctionId id) {
    FunctionId& copy = kept_[id];
    if (copy) return copy;
    copy = p.functions.add(Function(p.functions[id]));
    cx.made_functions.insert(copy);
    return copy;
}

/// The value of a call whose arguments are constants of integers, bools or enums. It is remembered, since unrolled
/// loops repeat such calls. Absent: the call cannot be evaluated, or some argument is no such constant.
ExprId Expander::known_call(const Expr& node, const std::vector<Pair>& arguments) {
    std::vector<std::uint64_t> key{node.function.index};
    for (const Pair& argument : arguments) {
        const Expr& constant = p.exprs[argument.value];
        if (argument.has || constant.op != Op::constant || p.types.is_floating(constant.type)) return {};
        key.push_back(constant.bits);
    }
    auto [found, is_new] = cx.known_calls.try_emplace(std::move(key));
    if (!is_new) return found->second;
    Expr call = node;
    for (std::size_t i = 0; i < arguments.size(); ++i) call.operands[i] = arguments[i].value;
    if (auto value = evaluate(p, p.exprs.add(std::move(call)))) found->second = materialize(p, *value, node.span);
    return found->second;
}

Pair Expander::expand_call(const Expr& node) {
    if (p.functions[node.function].is_statements()) return expand_as_statements(node);
    const Function& function = p.functions[node.function];
    std::vector<Pair> arguments;
    arguments.reserve(node.operands.size());
    bool constant = function.structures.empty(), uniform = constant;
    for (std::size_t i = 0; i < node.operands.size(); ++i) {
        Pair argument = expand(node.operands[i]);
        bool is_optional = static_cast<bool>(argument.has);
        constant = constant && build.is_constant(argument.value) && (!is_optional || build.is_constant(argument.has));
        uniform = uniform && !is_optional && is_uniform(cx, argument.value);
        arguments.push_back(argument);
    }
    bool is_optional = p.types.kind(function.result) == TypeKind::optional;
    if (holds_empty(p, function.result)) uniform = false;  // types with empty parts cannot be parameters
    if (uniform && !constant && out_ != top_ && may_not_end(node.function)) {
        Expr call = node;
        call.function = kept_in_kernel(node.function);
        for (std::size_t i = 0; i < arguments.size(); ++i)
            call.operands[i] = stored(arguments[i], p.locals[function.params[i]].type);
        const ExprId id = p.exprs.add(std::move(call));
        return p.types.kind(function.result) == TypeKind::optional ? of_optional(id) : Pair{id, {}};
    }
    if (constant && !is_optional)
        if (ExprId known = known_call(node, arguments)) return {known, {}};
    if (constant || (uniform && !is_optional && frame_->stage == nullptr && function.extern_name.empty())) {
        Expr call = node;
        for (std::size_t i = 0; i < arguments.size(); ++i)
            call.operands[i] = stored(arguments[i], p.locals[function.params[i]].type);
        ExprId id = p.exprs.add(std::move(call));
        if (constant)
            if (auto value = evaluate(p, id)) {
                ExprId known = materialize(p, *value, node.span);
                return is_optional ? of_optional(known) : Pair{known, {}};
            }
        if (uniform && !is_optional) return {id, {}};  // the host evaluates the call (in library functions the shader)
    }
    Frame frame;
    for (const Place& place : node.places) frame.places.push_back(resolved(place));
    if (!function.structures.empty() || frame_->stage != nullptr) frame.prefix = frame_->prefix;
    bool wanted = is_optional || !function.structures.empty() || frame_->stage != nullptr || !frame_->prefix.empty() ||
                  is_short(p, function);
    if (wanted && depth_ < depth_limit && inline_sizes_.of(node.function))
        return inlined(node.function, std::move(arguments), std::move(frame));
    return call_instance(node.function, std::move(arguments), std::move(frame));
}

/// Gives a value a local if it is large: the tree of an expression can double with each use of a value.
Pair Expander::bounded(const std::string& name, Pair pair) {
    if (pair.value && tree_sizes_.of(pair.value) > largest_tree) pair.value = named(name, pair.value);
    if (pair.has && tree_sizes_.of(pair.has) > largest_tree) pair.has = named(name + "_found", pair.has);
    return pair;
}

Pair Expander::inlined(FunctionId id, std::vector<Pair> arguments, Frame frame) {
    const Function& function = p.functions[id];
    for (std::size_t i = 0; i < function.params.size() && i < arguments.size(); ++i) {
        Pair argument = arguments[i];
        // An argument with an effect must be evaluated once, however often the body uses it.
        const std::string name = prefixed((*p.names)[p.locals[function.params[i]].name]);
        if (!numbers_.is_pure(argument.value)) argument.value = named(name, argument.value);
        if (argument.has && !numbers_.is_pure(argument.has)) argument.has = named(name + "_found", argument.has);
        frame.locals[function.params[i]] = bounded(name, argument);
    }
    ++depth_;
    Pair result = inside(std::move(frame), [&] { return run(function.body); });
    --depth_;
    return bounded(prefixed((*p.names)[function.name]), result);
}

/// Executes statements symbolically, with an expression for each local. Returns the value of the `return` that is
/// reached; absent: no return is reached, or it has no value.
Pair Expander::run(const std::vector<StmtId>& body) {
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Stmt& stmt = p.stmts[body[i]];
        switch (stmt.op) {
        case StmtOp::let: {
            TypeId type = p.locals[stmt.local].type;
            bool is_optional = p.types.kind(type) == TypeKind::optional;
            Pair value = stmt.value    ? expand(stmt.value)
                         : is_optional ? of_optional(build.zero(type))
                                       : Pair{build.zero(type), {}};
            note_name(value.value, p.locals[stmt.local].name);
            frame_->locals[stmt.local] = bounded(prefixed((*p.names)[p.locals[stmt.local].name]), value);
            break;
        }
        case StmtOp::assign: run_assign(stmt); break;
        case StmtOp::return_: return stmt.value ? expand(stmt.value) : Pair{};
        case StmtOp::if_: {
            if (returns(p, stmt.body) || returns(p, stmt.otherwise))
                return run_returning_if(stmt, {body.begin() + static_cast<std::ptrdiff_t>(i) + 1, body.end()});
            run_if(stmt);
            break;
        }
        case StmtOp::block: {
            std::vector<StmtId> flat = stmt.body;
            flat.insert(flat.end(), body.begin() + static_cast<std::ptrdiff_t>(i) + 1, body.end());
            return run(flat);
        }
        case StmtOp::for_: {
            auto rounds = rounds_of(p, stmt.value, stmt.limit);
            for (std::uint64_t k = 0; k < rounds->count; ++k) {
                frame_->locals[stmt.local] = {build.integer(p.locals[stmt.local].type, rounds->first + k), {}};
                run(stmt.body);
            }
            break;
        }
        default: break;  // InlineSizes refuses functions with other statements
        }
    }
    return {};
}

/// The condition, or its value as a constant, if known_ has the condition or its negation.
ExprId Expander::decided(ExprId condition) {
    if (known_.empty()) return condition;
    const Expr& node = p.exprs[condition];
    const bool is_negated = node.op == Op::unary && node.unary == UnaryOp::logical_not;
    const ValueNumber number = numbers_.of(is_negated ? node.operands[0] : condition);
    const auto fact = std::ranges::find(known_, number, &Fact::condition);
    return fact == known_.end() ? condition : build.truth(fact->holds != is_negated);
}

Pair Expander::run_returning_if(const Stmt& stmt, const std::vector<StmtId>& rest) {
    ExprId condition = decided(value_of(stmt.value));
    auto with_rest = [&](std::vector<StmtId> body) {
        body.insert(body.end(), rest.begin(), rest.end());
        return body;
    };
    if (build.is_true(condition)) return run(with_rest(stmt.body));
    if (build.is_false(condition)) return run(with_rest(stmt.otherwise));
    auto before = frame_->locals;
    Pair a, b;
    Block yes = collect([&] { a = run(with_rest(stmt.body)); });
    frame_->locals = before;
    Block no = collect([&] { b = run(with_rest(stmt.otherwise)); });
    TypeId type = a.value ? build.type(a.value) : b.value ? build.type(b.value) : p.types.void_;
    if (!a.value || !b.value) return a.value ? a : b;
    if (a.has) type = p.types.optional(type);
    return merged(condition, std::move(yes), a, std::move(no), b, type);
}

/// Executes an `if` symbolically: afterwards a local whose values on the two sides differ is a select between them, or
/// a variable that both sides assign.
void Expander::run_if(const Stmt& stmt) {
    ExprId condition = value_of(stmt.value);
    if (build.is_true(condition) || build.is_false(condition)) {
        run(build.is_true(condition) ? stmt.body : stmt.otherwise);
        return;
    }
    auto before = frame_->locals;
    Block yes = collect([&] { run(stmt.body); });
    const auto after_yes = frame_->locals;
    frame_->locals = before;
    Block no = collect([&] { run(stmt.otherwise); });
    const auto after_no = frame_->locals;
    frame_->locals = before;
    std::vector<LocalId> changed;
    before.for_each([&](LocalId local, const Pair&) {
        Pair a = *after_yes.find(local), b = *after_no.find(local);
        if (a.value != b.value || a.has != b.has) changed.push_back(local);
    });
    std::sort(changed.begin(), changed.end());
    for (LocalId local : changed) {
        Pair a = *after_yes.find(local), b = *after_no.find(local);
        // With selects, the statements of both sides are added unconditionally with the first local; the values of
        // further locals may use what these statements declare.
        if (is_speculatable(yes) && is_speculatable(no)) {
            frame_->locals[local] =
                bounded(prefixed((*p.names)[p.locals[local].name]),
                        merged(condition, std::move(yes), a, std::move(no), b, p.locals[local].type));
            yes.clear();
            no.clear();
            continue;
        }
        TypeId type = build.type(a.value);
        auto name = prefixed((*p.names)[p.locals[local].name]);
        Pair& merged_local = frame_->locals[local];
        LocalId value = variable(name, type, {});
        merged_local.value = build.local(value);
        auto finish = [&](Block& block, Pair pair, LocalId has) {
            Block last = collect([&] {
                assign(value, pair.value);
                if (pair.has) assign(has, pair.has);
            });
            block.insert(block.end(), last.begin(), last.end());
        };
        LocalId has;
        if (a.has) {
            has = variable(name + "_found", p.types.bool_, {});
            merged_local.has = build.local(has);
        }
        finish(yes, a, has);
        finish(no, b, has);
    }
    if (!yes.empty() || !no.empty()) append_if(condition, std::move(yes), std::move(no));
}

void Expander::run_assign(const Stmt& stmt) {
    ExprId root = stmt.target;
    while (p.exprs[root].op != Op::local) root = p.exprs[root].operands[0];
    LocalId local = p.exprs[root].local;
    Pair value = expand(stmt.value);
    if (root == stmt.target) {
        note_name(value.value, p.locals[local].name);
        frame_->locals[local] = bounded(prefixed((*p.names)[p.locals[local].name]), value);
        return;
    }
    ExprId whole = replaced(stmt.target, stored(value, build.type(stmt.target)));
    frame_->locals[local] = bounded(prefixed((*p.names)[p.locals[local].name]), {whole, {}});
}

/// The new value of a local after an assignment of `value` to `target`, which is the local or a part of it.
ExprId Expander::replaced(ExprId target, ExprId value) {
    const Expr node = p.exprs[target];
    if (node.op == Op::local) return value;
    ExprId whole = value_of(node.operands[0]);
    TypeId type = build.type(whole);
    Operands parts;
    if (node.op == Op::field) {
        std::size_t count = p.structs[p.types[type].struct_].fields.size();
        for (std::uint32_t i = 0; i < count; ++i) parts.push_back(i == node.slot ? value : build.field(whole, i));
    } else if (node.op == Op::swizzle) {
        for (std::uint32_t i = 0; i < p.types.components(type); ++i) {
            ExprId part = build.component(whole, i);
            for (std::uint32_t k = 0; k < p.types.components(node.type); ++k)
                if (node.lanes[k] == i) part = build.component(value, k);
            parts.push_back(part);
        }
    } else {
        const std::uint64_t last = p.types[type].count - 1;  // where an index beyond the array leads
        const std::uint64_t at = std::min(build.bits_of(value_of(node.operands[1])).value_or(0), last);
        for (std::uint32_t i = 0; i < p.types[type].count; ++i)
            parts.push_back(i == at ? value : build.index(whole, build.uint(i)));
    }
    return replaced(node.operands[0], build.construct(type, std::move(parts)));
}

bool Expander::is_speculatable(const Block& block) {
    constexpr std::size_t limit = 16;
    if (block.size() > limit) return false;
    for (StmtId id : block) {
        const Stmt& stmt = p.stmts[id];
        if (stmt.op != StmtOp::let || !stmt.value || p.locals[stmt.local].is_mutable) return false;
        bool pure = true;
        for_each_node(p, stmt.value, [&](ExprId part) {
            Op op = p.exprs[part].op;
            pure = pure && !is_load(op) && op != Op::call;
        });
        pure = pure && numbers_.is_pure(stmt.value);
        if (!pure) return false;
    }
    return true;
}

/// Chooses between two values, each with the statements that it needs: by a select if both may be executed, else by an
/// `if`.
Pair Expander::merged(ExprId condition, Block yes, Pair a, Block no, Pair b, TypeId type) {
    bool is_optional = p.types.kind(type) == TypeKind::optional;
    TypeId inner = is_optional ? p.types[type].element : type;
    Pair result;
    if (is_speculatable(yes) && is_speculatable(no)) {
        out_->insert(out_->end(), yes.begin(), yes.end());
        out_->insert(out_->end(), no.begin(), no.end());
        if (is_optional) {
            result.has = build.select(condition, a.has, b.has);
            // Where the optional has no value, `value` is never used, so the other side's value can stand there, too.
            if (build.is_false(a.has)) return {b.value, result.has};
            if (build.is_false(b.has)) return {a.value, result.has};
        }
        result.value = a.value == b.value ? a.value : build.select(condition, a.value, b.value);
        return result;
    }
    LocalId value = variable(prefixed("result"), inner, {}), has;
    result.value = build.local(value);
    if (is_optional) {
        has = variable(prefixed("found"), p.types.bool_, {});
        result.has = build.local(has);
    }
    auto finish = [&](Block& block, Pair pair) {
        Block last = collect([&] {
            assign(value, pair.value);
            if (is_optional) assign(has, pair.has);
        });
        block.insert(block.end(), last.begin(), last.end());
    };
    finish(yes, a);
    finish(no, b);
    append_if(condition, std::move(yes), std::move(no));
    return result;
}

}  // namespace gliftc::lower
