#include "lower/branch.h"

namespace gliftc::lower {

using namespace ir;

namespace {

Program extending(const Program& trunk, Names& names) {
    Program program;
    program.names = &names;
    program.types = trunk.types;
    program.exprs = Arena<Expr>::extending(trunk.exprs);
    program.stmts = Arena<Stmt>::extending(trunk.stmts);
    program.locals = Arena<Local>::extending(trunk.locals);
    program.functions = Arena<Function>::extending(trunk.functions);
    program.modules = trunk.modules;
    program.structs = trunk.structs;
    program.enums = trunk.enums;
    program.constants = trunk.constants;
    program.translators = trunk.translators;
    program.structures = trunk.structures;
    program.kernels = trunk.kernels;
    return program;
}

/// Replaces the branch's ids of nodes, types and names by those of the trunk.
class Settling {
public:
    Settling(Program& trunk, const Growth& growth)
        : trunk_(trunk), branch_(*growth.branch), begin_(growth.begin), end_(growth.end), to_(growth.to) {}

    void run(Lowered::Forms& forms) {
        settle_nodes(trunk_.exprs, begin_.exprs, end_.exprs, to_.exprs);
        settle_nodes(trunk_.stmts, begin_.stmts, end_.stmts, to_.stmts);
        settle_nodes(trunk_.locals, begin_.locals, end_.locals, to_.locals);
        settle_nodes(trunk_.functions, begin_.functions, end_.functions, to_.functions);
        for (Pass* pass : {&forms.direct, &forms.general, &forms.wide}) settle(*pass);
    }

private:
    template <class T> void settle_nodes(Arena<T>& nodes, std::uint32_t begin, std::uint32_t end, std::uint32_t to) {
        for (std::uint32_t i = to; i < to + (end - begin); ++i) settle(nodes[{i}]);
    }

    void settle(Expr& expr) {
        settle(expr.type);
        settle(expr.local);
        settle(expr.function);
        for (ExprId& operand : expr.operands) settle(operand);
    }
    void settle(Stmt& stmt) {
        settle(stmt.local);
        for (ExprId* root : {&stmt.target, &stmt.value, &stmt.limit}) settle(*root);
        for (ExprId& argument : stmt.arguments) settle(argument);
        settle_all(stmt.body);
        settle_all(stmt.otherwise);
        settle_all(stmt.locals);
    }
    void settle(Local& local) {
        settle(local.name);
        settle(local.type);
    }
    void settle(Function& function) {
        settle(function.name);
        settle(function.result);
        settle_all(function.params);
        settle_all(function.shared);
        settle_all(function.body);
    }
    void settle(Pass& pass) {
        for (PassBinding& binding : pass.bindings) settle(binding.element);
        for (PassParameter& parameter : pass.parameters) {
            settle(parameter.type);
            settle(parameter.value);
        }
        settle(pass.address);
        settle(pass.in_range);
        for (auto* body : bodies_of(pass)) settle_all(*body);
        for (Variant& variant : pass.variants)
            for (Bounds& bounds : variant.assumes.bounds)
                for (ExprId* part : {&bounds.value, &bounds.low, &bounds.high}) settle(*part);
        settle_all(pass.functions);
        settle_all(pass.shared);
        settle_all(pass.params);
    }
    template <class Ids> void settle_all(Ids& ids) {
        for (auto& id : ids) settle(id);
    }

    void settle(ExprId& id) const { settle(id, begin_.exprs, to_.exprs); }
    void settle(StmtId& id) const { settle(id, begin_.stmts, to_.stmts); }
    void settle(LocalId& id) const { settle(id, begin_.locals, to_.locals); }
    void settle(FunctionId& id) const { settle(id, begin_.functions, to_.functions); }
    template <class T> static void settle(Id<T>& id, std::uint32_t begin, std::uint32_t to) {
        if (id && id.index >= begin) id.index += to - begin;
    }
    void settle(TypeId& id) const {
        if (id && id.index >= branch_.first_type) id = branch_.trunk_types[id.index - branch_.first_type];
    }
    void settle(Name& name) const {
        if (name.index >= branch_.first_name) name = branch_.trunk_names[name.index - branch_.first_name];
    }

    Program& trunk_;
    const Branch& branch_;
    const Mark begin_, end_, to_;
};

/// Moves nodes one by one: for kinds of nodes of which there are few.
template <class T> void move(Arena<T>& from, Arena<T>& to, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) to.add(std::move(from[{i}]));
}

}  // namespace

Branch::Branch(const Program& trunk)
    : names(Names::extending(*trunk.names)), program(extending(trunk, names)), first_name(names.size()),
      first_type(program.types.size()) {}

void ready_for_branches(Program& trunk) {
    trunk.exprs.fill_block();
    trunk.stmts.fill_block();
}

void graft(Program& trunk, Growth& growth) {
    Branch& branch = *growth.branch;
    const auto first = [](std::uint32_t before, const auto& known) {
        return before + static_cast<std::uint32_t>(known.size());
    };
    for (std::uint32_t i = first(branch.first_name, branch.trunk_names); i < growth.names; ++i)
        branch.trunk_names.push_back(trunk.names->intern(branch.names[{i}]));
    for (std::uint32_t i = first(branch.first_type, branch.trunk_types); i < growth.types; ++i)
        branch.trunk_types.push_back(trunk.types.same_as(branch.program.types, {i}));
    growth.to = Mark(trunk);
    trunk.exprs.adopt(branch.program.exprs, growth.begin.exprs, growth.end.exprs);
    trunk.stmts.adopt(branch.program.stmts, growth.begin.stmts, growth.end.stmts);
    move(branch.program.locals, trunk.locals, growth.begin.locals, growth.end.locals);
    move(branch.program.functions, trunk.functions, growth.begin.functions, growth.end.functions);
}

void settle(Program& trunk, const Growth& growth, Lowered::Forms& forms) { Settling(trunk, growth).run(forms); }

}  // namespace gliftc::lower
