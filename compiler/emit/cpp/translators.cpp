#include "emit/cpp/translators.h"

#include "emit/cpp/mentions.h"
#include "ir/chain.h"

#include <algorithm>
#include <optional>

namespace gliftc::cpp {

bool uses_state_elsewhere(const ir::Program& program, ir::FunctionId id) {
    bool found = false;
    ir::for_each_expression(program, program.functions[id].body, [&](ir::ExprId node) {
        const ir::Expr& expr = program.exprs[node];
        if (expr.op != ir::Op::call) return;
        ir::for_each_expression(program, program.functions[expr.function].body, [&](ir::ExprId node) {
            const ir::Expr& inner = program.exprs[node];
            found = found || inner.op == ir::Op::state;
        });
    });
    return found;
}

std::vector<std::string> print_state(Unit& unit, Writer& out, ir::StructureId structure, const ir::Stage& stage,
                                     const std::string& object, std::initializer_list<const char*> taken,
                                     const NameSet* hiding) {
    const ir::Translator& translator = unit.program.translators[stage.translator];
    Printer p(unit.globals);
    p.class_names = hiding;
    p.outer_expression = [&](const ir::Expr& expr) {
        return structure_property(unit.globals, expr, structure, object);
    };
    std::vector<std::string> states;
    Scopes names;
    names.avoid(unit.globals.type_names);
    names.avoid(unit.globals.class_names[structure].own);
    names.reserve(taken);
    for (std::size_t i = 0; i < stage.scalars.size(); ++i) {
        states.push_back(names.declare(unit.name(translator.scalars[i].name)));
        out.line("[[maybe_unused]] const " + unit.type(translator.scalars[i].type) + " " + states.back() + " = " +
                 print_any(p, stage.scalars[i]) + ";");
    }
    return states;
}

void print_method(Unit& unit, Writer& out, const std::string& name, ir::FunctionId id, const std::string& result,
                  const std::vector<std::string>& states,
                  const std::function<Text(Printer&, const ir::Expr&)>& surroundings, const NameSet* hiding) {
    const ir::Function& function = unit.program.functions[id];
    Printer p(unit.globals);
    p.class_names = hiding;
    for (const std::string& state : states) p.names.declare(state);
    std::string parameters;
    for (ir::LocalId local : function.params) {
        const std::string type = unit.type(unit.program.locals[local].type);
        parameters += (parameters.empty() ? "" : ", ") + (unused_mark(unit.program, function.body, local) + type) +
                      " " + declare_local(p, local);
    }
    p.outer_expression = [&](const ir::Expr& expr) -> Text {
        if (expr.op == ir::Op::state) return {states[expr.slot]};
        return surroundings ? surroundings(p, expr) : Text{"{}"};
    };
    if (surroundings) p.outer_call = [&](const ir::Expr& expr) { return surroundings(p, expr).text; };
    for (int depth = 0; depth <= out.depth(); ++depth) p.out.indent();
    print_statements(p, function.body);
    out.open("const auto " + name + " = [&](" + parameters + ") -> " + result);
    out.raw(p.out.take());
    out.close(";");
}

/// Whether a translator is a total affine map, not many-to-one, that reads no other structures, and whose function
/// print_method can print.
static bool is_plain_map(const ir::Program& program, const ir::Translator& translator) {
    return translator.properties.affine && !translator.properties.partial &&
           translator.properties.mapping != ir::Mapping::many_to_one && translator.structures.empty() &&
           !uses_state_elsewhere(program, translator.translate);
}

bool has_rows(const ir::Program& program, const ir::Structure& structure) {
    if (structure.kind != ir::StructureKind::stored || structure.via.size() > 1 || structure.field) return false;
    if (!ir::is_contained(program, structure)) return false;
    if (!structure.via.empty() && !is_plain_map(program, program.translators[structure.via[0].translator]))
        return false;
    if (!structure.base.empty()) return has_rows(program, ir::structure_at(program, structure, structure.base));
    const ir::Memory& memory = structure.memories[structure.via_memory];
    const bool is_number = program.types.is_number(program.types.scalar_of(structure.element)) ||
                           structure.element == program.types.bool_ ||
                           program.types.kind(structure.element) == ir::TypeKind::struct_;
    return memory.shape == ir::MemoryShape::buffer && memory.element == structure.element && is_number;
}

/// Whether the elements lie in buffers of the structure's own, all by the same index, which index_of() can compute.
static bool lies_by_index(const ir::Program& program, const ir::Structure& structure) {
    if (structure.kind != ir::StructureKind::stored || !structure.base.empty() || structure.field) return false;
    const bool are_buffers = std::ranges::all_of(structure.memories, [&](const ir::Memory& memory) {
        const bool is_number = program.types.is_number(program.types.scalar_of(memory.element)) ||
                               memory.element == program.types.bool_ ||
                               program.types.kind(memory.element) == ir::TypeKind::struct_;
        const bool holds_elements = memory.element == structure.element || !memory.fields.empty();
        return memory.shape == ir::MemoryShape::buffer && holds_elements && is_number;
    });
    return are_buffers && std::ranges::all_of(structure.via, [&](const ir::Stage& stage) {
               const ir::Translator& translator = program.translators[stage.translator];
               return translator.properties.mapping != ir::Mapping::many_to_one && translator.structures.empty() &&
                      !uses_state_elsewhere(program, translator.translate);
           });
}

namespace {

/// The structure of which another one is a component, of a component, …, and the path of fields that leads there.
struct ComponentPath {
    const ir::Structure* structure;
    std::vector<std::uint32_t> fields;
};

ComponentPath component_path(const ir::Program& program, const ir::Structure& structure) {
    ComponentPath whole{&structure, {}};
    while (whole.structure->field) {
        whole.fields.insert(whole.fields.begin(), *whole.structure->field);
        whole.structure = &program.structures[whole.structure->members[0].structure];
    }
    return whole;
}

/// The number of the memory that has a component's elements.
std::optional<std::size_t> memory_of(const ComponentPath& whole) {
    const std::vector<ir::Memory>& memories = whole.structure->memories;
    for (std::size_t i = 0; i < memories.size(); ++i)
        if (memories[i].fields.empty() || memories[i].fields == whole.fields) return i;
    return std::nullopt;
}

}  // namespace

bool has_indices(const ir::Program& program, const ir::Structure& structure) {
    if (!structure.field) return !has_rows(program, structure) && lies_by_index(program, structure);
    const ComponentPath whole = component_path(program, structure);
    return lies_by_index(program, *whole.structure) && memory_of(whole).has_value();
}

/// The structure of which a component is one, of a component, …, as an expression of the component's class.
struct WholeText {
    ir::StructureId structure;
    std::string text;
};

static WholeText whole_text(const Unit& unit, ir::StructureId component) {
    WholeText whole{component, ""};
    while (unit.program.structures[whole.structure].field) {
        whole.text += unit.globals.class_names[whole.structure].members[0] + "().";
        whole.structure = unit.program.structures[whole.structure].members[0].structure;
    }
    return whole;
}

std::string index_memory_of(const Unit& unit, ir::StructureId index) {
    const ir::Structure& structure = unit.program.structures[index];
    if (!structure.field) return structure.memories.size() == 1 ? rows_of(unit, index) : "";
    const WholeText whole = whole_text(unit, index);
    const std::size_t memory = *memory_of(component_path(unit.program, structure));
    return whole.text + unit.globals.class_names[whole.structure].memories[memory] + "()";
}

std::string rows_of(const Unit& unit, ir::StructureId index) {
    const ir::Structure& structure = unit.program.structures[index];
    if (structure.base.empty()) return unit.globals.class_names[index].memory_fields[structure.via_memory];
    ir::Expr base;
    base.op = ir::Op::structure_value;
    base.place.members = structure.base;
    return structure_property(unit.globals, base, index, "").text + ".row_memory()";
}

void print_place(Unit& unit, Writer& out, ir::StructureId index) {
    const ir::Structure& structure = unit.program.structures[index];
    out.open(unit.linkage(structure.key) + ("std::uint64_t " + unit.own_name(index)) + "::place(" +
             unit.type(structure.domain_type) + " address) const");
    std::string place = "address";
    if (!structure.via.empty()) {
        const ir::Stage& stage = structure.via[0];
        const ir::Translator& translator = unit.program.translators[stage.translator];
        const NameSet& hiding = unit.globals.class_names[index].all;
        const std::vector<std::string> states =
            print_state(unit, out, index, stage, "", {"address", "translate", "place"}, &hiding);
        const ir::FunctionId exact = stage.wide ? stage.wide : translator.translate;
        print_method(unit, out, "translate", exact, unit.type(unit.program.functions[exact].result), states, {},
                     &hiding);
        place = "translate(address)";
    }
    if (!structure.base.empty()) {
        ir::Expr base;
        base.op = ir::Op::structure_value;
        base.place.members = structure.base;
        place = structure_property(unit.globals, base, index, "").text + ".place(" + place + ")";
    }
    out.line("return " + place + ";");
    out.close();
    out.gap();
}

void print_index(Unit& unit, Writer& out, ir::StructureId index) {
    const ir::Structure& structure = unit.program.structures[index];
    out.open(unit.linkage(structure.key) + ("std::uint64_t " + unit.own_name(index)) + "::index_of(" +
             unit.type(structure.domain_type) + " address) const");
    const ClassNames& names = unit.globals.class_names[index];
    const NameSet& hiding = names.all;
    std::string at = "address";
    if (structure.field) {
        const WholeText whole = whole_text(unit, index);
        const bool rows = has_rows(unit.program, unit.program.structures[whole.structure]);
        out.line("return " + whole.text + (rows ? "place" : "index_of") + "(address);");
        out.close();
        out.gap();
        return;
    }
    for (std::size_t i = 0; i < structure.via.size(); ++i) {
        const ir::Stage& stage = structure.via[i];
        const ir::Translator& translator = unit.program.translators[stage.translator];
        const std::string step = "step_" + std::to_string(i);
        out.open("const auto " + step + " = [&](auto address)");
        const std::vector<std::string> states =
            print_state(unit, out, index, stage, "", {"address", "translate", "step_0", "step_1", "step_2"}, &hiding);
        const ir::FunctionId exact = stage.wide ? stage.wide : translator.translate;
        print_method(unit, out, "translate", exact, unit.type(unit.program.functions[exact].result), states, {},
                     &hiding);
        out.line("return translate(address);");
        out.close(";");
        out.line("const auto at_" + std::to_string(i) + " = " + step + "(" + at + ");");
        at = "at_" + std::to_string(i);
        if (translator.properties.partial) {
            out.line("if (!" + at + ") return UINT64_MAX;");
            at = "*" + at;
        }
    }
    out.line("return " + at + ";");
    out.close();
    out.gap();
}

}  // namespace gliftc::cpp
