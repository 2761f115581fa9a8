// What only a test program has: the table of its tests, and the letters that say of which scalars an element
// consists (glift::KeptStructure), by which elements are compared between devices.
#include "emit/cpp/unit.h"
#include "ir/walk.h"
#include "layout/layout.h"

#include <algorithm>

namespace gliftc::cpp {

namespace {

using ir::TypeKind;

/// True if every pass that the pipeline runs gives the same bits on every device. Pipelines in `seen` are left out:
/// they have been looked at already.
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
        const std::string part = scalars_of(program, type.element);
        for (std::uint32_t i = 0; i < count; ++i) all += part;
        return all;
    }
    case TypeKind::struct_: {
        const ir::Struct& declared = program.structs[type.index];
        const std::vector<std::uint32_t> offsets = layout::offsets_of(program, declared);
        std::string all;
        std::uint32_t end = 0;
        const auto skip_to = [&](std::uint32_t offset) { all.append(offset - end, '.'); };
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            skip_to(offsets[i]);
            all += scalars_of(program, declared.fields[i].type);
            end = offsets[i] + layout::size_of(program, declared.fields[i].type).size;
        }
        skip_to(layout::size_of(program, id).size);
        return all;
    }
    case TypeKind::error:
    case TypeKind::void_:
    case TypeKind::optional:
    case TypeKind::structure:
    case TypeKind::slice:
    case TypeKind::device: return "";
    }
    return "";
}

std::string kept_scalars(const ir::Program& program, std::uint32_t index) {
    const ir::Structure& structure = program.structures[index];
    std::string scalars = scalars_of(program, structure.element);
    const auto draws = [&](const ir::Kernel& kernel) {
        return kernel.raster && std::ranges::any_of(kernel.raster->colours, [&](const ir::ColourTarget& target) {
                   return kernel.params[target.param].structure == index;
               });
    };
    if (structure.memories.empty() || std::ranges::none_of(program.kernels, draws)) return scalars;
    const ir::Format format = structure.memories[structure.via_memory].format;
    const bool is_fraction = format == ir::Format::r8 || format == ir::Format::rg8 || format == ir::Format::rgba8;
    if (is_fraction) std::ranges::replace(scalars, 'f', 'n');
    return scalars;
}

void print_tests(Unit& unit, Writer& out) {
    std::vector<std::string> rows;
    const auto row = [&](const std::string& title, Span span, bool exact, const std::string& rest) {
        unit.test_names.push_back({title, place_text(unit.sources, span)});
        rows.push_back("{" + quoted(title) + ", \"" + place_text(unit.sources, span) + "\", " +
                       (exact ? "true, " : "false, ") + rest + "},");
    };
    for (const TranslationCheck& check : unit.translation_checks)
        row(check.title, unit.program.structures[check.structure].span, true,
            check.of_extents.empty() ? "nullptr, " + quoted(check.why_not_alone) : "&" + check.of_extents);
    for (const ir::Test& test : unit.program.tests) {
        if (test.module != unit.module) continue;
        std::set<std::uint32_t> seen;
        row(test.title, test.span, is_exact(unit, test.pipeline, seen),
            "&" + unit.globals.pipeline_names.at(test.pipeline));
    }
    if (rows.empty()) return;
    unit.tests = unit.globals.names.declare("tests");
    out.line("const glift::TestCase " + unit.tests + "[] = {");
    out.indent();
    for (const std::string& text : rows) out.line(text);
    out.dedent();
    out.line("};");
    out.gap();
}

}  // namespace gliftc::cpp
