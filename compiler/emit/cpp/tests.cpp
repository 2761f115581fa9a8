// What only a test program has: the table of its tests, and the letters that say of which scalars an element
// consists (glift::KeptStructure), by which elements are compared between devices.
#include "emit/cpp/unit.h"
#include "ir/walk.h"
#include "layout/layout.h"

#include <algorithm>

namespace gliftc::cpp {

namespace {

using ir::TypeKind;

/// How much the devices' results of a test may differ.
enum class Agreement : std::uint8_t { exact, inexact, of_bytes };

const char* tolerance_of(Agreement agreement) {
    switch (agreement) {
    case Agreement::exact: return "0";
    case Agreement::inexact: return "glift::inexact_tolerance";
    case Agreement::of_bytes: return "glift::byte_tolerance";
    }
    return "";
}

bool is_of_bytes(ir::Format format) {
    return format == ir::Format::r8 || format == ir::Format::rg8 || format == ir::Format::rgba8;
}

bool filters_bytes(const ir::Pass& pass) {
    return std::ranges::any_of(
        pass.bindings, [](const ir::PassBinding& binding) { return binding.linear && is_of_bytes(binding.format); });
}

/// That of all passes that the pipeline runs. Pipelines in `seen` are left out: they have been looked at already.
Agreement agreement_of(const Unit& unit, ir::PipelineId index, std::set<ir::PipelineId>& seen) {
    Agreement all = Agreement::exact;
    if (!seen.insert(index).second) return all;
    const ir::Pipeline& pipeline = unit.program.pipelines[index];
    ir::for_each_statement(unit.program, pipeline.body, [&](const ir::Stmt& stmt) {
        if (stmt.op != ir::StmtOp::dispatch) return;
        const ir::Pass& pass = unit.lowered.passes[stmt.kernel()].direct;
        if (!pass.exact) all = std::max(all, filters_bytes(pass) ? Agreement::of_bytes : Agreement::inexact);
    });
    ir::for_each_expression(unit.program, pipeline.body, [&](ir::ExprId node) {
        const ir::Expr& expr = unit.program.exprs[node];
        if (expr.op == ir::Op::pipeline_call) all = std::max(all, agreement_of(unit, expr.pipeline(), seen));
    });
    return all;
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
        const ir::Struct& declared = program.structs[type.struct_];
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

std::string kept_scalars(const ir::Program& program, ir::StructureId index) {
    const ir::Structure& structure = program.structures[index];
    std::string scalars = scalars_of(program, structure.element);
    const auto draws = [&](const ir::Kernel& kernel) {
        return kernel.raster && std::ranges::any_of(kernel.raster->colours, [&](const ir::ColourTarget& target) {
                   return kernel.params[target.param].structure == index;
               });
    };
    if (structure.memories.empty() || std::ranges::none_of(program.kernels, draws)) return scalars;
    if (is_of_bytes(structure.memories[structure.via_memory].format)) std::ranges::replace(scalars, 'f', 'n');
    return scalars;
}

void print_tests(Unit& unit, Writer& out) {
    std::vector<std::string> rows;
    const auto row = [&](const std::string& title, Span span, Agreement agreement, const std::string& rest) {
        unit.test_names.push_back({title, place_text(unit.sources, span)});
        rows.push_back("{" + quoted(title) + ", \"" + place_text(unit.sources, span) + "\", " +
                       tolerance_of(agreement) + ", " + rest + "},");
    };
    for (const TranslationCheck& check : unit.translation_checks)
        row(check.title, unit.program.structures[check.structure].span, Agreement::exact,
            check.of_extents.empty() ? "nullptr, " + quoted(check.why_not_alone) : "&" + check.of_extents);
    for (const ir::Test& test : unit.program.tests) {
        if (test.module != unit.module) continue;
        std::set<ir::PipelineId> seen;
        row(test.title, test.span, agreement_of(unit, test.pipeline, seen),
            "&" + unit.globals.pipeline_names[test.pipeline]);
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
