// long: the parts of a class, in their order
// Structures as classes.
#include "emit/cpp/translators.h"
#include "emit/cpp/unit.h"
#include "ir/chain.h"
#include "ir/effects.h"
#include "ir/evaluate.h"

#include <algorithm>
#include <cmath>

namespace gliftc::cpp {

namespace {

using ir::Structure;
using ir::StructureKind;

/// One constructor of a class: its parameters as they are declared, and the default arguments of the last ones.
struct Constructor {
    std::vector<std::string> parameters;
    std::vector<std::string> defaults;

    std::size_t required() const { return parameters.size() - defaults.size(); }
    std::string text() const { return text_of(0); }
    std::string text_with_defaults() const { return text_of(defaults.size()); }

private:
    std::string text_of(std::size_t defaulted) const {
        std::string all;
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            all += (all.empty() ? "" : ", ") + parameters[i];
            if (i + defaulted >= parameters.size()) all += " = " + defaults[i - required()];
        }
        return all;
    }
};

Constructor constructor_of(const Unit& unit, ir::StructureId index, const ClassNames& names, bool qualified) {
    const Structure& structure = unit.program.structures[index];
    Constructor result;
    if (ir::takes_commands(unit.program, structure)) result.parameters.push_back("const glift::Commands& commands");
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        if (structure.members[i].by_reference)
            result.parameters.push_back("const " + unit.class_name(structure.members[i].structure) + "& " +
                                        names.members[i]);
    }
    for (std::size_t i = 0; i < structure.constructor.size(); ++i)
        result.parameters.push_back(unit.type(unit.program.locals[structure.constructor[i]].type, qualified) + " " +
                                    names.arguments[i]);
    return result;
}

std::string base_of(const Unit& unit, ir::StructureId index) {
    const Structure& structure = unit.program.structures[index];
    const std::string arguments = "<" + unit.own_name(index) + ", " + unit.type(structure.domain_type, true) + ", " +
                                  storage_text(unit.globals, structure.element, true) + ">";
    switch (structure.kind) {
    case StructureKind::stored: return " : public glift::Structure" + arguments;
    case StructureKind::computed: return " : public glift::View" + arguments;
    case StructureKind::no_elements: return "";
    }
    return "";
}

/// Whether boxes of the structure can be copied to the host, and back if ir::is_written_in_boxes. Every definition of
/// the class declares the functions that copy; only modules whose code may copy boxes define them (Reach::moved).
bool has_transfers(const Structure& structure) {
    return structure.kind == StructureKind::stored || (structure.kind == StructureKind::computed && structure.domain);
}

/// The type of a memory's extent: a number of 64 bits for the elements of a buffer, 32 bits along each axis of an
/// image.
std::string extent_type(const Unit& unit, const ir::Memory& memory, bool qualified) {
    if (memory.shape == ir::MemoryShape::buffer) return "std::uint64_t";
    const ir::TypeId type = unit.program.exprs[memory.extent].type;
    const std::uint32_t axes = unit.program.types.components(type);
    return (qualified ? "glift::uint" : "uint") + (axes == 1 ? "" : std::to_string(axes));
}

/// A number that is computed in 64 bits, as one of 32 bits; `what` names it in the error if it is too large.
std::string fitted(Printer& p, ir::ExprId id, const std::string& what) {
    return "glift::fitted(" + print_any(p, id) + ", " + quoted(what) + ")";
}

bool is_exact(const Unit& unit, ir::ExprId id) {
    const ir::Types& types = unit.program.types;
    return types.scalar_of(unit.program.exprs[id].type) == types.uint64;
}

std::string extent_value(Unit& unit, Printer& p, const std::string& owner, const ir::Memory& memory) {
    if (memory.shape == ir::MemoryShape::buffer || !is_exact(unit, memory.extent)) return print_any(p, memory.extent);
    return fitted(p, memory.extent, owner + "." + unit.name(memory.name));
}

/// Whether the class itself knows its device; those of stored structures have it from glift::Structure.
bool has_device_field(const Structure& structure) {
    return structure.is_container && structure.kind != StructureKind::stored;
}

/// Whether a member has a non-const accessor beside the const one: the member is the structure's memory, or contains
/// it, or was given to the structure, so that others may use it, too. (In containers all members have both.)
bool is_written_as(const Structure& structure, std::size_t member) {
    return structure.members[member].by_reference || (!structure.base.empty() && structure.base[0] == member);
}

/// The accessors of a memory that is a member with another name: `memory frames = pool;`.
void print_base(const Unit& unit, Writer& out, ir::StructureId index, const ClassNames& names) {
    if (names.base.empty()) return;
    const Structure& structure = unit.program.structures[index];
    ir::Expr whole;
    whole.op = ir::Op::structure_value;
    whole.place.members = structure.base;
    ir::StructureId base = index;
    for (std::uint32_t member : structure.base) base = unit.program.structures[base].members[member].structure;
    const std::string where = "return " + structure_property(unit.globals, whole, index, "").text + "; }";
    out.line("const " + unit.class_name(base) + "& " + names.base + "() const { " + where);
    if (structure.base.size() == 1) out.line(unit.class_name(base) + "& " + names.base + "() { " + where);
}

void print_accessors(Unit& unit, Writer& out, ir::StructureId index, const ClassNames& names) {
    constexpr bool qualified = true;
    const Structure& structure = unit.program.structures[index];
    for (std::size_t i = 0; i < structure.constructor.size(); ++i)
        out.line(unit.type(unit.program.locals[structure.constructor[i]].type, qualified) + " " + names.arguments[i] +
                 "() const { return " + names.argument_fields[i] + "; }");
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const ir::MemberStructure& member = structure.members[i];
        if (member.is_component) {  // an alias of its class comes after this class
            out.line(unit.own_name(member.structure) + " " + names.members[i] + "() const;");
            continue;
        }
        const std::string& type = unit.class_name(member.structure);
        const std::string field = names.member_fields[i] + (is_held_by_handle(structure, i) ? ".get()" : "");
        out.line("const " + type + "& " + names.members[i] + "() const { return " + field + "; }");
        if (structure.is_container || is_written_as(structure, i))
            out.line(type + "& " + names.members[i] + "() { return " + field + "; }");
    }
    print_base(unit, out, index, names);
    for (std::size_t i = 0; i < structure.memories.size(); ++i) {
        out.line("const glift::Memory& " + names.memories[i] + "() const { return " + names.memory_fields[i] + "; }");
        out.line(extent_type(unit, structure.memories[i], qualified) + " " + names.extents[i] + "() const { return " +
                 names.extent_fields[i] + "; }");
    }
    for (std::size_t i = 0; i < structure.host.size(); ++i)
        out.line(unit.type(structure.host[i].type, qualified) + " " + names.host[i] + "() const { return " +
                 names.host_fields[i] + ".get(); }");
}

std::string field_type(const Unit& unit, const Structure& structure, std::size_t member) {
    const std::string& type = unit.class_name(structure.members[member].structure);
    return is_held_by_handle(structure, member) ? "glift::Shared<" + type + ">" : type;
}

void print_fields(Unit& unit, Writer& out, ir::StructureId index, const ClassNames& names) {
    constexpr bool qualified = true;
    const Structure& structure = unit.program.structures[index];
    if (has_device_field(structure)) out.line("glift::Device device_;");
    for (std::size_t i = 0; i < structure.constructor.size(); ++i)
        out.line(unit.type(unit.program.locals[structure.constructor[i]].type, qualified) + " " +
                 names.argument_fields[i] + "{};");
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        if (!structure.members[i].is_component)
            out.line(field_type(unit, structure, i) + " " + names.member_fields[i] + ";");
    for (std::size_t i = 0; i < structure.memories.size(); ++i) {
        out.line(extent_type(unit, structure.memories[i], qualified) + " " + names.extent_fields[i] + "{};");
        out.line("glift::Memory " + names.memory_fields[i] + ";");
    }
    for (std::size_t i = 0; i < structure.host.size(); ++i)
        out.line("glift::Shared<" + unit.type(structure.host[i].type, qualified) + "> " + names.host_fields[i] + ";");
}

std::string memory_parameters(const Unit& unit, ir::StructureId index, const ClassNames& names) {
    std::string text;
    const Structure& structure = unit.program.structures[index];
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        if (!is_held(structure.members[i])) continue;
        text += ", " + unit.class_name(structure.members[i].structure) + " " + names.members[i];
    }
    for (std::size_t i = 0; i < structure.memories.size(); ++i)
        if (!structure.memories[i].part) text += ", glift::Memory " + names.memories[i];
    return text;
}

bool is_own(const ir::Memory& memory) { return !memory.part; }

bool has_own_memory(const Structure& structure) { return std::ranges::any_of(structure.memories, is_own); }

bool has_own_member(const Structure& structure) { return std::ranges::any_of(structure.members, is_held); }

bool has_parts(const Structure& structure) {
    return structure.kind == StructureKind::stored && (has_own_memory(structure) || has_own_member(structure));
}

/// What the constructor of a structure that has_parts may be given instead of making it.
std::string parts_text(const Structure& structure) {
    if (!has_own_member(structure)) return "memory";
    return has_own_memory(structure) ? "nested structures and memory" : "nested structures";
}

/// The glift::MemoryDescription of a memory.
std::string memory_description(Unit& unit, Printer& p, ir::StructureId index, std::size_t i, const ClassNames& names) {
    const ir::Memory& memory = unit.program.structures[index].memories[i];
    const std::string& extent = names.extent_fields[i];
    std::string text = "{.name = " + quoted(unit.program.structures[index].display + "." + unit.name(memory.name));
    const std::string mips = memory.mips ? ", .mips = " + print_any(p, memory.mips) : "";
    switch (memory.shape) {
    case ir::MemoryShape::buffer:
        return text + ", .bytes = glift::buffer_bytes<" + storage_text(unit.globals, memory.element) + ">(" + extent +
               ")}";
    case ir::MemoryShape::image1d: text += ", .kind = glift::MemoryKind::image1d"; break;
    case ir::MemoryShape::image2d: text += ", .kind = glift::MemoryKind::image2d"; break;
    case ir::MemoryShape::image3d: text += ", .kind = glift::MemoryKind::image3d"; break;
    case ir::MemoryShape::imagecube: text += ", .kind = glift::MemoryKind::imagecube"; break;
    case ir::MemoryShape::image2darray: text += ", .kind = glift::MemoryKind::image2darray"; break;
    }
    return text + ", .format = glift::Format::" + std::string(format_name(memory.format)) +
           ", .extent = glift::" + (memory.shape == ir::MemoryShape::imagecube ? "cube_extent(" : "image_extent(") +
           extent + ")" + mips + "}";
}

/// A printer for expressions over the structure itself, within its class.
Printer own_printer(Unit& unit, ir::StructureId index) {
    Printer p(unit.globals);
    p.class_names = &unit.globals.class_names[index].all;
    p.outer_expression = [&unit, index](const ir::Expr& expr) {
        return structure_property(unit.globals, expr, index, "");
    };
    return p;
}

/// The expression for a memory of a structure that is being made: a new memory, one that exists already, or a part of
/// another structure's.
std::string memory_value(Unit& unit, Printer& p, ir::StructureId index, std::size_t i, const ClassNames& names,
                         bool adopts) {
    const ir::Memory& memory = unit.program.structures[index].memories[i];
    if (!memory.part)
        return std::string("commands.") + (adopts ? "adopt(std::move(" + names.memories[i] + "), " : "allocate(") +
               memory_description(unit, p, index, i, names) + ")";
    ir::Expr whole;
    whole.op = ir::Op::structure_value;
    whole.place = memory.part->of;
    ir::StructureId of = index;
    for (std::uint32_t member : whole.place.members) of = unit.program.structures[of].members[member].structure;
    const char* const part = memory.part->kind == ir::ImagePart::Kind::mip ? "mip" : "layer";
    return p.outer_expression(whole).text + "." + unit.globals.class_names[of].memories[memory.part->slot] + "()." +
           part + "(" + print_any(p, memory.part->number) + ")";
}

/// An argument that a structure gives to one of its members. A value that is computed in 64 bits is narrowed, which
/// throws where it does not fit.
std::string argument_of_part(Unit& unit, Printer& p, const ir::MemberStructure& member, std::size_t i,
                             const std::string& part) {
    const ir::ExprId argument = member.arguments[i];
    const Structure& made = unit.program.structures[member.structure];
    if (unit.program.exprs[argument].type == unit.program.locals[made.constructor[i]].type)
        return print(p, argument, Level::relation);
    return fitted(p, argument, part);
}

/// The default of a constructor's argument; empty if C++ has to give the argument: the default depends on others, or is
/// no zero, and no scalar or vector either, or one of halves.
std::string default_argument(Unit& unit, ir::StructureId index, ir::ExprId value) {
    const std::optional<ir::Value> known = value ? ir::evaluate(unit.program, value) : std::nullopt;
    if (!known) return "";
    const auto is_zero = [](const ir::Lane& lane) {
        return lane.bits == 0 && lane.number == 0 && !std::signbit(lane.number);
    };
    if (std::ranges::all_of(known->lanes, is_zero)) return "{}";
    const ir::Types& types = unit.program.types;
    const bool is_vector = types.is_vector(known->type);
    if ((!types.is_scalar(known->type) && !is_vector) || types.scalar_of(known->type) == types.half) return "";
    Printer p = own_printer(unit, index);
    return (is_vector ? "glift::" : "") + print_any(p, value);
}

/// Gives the last parameters their defaults. One parameter is left without: `Type()` makes an empty handle.
void add_defaults(Unit& unit, ir::StructureId index, Constructor& constructor) {
    const std::vector<ir::ExprId>& defaults = unit.program.structures[index].defaults;
    for (std::size_t i = defaults.size(); i > 0 && constructor.required() > 1; --i) {
        const std::string text = default_argument(unit, index, defaults[i - 1]);
        if (text.empty()) return;
        constructor.defaults.insert(constructor.defaults.begin(), text);
    }
}

/// Like own_printer, for functions of the class whose parameters have names from the source.
Printer method_printer(Unit& unit, ir::StructureId index) {
    Printer p = own_printer(unit, index);
    p.names.reserve({"commands"});
    p.names.avoid(unit.globals.class_names[index].own);
    return p;
}

std::string member_value(Unit& unit, Printer& p, const std::string& owner, const ir::MemberStructure& member) {
    const Structure& made = unit.program.structures[member.structure];
    std::string arguments = ir::takes_commands(unit.program, made) ? "commands" : "";
    for (const ir::Place& place : member.structures) {
        ir::Expr whole;
        whole.op = ir::Op::structure_value;
        whole.place = place;
        arguments += (arguments.empty() ? "" : ", ") + p.outer_expression(whole).text;
    }
    for (std::size_t i = 0; i < member.arguments.size(); ++i) {
        arguments += (arguments.empty() ? "" : ", ") +
                     argument_of_part(unit, p, member, i, owner + "." + unit.name(member.name));
    }
    return unit.class_name(member.structure) + "(" + arguments + ")";
}

/// The value of a member that is given to the constructor, with the check that it was made with the values that the
/// structure would have given it; structures that it was made with are not compared.
std::string adopted_part(Unit& unit, Printer& p, ir::StructureId index, std::size_t i, const ClassNames& names) {
    const ir::MemberStructure& member = unit.program.structures[index].members[i];
    const ClassNames& made = unit.globals.class_names[member.structure];
    std::string alike;
    for (std::size_t k = 0; k < member.arguments.size(); ++k)
        alike += (alike.empty() ? "" : " && ") + names.members[i] + "." + made.arguments[k] + "() == " +
                 argument_of_part(unit, p, member, k, unit.program.structures[index].display + "." + names.members[i]);
    return "glift::detail::part(std::move(" + names.members[i] + "), " + (alike.empty() ? "true" : alike) + ", " +
           quoted(unit.program.structures[index].display + "." + names.members[i]) + ")";
}

void print_constructors(Unit& unit, Writer& out, ir::StructureId index, const ClassNames& names) {
    const Structure& structure = unit.program.structures[index];
    const std::string& type = unit.own_name(index);
    Printer p = own_printer(unit, index);
    const auto head = [&](const std::string& more, bool adopts) {
        std::vector<std::string> initialisers;
        const std::string device = structure.field ? names.members[0] + ".device()" : "commands.device()";
        if (structure.kind == StructureKind::stored) initialisers.push_back("Structure(" + device + ")");
        if (has_device_field(structure)) initialisers.push_back("device_(commands.device())");
        for (std::size_t i = 0; i < names.arguments.size(); ++i)
            initialisers.push_back(names.argument_fields[i] + "(" + names.arguments[i] + ")");
        for (std::size_t i = 0; i < structure.members.size(); ++i) {
            const ir::MemberStructure& member = structure.members[i];
            if (member.is_component) continue;
            const std::string value = member.by_reference ? names.members[i]
                                      : adopts            ? adopted_part(unit, p, index, i, names)
                                                          : member_value(unit, p, structure.display, member);
            initialisers.push_back(names.member_fields[i] + "(" + value + ")");
        }
        for (std::size_t i = 0; i < structure.memories.size(); ++i) {
            initialisers.push_back(names.extent_fields[i] + "(" +
                                   extent_value(unit, p, structure.display, structure.memories[i]) + ")");
            initialisers.push_back(names.memory_fields[i] + "(" + memory_value(unit, p, index, i, names, adopts) + ")");
        }
        for (std::size_t i = 0; i < structure.host.size(); ++i) {
            if (structure.host[i].initial)
                initialisers.push_back(names.host_fields[i] + "(" + print_any(p, structure.host[i].initial) + ")");
        }
        out.line(unit.linkage(structure.key) + type + "::" + type + "(" +
                 constructor_of(unit, index, names, false).text() + more + ")");
        out.indent();
        for (std::size_t i = 0; i < initialisers.size(); ++i)
            out.line((i == 0 ? ": " : "  ") + initialisers[i] + (i + 1 < initialisers.size() ? "," : " {}"));
        if (initialisers.empty()) out.line("{}");
        out.dedent();
        out.gap();
    };
    if (!constructor_of(unit, index, names, false).parameters.empty()) head("", false);  // else = default in the class
    if (has_parts(structure)) head(memory_parameters(unit, index, names), true);
}

void print_same_state(Unit& unit, Writer& out, ir::StructureId index, const ClassNames& names) {
    std::string condition;
    const auto also = [&](const std::string& text) { condition += (condition.empty() ? "" : " && ") + text; };
    for (const std::string& field : names.argument_fields) also(field + " == other." + field);
    for (std::size_t i = 0; i < names.member_fields.size(); ++i) {
        if (unit.program.structures[index].members[i].is_component) continue;
        const bool is_handle = is_held_by_handle(unit.program.structures[index], i);
        const std::string field = names.member_fields[i] + (is_handle ? ".get()" : "");
        also(field + ".same_state(other." + field + ")");
    }
    const std::string& type = unit.own_name(index);
    out.open(unit.linkage(unit.program.structures[index].key) + ("bool " + type) + "::same_state(const " + type +
             "& other) const");
    out.line(condition.empty() ? "return this == &other || true;" : "return " + condition + ";");
    out.close();
    out.gap();
}

/// Prints the function of the whole's class that makes the component.
void print_maker(Unit& unit, Writer& out, ir::StructureId component) {
    const Structure& structure = unit.program.structures[component];
    const ir::StructureId whole = structure.members[0].structure;
    const std::vector<ir::MemberStructure>& members = unit.program.structures[whole].members;
    const auto own = std::ranges::find(members, component, &ir::MemberStructure::structure);
    const std::string& name = unit.globals.class_names[whole].members[static_cast<std::size_t>(own - members.begin())];
    const std::string& type = unit.own_name(component);
    out.open(unit.linkage(structure.key) + type + " " + unit.own_name(whole) + "::" + name + "() const");
    out.line("return " + type + "(*this);");
    out.close();
    out.gap();
}

}  // namespace

/// The parameters of a method as they are declared. Methods that read memory run a pass, so they take commands, too.
static std::string method_parameters(Unit& unit, Printer& p, const ir::Method& method, bool qualified) {
    std::string text = method.pipeline ? "const glift::Commands& commands" : "";
    for (ir::LocalId local : unit.program.functions[method.function].params)
        text += (text.empty() ? "" : ", ") + unit.type(unit.program.locals[local].type, qualified) + " " +
                declare_local(p, local);
    return text;
}

static void print_methods(Unit& unit, Writer& out, ir::StructureId index) {
    const Structure& structure = unit.program.structures[index];
    for (std::size_t i = 0; i < structure.methods.size(); ++i) {
        const ir::Method& method = structure.methods[i];
        const ir::Function& function = unit.program.functions[method.function];
        Printer p = method_printer(unit, index);
        out.open(unit.linkage(structure.key) + unit.type(function.result) + " " + unit.own_name(index) +
                 "::" + unit.globals.class_names[index].methods[i] + "(" + method_parameters(unit, p, method, false) +
                 ") const");
        std::string arguments = method.pipeline ? "commands, *this" : "*this";
        for (ir::LocalId local : function.params) arguments += ", " + p.local_names.at(local);
        if (!method.pipeline) require_function(unit.globals, method.function);
        const std::string& called = method.pipeline ? unit.globals.pipeline_names[method.pipeline]
                                                    : unit.globals.function_names.at(method.function);
        out.line("return " + visible(p, called) + "(" + arguments + ")" +
                 (method.pipeline ? ".await(commands);" : ";"));
        out.close();
        out.gap();
    }
}
// long: the members of a generated class, in their order
void print_class(Unit& unit, Writer& out, ir::StructureId index) {
    const Structure& structure = unit.program.structures[index];
    const ClassNames& names = unit.globals.class_names[index];
    const std::string& type = unit.own_name(index);
    const bool is_instance = structure.display != unit.name(structure.name);
    for (const ir::MemberStructure& member : structure.members)
        if (member.is_component) out.line("class " + unit.own_name(member.structure) + ";");
    if (structure.doc.empty())
        out.line("/// " + structure.display + ", " + place_text(unit.sources, structure.span) + ".");
    else write_doc(out, is_instance ? structure.display + ". " + structure.doc : structure.doc);
    out.open("class " + type + base_of(unit, index));
    out.dedent();
    out.line("public:");
    out.indent();
    out.line("static constexpr const char* type_name = " + quoted(structure.display) + ";");
    out.gap();
    out.line(type + "() = default;");
    Constructor constructor = constructor_of(unit, index, names, true);
    add_defaults(unit, index, constructor);
    if (!constructor.parameters.empty())
        out.line((constructor.required() == 1 ? "explicit " : "") + type + "(" + constructor.text_with_defaults() +
                 ");");
    if (has_parts(structure)) {
        out.line("/// Makes the structure with the given " + parts_text(structure) + ".");
        out.line(type + "(" + constructor.text() + memory_parameters(unit, index, names) + ");");
    }
    out.gap();
    if (structure.kind != StructureKind::no_elements)
        out.line(unit.type(structure.domain_type, true) + " domain() const;");
    if (has_device_field(structure)) {
        out.open("const glift::Device& device() const");
        out.line("if (!device_) glift::detail::throw_empty_structure(type_name, \"device\");");
        out.line("return device_;");
        out.close();
    }
    print_accessors(unit, out, index, names);
    out.line("bool same_state(const " + type + "& other) const;");
    if (has_transfers(structure)) {
        const bool is_written = ir::is_written_in_boxes(unit.program, index);
        out.gap();
        if (is_written) {
            const std::string element = unit.type(structure.element, true);
            out.line("void fill(" + element + " value);");
            out.line("void fill(" + element + " value, const glift::Range<" + type + ">& range);");
        }
        const std::string parameters = "(const glift::Commands& commands, const glift::Range<" + type +
                                       ">& range, const glift::Memory& box) const;";
        if (has_rows(unit.program, structure)) {
            out.line("std::uint64_t place(" + unit.type(structure.domain_type, true) + " address) const;");
            out.line("const glift::Memory& row_memory() const { return " + rows_of(unit, index) + "; }");
        }
        if (structure.blocks) {
            out.line("/// The extent of every block.");
            out.line(unit.type(structure.domain_type, true) + " block_extent() const;");
        }
        if (has_indices(unit.program, structure)) {
            out.line("std::uint64_t index_of(" + unit.type(structure.domain_type, true) + " address) const;");
            if (const std::string memory = index_memory_of(unit, index); !memory.empty())
                out.line("const glift::Memory& index_memory() const { return " + memory + "; }");
        }
        out.line("void copy_out" + parameters);
        if (is_written) out.line("void copy_in" + parameters);
        print_list_declaration(unit, out, index);
    }
    print_description(unit, out, index);
    print_state_visit(unit, out, index);
    for (ir::PipelineId pipeline : structure.pipelines) {
        out.gap();
        write_doc(out, unit.program.pipelines[pipeline].doc);
        out.line(pipeline_signature(unit, pipeline, true) + ";");
    }
    for (std::size_t i = 0; i < structure.methods.size(); ++i) {
        const ir::Function& function = unit.program.functions[structure.methods[i].function];
        Printer p = method_printer(unit, index);
        out.gap();
        write_doc(out, function.doc);
        out.line(unit.type(function.result, true) + " " + names.methods[i] + "(" +
                 method_parameters(unit, p, structure.methods[i], true) + ") const;");
    }
    out.gap();
    out.dedent();
    out.line("private:");
    out.indent();
    print_fields(unit, out, index, names);
    out.close(";");
    out.gap();
}

void print_class_members(Unit& unit, Writer& out, ir::StructureId index) {
    const Structure& structure = unit.program.structures[index];
    const ClassNames& names = unit.globals.class_names[index];
    print_constructors(unit, out, index, names);
    if (structure.kind != StructureKind::no_elements) {
        Printer p = own_printer(unit, index);
        out.open(unit.linkage(structure.key) + unit.type(structure.domain_type) + " " + unit.own_name(index) +
                 "::domain() const");
        out.line("return " + (structure.domain ? print_any(p, structure.domain) : std::string("{}")) + ";");
        out.close();
        out.gap();
    }
    print_same_state(unit, out, index, names);
    if (structure.field) print_maker(unit, out, index);
    if (has_rows(unit.program, structure)) print_place(unit, out, index);
    if (has_transfers(structure) && structure.blocks) {
        Printer p = own_printer(unit, index);
        out.open(unit.linkage(structure.key) + unit.type(structure.domain_type) + " " + unit.own_name(index) +
                 "::block_extent() const");
        out.line("return " + print_any(p, structure.blocks->extent) + ";");
        out.close();
        out.gap();
    }
    if (has_transfers(structure) && has_indices(unit.program, structure)) print_index(unit, out, index);
    print_methods(unit, out, index);
}

}  // namespace gliftc::cpp
