// Functions that stay functions: one made for each set of places that it is called with.
#include "lower/expand.h"

namespace gliftc::lower {

using namespace ir;

Pair Expander::call_instance(FunctionId function, std::vector<Pair> arguments, Frame frame) {
    const Function& original = p.functions[function];
    Expr call;
    call.op = Op::call;
    call.type = original.result;
    for (std::size_t i = 0; i < arguments.size() && i < original.params.size(); ++i)
        call.operands.push_back(stored(arguments[i], p.locals[original.params[i]].type));
    call.function = instance(function, std::move(frame));
    ExprId result = p.exprs.add(std::move(call));
    if (p.types.kind(original.result) == TypeKind::optional) return of_optional(result);
    return {result, {}};
}

FunctionId Expander::instance(FunctionId id, Frame frame) {
    const Function original = p.functions[id];
    // Without structures or state there is nothing to put in: all passes share the function as it is.
    if (frame.places.empty() && frame.stage == nullptr) return id;
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
    if (auto found = cx.instances.find(key); found != cx.instances.end()) return found->second;

    Function made = original;
    const Place& owner = frame.stage != nullptr ? frame.structure : frame.places[0];
    frame.prefix.clear();
    made.name = p.names->intern(cx.name_of(owner) + "_" + (*p.names)[original.name]);
    made.structures.clear();
    made.params.clear();
    frame.result = original.result;
    for (LocalId param : original.params) {
        Local local = p.locals[param];
        LocalId copy = p.locals.add(local);
        made.params.push_back(copy);
        Pair value{make.local(copy), {}};
        if (p.types.kind(local.type) == TypeKind::optional) value = of_optional(value.value);
        frame.locals[param] = value;
    }
    Block body;
    inside(std::move(frame), [&] {
        Block* outer = out_;
        out_ = &body;
        expand_body(original.body);
        out_ = outer;
        return 0;
    });
    made.body = std::move(body);
    FunctionId result = p.functions.add(std::move(made));
    cx.instances.emplace(std::move(key), result);
    cx.made_functions.insert(result);
    return result;
}

}  // namespace gliftc::lower
