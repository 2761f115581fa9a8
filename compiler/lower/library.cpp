#include "lower/library.h"

#include "ir/chain.h"
#include "ir/walk.h"

#include "lower/lower.h"

#include <algorithm>
#include <array>
#include <string_view>

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
             std::vector<Stmt> body) {
        Kernel kernel;
        kernel.name = program.names->intern(library.name + "_" + function);
        kernel.params = {std::move(of_structure), param("at", Pattern::at, Direction::in)};
        kernel.domain_type = program.structures[library.structure].domain_type;
        for (Stmt& stmt : body) kernel.body.push_back(program.stmts.add(std::move(stmt)));
        library.functions.push_back(
            {function, result, lower_function(program, diagnostics, kernel, std::move(params))});
    }

    void add_value(const std::string& function, ExprId result) {
        Stmt stmt;
        stmt.op = StmtOp::evaluate;
        stmt.value = result;
        add(function, program.exprs[result].type, {address}, param(library.name, Pattern::any, Direction::in),
            {std::move(stmt)});
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
          k.param(k.library.name, Pattern::scatter, Direction::out), {std::move(stmt)});
}

/// `sample` at a point, of elements that can be filtered and lie in a buffer or are computed: an image that is written
/// is a storage image, which has no filter.
void add_sample(Maker& k) {
    const Structure& s = k.program.structures[k.library.structure];
    Types& types = k.program.types;
    const bool is_image = !is_computed(k.program, s) && root_memory(k.program, s).shape != MemoryShape::buffer;
    const bool is_number = types.is_scalar(s.element) || types.is_vector(s.element);
    const std::uint32_t axes = types.components(s.domain_type);
    if (is_image || axes > 3 || !is_number || types.scalar_of(s.element) != types.float_) return;
    const LocalId point = k.local("point", types.with_scalar(s.domain_type, types.float_));
    Stmt stmt;
    stmt.op = StmtOp::evaluate;
    stmt.value = k.make(Op::sample, s.element, k.use(point));
    k.add("sample", s.element, {point}, k.param(k.library.name, Pattern::any, Direction::in), {std::move(stmt)});
}

/// The functions by which elements are reached.
bool is_access(std::string_view name) {
    constexpr std::array<std::string_view, 4> names{"sample", "gather", "compare", "contains"};
    return std::ranges::find(names, name) != names.end();
}

/// The functions that libraries have without a declaration.
bool is_made(std::string_view name) {
    constexpr std::array<std::string_view, 4> names{"read", "write", "translate", "is_mapped"};
    return std::ranges::find(names, name) != names.end();
}

/// Whether reads of elements use all memories that the function uses. Functions that use others, such as those that say
/// which pages were asked for, would make each shader bind these.
bool uses_what_reads_use(const Library& library, const LibraryFunction& function) {
    const auto read = std::ranges::find(library.functions, "read", &LibraryFunction::name);
    return std::ranges::all_of(function.pass.bindings, [&](const PassBinding& wanted) {
        return std::ranges::any_of(read->pass.bindings, [&](const PassBinding& have) {
            return have.place == wanted.place && have.memory == wanted.memory;
        });
    });
}

/// Whether the function filters or compares texels, which only sampled images can.
bool samples_images(const Program& program, const Pass& pass) {
    bool found = false;
    const auto visit = [&](ExprId id) {
        const Op op = program.exprs[id].op;
        found = found || op == Op::image_sample || op == Op::image_gather || op == Op::image_compare;
    };
    for_each_expression(program, pass.plain().body, visit);
    for (FunctionId id : pass.functions) for_each_expression(program, program.functions[id].body, visit);
    return found;
}

/// A function that the structure declares itself.
void add_own(Maker& k, FunctionId id) {
    const Function function = k.program.functions[id];
    Expr call;
    call.op = Op::call;
    call.type = function.result;
    call.function = id;
    call.places = {Place{}};
    std::vector<LocalId> params;
    for (LocalId param : function.params) {
        params.push_back(
            k.local((*k.program.names)[k.program.locals[param].name].c_str(), k.program.locals[param].type));
        call.operands.push_back(k.use(params.back()));
    }
    const LocalId result = k.local("result", function.result);
    Stmt let, evaluate;  // a call that is evaluated as a statement has no result
    let.op = StmtOp::let;
    let.local = result;
    let.value = k.program.exprs.add(std::move(call));
    evaluate.op = StmtOp::evaluate;
    evaluate.value = k.use(result);
    k.add((*k.program.names)[function.name], function.result, std::move(params),
          k.param(k.library.name, Pattern::any, Direction::in), {std::move(let), std::move(evaluate)});
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
    const auto name_of = [&](FunctionId function) -> std::string_view {
        return (*program.names)[program.functions[function].name];
    };
    if (std::ranges::find(s.functions, "sample", name_of) == s.functions.end()) add_sample(k);
    for (FunctionId function : std::vector(s.functions)) {
        if (is_made(name_of(function))) continue;
        add_own(k, function);
        const LibraryFunction& added = library.functions.back();
        const bool is_meant = is_access(name_of(function)) || uses_what_reads_use(library, added);
        // Images that the library writes are storage images.
        if (!is_meant || (is_written && samples_images(program, added.pass))) library.functions.pop_back();
    }
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
