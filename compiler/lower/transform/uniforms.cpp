#include "lower/transform/uniforms.h"

#include "ir/empty.h"
#include "ir/walk.h"
#include "lower/analysis/number.h"
#include "lower/build/rewrite.h"

#include <map>

namespace gliftc::lower {

using namespace ir;

namespace {

/// Up to this many operations on parameters that exist anyway are cheaper than one more parameter.
constexpr unsigned shader_operations = 3;

std::string word_for(BinaryOp op) {
    switch (op) {
    case BinaryOp::multiply: return "times";
    case BinaryOp::divide: return "over";
    case BinaryOp::add: return "plus";
    case BinaryOp::subtract: return "minus";
    default: return "value";
    }
}

/// What becomes parameters: uniform values, which the host computes; or only the state that they are computed from, the
/// leaves of their expressions.
enum class Lifted { values, state };

class Uniforms {
public:
    Uniforms(Context& context, Lifted lifted) : cx(context), lifted_(lifted), numbers_(context) {}

    void collect(const std::vector<StmtId>& body);
    std::vector<StmtId> moved(const std::vector<StmtId>& body, std::size_t place);

private:
    bool is_field_of_argument(ExprId id) const;
    bool is_leaf(ExprId id) const;
    ExprId base(ExprId id) const;
    bool is_part_of_leaf(ExprId id) const { return is_leaf(base(id)); }
    std::uint32_t lanes_of(ExprId part) const;
    bool is_single(ExprId part);
    bool is_lifted(ExprId id);
    ExprId closed(ExprId id);
    void find(ExprId id);
    void note_leaves(ExprId id);
    bool is_cheap(ExprId id, unsigned& operations);
    bool is_kept(ExprId whole);
    void count(ExprId id);
    ExprId visit(ExprId id);
    ExprId visit_operands(ExprId id);
    std::vector<StmtId> rewrite(const std::vector<StmtId>& body);
    ExprId parameter(ExprId value);
    std::string name_of(ExprId id);
    bool has_one_constant(ExprId id) const;
    std::string unique(std::string name) const;

    Context& cx;
    Lifted lifted_;
    Numbers numbers_;
    std::map<ValueNumber, std::uint32_t> leaves_;  ///< leaves that are used, with a bit for each component used
    /// For each body the uniform values in it, in the order of their uses.
    std::vector<std::vector<ExprId>> lifted_values_;
    std::unordered_map<ValueNumber, std::uint32_t> slots_;  ///< index of the parameter that a value has become
    // The members from visited_ to top_ are for the body that is being rewritten.
    NodeMap<ExprId, ExprId> visited_{cx.first_expr};
    std::unordered_map<ValueNumber, unsigned> counts_;  ///< number of uses of uniform values that the shader computes
    std::unordered_map<ValueNumber, LocalId> locals_;   ///< the locals that hold these values
    std::vector<StmtId> top_;                           ///< the `let`s of these locals, put before the body
    NodeMap<ExprId, ExprId> closed_{cx.first_expr};     ///< the results of closed()
};

/// Whether this is a field of an argument of a structure's constructor, such as the background of a sparse grid:
/// shaders get the fields that they use. What a user's own shader fills in stays whole.
bool Uniforms::is_field_of_argument(ExprId id) const {
    const Expr* node = &cx.p.exprs[id];
    if (lifted_ == Lifted::state || holds_empty(cx.p, node->type)) return false;
    while (node->op == Op::field) node = &cx.p.exprs[node->operands[0]];
    return node->op == Op::member && !holds_empty(cx.p, node->type);
}

bool Uniforms::is_leaf(ExprId id) const {
    const Expr& node = cx.p.exprs[id];
    // A struct with empty parts cannot be a parameter; its other fields are leaves.
    if (node.op == Op::field)
        return is_field_of_argument(id) ||
               (holds_empty(cx.p, cx.build.type(node.operands[0])) && !holds_empty(cx.p, node.type));
    return node.op == Op::member || node.op == Op::memory_extent || node.op == Op::host_state ||
           node.op == Op::domain || node.op == Op::local;
}

/// The leaf or other expression at the bottom of a chain of swizzles and fields.
ExprId Uniforms::base(ExprId id) const {
    const Expr* node = &cx.p.exprs[id];
    while (!is_leaf(id) && (node->op == Op::swizzle || node->op == Op::field)) {
        id = node->operands[0];
        node = &cx.p.exprs[id];
    }
    return id;
}

/// The components of a leaf that a use of it takes, a bit for each.
std::uint32_t Uniforms::lanes_of(ExprId part) const {
    const Expr& node = cx.p.exprs[part];
    constexpr std::uint32_t all = 15;
    if (node.op != Op::swizzle || !is_leaf(node.operands[0])) return all;
    std::uint32_t lanes = 0;
    for (std::uint32_t i = 0; i < cx.p.types.components(node.type); ++i) lanes |= 1u << node.lanes[i];
    return lanes;
}

/// Whether this is a component of a leaf of which no other component is used: it alone becomes the parameter.
bool Uniforms::is_single(ExprId part) {
    const Expr& node = cx.p.exprs[part];
    if (lifted_ == Lifted::state) return false;  // the user fills in whole values, whatever is used of them
    if (node.op != Op::swizzle || !is_leaf(node.operands[0]) || cx.p.types.is_vector(node.type)) return false;
    return leaves_[numbers_.of(node.operands[0])] == lanes_of(part);
}

/// The uniform value with definitions in place of locals of the body, so that the host can evaluate it.
ExprId Uniforms::closed(ExprId id) {
    if (const ExprId* found = closed_.find(id)) return *found;
    const Expr& node = cx.p.exprs[id];
    ExprId result = id;
    const ExprId* definition = node.op == Op::local ? cx.definitions.find(node.local) : nullptr;
    if (definition) {
        result = closed(*definition);
    } else if (!node.operands.empty()) {
        Operands operands;
        bool same = true;
        for (ExprId operand : node.operands) {
            operands.push_back(closed(operand));
            same = same && operands.back() == operand;
        }
        if (!same) result = cx.build.again(node, std::move(operands));
    }
    closed_.emplace(id, result);
    return result;
}

bool Uniforms::is_lifted(ExprId id) {
    if (!is_uniform(cx, id) || cx.build.is_constant(id)) return false;
    const TypeId type = cx.build.type(id);
    const TypeKind kind = cx.p.types.kind(type);
    return kind != TypeKind::optional && kind != TypeKind::void_ && !holds_empty(cx.p, type);
}

void Uniforms::find(ExprId id) {
    if (is_lifted(id)) {
        lifted_values_.back().push_back(id);
        return;
    }
    for (ExprId operand : cx.p.exprs[id].operands) find(operand);
}

/// Notes the leaves that become parameters because of an expression.
void Uniforms::note_leaves(ExprId id) {
    const bool is_whole = is_lifted(id);
    if (is_whole) id = closed(id);
    if (is_whole && is_part_of_leaf(id)) leaves_[numbers_.of(base(id))] |= lanes_of(id);
    else if (!is_whole || lifted_ == Lifted::state)
        for (ExprId operand : cx.p.exprs[id].operands) note_leaves(operand);
}

void Uniforms::collect(const std::vector<StmtId>& body) {
    lifted_values_.emplace_back();
    for_each_statement(cx.p, body, [&](const Stmt& stmt) {
        // A `let` of a uniform value is dropped; its uses need the value, if there are any.
        if (stmt.op == StmtOp::let && stmt.value && !cx.p.locals[stmt.local].is_mutable && is_lifted(stmt.value)) {
            ExprId whole = closed(stmt.value);
            cx.names.emplace(whole, cx.p.locals[stmt.local].name);
            return;
        }
        for_each_root(stmt, [&](ExprId root) { find(root); });
    });
    for (ExprId value : lifted_values_.back()) note_leaves(value);
}

/// Whether the value is computed from constants and from leaves that are parameters anyway (or parts of these), by at
/// most shader_operations sums, differences and products of scalars. `operations` counts them.
bool Uniforms::is_cheap(ExprId id, unsigned& operations) {
    if (cx.build.is_constant(id)) return true;
    if (is_part_of_leaf(id)) return leaves_.contains(numbers_.of(base(id)));
    const Expr& node = cx.p.exprs[id];
    if (cx.p.types.is_vector(node.type)) return false;
    bool is_sum = node.op == Op::binary && (node.binary == BinaryOp::add || node.binary == BinaryOp::subtract ||
                                            node.binary == BinaryOp::multiply);
    if (!is_sum || ++operations > shader_operations) return false;
    return is_cheap(node.operands[0], operations) && is_cheap(node.operands[1], operations);
}

bool Uniforms::has_one_constant(ExprId id) const {
    const Expr& node = cx.p.exprs[id];
    return node.op == Op::binary && cx.build.is_constant(node.operands[0]) != cx.build.is_constant(node.operands[1]);
}

std::string Uniforms::name_of(ExprId id) {
    if (const Name* found = cx.names.find(id)) return (*cx.p.names)[*found];
    const Expr& node = cx.p.exprs[id];
    const auto text = [&](Name name) { return (*cx.p.names)[name]; };
    switch (node.op) {
    case Op::member:
        return cx.name_of(node.place) + "_" +
               text(cx.p.locals[cx.structure_at(node.place).constructor[node.slot]].name);
    case Op::memory_extent:
        return cx.name_of(node.place) + "_" + text(cx.structure_at(node.place).memories[node.slot].name) + "_extent";
    case Op::host_state: return cx.name_of(node.place) + "_" + text(cx.structure_at(node.place).host[node.slot].name);
    case Op::domain: return cx.name_of(node.place) + "_domain";
    case Op::local: return text(cx.p.locals[node.local].name);
    case Op::field:
        return name_of(node.operands[0]) + "_" +
               text(cx.p.structs[cx.p.types[cx.build.type(node.operands[0])].struct_].fields[node.slot].name);
    case Op::swizzle: {
        std::string name = name_of(node.operands[0]) + "_";
        for (std::uint32_t i = 0; i < cx.p.types.components(node.type); ++i) name += "xyzw"[node.lanes[i]];
        return name;
    }
    case Op::call: return text(cx.p.functions[node.function].name);
    default: break;  // named after its operands
    }
    // An operation with one constant: s_extent / 8 is named s_extent_over_8, and so is (s_extent + 8 - 1) / 8.
    if (has_one_constant(id)) {
        bool is_first = cx.build.is_constant(node.operands[0]);
        ExprId number = node.operands[is_first ? 0 : 1], value = node.operands[is_first ? 1 : 0];
        while (!cx.names.find(value) && has_one_constant(value)) {
            const Expr& inner = cx.p.exprs[value];
            value = inner.operands[cx.build.is_constant(inner.operands[0]) ? 1 : 0];
        }
        std::string word = word_for(node.binary);
        if (auto count = cx.build.bits_of(number); count && !cx.p.types.is_floating(cx.build.type(number)))
            word += "_" + std::to_string(*count);
        return name_of(value) + "_" + word;
    }
    std::string name;
    for (ExprId operand : node.operands)
        if (!cx.build.is_constant(operand)) {
            std::string part = name_of(operand);
            // f_extent_x times f_extent_y is f_extent_xy.
            std::size_t stem = part.find_last_of('_');
            bool joins = !name.empty() && stem != std::string::npos &&
                         name.compare(0, stem + 1, part, 0, stem + 1) == 0 &&
                         name.find('_', stem + 1) == std::string::npos && part.size() <= stem + 5;
            if (name.empty()) name = part;
            else if (joins) name += part.substr(stem + 1);
        }
    return name.empty() ? "uniform_value" : name;
}

std::string Uniforms::unique(std::string name) const {
    auto taken = [&](const std::string& candidate) {
        for (const PassParameter& other : cx.pass.parameters)
            if (other.name == candidate) return true;
        return false;
    };
    std::string candidate = name;
    for (unsigned i = 2; taken(candidate); ++i) candidate = name + "_" + std::to_string(i);
    return candidate;
}

ExprId Uniforms::parameter(ExprId value) {
    ValueNumber number = numbers_.of(value);
    auto [found, is_new] = slots_.try_emplace(number, static_cast<std::uint32_t>(cx.pass.parameters.size()));
    if (is_new) {
        PassParameter made;
        made.name = unique(name_of(value));
        made.type = cx.build.type(value);
        made.source = ParameterSource::uniform;
        made.value = value;
        cx.pass.parameters.push_back(std::move(made));
    }
    return cx.parameter_expr(found->second);
}

/// Whether the shader computes the uniform value from parameters.
bool Uniforms::is_kept(ExprId whole) {
    if (cx.build.is_constant(whole) || is_part_of_leaf(whole)) return false;
    unsigned operations = 0;
    return lifted_ == Lifted::state || is_cheap(whole, operations);
}

void Uniforms::count(ExprId id) {
    if (is_lifted(id)) {
        ExprId whole = closed(id);
        if (!is_kept(whole)) return;
        if (++counts_[numbers_.of(whole)] > 1) return;
        for (ExprId operand : cx.p.exprs[whole].operands) count(operand);
        return;
    }
    for (ExprId operand : cx.p.exprs[id].operands) count(operand);
}

ExprId Uniforms::visit_operands(ExprId id) {
    const Expr& node = cx.p.exprs[id];
    Operands operands;
    for (ExprId operand : node.operands) operands.push_back(visit(operand));
    return operands == node.operands ? id : cx.build.again(node, std::move(operands));
}

ExprId Uniforms::visit(ExprId id) {
    if (const ExprId* found = visited_.find(id)) return *found;
    ExprId result;
    if (!is_lifted(id)) {
        result = visit_operands(id);
    } else if (ExprId whole = closed(id); cx.build.is_constant(whole)) {
        result = whole;
    } else if (is_kept(whole)) {
        ValueNumber number = numbers_.of(whole);
        auto [found, is_new] = locals_.try_emplace(number, LocalId{});
        if (counts_[number] < 2) {
            result = visit_operands(whole);
        } else if (is_new) {
            ExprId value = visit_operands(whole);
            Stmt stmt = statement(StmtOp::let, cx.kernel.span);
            stmt.local = cx.new_local(name_of(whole), cx.build.type(whole), cx.kernel.span);
            stmt.value = value;
            locals_[number] = stmt.local;
            result = cx.build.local(stmt.local);
            top_.push_back(cx.add(std::move(stmt)));
        } else {
            result = cx.build.local(found->second);
        }
    } else if (is_part_of_leaf(whole) && !is_leaf(whole) && !is_single(whole)) {
        result = visit_operands(whole);
    } else {
        result = parameter(whole);
    }
    visited_.emplace(id, result);
    return result;
}

std::vector<StmtId> Uniforms::rewrite(const std::vector<StmtId>& body) {
    std::vector<StmtId> result;
    for (StmtId id : body) {
        const Stmt& stmt = cx.p.stmts[id];
        if (stmt.op == StmtOp::let && stmt.value && !cx.p.locals[stmt.local].is_mutable && is_lifted(stmt.value))
            continue;
        Builder::Parts parts = visited_parts(stmt, [&](ExprId part) { return visit(part); });
        parts.body = rewrite(stmt.body);
        parts.otherwise = rewrite(stmt.otherwise);
        result.push_back(cx.build.again(id, std::move(parts)));
    }
    return result;
}

std::vector<StmtId> Uniforms::moved(const std::vector<StmtId>& body, std::size_t place) {
    visited_.clear();
    counts_.clear();
    locals_.clear();
    top_.clear();
    for (ExprId value : lifted_values_[place]) count(value);
    std::vector<StmtId> result = rewrite(body);
    top_.insert(top_.end(), result.begin(), result.end());
    return std::move(top_);
}

void rewrite(Context& cx, const std::vector<std::vector<StmtId>*>& bodies, Lifted lifted) {
    // Earlier passes have simplified values of `let`s, so that more may be uniform now.
    cx.uniform_sizes.clear();
    Uniforms uniforms(cx, lifted);
    for (const auto* body : bodies) uniforms.collect(*body);
    for (std::size_t i = 0; i < bodies.size(); ++i) *bodies[i] = uniforms.moved(*bodies[i], i);
}

}  // namespace

void move_uniforms(Context& cx, const std::vector<std::vector<StmtId>*>& bodies) {
    rewrite(cx, bodies, Lifted::values);
}

void name_state(Context& cx, const std::vector<std::vector<StmtId>*>& bodies) { rewrite(cx, bodies, Lifted::state); }

}  // namespace gliftc::lower
