// What only a test program has: the table of tests, and checks of translators that nobody wrote.
#include "emit/cpp/translators.h"
#include "emit/cpp/unit.h"
#include "ir/walk.h"

namespace gliftc::cpp {

namespace {

using ir::Structure;
using ir::TypeKind;

/// True if every pass that the pipeline runs gives the same bits on every device.
bool is_exact(const Unit& unit, std::uint32_t index, std::set<std::uint32_t>& seen) {
    if (!seen.insert(index).second) return true;
    bool exact = true;
    const ir::Pipeline& pipeline = unit.program.pipelines[index];
    ir::for_each_statement(unit.program, pipeline.body, [&](const ir::Stmt& stmt) {
        if (stmt.op == ir::StmtOp::dispatch) exact = exact && unit.lowered.passes[stmt.slot].direct.exact;
    });
    ir::for_each_expression(unit.program, pipeline.body, [&](ir::ExprId node) {
        const ir::Expr& expr = unit.program.exprs[node];
        if (expr.op == ir::Op::pipeline_call) exact = exact && is_exact(unit, expr.slot, seen);
    });
    return exact;
}

/// Its constructor takes nothing but extents of its domain, so that any size makes a whole structure.
bool can_be_made(const ir::Program& program, const Structure& structure) {
    if (structure.kind != ir::StructureKind::stored || structure.constructor.empty() || structure.via.empty())
        return false;
    for (ir::LocalId local : structure.constructor) {
        if (program.locals[local].type != structure.domain_type) return false;
    }
    return true;
}

/// A value of the structure's element type that its memory keeps exactly, from a number `i`; empty where there is none.
std::string sample_value(const Unit& unit, const Structure& structure) {
    if (structure.memories.empty()) return "";
    const ir::Type& type = unit.program.types[structure.element];
    const ir::TypeId scalar = unit.program.types.scalar_of(structure.element);
    if (type.kind == TypeKind::struct_ || type.kind == TypeKind::array || type.kind == TypeKind::matrix ||
        type.kind == TypeKind::optional)
        return "";
    std::string number = "i";
    switch (structure.memories[structure.via_memory].format) {
    case ir::Format::none: break;
    case ir::Format::r8:
    case ir::Format::rg8:
    case ir::Format::rgba8: number = "i % 2"; break;
    case ir::Format::r8ui:
    case ir::Format::rgba8ui: number = "i % 251"; break;
    case ir::Format::r16f:
    case ir::Format::rg16f:
    case ir::Format::rgba16f: number = "i % 2039"; break;
    case ir::Format::r16ui: number = "i % 65521"; break;
    case ir::Format::d32:
    case ir::Format::r32f:
    case ir::Format::rg32f:
    case ir::Format::rgba32f:
    case ir::Format::r32ui:
    case ir::Format::rg32ui:
    case ir::Format::rgba32ui:
    case ir::Format::r32i:
    case ir::Format::rg32i:
    case ir::Format::rgba32i: break;
    }
    if (unit.program.types.kind(scalar) == TypeKind::bool_) number = "i % 2 == 1";
    if (unit.program.types.kind(scalar) == TypeKind::half) number = "i % 2039";
    const std::string value = storage_text(unit.globals, scalar) + "(" + number + ")";
    return unit.program.types.is_vector(structure.element)
               ? storage_text(unit.globals, structure.element) + "(" + value + ")"
               : value;
}

void print_stage_check(Unit& unit, Writer& out, std::uint32_t index, std::size_t stage_index) {
    const Structure& structure = unit.program.structures[index];
    const ir::Stage& stage = structure.via[stage_index];
    const ir::Translator& translator = unit.program.translators[stage.translator];
    if (!translator.structures.empty() || !translator.translate ||
        uses_state_elsewhere(unit.program, translator.translate))
        return;
    if (stage_index > 0 && !translator.domain) return;
    if (translator.invert && uses_state_elsewhere(unit.program, translator.invert)) return;
    out.open("");
    const std::vector<std::string> states =
        print_state(unit, out, index, stage, "structure.",
                    {"structure", "translate", "invert", "test", "commands", "extent", "domain"});
    print_method(unit, out, "translate", translator.translate,
                 "std::optional<" + unit.type(translator.physical_type) + ">", states);
    if (translator.invert)
        print_method(unit, out, "invert", translator.invert, unit.type(translator.virtual_type), states);
    std::string domain = "structure.domain()";
    if (stage_index > 0) {
        print_method(unit, out, "domain", translator.domain, unit.type(translator.virtual_type), states);
        domain = "domain()";
    }
    out.line("glift::check_translator(test, \"" + translator.display + "\", " + domain + ", translate, " +
             (translator.invert ? "invert" : "nullptr") + ", " + (translator.properties.one_to_one ? "true" : "false") +
             ");");
    out.close();
}

std::string extents_text(const Unit& unit, ir::TypeId type) {
    static constexpr std::uint32_t sizes[4][4] = {{1, 1, 1, 1}, {4, 4, 4, 4}, {13, 7, 5, 3}, {70, 33, 9, 4}};
    const std::uint32_t axes = unit.program.types.components(type);
    std::string text;
    for (const auto& size : sizes) {
        text += text.empty() ? "" : ", ";
        if (axes == 1) {
            text += std::to_string(size[0] * size[1]) + "u";
            continue;
        }
        text += unit.type(type) + "(";
        for (std::uint32_t i = 0; i < axes; ++i) text += (i ? ", " : "") + std::to_string(size[i]);
        text += ")";
    }
    return text;
}

/// Returns the name of the function that it printed, or nothing.
std::string print_structure_check(Unit& unit, Writer& out, std::uint32_t index) {
    const Structure& structure = unit.program.structures[index];
    if (!can_be_made(unit.program, structure)) return "";
    const std::string name = unit.globals.names.declare("check_" + unit.class_name(index));
    out.open("void " + name + "(glift::Test& test, const glift::Commands& commands)");
    out.open("for (const " + unit.type(structure.domain_type) + " extent : {" +
             extents_text(unit, structure.domain_type) + "})");
    std::string arguments;
    for (std::size_t i = 0; i < structure.constructor.size(); ++i) arguments += ", extent";
    out.line(unit.class_name(index) + " structure(commands" + arguments + ");");
    for (std::size_t i = 0; i < structure.via.size(); ++i) print_stage_check(unit, out, index, i);
    bool total = structure.copyable;
    for (const ir::Stage& stage : structure.via) {
        const ir::Properties& properties = unit.program.translators[stage.translator].properties;
        total = total && !properties.partial && properties.one_to_one;
    }
    const std::string value = sample_value(unit, structure);
    bool moved = false;
    for (const ir::Program::Transfer& transfer : unit.program.transfers)
        moved = moved || (transfer.structure == index && transfer.write_kernel < unit.program.kernels.size());
    if (total && moved && !value.empty())
        out.line("glift::check_boxes(test, \"" + structure.display + "\", structure, [](uint i) { return " + value +
                 "; });");
    out.close();
    out.close();
    out.gap();
    return name;
}

}  // namespace

std::string scalars_of(const ir::Program& program, ir::TypeId id) {
    const ir::Type& type = program.types[id];
    switch (type.kind) {
    case TypeKind::bool_: return "b";
    case TypeKind::int_: return "i";
    case TypeKind::uint:
    case TypeKind::enum_: return "u";
    case TypeKind::float_: return "f";
    case TypeKind::half: return "h";
    case TypeKind::double_: return "d";
    case TypeKind::int64: return "I";
    case TypeKind::uint64: return "U";
    case TypeKind::vector:
    case TypeKind::matrix:
    case TypeKind::array: {
        std::string all;
        const std::uint32_t count = type.kind == TypeKind::matrix ? type.count * type.rows : type.count;
        for (std::uint32_t i = 0; i < count; ++i) all += scalars_of(program, type.element);
        return all;
    }
    case TypeKind::struct_: {
        std::string all;
        for (const ir::StructField& field : program.structs[type.index].fields) all += scalars_of(program, field.type);
        return all;
    }
    case TypeKind::error:
    case TypeKind::void_:
    case TypeKind::optional:
    case TypeKind::range:
    case TypeKind::structure:
    case TypeKind::slice:
    case TypeKind::device: return "";
    }
    return "";
}

void print_tests(Unit& unit, Writer& out) {
    std::vector<std::string> rows;
    for (std::uint32_t index : unit.reach.structures) {
        const std::string name = print_structure_check(unit, out, index);
        if (name.empty()) continue;
        rows.push_back("{" + quoted("translation of " + unit.program.structures[index].display) + ", \"" +
                       place_text(unit.sources, unit.program.structures[index].span) + "\", true, &" + name + "},");
    }
    for (const ir::Test& test : unit.program.tests) {
        if (test.module != unit.module) continue;
        std::set<std::uint32_t> seen;
        rows.push_back("{" + quoted(test.title) + ", \"" + place_text(unit.sources, test.span) + "\", " +
                       (is_exact(unit, test.pipeline, seen) ? "true" : "false") + ", &" +
                       unit.globals.pipeline_names.at(test.pipeline) + "},");
    }
    if (rows.empty()) return;
    unit.tests = unit.globals.names.declare("tests");
    out.line("const glift::TestCase " + unit.tests + "[] = {");
    out.indent();
    for (const std::string& row : rows) out.line(row);
    out.dedent();
    out.line("};");
    out.gap();
}

}  // namespace gliftc::cpp
