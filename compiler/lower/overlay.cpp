#include "lower/overlay.h"

namespace gliftc::lower {

using namespace ir;

namespace {

Program extending(const Program& base, Names& names) {
    Program program;
    program.names = &names;
    program.types = base.types;
    program.exprs = Arena<Expr>::extending(base.exprs);
    program.stmts = Arena<Stmt>::extending(base.stmts);
    program.locals = Arena<Local>::extending(base.locals);
    program.functions = Arena<Function>::extending(base.functions);
    program.modules = base.modules;
    program.structs = base.structs;
    program.enums = base.enums;
    program.constants = base.constants;
    program.translators = base.translators;
    program.structures = base.structures;
    program.kernels = base.kernels;
    return program;
}

/// Replaces the overlay's ids of nodes, types and names by those of the base.
class Renumbering {
public:
    Renumbering(Program& base, const Growth& growth)
        : base_(base), overlay_(*growth.overlay), begin_(growth.begin), end_(growth.end), to_(growth.to) {}

    void run(Lowered::Forms& forms) {
        renumber_nodes(base_.exprs, begin_.exprs, end_.exprs, to_.exprs);
        renumber_nodes(base_.stmts, begin_.stmts, end_.stmts, to_.stmts);
        renumber_nodes(base_.locals, begin_.locals, end_.locals, to_.locals);
        renumber_nodes(base_.functions, begin_.functions, end_.functions, to_.functions);
        for (Pass* pass : forms.all()) renumber(*pass);
    }

private:
    template <class T> void renumber_nodes(Arena<T>& nodes, std::uint32_t begin, std::uint32_t end, std::uint32_t to) {
        for (std::uint32_t i = to; i < to + (end - begin); ++i) renumber(nodes[{i}]);
    }

    void renumber(Expr& expr) {
        renumber(expr.type);
        renumber(expr.local);
        renumber(expr.function);
        for (ExprId& operand : expr.operands) renumber(operand);
    }
    void renumber(Stmt& stmt) {
        renumber(stmt.local);
        for (ExprId* root : {&stmt.target, &stmt.value, &stmt.limit}) renumber(*root);
        for (ExprId& argument : stmt.arguments) renumber(argument);
        renumber_all(stmt.body);
        renumber_all(stmt.otherwise);
        renumber_all(stmt.locals);
    }
    void renumber(Local& local) {
        renumber(local.name);
        renumber(local.type);
    }
    void renumber(Function& function) {
        renumber(function.name);
        renumber(function.result);
        renumber_all(function.params);
        renumber_all(function.shared);
        renumber_all(function.body);
    }
    void renumber(Pass& pass) {
        for (PassBinding& binding : pass.bindings) renumber(binding.element);
        for (PassParameter& parameter : pass.parameters) {
            renumber(parameter.type);
            renumber(parameter.value);
        }
        renumber(pass.address);
        renumber(pass.in_range);
        for (auto* body : bodies_of(pass)) renumber_all(*body);
        for (Variant& variant : pass.variants)
            for (Bounds& bounds : variant.assumes.bounds)
                for (ExprId* part : {&bounds.value, &bounds.low, &bounds.high}) renumber(*part);
        renumber_all(pass.functions);
        renumber_all(pass.shared);
        renumber_all(pass.params);
    }
    template <class Ids> void renumber_all(Ids& ids) {
        for (auto& id : ids) renumber(id);
    }

    void renumber(ExprId& id) const { renumber(id, begin_.exprs, to_.exprs); }
    void renumber(StmtId& id) const { renumber(id, begin_.stmts, to_.stmts); }
    void renumber(LocalId& id) const { renumber(id, begin_.locals, to_.locals); }
    void renumber(FunctionId& id) const { renumber(id, begin_.functions, to_.functions); }
    template <class T> static void renumber(Id<T>& id, std::uint32_t begin, std::uint32_t to) {
        if (id && id.index >= begin) id.index += to - begin;
    }
    void renumber(TypeId& id) const {
        if (id && id.index >= overlay_.first_type) id = overlay_.base_types[id.index - overlay_.first_type];
    }
    void renumber(Name& name) const {
        if (name.index >= overlay_.first_name) name = overlay_.base_names[name.index - overlay_.first_name];
    }

    Program& base_;
    const Overlay& overlay_;
    const Mark begin_, end_, to_;
};

/// Moves nodes one by one: for kinds of nodes of which there are few.
template <class T> void move(Arena<T>& from, Arena<T>& to, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) to.add(std::move(from[{i}]));
}

}  // namespace

Overlay::Overlay(const Program& base)
    : names(Names::extending(*base.names)), program(extending(base, names)), first_name(names.size()),
      first_type(program.types.size()) {}

void prepare_for_overlays(Program& base) {
    base.exprs.fill_block();
    base.stmts.fill_block();
}

void merge(Program& base, Growth& growth) {
    Overlay& overlay = *growth.overlay;
    const auto first = [](std::uint32_t before, const auto& known) {
        return before + static_cast<std::uint32_t>(known.size());
    };
    for (std::uint32_t i = first(overlay.first_name, overlay.base_names); i < growth.names; ++i)
        overlay.base_names.push_back(base.names->intern(overlay.names[{i}]));
    for (std::uint32_t i = first(overlay.first_type, overlay.base_types); i < growth.types; ++i)
        overlay.base_types.push_back(base.types.same_as(overlay.program.types, {i}));
    growth.to = Mark(base);
    base.exprs.adopt(overlay.program.exprs, growth.begin.exprs, growth.end.exprs);
    base.stmts.adopt(overlay.program.stmts, growth.begin.stmts, growth.end.stmts);
    move(overlay.program.locals, base.locals, growth.begin.locals, growth.end.locals);
    move(overlay.program.functions, base.functions, growth.begin.functions, growth.end.functions);
}

void renumber(Program& base, const Growth& growth, Lowered::Forms& forms) { Renumbering(base, growth).run(forms); }

}  // namespace gliftc::lower
