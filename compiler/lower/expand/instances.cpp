// Expander: functions that are not inlined. A lowered instance of a function is made for each list of structures, or
// translator's state, that it is called with (FunctionKey of context.h has the whole key); a function that takes
// neither is used as it is, unless it zeroes a long array (is_long_array of unroll.h), for which expansion makes loops.
#include "lower/expand/expand.h"

#include "ir/walk.h"
#include "lower/analysis/unroll.h"

namespace gliftc::lower {

using namespace ir;

/// Whether the function or one that it calls reads neighbours of the current element.
bool Expander::sees_window(FunctionId function) {
    if (auto found = windows_.find(function); found != windows_.end()) return found->second;
    bool sees = false;
    for_each_expression(p, p.functions[function].body, [&](ExprId id) {
        const Expr& node = p.exprs[id];
        sees = sees || node.op == Op::near || (node.op == Op::call && sees_window(node.function));
    });
    windows_.emplace(function, sees);
    return sees;
}

/// Whether the function or one that it calls declares a long array that is zero-initialised, for which expansion makes
/// a loop.
bool Expander::has_long_zero(FunctionId function) {
    if (auto found = long_zeros_.find(function); found != long_zeros_.end()) return found->second;
    bool has = false;
    for_each_statement(p, p.functions[function].body, [&](const Stmt& stmt) {
        has = has || (stmt.op == StmtOp::let && !stmt.value && is_long_array(p, p.locals[stmt.local].type));
    });
    for_each_expression(p, p.functions[function].body, [&](ExprId id) {
        const Expr& node = p.exprs[id];
        has = has || (node.op == Op::call && has_long_zero(node.function));
    });
    long_zeros_.emplace(function, has);
    return has;
}

Pair Expander::call_instance(FunctionId function, std::vector<Pair> arguments, Frame frame) {
    const Function& original = p.functions[function];
    Expr call;
    call.op = Op::call;
    call.type = original.result;
    for (std::size_t i = 0; i < arguments.size() && i < original.params.size(); ++i)
        call.operands.push_back(stored(arguments[i], p.locals[original.params[i]].type));
    if (sees_window(function)) call.operands.push_back(build.local(cx.pass.address));
    call.function = instance(function, std::move(frame));
    if (p.functions[call.function].params.size() > call.operands.size())
        call.operands.push_back(build.local(cx.pass.in_range));
    ExprId result = p.exprs.add(std::move(call));
    if (p.types.kind(original.result) == TypeKind::optional) return of_optional(result);
    return {result, {}};
}

/// Begins an instance of a function that reads neighbours. Its last parameters are the invocation's address
/// (Pass::address) and, in kernels with a group, Pass::in_range; it computes all other addresses from these in its own
/// body.
Expander::Current Expander::enter_window(Function& made) {
    Current outer{cx.pass.address,     cx.pass.in_range,      std::move(prelude_),
                  std::move(centres_), std::move(addresses_), std::exchange(block_, {})};
    cx.pass.address = cx.new_local("address", p.locals[outer.address].type, made.span);
    made.params.push_back(cx.pass.address);
    if (cx.kernel.grouped())
        made.params.push_back(cx.pass.in_range = cx.new_local("in_range", p.types.bool_, made.span));
    prelude_ = {};
    centres_ = {};
    addresses_ = {};
    near_offsets.reset();
    return outer;
}

void Expander::leave_window(Function& made, Current outer) {
    made.body.insert(made.body.begin(), prelude_.begin(), prelude_.end());
    cx.pass.address = outer.address;
    cx.pass.in_range = outer.in_range;
    prelude_ = std::move(outer.prelude);
    centres_ = std::move(outer.centres);
    addresses_ = std::move(outer.addresses);
    block_ = outer.block;
}

FunctionId Expander::instance(FunctionId id, Frame frame) {
    const Function original = p.functions[id];
    // A function without structures and state is used as it is, by all passes, unless it zeroes a long array.
    if (frame.places.empty() && frame.stage == nullptr && !has_long_zero(id)) return id;
    FunctionKey key{id, {}, {}};
    auto path = [](const Place& place) {
        std::vector<std::uint32_t> numbers{place.root};
        numbers.insert(numbers.end(), place.members.begin(), place.members.end());
        return numbers;
    };
    for (const Place& place : frame.places) key.places.push_back(path(place));
    if (frame.stage != nullptr) {
        key.state = path(frame.structure);
        const auto& via = cx.structure_at(frame.structure).via;
        key.state.push_back(static_cast<std::uint32_t>(frame.stage - via.data()));
    }
    key.is_within = within_ > 0;
    if (auto found = cx.instances.find(key); found != cx.instances.end()) return found->second;

    Function made = original;
    frame.prefix.clear();
    if (frame.stage != nullptr || !frame.places.empty()) {
        const Place& owner = frame.stage != nullptr ? frame.structure : frame.places[0];
        made.name = p.names->intern(cx.name_of(owner) + "_" + (*p.names)[original.name]);
    }
    made.structures.clear();
    made.params.clear();
    frame.result = original.result;
    for (LocalId param : original.params) {
        Local local = p.locals[param];
        LocalId copy = p.locals.add(local);
        made.params.push_back(copy);
        Pair value{build.local(copy), {}};
        if (p.types.kind(local.type) == TypeKind::optional) value = of_optional(value.value);
        frame.locals[param] = value;
    }
    const bool is_window = sees_window(id);
    Current outer = is_window ? enter_window(made) : Current{};
    // In checked builds, accesses by address ask for Pass::in_range, too (check.cpp).
    const bool may_check = cx.checks == Checks::ranges && cx.kernel.grouped() && !is_window;
    const LocalId in_range = cx.pass.in_range;
    if (may_check) cx.pass.in_range = cx.new_local("in_range", p.types.bool_, made.span);
    made.body = inside(std::move(frame), [&] { return collect([&] { expand_body(original.body); }); });
    if (is_window) leave_window(made, std::move(outer));
    if (may_check && mentions(p, made.body, cx.pass.in_range)) made.params.push_back(cx.pass.in_range);
    if (may_check) cx.pass.in_range = in_range;
    FunctionId result = p.functions.add(std::move(made));
    cx.instances.emplace(std::move(key), result);
    cx.made_functions.insert(result);
    return result;
}

}  // namespace gliftc::lower
