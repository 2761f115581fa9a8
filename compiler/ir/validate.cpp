#include "ir/validate.h"

#include "ir/evaluate.h"
#include "ir/levels.h"
#include "ir/print.h"
#include "ir/walk.h"

#include <unordered_set>

namespace gliftc::ir {

namespace {

enum class Uniforms { allowed, moved };

class Validator {
public:
    Validator(const Program& program, const Pass& pass, Uniforms uniforms)
        : p(program), pass_(pass), uniforms_(uniforms) {
        for (LocalId local : pass.shared) known_.insert(local);
        if (pass.address) known_.insert(pass.address);
        if (pass.in_range) known_.insert(pass.in_range);
        for (LocalId local : pass.params) known_.insert(local);
        if (!pass.kernel) return;
        if (program.kernels[pass.kernel].raster)
            for (LocalId local : given_locals(*program.kernels[pass.kernel].raster)) known_.insert(local);
        for (const KernelParam& param : program.kernels[pass.kernel].params)
            if (uniforms == Uniforms::allowed && param.pattern == Pattern::value) known_.insert(param.local);
    }

    void declare(LocalId local) { known_.insert(local); }
    void body(const std::vector<StmtId>& body);
    void variant(const Variant& variant) {
        body(statements_of(variant));
        if (variant.devices != Devices::host) no_cpu_level(variant.body);
    }
    std::vector<std::string> problems;

private:
    void fail(const std::string& what, ExprId id = {}) {
        problems.push_back(what + (id ? ": " + print(p, id, &pass_) : ""));
    }
    void no_cpu_level(const std::vector<StmtId>& body);
    bool has_path(const Stmt& store) const;
    void stmt(const Stmt& stmt);
    void expr(ExprId id);
    void expect_type(ExprId id, TypeId type, const char* where) {
        if (p.exprs[id].type != type)
            fail(std::string(where) + " is " + to_text(p, p.exprs[id].type) + ", not " + to_text(p, type), id);
    }
    void low_level(ExprId id);
    void operand_types(ExprId id);

    const Program& p;
    const Pass& pass_;
    Uniforms uniforms_;
    std::unordered_set<LocalId> known_;
    std::unordered_set<ExprId> seen_;
};

void Validator::low_level(ExprId id) {
    const Expr& node = p.exprs[id];
    switch (node.op) {
    case Op::guarded_load:
        if (uniforms_ == Uniforms::moved) return fail("a load that is not guarded yet", id);
        if (node.slot >= pass_.bindings.size()) return fail("no such binding");
        return expect_type(id, pass_.bindings[node.slot].element, "a load");
    case Op::parameter:
        if (node.slot >= pass_.parameters.size()) return fail("no such parameter");
        return expect_type(id, pass_.parameters[node.slot].type, "a parameter");
    case Op::load:
    case Op::row_load:
    case Op::image_load:
    case Op::image_sample:
    case Op::image_gather:
    case Op::image_compare: {
        if (node.slot >= pass_.bindings.size()) return fail("no such binding");
        const PassBinding& binding = pass_.bindings[node.slot];
        if ((binding.shape == MemoryShape::buffer) != (node.op == Op::load || node.op == Op::row_load))
            fail("load from another kind of memory", id);
        if (node.op == Op::image_gather) {
            const bool is_four = p.types.components(node.type) == 4 && p.types.scalar_of(node.type) == binding.element;
            return is_four ? void() : fail("four texels of another type", id);
        }
        if ((node.op == Op::image_compare) != binding.compare.has_value()) fail("a sampler that compares, or not", id);
        if (!is_row(p.types, binding, node.type)) expect_type(id, binding.element, "a load");
        return;
    }
#define SHAPE_OPERATION(name) case Op::name:
#include "ir/operations.def"
        if (uniforms_ == Uniforms::moved) fail("a uniform value is not a parameter", id);
        return;
#define STRUCTURE_OPERATION(name) case Op::name:
#define HOST_OPERATION(name) case Op::name:
#include "ir/operations.def"
        return fail("high-level operation in a lowered kernel", id);
    case Op::builtin:
    case Op::row_item: return;
#define VALUE_OPERATION(name) case Op::name:
#include "ir/operations.def"
        return;
    }
}

void Validator::operand_types(ExprId id) {
    const Expr& node = p.exprs[id];
    auto type = [&](std::size_t i) { return p.exprs[node.operands[i]].type; };
    switch (node.op) {
    case Op::binary: {
        if (p.types.is_matrix(type(0)) || p.types.is_matrix(type(1))) return;
        bool is_shift = node.binary == BinaryOp::shift_left || node.binary == BinaryOp::shift_right;
        if (!is_shift && p.types.scalar_of(type(0)) != p.types.scalar_of(type(1))) fail("operands of two types", id);
        return;
    }
    case Op::select:
        if (p.types.scalar_of(type(0)) != p.types.bool_) fail("the condition is not a bool", id);
        if (type(1) != type(2) || type(1) != node.type) fail("a select of two types", id);
        return;
    case Op::guarded_load:
        expect_type(node.operands[0], p.types.bool_, "a condition");
        if (type(1) != type(2)) fail("two types of addresses", id);
        return expect_type(node.operands[3], node.type, "what is given outside");
    case Op::swizzle:
        for (std::uint32_t i = 0; i < p.types.components(node.type); ++i)
            if (node.lanes[i] >= p.types.components(type(0))) fail("no such component", id);
        return;
    case Op::call: {
        const auto& params = p.functions[node.function].params;
        if (params.size() != node.operands.size()) return fail("a call with other arguments", id);
        for (std::size_t i = 0; i < params.size(); ++i)
            expect_type(node.operands[i], p.locals[params[i]].type, "an argument");
        if (!node.places.empty()) fail("a structure is passed in a lowered kernel", id);
        return;
    }
    default: return;  // the compiler of the generated code checks the other operations
    }
}

void Validator::expr(ExprId id) {
    const Expr& node = p.exprs[id];
    if (node.op == Op::local && !known_.contains(node.local)) fail("a local before its let", id);
    if (!seen_.insert(id).second) return;
    if (!node.type || node.type == p.types.error) fail("an expression without a type", id);
    for (ExprId operand : node.operands) {
        if (!operand) return fail("an absent operand");
        expr(operand);
    }
    operand_types(id);
    low_level(id);
}

bool Validator::has_path(const Stmt& store) const {
    TypeId type = pass_.bindings[store.slot].element;
    for (std::uint32_t slot : store.path) {
        if (p.types.kind(type) != TypeKind::struct_) return false;
        const std::vector<StructField>& fields = p.structs[p.types[type].struct_].fields;
        if (slot >= fields.size()) return false;
        type = fields[slot].type;
    }
    return true;
}

void Validator::stmt(const Stmt& stmt) {
    if (stmt.value) expr(stmt.value);
    if (stmt.target) expr(stmt.target);
    if (stmt.limit) expr(stmt.limit);
    switch (stmt.op) {
    case StmtOp::let:
        if (stmt.value) expect_type(stmt.value, p.locals[stmt.local].type, "a let");
        known_.insert(stmt.local);
        return;
    case StmtOp::assign: return expect_type(stmt.value, p.exprs[stmt.target].type, "an assignment");
    case StmtOp::if_:
    case StmtOp::while_: expect_type(stmt.value, p.types.bool_, "a condition"); break;
    case StmtOp::for_: known_.insert(stmt.local); break;
    case StmtOp::keep: known_.insert(stmt.local); return;
    case StmtOp::load_rows:
        if (stmt.slot >= pass_.bindings.size()) return fail("no such binding");
        if (p.exprs[stmt.target].op != Op::local) fail("rows are loaded into what is no local array", stmt.target);
        return;
    case StmtOp::copy_row:
        if (stmt.slot >= pass_.bindings.size()) return fail("no such binding");
        return expect_type(stmt.target, pass_.bindings[stmt.slot].element, "a copied row");
    case StmtOp::store_rows:
        if (stmt.slot >= pass_.bindings.size()) return fail("no such binding");
        if (pass_.bindings[stmt.slot].access == Access::read) fail("a store to memory that is only read");
        return;
    case StmtOp::store:
    case StmtOp::row_store:
    case StmtOp::image_store:
    case StmtOp::atomic:
    case StmtOp::row_update:
    case StmtOp::column_update:
        if (stmt.slot >= pass_.bindings.size()) return fail("no such binding");
        if (pass_.bindings[stmt.slot].access == Access::read) fail("a store to memory that is only read");
        if (!has_path(stmt)) return fail("a store to a member that the element does not have");
        if (!is_row(p.types, pass_.bindings[stmt.slot], p.exprs[stmt.value].type))
            expect_type(stmt.value, for_each_step(p, pass_, stmt, [](std::uint32_t, StructId) {}), "a store");
        return;
    case StmtOp::report:
        if (stmt.slot >= pass_.bindings.size() && stmt.slot != no_binding) return fail("no such binding");
        return;
#define STRUCTURE_STATEMENT(name) case StmtOp::name:
#define HOST_STATEMENT(name) case StmtOp::name:
#include "ir/statements.def"
        return fail("high-level statement in a lowered kernel");
    default: break;
    }
    body(stmt.body);
    body(stmt.otherwise);
}

void Validator::no_cpu_level(const std::vector<StmtId>& body) {
    for_each_statement(p, body, [&](const Stmt& stmt) {
        if (level_of(stmt.op) == Level::cpu) fail("a statement of the host device in a body of shaders");
    });
    for_each_expression(p, body, [&](ExprId id) {
        if (level_of(p.exprs[id].op) == Level::cpu) fail("an operation of the host device in a body of shaders", id);
    });
}

/// Locals that a body declares are out of scope after it.
void Validator::body(const std::vector<StmtId>& body) {
    auto outer = known_;
    for (StmtId id : body) stmt(p.stmts[id]);
    // Nodes that were checked inside may use locals that are out of scope now: they must be checked again.
    if (outer.size() != known_.size()) seen_.clear();
    known_ = std::move(outer);
}

}  // namespace

std::vector<std::string> validate(const Program& program, const Pass& pass, const std::vector<StmtId>& body,
                                  const std::vector<LocalId>& declared) {
    Validator validator(program, pass, Uniforms::allowed);
    for (LocalId local : declared) validator.declare(local);
    validator.body(body);
    return std::move(validator.problems);
}

std::vector<std::string> validate(const Program& program, const Pass& pass) {
    Validator validator(program, pass, Uniforms::moved);
    validator.body(pass.prologue);
    for (const Variant& variant : pass.variants) validator.variant(variant);
    for (FunctionId id : pass.functions) {
        for (LocalId param : program.functions[id].params) validator.declare(param);
        validator.body(program.functions[id].body);
    }
    return std::move(validator.problems);
}

}  // namespace gliftc::ir
