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

using Places = std::vector<ir::Place>;

ir::Place resolved(const ir::Place& place, const Places& at) {
    ir::Place result = at[place.root];
    result.members.append(place.members);
    return result;
}

/// A function, and the places of its structures (Function::structures), seen from one structure.
struct FunctionAt {
    ir::FunctionId function;
    Places at;

    bool operator==(const FunctionAt&) const = default;
};

FunctionAt called(const ir::Expr& call, const Places& at) {
    FunctionAt result{call.function, {}};
    for (const ir::Place& place : call.places) result.at.push_back(resolved(place, at));
    return result;
}

/// What functions that read tables need, each once: the tables, and the functions to which they pass structures, after
/// those that these call.
struct Needs {
    Places tables;
    std::vector<FunctionAt> callees;

    void add(const ir::Program& program, const FunctionAt& reader) {
        if (!reader.function) return;
        ir::for_each_expression(program, program.functions[reader.function].body, [&](ir::ExprId node) {
            const ir::Expr& expr = program.exprs[node];
            if (expr.op == ir::Op::read) {
                const ir::Place table = resolved(expr.place, reader.at);
                if (std::ranges::find(tables, table) == tables.end()) tables.push_back(table);
            }
            if (expr.op != ir::Op::call || expr.places.empty()) return;
            const FunctionAt callee = called(expr, reader.at);
            if (std::ranges::find(callees, callee) != callees.end()) return;
            add(program, callee);
            callees.push_back(callee);
        });
    }
};

Needs needs_of(const ir::Program& program, const ir::Stage& stage) {
    const ir::Translator& translator = program.translators[stage.translator];
    const Places at(stage.structures.begin(), stage.structures.end());
    Needs needs;
    for (ir::FunctionId id : {translator.translate, translator.invert}) needs.add(program, {id, at});
    return needs;
}

Needs needs_of(const ir::Program& program, const ir::Blocks& blocks) {
    Needs needs;
    for (ir::FunctionId id : {blocks.count, blocks.first}) needs.add(program, {id, {ir::Place{}}});
    return needs;
}

/// Why a translator's function cannot be printed as a lambda (print_method); empty: it can.
std::string why_not_printed(const ir::Program& program, ir::FunctionId id) {
    if (!id) return "";
    const std::string name = (*program.names)[program.functions[id].name];
    if (uses_state_elsewhere(program, id)) return "'" + name + "' calls functions that use its state";
    std::string why;
    ir::for_each_expression(program, program.functions[id].body, [&](ir::ExprId node) {
        const ir::Expr& expr = program.exprs[node];
        if (expr.op == ir::Op::call && !expr.places.empty())
            if (std::string inner = why_not_printed(program, expr.function); !inner.empty()) why = std::move(inner);
        const bool reads_rows = expr.op == ir::Op::read && program.types.kind(expr.type) == TypeKind::array;
        if (reads_rows || expr.op == ir::Op::sample || expr.op == ir::Op::gather || expr.op == ir::Op::compare ||
            expr.op == ir::Op::translate)
            why = "'" + name + "' asks a structure for more than elements";
    });
    return why;
}

/// A partial translator gives `none` for unused entries of its tables. A total one maps each entry somewhere, so that
/// unused entries of a list may share an address.
const char* mapping_text(const ir::Properties& properties, bool reads_tables) {
    switch (properties.mapping) {
    case ir::Mapping::unknown:
        return reads_tables && !properties.partial ? "glift::Mapping::by_tables" : "glift::Mapping::undeclared";
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
        out_.open("void " + name + "(glift::Test& test, " + unit_.class_name(index_) +
                  "& structure, const std::vector<" + unit_.type(structure_.domain_type) + ">& residents = {})");
        for (std::size_t i = 0; i < structure_.via.size(); ++i) stage(i, title);
        boxes(title);
        out_.close();
        out_.gap();
    }

    /// Prints the function that gives the addresses in the structure's blocks.
    void print_blocks(const std::string& name) {
        const ir::Blocks& blocks = *structure_.blocks;
        const std::string address = unit_.type(structure_.domain_type);
        out_.open("std::vector<" + address + "> " + name + "(const " + unit_.class_name(index_) + "& structure)");
        print_needs(needs_of(unit_.program, blocks), {}, {"structure", "blocks", "first"});
        print_reader("blocks", {blocks.count, {ir::Place{}}}, "uint", {});
        print_reader("first", {blocks.first, {ir::Place{}}}, "std::optional<" + address + ">", {});
        Printer p(unit_.globals);
        p.outer_expression = [&](const ir::Expr& expr) {
            return structure_property(unit_.globals, expr, index_, "structure.");
        };
        out_.line("return glift::addresses_in_blocks<" + address + ">(blocks, first, " + print_any(p, blocks.extent) +
                  ", structure.domain());");
        out_.close();
        out_.gap();
    }

private:
    /// Declares the mirrors of tables, and callees as lambdas. None of their names is `taken` or one of `states`.
    void print_needs(const Needs& needs, const std::vector<std::string>& states,
                     std::initializer_list<const char*> taken) {
        needs_ = needs;
        names_.assign(states.begin(), states.end());
        names_.insert(names_.end(), taken.begin(), taken.end());
        mirrors_.clear();
        callees_.clear();
        for (const ir::Place& place : needs.tables) {
            ir::Expr table;
            table.op = ir::Op::structure_value;
            table.place = place;
            mirrors_.push_back(free_name("table_" + std::to_string(mirrors_.size())));
            out_.line("const glift::Mirror " + mirrors_.back() + "(" +
                      structure_property(unit_.globals, table, index_, "structure.").text + ", structure.device());");
        }
        for (const FunctionAt& callee : needs.callees) {
            const ir::Function& function = unit_.program.functions[callee.function];
            const std::string name = free_name("call_" + std::to_string(callees_.size()));
            print_reader(name, callee, unit_.type(function.result), {});
            callees_.push_back(name);
        }
    }

    std::string free_name(std::string name) {
        while (std::ranges::find(names_, name) != names_.end()) name += "_t";
        names_.push_back(name);
        return name;
    }

    /// Declares a function that reads tables as a lambda, after print_needs().
    void print_reader(const std::string& name, const FunctionAt& reader, const std::string& result,
                      std::vector<std::string> states) {
        states.insert(states.end(), names_.begin(), names_.end());
        print_method(unit_, out_, name, reader.function, result, states, [&](Printer& p, const ir::Expr& expr) -> Text {
            if (expr.op == ir::Op::call) {
                const auto callee = std::ranges::find(needs_.callees, called(expr, reader.at));
                return {callees_.at(static_cast<std::size_t>(callee - needs_.callees.begin()))};
            }
            ir::Expr outer = expr;
            if (expr.place.root < reader.at.size()) outer.place = resolved(expr.place, reader.at);
            if (expr.op != ir::Op::read) return structure_property(unit_.globals, outer, index_, "structure.");
            const auto table = std::ranges::find(needs_.tables, outer.place);
            return {mirrors_.at(static_cast<std::size_t>(table - needs_.tables.begin())) + "[" +
                    print_any(p, expr.operands[0]) + "]"};
        });
    }

    void stage(std::size_t i, const std::string& title) {
        const ir::Stage& stage = structure_.via[i];
        const ir::Translator& translator = unit_.program.translators[stage.translator];
        out_.open("const auto reached_" + std::to_string(i) + " = [&]");
        const Needs needs = needs_of(unit_.program, stage);
        const Places at(stage.structures.begin(), stage.structures.end());
        const std::initializer_list<const char*> taken = {"structure", "translate", "invert",
                                                          "test",      "memory",    "residents"};
        const std::vector<std::string> states = print_state(unit_, out_, index_, stage, "structure.", taken);
        print_needs(needs, states, taken);
        print_reader("translate", {translator.translate, at},
                     "std::optional<" + unit_.type(translator.physical_type) + ">", states);
        if (translator.invert)
            print_reader("invert", {translator.invert, at}, unit_.type(translator.virtual_type), states);
        const std::string memory =
            i + 1 == structure_.via.size() && ir::stays_inside(unit_.program, structure_) ? "&memory" : "nullptr";
        if (memory != "nullptr") out_.line("const glift::Extent memory = glift::detail::limit_of(" + extent() + ");");
        out_.line(
            "return glift::check_translator(test, " + quoted(title + ": " + translator.display) + ", " +
            (i == 0 ? std::string("glift::tried(structure.domain(), residents)") : "reached_" + std::to_string(i - 1)) +
            ", translate, " + (translator.invert ? "invert" : "nullptr") + ", " +
            mapping_text(translator.properties, !needs.tables.empty()) + ", " + memory + ");");
        out_.close("();");
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
    // Of the functions that are printed:
    Needs needs_;
    std::vector<std::string> mirrors_, callees_;  ///< the names of needs_.tables and needs_.callees
    std::vector<std::string> names_;              ///< those that are taken
};

bool reads_tables(const ir::Program& program, const Structure& structure) {
    return std::ranges::any_of(structure.via,
                               [&](const ir::Stage& stage) { return !needs_of(program, stage).tables.empty(); });
}

/// Why the tables cannot be copied to the host; empty: they can.
std::string why_not_mirrored(const ir::Program& program, const Structure& structure, const Places& tables) {
    for (const ir::Place& place : tables) {
        const Structure& table = ir::structure_at(program, structure, place.members);
        if (table.kind == ir::StructureKind::computed && !table.domain)
            return "its table is " + table.display + ", a view without a domain";
    }
    return "";
}

/// Whether print_blocks can print the blocks of the structure.
bool lists_blocks(const ir::Program& program, const Structure& structure) {
    if (!structure.blocks) return false;
    const ir::Blocks& blocks = *structure.blocks;
    for (ir::FunctionId id : {blocks.count, blocks.first})
        if (!why_not_printed(program, id).empty()) return false;
    return why_not_mirrored(program, structure, needs_of(program, blocks).tables).empty();
}

/// Why the structure's translation cannot be checked at all; empty: it can.
std::string why_never(const ir::Program& program, const Structure& structure) {
    for (const ir::Stage& stage : structure.via) {
        const ir::Translator& translator = program.translators[stage.translator];
        if (std::string why = why_not_mirrored(program, structure, needs_of(program, stage).tables); !why.empty())
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

std::map<ir::StructureId, std::string> print_block_lists(Unit& unit, Writer& out) {
    std::map<ir::StructureId, std::string> names;
    for (ir::StructureId index : unit.reach.structures) {
        const Structure& structure = unit.program.structures[index];
        if (structure.kind != ir::StructureKind::stored || !lists_blocks(unit.program, structure)) continue;
        names[index] = unit.globals.names.declare("blocks_of_" + unit.class_name(index));
        CheckPrinter(unit, out, index).print_blocks(names[index]);
    }
    return names;
}

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
