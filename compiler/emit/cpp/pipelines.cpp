// Pipelines as functions that call kernels and other pipelines.
#include "emit/cpp/mentions.h"
#include "emit/cpp/reloadable.h"
#include "emit/cpp/translators.h"
#include "emit/cpp/unit.h"
#include "ir/chain.h"
#include "ir/changes.h"
#include "ir/levels.h"
#include "ir/spelling.h"
#include "ir/walk.h"

#include <utility>

namespace gliftc::cpp {

namespace {

using ir::Expr;
using ir::ExprId;
using ir::Op;
using ir::Pipeline;
using ir::Stmt;
using ir::StmtOp;
using ir::TypeKind;

/// A structure whose translators are checked as a test leaves it.
struct Checked {
    std::string object;  ///< the C++ expression
    std::string path;    ///< its name in the language
    ir::StructureId index;
    std::string residents;  ///< the C++ expression of the addresses in its blocks; empty: it has none
};

struct PipelinePrinter {
    Unit& unit;
    const Pipeline& pipeline;
    Printer p;
    std::string commands = "commands";  ///< the C++ expression of the glift::Commands that calls get
    bool tracks = false;                ///< in tests: structures live to the end, to be compared

    PipelinePrinter(Unit& unit, const Pipeline& pipeline) : unit(unit), pipeline(pipeline), p(unit.globals) {
        p.names.reserve({"commands", "test"});
        if (pipeline.owner) {
            p.class_names = &unit.globals.class_names[pipeline.owner].all;
            p.names.avoid(unit.globals.class_names[pipeline.owner].own);
        }
        p.outer_expression = [this](const Expr& expr) { return expression(expr); };
        p.outer_statement = [this](const Stmt& stmt) { statement(stmt); };
        for (const ir::PipelineParam& param : pipeline.params) declare_local(p, param.local);
    }
    PipelinePrinter(const PipelinePrinter&) = delete;

    TypeKind kind(ir::TypeId type) const { return unit.program.types.kind(type); }
    bool is_slice(const Expr& expr) const {
        return expr.local && kind(unit.program.locals[expr.local].type) == TypeKind::slice;
    }
    std::string object(const Expr& expr);
    ir::StructureId root_structure(const Expr& expr) const;
    Text property(const Expr& expr);
    std::string base(const Expr& expr);
    Text expression(const Expr& expr);
    Text slice(const Expr& expr);
    Text call(const Expr& expr);
    void statement(const Stmt& stmt);
    void temporary(const Stmt& stmt);
    void arms(const Stmt& stmt);
    void arm(const std::string& condition, const std::vector<ir::StmtId>& body, const char* where);
    void dispatch(const Stmt& stmt);
    void expect(const Stmt& stmt);
    void expect_same(const Stmt& stmt);
    void replace(const Stmt& stmt);
    void keep(const std::string& shown, const std::string& object, ir::StructureId structure);
    void keep_all();
    void check_with_members(const Checked& checked);
    void check_as_made(const Checked& checked);
};

/// The structure at which the expression's place begins, with what stands before a member: `f.`, `part->` for a slice,
/// or empty for the container that owns the pipeline.
std::string PipelinePrinter::object(const Expr& expr) {
    if (!expr.local) return "";
    return p.local_names.at(expr.local) + (is_slice(expr) ? "->" : ".");
}

ir::StructureId PipelinePrinter::root_structure(const Expr& expr) const {
    if (!expr.local) return pipeline.owner;
    const ir::Type& type = unit.program.types[unit.program.locals[expr.local].type];
    return type.kind == TypeKind::slice ? unit.program.types[type.element].structure : type.structure;
}

Text PipelinePrinter::property(const Expr& expr) {
    return structure_property(unit.globals, expr, root_structure(expr), object(expr));
}

/// The structure or slice at the expression's place, as an expression of its own.
std::string PipelinePrinter::base(const Expr& expr) {
    if (is_slice(expr) && expr.place.members.empty()) return p.local_names.at(expr.local);
    Expr whole;
    whole.op = Op::structure_value;
    whole.local = expr.local;
    whole.place = expr.place;
    return wrap(property(whole), Level::postfix);
}

Text PipelinePrinter::slice(const Expr& expr) {
    const std::string first = print_any(p, expr.operands[0]), last = print_any(p, expr.operands[1]);
    if (kind(unit.program.exprs[expr.operands[1]].type) == TypeKind::device)
        return {base(expr) + ".first(" + last + ")"};
    return {"glift::slice(" + base(expr) + ", " + first + ", " + last + ", " +
            quoted(place_text(unit.sources, expr.span)) + ")"};
}

Text PipelinePrinter::call(const Expr& expr) {
    const Pipeline& callee = unit.program.pipelines[expr.pipeline()];
    std::string name = unit.globals.pipeline_names[expr.pipeline()];
    if (callee.owner) {
        const std::string owner = base(expr);
        name = (owner == "*this" || owner == "(*this)" ? "" : owner + ".") + name;
    } else {
        name = visible(p, name);
    }
    const std::string arguments = join_arguments(p, expr.operands);
    return {name + "(" + commands + (arguments.empty() ? "" : ", ") + arguments + ")"};
}

std::string device_property(ir::DeviceProperty property) {
    const std::string all = "commands.device().properties().";
    switch (property) {
    case ir::DeviceProperty::is_host: return "commands.device().is_host()";
    case ir::DeviceProperty::is_gpu: return "(" + all + "kind == glift::DeviceKind::gpu)";
    case ir::DeviceProperty::subgroup_size: return all + "subgroup_size";
    case ir::DeviceProperty::subgroup_arithmetic: return all + "subgroup_arithmetic";
    case ir::DeviceProperty::int64: return all + "int64";
    case ir::DeviceProperty::shared_memory_bytes: return all + "shared_memory_bytes";
    }
    return "{}";
}

Text PipelinePrinter::expression(const Expr& expr) {
    switch (expr.op) {
    case Op::member:
    case Op::memory_extent:
    case Op::host_state: return property(expr);
    case Op::structure_value:
        if (is_slice(expr) && expr.place.members.empty()) return {p.local_names.at(expr.local)};
        return property(expr);
    case Op::domain:
        if (is_slice(expr) && expr.place.members.empty()) return {p.local_names.at(expr.local) + ".size()"};
        return property(expr);
    case Op::device_property: return {device_property(static_cast<ir::DeviceProperty>(expr.slot))};
    case Op::element_count: return {"glift::element_count(" + base(expr) + ")"};
    case Op::device_read:
        return {base(expr) + (expr.slot == 0 ? ".element" : ".element_in_place") + "(" + commands + ", " +
                print_any(p, expr.operands[0]) + ")"};
    case Op::host_read:
        return {base(expr) + ".element_in_place(commands, " + print_any(p, expr.operands[0]) + ").await(commands)"};
    case Op::await_value: return {print(p, expr.operands[0], Level::postfix) + ".await(commands)"};
    case Op::slice: return slice(expr);
    case Op::pipeline_call: return call(expr);
    case Op::device_value: break;
#define VALUE_OPERATION(name) case Op::name:
#define STRUCTURE_OPERATION(name) case Op::name:
#define GUARDED_OPERATION(name) case Op::name:
#define MEMORY_OPERATION(name) case Op::name:
#define CPU_OPERATION(name) case Op::name:
#include "ir/operations.def"
        break;
    }
    ir::misplaced(expr.op, "emit/cpp: a pipeline");
}

/// Declares a temporary. The arguments are in the order of the class's constructor: the commands, if the structure
/// makes memory, then structures, then values.
void PipelinePrinter::temporary(const Stmt& stmt) {
    const ir::Type& type = unit.program.types[unit.program.locals[stmt.local].type];
    const ir::Structure& made = unit.program.structures[type.structure];
    std::string structures, values;
    for (ExprId argument : stmt.arguments) {
        std::string& list = kind(unit.program.exprs[argument].type) == TypeKind::structure ? structures : values;
        list += ", " + print_any(p, argument);
    }
    const std::string device = ", " + commands + (stmt.uninitialized ? ".uninitialized()" : "");
    std::string arguments = (ir::takes_commands(unit.program, made) ? device : "") + structures + values;
    const std::string name = declare_local(p, stmt.local);
    p.out.line(unit.class_name(type.structure) + " " + name +
               (arguments.empty() ? ";" : "(" + arguments.substr(2) + ");"));
}

/// One arm: a side of an `if`, or a round of a `for … while`, whose condition lies on the device. Its passes are
/// recorded by commands under that condition (Commands::where, where_not).
void PipelinePrinter::arm(const std::string& condition, const std::vector<ir::StmtId>& body, const char* where) {
    if (body.empty()) return;
    p.out.open("");
    p.names.enter();
    const std::string inner = p.names.declare("commands");
    p.out.line("const glift::Commands " + inner + " = " + commands + "." + where + "(" + condition + ");");
    const std::string outer = std::exchange(commands, inner);
    print_statements(p, body);
    commands = outer;
    p.names.leave();
    p.out.close();
}

void PipelinePrinter::arms(const Stmt& stmt) {
    const std::string condition = print_any(p, stmt.value);
    arm(condition, stmt.body, "where");
    arm(condition, stmt.otherwise, "where_not");
}

void PipelinePrinter::dispatch(const Stmt& stmt) {
    std::string arguments;
    for (ExprId argument : stmt.arguments) arguments += ", " + print(p, argument, Level::postfix);
    p.out.line(visible(p, unit.globals.kernel_names[stmt.kernel()]) + "(" + commands + arguments + ");");
}

void PipelinePrinter::expect(const Stmt& stmt) {
    std::string text = "test.expect(" + print_any(p, stmt.value) + ", \"" + place_text(unit.sources, stmt.span) +
                       "\", " + quoted(source_text(unit.sources, stmt.span));
    if (!stmt.arguments.empty())
        text += ", " + quoted(source_text(unit.sources, unit.program.exprs[stmt.arguments[0]].span)) + ", " +
                print_any(p, stmt.arguments[0]) + ", \"" +
                std::string(ir::spelling(unit.program.exprs[stmt.value].binary)) + "\", " +
                print_any(p, stmt.arguments[1]);
    p.out.line(text + ");");
}

void PipelinePrinter::expect_same(const Stmt& stmt) {
    const ir::Type& type = unit.program.types[unit.program.exprs[stmt.arguments[0]].type];
    const ir::StructureId structure =
        type.kind == TypeKind::slice ? unit.program.types[type.element].structure : type.structure;
    p.out.line("test.expect_same(" + print_any(p, stmt.arguments[0]) + ", " + print_any(p, stmt.arguments[1]) + ", \"" +
               scalars_of(unit.program, unit.program.structures[structure].element) + "\", \"" +
               place_text(unit.sources, stmt.span) + "\"" +
               (stmt.arguments.size() > 2 ? ", " + print_any(p, stmt.arguments[2]) : "") + ");");
}

/// The memories that a structure has made, and those of the members that it has made, as arguments. A level or layer of
/// an image is not among them: the image is another structure's.
std::string memories_of(const Unit& unit, const std::string& object, ir::StructureId index) {
    const ir::Structure& structure = unit.program.structures[index];
    const ClassNames& names = unit.globals.class_names[index];
    std::string text;
    const auto also = [&](const std::string& more) { text += (text.empty() || more.empty() ? "" : ", ") + more; };
    for (std::size_t i = 0; i < structure.memories.size(); ++i)
        if (!structure.memories[i].part) also(object + "." + names.memories[i] + "()");
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        if (is_held(structure.members[i]))
            also(memories_of(unit, object + "." + names.members[i] + "()", structure.members[i].structure));
    return text;
}

/// Replaces a member by a temporary. The member's memories are given, too: recordings that use them become invalid.
void PipelinePrinter::replace(const Stmt& stmt) {
    Expr whole;
    whole.op = Op::structure_value;
    whole.place = stmt.place;
    const std::string member = base(whole);
    const ir::StructureId index = unit.program.types[unit.program.locals[stmt.local].type].structure;
    p.out.line("commands.replace(" + member + ", std::move(" + p.local_names.at(stmt.local) + "), {" +
               memories_of(unit, member, index) + "});");
}

/// Prints the statement that keeps a structure's elements, to be compared between devices (glift::Test::keep), under
/// the name `shown`. The domain of a structure without rows (has_rows), which may be sparse, may be too large to read
/// address by address. For such a structure also prints the statements that, in that case, keep its memories and those
/// stored members that the host can read.
void PipelinePrinter::keep(const std::string& shown, const std::string& object, ir::StructureId index) {
    const ir::Structure& made = unit.program.structures[index];
    const ClassNames& names = unit.globals.class_names[index];
    const std::string keeps =
        "test.keep(" + quoted(shown) + ", " + object + ", \"" + kept_scalars(unit.program, index) + "\")";
    if (has_rows(unit.program, made)) return p.out.line(keeps + ";");
    p.out.open("if (!" + keeps + ")");
    for (std::size_t i = 0; i < made.memories.size(); ++i) {
        const std::string memory = object + "." + names.memories[i] + "()";
        p.out.line("test.keep_memory(commands, " + quoted(shown + "." + unit.name(made.memories[i].name)) + ", " +
                   memory + ", \"" + scalars_of(unit.program, made.memories[i].element) + "\");");
    }
    for (std::size_t i = 0; i < made.members.size(); ++i) {
        const ir::Structure& member = unit.program.structures[made.members[i].structure];
        if (!made.members[i].is_component && member.kind == ir::StructureKind::stored && member.copyable)
            keep(shown + "." + unit.name(made.members[i].name), object + "." + names.members[i] + "()",
                 made.members[i].structure);
    }
    p.out.close();
}

/// Prints, for the structures that the outermost statements of a test make, if they are stored and the host can read
/// them, the statements that keep them to be compared between devices. Also prints the checks of translators that need
/// the state of such structures, containers' members included.
void PipelinePrinter::keep_all() {
    std::vector<Checked> made;
    for (ir::StmtId id : pipeline.body) {
        const Stmt& stmt = unit.program.stmts[id];
        if (stmt.op != StmtOp::temp) continue;
        const std::string name = unit.name(unit.program.locals[stmt.local].name);
        const ir::StructureId index = unit.program.types[unit.program.locals[stmt.local].type].structure;
        const ir::Structure& structure = unit.program.structures[index];
        made.push_back({p.local_names.at(stmt.local), name, index, ""});
        if (structure.kind == ir::StructureKind::stored && structure.copyable) keep(name, made.back().object, index);
    }
    for (const Checked& checked : made) check_with_members(checked);
}

/// Checks a structure and, at any depth, the members that it made. Blocks of a structure without translators are those
/// of its memory.
void PipelinePrinter::check_with_members(const Checked& checked) {
    const ir::Structure& structure = unit.program.structures[checked.index];
    std::string residents = checked.residents;
    if (const auto list = unit.block_lists.find(checked.index); list != unit.block_lists.end())
        residents = list->second + "(" + checked.object + ")";
    check_as_made({checked.object, checked.path, checked.index, residents});
    for (std::size_t m = 0; m < structure.members.size(); ++m) {
        if (!is_held(structure.members[m])) continue;
        const bool is_memory = structure.via.empty() && structure.base.size() == 1 && structure.base[0] == m;
        check_with_members({checked.object + "." + unit.globals.class_names[checked.index].members[m] + "()",
                            checked.path + "." + unit.name(structure.members[m].name), structure.members[m].structure,
                            is_memory ? residents : ""});
    }
}

void PipelinePrinter::check_as_made(const Checked& checked) {
    for (const TranslationCheck& check : unit.translation_checks) {
        if (check.structure != checked.index || !check.of_extents.empty() || check.of_one.empty()) continue;
        p.out.open("test.check_as_made(" + quoted(check.title) + ", " + quoted(checked.path) + ", [&]");
        p.out.line("auto structure = " + checked.object + ";");
        p.out.line(check.of_one + "(test, structure" + (checked.residents.empty() ? "" : ", " + checked.residents) +
                   ");");
        p.out.close(");");
    }
}

void PipelinePrinter::statement(const Stmt& stmt) {
    const auto place = [&] { return "\"" + place_text(unit.sources, stmt.span) + "\""; };
    switch (stmt.op) {
    case StmtOp::temp: return temporary(stmt);
    case StmtOp::release:
        // In tests nothing is released: the structures are compared at the end.
        if (tracks) return;
        for (ir::LocalId local : stmt.locals) p.out.line(p.local_names.at(local) + " = {};");
        return;
    case StmtOp::arms: return arms(stmt);
    case StmtOp::dispatch: return dispatch(stmt);
    case StmtOp::expect: return expect(stmt);
    case StmtOp::expect_near:
        return p.out.line("test.expect_near(" + join_arguments(p, stmt.arguments) + ", " + place() + ");");
    case StmtOp::expect_same: return expect_same(stmt);
    case StmtOp::replace: return replace(stmt);
    case StmtOp::host_assign: return p.out.line(print_any(p, stmt.target) + " = " + print_any(p, stmt.value) + ";");
#define VALUE_STATEMENT(name) case StmtOp::name:
#define STRUCTURE_STATEMENT(name) case StmtOp::name:
#define MEMORY_STATEMENT(name) case StmtOp::name:
#define CPU_STATEMENT(name) case StmtOp::name:
#include "ir/statements.def"
        break;
    }
    ir::misplaced(stmt.op, "emit/cpp: a pipeline");
}

/// Whether a kernel that the pipeline dispatches calls functions. A pipeline that computes a value on the device
/// (Pipeline::is_value) without such calls runs whatever the conditions of its caller are (Commands::always), since
/// passes under conditions take longer. With calls it runs under these conditions: a function may loop for long on
/// values that are missing because the arm that computes them did not run.
bool calls_functions(const Unit& unit, const Pipeline& pipeline) {
    bool found = false;
    for (ir::StmtId id : pipeline.body) {
        const Stmt& stmt = unit.program.stmts[id];
        if (stmt.op != StmtOp::dispatch) continue;
        ir::for_each_expression(unit.program, unit.program.kernels[stmt.kernel()].body,
                                [&](ExprId node) { found = found || unit.program.exprs[node].op == Op::call; });
    }
    return found;
}

bool is_test(const Unit& unit, ir::PipelineId pipeline) {
    for (const ir::Test& test : unit.program.tests) {
        if (test.pipeline == pipeline) return true;
    }
    return false;
}

/// Whether a running program can replace the pipeline: it is neither a function of a structure nor a test.
bool is_reloadable(const Unit& unit, ir::PipelineId pipeline) {
    return unit.options.reload && !unit.program.pipelines[pipeline].owner && !is_test(unit, pipeline);
}

std::string param_type(const Unit& unit, const ir::PipelineParam& param, bool qualified) {
    const ir::TypeId type = unit.program.locals[param.local].type;
    switch (param.pattern) {
    case ir::HostPattern::value: return unit.type(type, qualified) + " ";
    case ir::HostPattern::range: return "const " + unit.type(type, qualified) + "& ";
    case ir::HostPattern::structure:
        return (ir::may_be_changed(unit.program, param) ? "" : "const ") + unit.type(type, qualified) + "& ";
    }
    return "";
}

/// `mark_of_commands` stands before the parameter `commands`.
std::string signature(Unit& unit, ir::PipelineId index, const Printer& names, const std::string& owner, bool qualified,
                      const std::string& mark_of_commands = {}) {
    const Pipeline& pipeline = unit.program.pipelines[index];
    std::string parameters = mark_of_commands + "const glift::Commands& commands";
    if (is_test(unit, index)) parameters = "glift::Test& test, " + parameters;
    const auto mark = [&](const ir::PipelineParam& param) -> std::string {
        return qualified ? std::string() : unused_mark(unit.program, pipeline.body, param.local);
    };
    for (const ir::PipelineParam& param : pipeline.params)
        parameters += ", " + (mark(param) + param_type(unit, param, qualified)) + names.local_names.at(param.local);
    const bool is_const = pipeline.owner && !pipeline.changes_owner;
    return unit.type(pipeline.result, qualified) + " " + owner + unit.own.pipelines[index] + "(" + parameters + ")" +
           (is_const ? " const" : "");
}

}  // namespace

std::string pipeline_signature(Unit& unit, ir::PipelineId index, bool qualified) {
    PipelinePrinter printer(unit, unit.program.pipelines[index]);
    return signature(unit, index, printer.p, "", qualified);
}

void print_pipeline(Unit& unit, Writer& out, ir::PipelineId index) {
    const Pipeline& pipeline = unit.program.pipelines[index];
    PipelinePrinter printer(unit, pipeline);
    printer.tracks = is_test(unit, index);
    printer.p.out.indent();
    printer.p.marks_unused = true;
    if (pipeline.is_value && !calls_functions(unit, pipeline)) printer.commands = "commands.always()";
    print_statements(printer.p, pipeline.body);
    if (printer.tracks) printer.keep_all();
    out.gap();
    out.line("// " + place_text(unit.sources, pipeline.span) + ": " +
             (is_test(unit, index) ? quoted(pipeline.display) : pipeline.display));
    const std::string owner = pipeline.owner ? unit.own_name(pipeline.owner) + "::" : "";
    const std::string body = printer.p.out.take();
    const bool uses_commands = body.find("commands") != std::string::npos;
    const std::string mark = uses_commands ? "" : "[[maybe_unused]] ";
    Writer statements;
    statements.indent();
    // What profiles and debuggers show (<glift/mark.h>). A value's pipeline is a part of its caller, and a test is no
    // part of a program. No name of the language's begins with '_' here: the variable hides none.
    if (uses_commands && !pipeline.is_value && !printer.tracks)
        statements.line("const glift::PipelineMark _mark(" + quoted(pipeline.display) + ", \"" +
                        place_text(unit.sources, pipeline.span) + "\");");
    statements.raw(body);
    const std::string head = signature(unit, index, printer.p, owner, false, mark);
    if (!is_reloadable(unit, index)) {
        out.open(unit.linkage(pipeline.key) + head);
        out.raw(statements.text());
        out.close();
        return;
    }
    std::string arguments = "commands";
    for (const ir::PipelineParam& param : pipeline.params) arguments += ", " + printer.p.local_names.at(param.local);
    const std::string& name = unit.own.pipelines[index];
    std::string stem = "pipeline_" + name;
    for (int n = 2; !unit.reloadable.insert(stem).second; ++n) stem = "pipeline_" + name + "_" + std::to_string(n);
    print_function(unit, out,
                   {unit.linkage(pipeline.key), head, pipeline_signature(unit, index, true), name, arguments, stem, ""},
                   statements.text());
}

}  // namespace gliftc::cpp
