#include "emit/json/words.h"

#include "ir/effects.h"
#include "ir/evaluate.h"
#include "ir/levels.h"

namespace gliftc::json {

using ir::Expr;
using ir::ExprId;
using ir::Op;

const char* word(ir::MemoryShape shape) {
    switch (shape) {
    case ir::MemoryShape::buffer: return "buffer";
    case ir::MemoryShape::image1d: return "image1d";
    case ir::MemoryShape::image2d: return "image2d";
    case ir::MemoryShape::image3d: return "image3d";
    case ir::MemoryShape::imagecube: return "imagecube";
    case ir::MemoryShape::image2darray: return "image2darray";
    }
    return "";
}

const char* word(ir::Format format) {
    switch (format) {
    case ir::Format::none: return "none";
    case ir::Format::r8: return "r8";
    case ir::Format::rg8: return "rg8";
    case ir::Format::rgba8: return "rgba8";
    case ir::Format::r16f: return "r16f";
    case ir::Format::rg16f: return "rg16f";
    case ir::Format::rgba16f: return "rgba16f";
    case ir::Format::r32f: return "r32f";
    case ir::Format::rg32f: return "rg32f";
    case ir::Format::rgba32f: return "rgba32f";
    case ir::Format::r8ui: return "r8ui";
    case ir::Format::r16ui: return "r16ui";
    case ir::Format::r32ui: return "r32ui";
    case ir::Format::rg32ui: return "rg32ui";
    case ir::Format::rgba32ui: return "rgba32ui";
    case ir::Format::r32i: return "r32i";
    case ir::Format::rg32i: return "rg32i";
    case ir::Format::rgba32i: return "rgba32i";
    case ir::Format::rgba8ui: return "rgba8ui";
    case ir::Format::d32: return "d32";
    }
    return "";
}

const char* word(ir::Access access) {
    switch (access) {
    case ir::Access::read: return "read";
    case ir::Access::write: return "write";
    case ir::Access::read_write: return "read_write";
    }
    return "";
}

const char* word(ir::Direction direction) {
    switch (direction) {
    case ir::Direction::in: return "in";
    case ir::Direction::out: return "out";
    case ir::Direction::inout: return "inout";
    }
    return "";
}

const char* word(ir::Pattern pattern) { return ir::traits_of(pattern).name; }

const char* word(ir::Combine combine) {
    switch (combine) {
    case ir::Combine::replace: return "any";
    case ir::Combine::min: return "min";
    case ir::Combine::max: return "max";
    case ir::Combine::add: return "add";
    case ir::Combine::bit_and: return "and";
    case ir::Combine::bit_or: return "or";
    case ir::Combine::bit_xor: return "xor";
    }
    return "";
}

const char* word(ir::StructureKind kind) {
    switch (kind) {
    case ir::StructureKind::stored: return "structure";
    case ir::StructureKind::computed: return "view";
    case ir::StructureKind::no_elements: return "container";
    }
    return "";
}

const char* word(ir::ParameterSource source) {
    switch (source) {
    case ir::ParameterSource::uniform: return "uniform";
    case ir::ParameterSource::origin: return "origin";
    case ir::ParameterSource::size: return "size";
    case ir::ParameterSource::range_size: return "range_size";
    case ir::ParameterSource::address: return "address";
    case ir::ParameterSource::index: return "index";
    case ir::ParameterSource::base: return "base";
    }
    return "";
}

const char* word(ir::HostPattern pattern) {
    switch (pattern) {
    case ir::HostPattern::value: return "value";
    case ir::HostPattern::structure: return "structure";
    case ir::HostPattern::range: return "range";
    }
    return "";
}

const char* word(ir::Mapping mapping) {
    switch (mapping) {
    case ir::Mapping::unknown: return "not known";
    case ir::Mapping::claimed_one_to_one: return "claimed one-to-one";
    case ir::Mapping::many_to_one: return "many-to-one";
    }
    return "";
}

namespace {

const char* sign_of(ir::BinaryOp op) {
    switch (op) {
    case ir::BinaryOp::multiply: return "*";
    case ir::BinaryOp::divide: return "/";
    case ir::BinaryOp::remainder: return "%";
    case ir::BinaryOp::add: return "+";
    case ir::BinaryOp::subtract: return "-";
    case ir::BinaryOp::shift_left: return "<<";
    case ir::BinaryOp::shift_right: return ">>";
    case ir::BinaryOp::less: return "<";
    case ir::BinaryOp::less_equal: return "<=";
    case ir::BinaryOp::greater: return ">";
    case ir::BinaryOp::greater_equal: return ">=";
    case ir::BinaryOp::equal: return "==";
    case ir::BinaryOp::not_equal: return "!=";
    case ir::BinaryOp::bit_and: return "&";
    case ir::BinaryOp::bit_xor: return "^";
    case ir::BinaryOp::bit_or: return "|";
    case ir::BinaryOp::logical_and: return "&&";
    case ir::BinaryOp::logical_or: return "||";
    }
    return "?";
}

struct Speller {
    const ir::Program& program;
    const std::vector<Root>& roots;

    std::string name(Name name) const { return (*program.names)[name]; }

    std::string joined(const ir::Operands& operands) const {
        std::string text;
        for (ExprId operand : operands) text += (text.empty() ? "" : ", ") + spell(operand);
        return text;
    }

    std::string grouped(ExprId id) const {
        Op op = program.exprs[id].op;
        std::string text = spell(id);
        return op == Op::binary || op == Op::select ? "(" + text + ")" : text;
    }

    std::string dotted(const ir::Place& place, const std::string& member) const {
        std::string where = place_text(program, roots, place);
        return where.empty() ? member : where + "." + member;
    }

    ir::StructureId structure_of(const ir::Place& place) const { return structure_at(program, roots, place); }

    std::string swizzled(const Expr& expr) const {
        std::string text = grouped(expr.operands[0]) + ".";
        for (std::uint32_t i = 0; i < program.types.components(expr.type); ++i) text += "xyzw"[expr.lanes[i]];
        return text;
    }

    std::string spell(ExprId id) const;
};

std::string Speller::spell(ExprId id) const {
    if (auto value = ir::evaluate(program, id)) return ir::to_text(program, *value);
    const Expr& expr = program.exprs[id];
    switch (expr.op) {
    case Op::local: return name(program.locals[expr.local].name);
    case Op::construct:
    case Op::convert: return ir::to_text(program, expr.type) + "(" + joined(expr.operands) + ")";
    case Op::unary:
        return (expr.unary == ir::UnaryOp::minus         ? "-"
                : expr.unary == ir::UnaryOp::logical_not ? "!"
                                                         : "~") +
               grouped(expr.operands[0]);
    case Op::binary: return grouped(expr.operands[0]) + " " + sign_of(expr.binary) + " " + grouped(expr.operands[1]);
    case Op::select: return "select(" + joined(expr.operands) + ")";
    case Op::swizzle: return swizzled(expr);
    case Op::index: return grouped(expr.operands[0]) + "[" + spell(expr.operands[1]) + "]";
    case Op::call: return name(program.functions[expr.function].name) + "(" + joined(expr.operands) + ")";
    case Op::intrinsic: return std::string(ir::name_of(expr.intrinsic)) + "(" + joined(expr.operands) + ")";
    case Op::member:
        return dotted(expr.place,
                      name(program.locals[program.structures[structure_of(expr.place)].constructor[expr.slot]].name));
    case Op::memory_extent:
        return dotted(expr.place,
                      name(program.structures[structure_of(expr.place)].memories[expr.slot].name) + ".extent");
    case Op::host_state:
        return dotted(expr.place, name(program.structures[structure_of(expr.place)].host[expr.slot].name));
    case Op::domain: return dotted(expr.place, "domain");
    case Op::field: {
        const ir::Type& of = program.types[program.exprs[expr.operands[0]].type];
        return grouped(expr.operands[0]) + "." + name(program.structs[of.struct_].fields[expr.slot].name);
    }
    case Op::none: return "none";
    case Op::some:
    case Op::value: return spell(expr.operands[0]);
    case Op::has_value: return grouped(expr.operands[0]) + " != none";
    case Op::constant:
#define STRUCTURE_OPERATION(name) case Op::name:
#define GUARDED_OPERATION(name) case Op::name:
#define HOST_OPERATION(name) case Op::name:
#define MEMORY_OPERATION(name) case Op::name:
#define CPU_OPERATION(name) case Op::name:
#include "ir/operations.def"
        break;
    }
    ir::misplaced(expr.op, "emit/json: a uniform value");
}

}  // namespace

ir::StructureId structure_at(const ir::Program& program, const std::vector<Root>& roots, const ir::Place& place) {
    ir::StructureId structure = roots.at(place.root).structure;
    for (std::uint32_t member : place.members) structure = program.structures[structure].members[member].structure;
    return structure;
}

std::string place_text(const ir::Program& program, const std::vector<Root>& roots, const ir::Place& place) {
    std::string text = roots.at(place.root).name;
    ir::StructureId structure = roots.at(place.root).structure;
    for (std::uint32_t member : place.members) {
        const ir::MemberStructure& m = program.structures[structure].members[member];
        text += (text.empty() ? "" : ".") + (*program.names)[m.name];
        structure = m.structure;
    }
    return text;
}

std::string expression_text(const ir::Program& program, ExprId expr, const std::vector<Root>& roots) {
    return Speller{program, roots}.spell(expr);
}

}  // namespace gliftc::json
