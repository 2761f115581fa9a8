#include "lower/library.h"

#include "ir/chain.h"

#include "lower/lower.h"

#include <algorithm>

namespace gliftc::lower {

using namespace ir;

namespace {

/// Makes the functions of one structure: each is the body of a kernel that is made for the function and lowered by
/// lower_function.
struct Maker {
    Program& program;
    Diagnostics& diagnostics;
    Library& library;
    LocalId address, value;

    ExprId use(LocalId id) {
        Expr expr;
        expr.op = Op::local;
        expr.type = program.locals[id].type;
        expr.local = id;
        return program.exprs.add(std::move(expr));
    }

    ExprId make(Op op, TypeId type, ExprId operand) {
        Expr expr;
        expr.op = op;
        expr.type = type;
        expr.operands = {operand};
        return program.exprs.add(std::move(expr));
    }

    LocalId local(const char* text, TypeId type) {
        Local made;
        made.name = program.names->intern(text);
        made.type = type;
        return program.locals.add(std::move(made));
    }

    KernelParam param(const std::string& text, Pattern pattern, Direction direction) {
        KernelParam made;
        made.name = program.names->intern(text);
        made.pattern = pattern;
        made.direction = direction;
        made.structure = library.structure;
        return made;
    }

    void add(const std::string& function, TypeId result, std::vector<LocalId> params, KernelParam of_structure,
             Stmt body) {
        Kernel kernel;
        kernel.name = program.names->intern(library.name + "_" + function);
        kernel.params = {std::move(of_structure), param("at", Pattern::at, Direction::in)};
        kernel.domain_type = program.structures[library.structure].domain_type;
        kernel.body = {program.stmts.add(std::move(body))};
        library.functions.push_back(
            {function, result, lower_function(program, diagnostics, kernel, std::move(params))});
    }

    void add_value(const std::string& function, ExprId result) {
        Stmt stmt;
        stmt.op = StmtOp::evaluate;
        stmt.value = result;
        add(function, program.exprs[result].type, {address}, param(library.name, Pattern::any, Direction::in),
            std::move(stmt));
    }
};

bool is_partial(const Program& program, const Structure& s) {
    return std::any_of(s.via.begin(), s.via.end(),
                       [&](const Stage& stage) { return program.translators[stage.translator].properties.partial; });
}

void add_translate(Maker& k) {
    const Structure& s = k.program.structures[k.library.structure];
    const TypeId physical = physical_type(k.program, s);
    if (!physical) return;
    ExprId translated = k.make(Op::translate, k.program.types.optional(physical), k.use(k.address));
    if (is_partial(k.program, s) || !is_contained(k.program, s) || !s.base.empty())
        k.add_value("is_mapped", k.make(Op::has_value, k.program.types.bool_, translated));
    k.add_value("translate", k.make(Op::value, physical, translated));
}

void add_write(Maker& k) {
    Stmt stmt;
    stmt.op = StmtOp::write;
    stmt.target = k.use(k.address);
    stmt.value = k.use(k.value);
    k.add("write", k.program.types.void_, {k.address, k.value},
          k.param(k.library.name, Pattern::scatter, Direction::out), std::move(stmt));
}

Library library_of(Program& program, StructureId structure, const Alias& alias, Diagnostics& diagnostics) {
    const Structure& s = program.structures[structure];
    Library library{structure, alias.module, (*program.names)[alias.name], {}};
    Maker k{program, diagnostics, library, {}, {}};
    k.address = k.local("address", s.domain_type);
    k.value = k.local("value", s.element);
    add_translate(k);
    k.add_value("read", k.make(Op::read, s.element, k.use(k.address)));
    const bool is_written = s.kind == StructureKind::stored && root_memory(program, s).format != Format::d32;
    if (is_written) add_write(k);
    // Without a `write` function, images are sampled images: these can be filtered, and devices need not have storage
    // images of depths.
    for (LibraryFunction& function : library.functions)
        for (PassBinding& binding : function.pass.bindings)
            binding.sampled = !is_written && binding.shape != MemoryShape::buffer;
    return library;
}

}  // namespace

std::vector<Library> lower_libraries(Program& program, Diagnostics& diagnostics) {
    std::vector<Library> libraries;
    for (StructureId i : program.structures.ids()) {
        if (program.structures[i].kind == StructureKind::no_elements) continue;
        const std::vector<Alias> aliases = program.structures[i].aliases;
        for (const Alias& alias : aliases)
            if (alias.is_pub && program.modules[alias.module].is_root)
                libraries.push_back(library_of(program, i, alias, diagnostics));
    }
    return libraries;
}

}  // namespace gliftc::lower
