// Generated checks of translators: `invert` undoes `translate`, a translator that is not declared many-to-one maps no
// two addresses to one, none to an address outside of the memory, and boxes of elements have the values that were
// written when they are read back.
#include "emit/cpp/translators.h"
#include "ir/chain.h"
#include "ir/walk.h"

#include <algorithm>

namespace gliftc::cpp {

namespace {

using ir::Structure;
using ir::TypeKind;

/// Whether the structure's constructor takes nothing but values of the type of its domain, so that a structure can be
/// made of any extent.
bool is_made_of_extents(const ir::Program& program, const Structure& structure) {
    const auto is_given = [](const ir::MemberStructure& member) { return member.by_reference; };
    if (std::ranges::any_of(structure.members, is_given)) return false;
    return !structure.constructor.empty() && std::ranges::all_of(structure.constructor, [&](ir::LocalId local) {
        return program.locals[local].type == structure.domain_type;
    });
}

/// The C++ expression of a value of the structure's element type, made from a number `i`, that its memory keeps
/// exactly. Empty if the elements are computed, or are structs, arrays, matrices or optionals: these are not checked.
std::string sample_value(const Unit& unit, const Structure& structure) {
    if (ir::is_computed(unit.program, structure)) return "";
    const ir::Type& type = unit.program.types[structure.element];
    const ir::TypeId scalar = unit.program.types.scalar_of(structure.element);
    if (type.kind == TypeKind::struct_ || type.kind == TypeKind::array || type.kind == TypeKind::matrix ||
        type.kind == TypeKind::optional)
        return "";
    std::string number = "i";
    switch (ir::root_memory(unit.program, structure).format) {
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

using Tables = std::vector<ir::Place>;

/// The structures (tables) whose elements the translator's functions read, each once. The root of each place is an
/// index in Translator::structures.
Tables tables_of(const ir::Program& program, const ir::Translator& translator) {
    Tables tables;
    for (ir::FunctionId id : {translator.translate, translator.invert}) {
        if (!id) continue;
        ir::for_each_expression(program, program.functions[id].body, [&](ir::ExprId node) {
            const ir::Expr& expr = program.exprs[node];
            if (expr.op == ir::Op::read && std::ranges::find(tables, expr.place) == tables.end())
                tables.push_back(expr.place);
        });
    }
    return tables;
}

/// The place as seen from the structure that has the translator.
ir::Place placed(const ir::Stage& stage, const ir::Place& place) {
    ir::Place result = stage.structures[place.root];
    result.members.append(place.members);
    return result;
}

/// Why a translator's function cannot be printed as a lambda (print_method); empty: it can.
std::string why_not_printed(const ir::Program& program, ir::FunctionId id) {
    if (!id) return "";
    const std::string name = (*program.names)[program.functions[id].name];
    if (uses_state_elsewhere(program, id)) return "'" + name + "' calls functions that use its state";
    std::string why;
    ir::for_each_expression(program, program.functions[id].body, [&](ir::ExprId node) {
        const ir::Expr& expr = program.exprs[node];
        const bool passes_structures = expr.op == ir::Op::call && !expr.places.empty();
        const bool reads_rows = expr.op == ir::Op::read && program.types.kind(expr.type) == TypeKind::array;
        if (passes_structures) why = "'" + name + "' gives structures to functions";
        if (reads_rows || expr.op == ir::Op::sample || expr.op == ir::Op::gather || expr.op == ir::Op::compare ||
            expr.op == ir::Op::translate)
            why = "'" + name + "' asks a structure for more than elements";
    });
    return why;
}

const char* mapping_text(ir::Mapping mapping, bool reads_tables) {
    switch (mapping) {
    case ir::Mapping::unknown: return reads_tables ? "glift::Mapping::by_tables" : "glift::Mapping::undeclared";
    case ir::Mapping::claimed_one_to_one: return "glift::Mapping::one_to_one";
    case ir::Mapping::many_to_one: return "glift::Mapping::many_to_one";
    }
    return "";
}

/// Prints the translators of one structure as lambdas, and the calls that check them.
class CheckPrinter {
public:
    CheckPrinter(Unit& unit, Writer& out, ir::StructureId index)
        : unit_(unit), out_(out), index_(index), structure_(unit.program.structures[index]) {}

    void print(const std::string& name, const std::string& title) {
        out_.open("void " + name + "(glift::Test& test, " + unit_.class_name(index_) + "& structure)");
        for (std::size_t i = 0; i < structure_.via.size(); ++i) stage(i, title);
        boxes(title);
        out_.close();
        out_.gap();
    }

private:
    void stage(std::size_t i, const std::string& title) {
        const ir::Stage& stage = structure_.via[i];
        const ir::Translator& translator = unit_.program.translators[stage.translator];
        out_.open("const auto reached_" + std::to_string(i) + " = [&]");
        const Tables tables = tables_of(unit_.program, translator);
        std::vector<std::string> names = print_state(unit_, out_, index_, stage, "structure.",
                                                     {"structure", "translate", "invert", "test", "memory"});
        const std::vector<std::string> mirrors = print_mirrors(stage, tables, names);
        names.insert(names.end(), mirrors.begin(), mirrors.end());
        const auto surroundings = [&](Printer& p, const ir::Expr& expr) -> Text {
            ir::Expr outer = expr;
            outer.place = placed(stage, expr.place);
            if (expr.op != ir::Op::read) return structure_property(unit_.globals, outer, index_, "structure.");
            const auto table = static_cast<std::size_t>(std::ranges::find(tables, expr.place) - tables.begin());
            return {mirrors[table] + "[" + print_any(p, expr.operands[0]) + "]"};
        };
        print_method(unit_, out_, "translate", translator.translate,
                     "std::optional<" + unit_.type(translator.physical_type) + ">", names, surroundings);
        if (translator.invert)
            print_method(unit_, out_, "invert", translator.invert, unit_.type(translator.virtual_type), names,
                         surroundings);
        const std::string memory =
            i + 1 == structure_.via.size() && ir::stays_inside(unit_.program, structure_) ? "&memory" : "nullptr";
        if (memory != "nullptr") out_.line("const glift::Extent memory = glift::detail::limit_of(" + extent() + ");");
        out_.line("return glift::check_translator(test, " + quoted(title + ": " + translator.display) + ", " +
                  (i == 0 ? std::string("glift::tried(structure.domain())") : "reached_" + std::to_string(i - 1)) +
                  ", translate, " + (translator.invert ? "invert" : "nullptr") + ", " +
                  mapping_text(translator.properties.mapping, !tables.empty()) + ", " + memory + ");");
        out_.close("();");
    }

    /// Declares copies of the tables on the host. Returns their names, none of which is `taken`.
    std::vector<std::string> print_mirrors(const ir::Stage& stage, const Tables& tables,
                                           const std::vector<std::string>& taken) {
        std::vector<std::string> names;
        for (const ir::Place& place : tables) {
            ir::Expr table;
            table.op = ir::Op::structure_value;
            table.place = placed(stage, place);
            names.push_back("table_" + std::to_string(names.size()));
            while (std::ranges::find(taken, names.back()) != taken.end()) names.back() += "_t";
            out_.line("const glift::Mirror " + names.back() + "(" +
                      structure_property(unit_.globals, table, index_, "structure.").text + ", structure.device());");
        }
        return names;
    }

    void boxes(const std::string& title) {
        const std::string last = "reached_" + std::to_string(structure_.via.size() - 1);
        const std::string value = sample_value(unit_, structure_);
        const bool is_moved = std::ranges::any_of(unit_.program.transfers, [&](const ir::Program::Transfer& transfer) {
            return transfer.structure == index_ && transfer.write_kernel;
        });
        // If the memory (or that one's memory, and so on) is a structure that does not map all its addresses, writes to
        // the others are lost.
        const bool keeps_all = structure_.copyable && maps_all_of_memory();
        if (!is_moved || !keeps_all || value.empty()) return out_.line("(void)" + last + ";");
        out_.open("if (glift::fill_memory(" + last + ", " + extent() + "))");
        out_.line("glift::check_boxes(test, " + quoted(title) + ", structure, [](uint i) { return " + value + "; });");
        out_.close();
    }

    /// Whether every link after the first is proved to map all of its domain.
    bool maps_all_of_memory() const {
        if (ir::leads_through_partial(unit_.program, structure_)) return false;
        const Structure* link = &structure_;
        while (!link->base.empty()) {
            link = &ir::structure_at(unit_.program, *link, link->base);
            if (ir::physical_type(unit_.program, *link) && !ir::is_contained(unit_.program, *link)) return false;
        }
        return true;
    }

    /// The extent of the memory that the translators lead to.
    std::string extent() const {
        if (structure_.base.empty())
            return "structure." + unit_.globals.class_names[index_].extents[structure_.via_memory] + "()";
        ir::Expr domain;
        domain.op = ir::Op::domain;
        domain.place.members = structure_.base;
        return structure_property(unit_.globals, domain, index_, "structure.").text;
    }

    Unit& unit_;
    Writer& out_;
    ir::StructureId index_;
    const Structure& structure_;
};

bool reads_tables(const ir::Program& program, const Structure& structure) {
    return std::ranges::any_of(structure.via, [&](const ir::Stage& stage) {
        return !tables_of(program, program.translators[stage.translator]).empty();
    });
}

/// Why the tables that a translator reads cannot be copied to the host; empty: they can.
std::string why_not_mirrored(const ir::Program& program, const Structure& structure, const ir::Stage& stage) {
    for (const ir::Place& place : tables_of(program, program.translators[stage.translator])) {
        const Structure& table = ir::structure_at(program, structure, placed(stage, place).members);
        if (table.kind == ir::StructureKind::computed && !table.domain)
            return "its table is " + table.display + ", a view without a domain";
    }
    return "";
}

/// Why the structure's translation cannot be checked at all; empty: it can.
std::string why_never(const ir::Program& program, const Structure& structure) {
    for (const ir::Stage& stage : structure.via) {
        const ir::Translator& translator = program.translators[stage.translator];
        if (std::string why = why_not_mirrored(program, structure, stage); !why.empty())
            return translator.display + ": " + why;
        for (ir::FunctionId id : {translator.translate, translator.invert})
            if (std::string why = why_not_printed(program, id); !why.empty()) return translator.display + ": " + why;
    }
    return "";
}

/// Prints the function that makes structures of several extents and checks each.
void print_check_of_extents(Unit& unit, Writer& out, ir::StructureId index, const std::string& name,
                            const std::string& check) {
    const Structure& structure = unit.program.structures[index];
    out.open("void " + name + "(glift::Test& test, const glift::Commands& commands)");
    out.open("for (const " + unit.type(structure.domain_type) + " extent : {" +
             extents_text(unit, structure.domain_type) + "})");
    std::string arguments;
    for (std::size_t i = 0; i < structure.constructor.size(); ++i) arguments += ", extent";
    out.line("if (auto made = test.make<" + unit.class_name(index) + ">(commands" + arguments + ")) " + check +
             "(test, *made);");
    out.close();
    out.close();
    out.gap();
}

}  // namespace

std::vector<TranslationCheck> print_translation_checks(Unit& unit, Writer& out) {
    std::vector<TranslationCheck> checks;
    for (ir::StructureId index : unit.reach.structures) {
        const Structure& structure = unit.program.structures[index];
        if (structure.kind != ir::StructureKind::stored || structure.via.empty()) continue;
        TranslationCheck& check = checks.emplace_back();
        check.structure = index;
        check.title = "translation of " + structure.display;
        check.why_not_alone = why_never(unit.program, structure);
        if (!check.why_not_alone.empty()) continue;
        check.of_one = unit.globals.names.declare("check_" + unit.class_name(index));
        CheckPrinter(unit, out, index).print(check.of_one, check.title);
        if (reads_tables(unit.program, structure)) {
            check.why_not_alone = "it reads tables, and no test that ran has one at its end";
        } else if (!is_made_of_extents(unit.program, structure)) {
            check.why_not_alone = "it takes other arguments than an extent, and no test that ran has one at its end";
        } else {
            check.of_extents = unit.globals.names.declare(check.of_one + "_of_extents");
            print_check_of_extents(unit, out, index, check.of_extents, check.of_one);
        }
    }
    // Structures that no code of the module uses are not in its C++.
    const std::set<ir::StructureId> reached(unit.reach.structures.begin(), unit.reach.structures.end());
    for (ir::StructureId index : unit.program.structures.ids()) {
        const Structure& structure = unit.program.structures[index];
        if (structure.module != unit.module || structure.via.empty() || reached.contains(index)) continue;
        checks.push_back({.structure = index,
                          .title = "translation of " + structure.display,
                          .why_not_alone = "it is not public, and no test makes one"});
    }
    return checks;
}

}  // namespace gliftc::cpp
