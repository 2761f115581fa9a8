// Each function is the body of a kernel made for it: the kernel is lowered like any other and printed as a function.
#include "emit/glsl/library.h"

#include "emit/glsl/printer.h"
#include "ir/walk.h"
#include "lower/lower.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace gliftc::glsl {

using namespace ir;

namespace {

/// A function to be: its kernel's body ends in `evaluate result`, or gives nothing.
struct Wanted {
    std::string name;
    TypeId result;
    std::vector<LocalId> params;
};

/// The kernels of a program that has no others.
struct Kernels {
    Program& program;
    std::uint32_t structure;
    std::string name;
    LocalId address, value;
    std::vector<Wanted> wanted;

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
        made.structure = structure;
        return made;
    }

    void add(Wanted function, KernelParam param_of_structure, Stmt body) {
        Kernel kernel;
        kernel.name = program.names->intern(function.name);
        kernel.display = function.name;
        kernel.params = {std::move(param_of_structure), param("at", Pattern::at, Direction::in)};
        kernel.domain_type = program.structures[structure].domain_type;
        kernel.body = {program.stmts.add(std::move(body))};
        program.kernels.push_back(std::move(kernel));
        wanted.push_back(std::move(function));
    }

    void add_value(const std::string& function, ExprId result) {
        Stmt stmt;
        stmt.op = StmtOp::evaluate;
        stmt.value = result;
        add({name + "_" + function, program.exprs[result].type, {address}}, param(name, Pattern::any, Direction::in), std::move(stmt));
    }
};

bool is_partial(const Program& program, const Structure& s) {
    return std::any_of(s.via.begin(), s.via.end(), [&](const Stage& stage) { return program.translators[stage.translator].properties.partial; });
}

void add_translate(Kernels& k) {
    const Structure& s = k.program.structures[k.structure];
    if (s.via.empty()) return;
    TypeId physical = k.program.translators[s.via.back().translator].physical_type;
    ExprId translated = k.make(Op::translate, k.program.types.optional(physical), k.use(k.address));
    if (is_partial(k.program, s)) k.add_value("is_mapped", k.make(Op::has_value, k.program.types.bool_, translated));
    k.add_value("translate", k.make(Op::value, physical, translated));
}

void add_write(Kernels& k) {
    Stmt stmt;
    stmt.op = StmtOp::write;
    stmt.target = k.use(k.address);
    stmt.value = k.use(k.value);
    k.add({k.name + "_write", k.program.types.void_, {k.address, k.value}}, k.param(k.name, Pattern::scatter, Direction::out), std::move(stmt));
}

Kernels kernels_for(Program& program, std::uint32_t structure) {
    const Structure& s = program.structures[structure];
    Kernels k{program, structure, identifier((*program.names)[s.alias ? s.alias : s.name]), {}, {}, {}};
    program.kernels.clear();
    program.pipelines.clear();
    program.tests.clear();
    program.transfers.clear();
    k.address = k.local("address", s.domain_type);
    k.value = k.local("value", s.element);
    add_translate(k);
    k.add_value("read", k.make(Op::read, s.element, k.use(k.address)));
    if (s.kind == StructureKind::stored) add_write(k);
    return k;
}

/// The parameters that the function's body uses; the others belong to the dispatch that it does not have.
std::vector<bool> used_parameters(const Program& program, const Pass& pass) {
    std::vector<bool> used(pass.parameters.size());
    auto visit = [&](ExprId id) {
        if (program.exprs[id].op == Op::parameter) used.at(program.exprs[id].slot) = true;
    };
    for_each_expression(program, pass.body, visit);
    for (FunctionId id : pass.functions) for_each_expression(program, program.functions[id].body, visit);
    return used;
}

/// What all functions share: the union of their memories and state, by name.
struct Interface {
    Pass all;
    Scopes names;

    std::string binding(const PassBinding& wanted) {
        for (PassBinding& have : all.bindings)
            if (have.place == wanted.place && have.memory == wanted.memory) {
                if (have.access != wanted.access) have.access = Access::read_write;
                return have.name;
            }
        all.bindings.push_back(wanted);
        all.bindings.back().sampled = false;
        return all.bindings.back().name = names.declare(wanted.name);
    }

    std::string parameter(const PassParameter& wanted) {
        for (const PassParameter& have : all.parameters)
            if (have.name == wanted.name) return have.name;
        all.parameters.push_back(wanted);
        names.declare(wanted.name);
        return wanted.name;
    }
};

std::string upper_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) text.replace(at, what.size(), by);
}

/// What the printers of the functions found out they need.
void carry_over(const Printer& from, Printer& to) {
    to.names = from.names;
    to.struct_names = from.struct_names;
    to.field_names = from.field_names;
    to.function_names = from.function_names;
    to.extensions = from.extensions;
    to.struct_types = from.struct_types;
    to.helpers = from.helpers;
    to.enumerators = from.enumerators;
}

std::string print_function(Printer& p, const Wanted& wanted) {
    p.names.enter();
    std::string parameters;
    for (LocalId id : wanted.params) {
        const Local& local = p.program.locals[id];
        p.local_names[id] = p.names.declare((*p.program.names)[local.name]);
        parameters += (parameters.empty() ? "" : ", ") + declaration(p, local.type, p.local_names[id]);
    }
    line(p, type_text(p, wanted.result) + " " + wanted.name + "(" + parameters + ") {");
    p.indent = 1;
    for (StmtId id : p.pass.body) {
        const Stmt& stmt = p.program.stmts[id];
        if (stmt.op == StmtOp::evaluate) line(p, "return " + print_any(p, stmt.value) + ";");
        else print_statement(p, id);
    }
    p.indent = 0;
    line(p, "}");
    p.names.leave();
    return std::exchange(p.out, {});
}

/// Bindings as macros, so that the including shader chooses.
std::string memories_text(Printer& p, const std::string& macro) {
    std::string text = bindings_text(p);
    replace_all(text, "set = 0, binding = ", "set = " + macro + "_SET, binding = " + macro + "_BINDING + ");
    return text;
}

std::string state_text(Printer& p, const std::string& name, const std::string& macro) {
    if (p.pass.parameters.empty()) return "";
    std::string text = parameters_text(p);
    replace_all(text, "set = 0, binding = 0", "set = " + macro + "_SET, binding = " + macro + "_BINDING");
    replace_all(text, "buffer Parameters", "buffer " + name + "_state");
    return "#ifndef " + macro + "_STATE  // define it where the members below are declared in a block of your own\n" + text + "#endif\n\n";
}

std::string heading(const Program& program, const Sources& sources, std::uint32_t structure, const std::string& macro) {
    const Structure& s = program.structures[structure];
    std::string text = "// " + s.display;
    if (s.span) text += ", " + file_name(sources[s.span.file].path) + ":" + std::to_string(sources.position(s.span).line);
    return text + ".\n// Define before including: " + macro + "_SET, " + macro + "_BINDING (the state; memory k follows at + 1 + k), " + macro +
           "_STATE, " + macro + "_READONLY.\n";
}

std::string macros_text(const std::string& macro) {
    std::string text;
    for (const char* suffix : {"_SET", "_BINDING"}) text += "#ifndef " + macro + suffix + "\n#define " + macro + suffix + " 0\n#endif\n";
    return text + "#ifdef " + macro + "_READONLY\n#define " + macro + "_ACCESS readonly\n#else\n#define " + macro + "_ACCESS\n#endif\n\n";
}

}  // namespace

std::vector<std::uint32_t> library_structures(const Program& program, std::uint32_t module) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < program.structures.size(); ++i) {
        const Structure& s = program.structures[i];
        if (s.is_pub && s.pub_module == module && s.kind != StructureKind::adaptor) found.push_back(i);
    }
    return found;
}

std::string library_of(const Program& original, const Sources& sources, std::uint32_t structure, Diagnostics& diagnostics) {
    Program program = original;
    Kernels kernels = kernels_for(program, structure);
    Lowered lowered = lower::lower(program, diagnostics);
    const std::string macro = upper_case(kernels.name);

    Interface interface;
    interface.all.push_constants = false;
    for (const Wanted& function : kernels.wanted) interface.names.declare(function.name);
    std::vector<std::vector<std::string>> bindings, parameters;
    for (const Lowered::Forms& forms : lowered.passes) {
        std::vector<bool> used = used_parameters(program, forms.direct);
        bindings.emplace_back();
        parameters.emplace_back();
        for (const PassBinding& binding : forms.direct.bindings) bindings.back().push_back(interface.binding(binding));
        for (std::size_t i = 0; i < used.size(); ++i)
            parameters.back().push_back(used[i] ? interface.parameter(forms.direct.parameters[i]) : forms.direct.parameters[i].name);
    }
    for (PassBinding& binding : interface.all.bindings) binding.access = Access::read_write;

    Printer all(program, sources, interface.all, {});
    all.names = interface.names;
    for (const PassBinding& binding : interface.all.bindings) {
        all.binding_names.push_back(binding.name);
        all.block_names.push_back(all.names.declare(binding.name + "_memory"));
    }
    for (const PassParameter& parameter : interface.all.parameters) all.parameter_names.push_back(parameter.name);
    name_structs(all);
    std::string functions;
    for (std::size_t i = 0; i < kernels.wanted.size(); ++i) {
        Pass pass = lowered.passes[i].direct;
        for (PassBinding& binding : pass.bindings) binding.sampled = false;
        Printer p(program, sources, pass, {});
        carry_over(all, p);
        p.binding_names = bindings[i];
        p.parameter_names = parameters[i];
        std::string text = callees_text(p) + print_function(p, kernels.wanted[i]);
        bool writes = program.types.kind(kernels.wanted[i].result) == TypeKind::void_;
        functions += writes ? "#ifndef " + macro + "_READONLY\n" + text + "#endif\n" : text + "\n";
        carry_over(p, all);
    }
    std::string memories = memories_text(all, macro);
    replace_all(memories, ") buffer ", ") " + macro + "_ACCESS buffer ");
    replace_all(memories, ") uniform ", ") uniform " + macro + "_ACCESS ");
    std::string state = state_text(all, kernels.name, macro), helpers = helper_definitions(all), structs = struct_definitions(all);
    return "#ifndef GLIFT_" + macro + "\n#define GLIFT_" + macro + "\n" + heading(program, sources, structure, macro) + extensions_text(all) +
           macros_text(macro) + enumerators_text(all) + structs + state + memories + (memories.empty() ? "" : "\n") + helpers + functions + "#endif\n";
}

}  // namespace gliftc::glsl
