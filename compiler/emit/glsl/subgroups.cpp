// Subgroup operations. GLSL exchanges scalars and vectors between lanes; other types are exchanged part by part, in a
// function for each type. If the source lane is not in the subgroup, the result is the lane's own value.
#include "emit/glsl/printer.h"

#include <stdexcept>

namespace gliftc::glsl {

using ir::Expr;
using ir::Intrinsic;
using ir::TypeId;
using ir::TypeKind;

namespace {

/// How an exchange between lanes is written in GLSL.
struct Exchange {
    const char* function;
    const char* extension;
    const char* argument;   ///< name of the second parameter; empty: there is none
    const char* inside;     ///< condition: the source lane is in the subgroup; empty: it always is
    const char* lane = "";  ///< without a parameter: a comma and the second argument of `function`, or empty
};

Exchange exchange_of(Printer& p, const HelperUse& use) {
    switch (use.helper) {
    case Helper::shuffled: return {"subgroupShuffle", "shuffle", "lane", "lane < gl_SubgroupSize"};
    case Helper::shuffled_xor:
        return {"subgroupShuffleXor", "shuffle", "mask", "(gl_SubgroupInvocationID ^ mask) < gl_SubgroupSize"};
    case Helper::shuffled_up:
        return {"subgroupShuffleUp", "shuffle_relative", "delta", "delta <= gl_SubgroupInvocationID"};
    case Helper::shuffled_down:
        return {"subgroupShuffleDown", "shuffle_relative", "delta",
                "delta < gl_SubgroupSize - gl_SubgroupInvocationID"};
    case Helper::broadcast: return {"subgroupBroadcast", "ballot", "lane", "lane < gl_SubgroupSize"};
    case Helper::broadcast_first:
        if (!p.program.types.is_floating(p.program.types.scalar_of(use.a)))
            return {"subgroupBroadcastFirst", "ballot", "", ""};
        // LLVM 15, under lavapipe, has no code for subgroupBroadcastFirst of some floats.
        p.extensions.insert("GL_KHR_shader_subgroup_ballot");
        return {"subgroupShuffle", "shuffle", "", "", ", subgroupBallotFindLSB(subgroupBallot(true))"};
    default: break;
    }
    throw std::logic_error("emit/glsl: not an exchange between lanes");
}

/// Whether GLSL exchanges values of the type, without a function for its parts.
bool is_exchanged_whole(const ir::Types& types, TypeId type) {
    return types.is_scalar(type) || types.is_vector(type) || types.kind(type) == TypeKind::enum_;
}

void use_extensions(Printer& p, const char* kind, TypeId type) {
    p.extensions.insert("GL_KHR_shader_subgroup_basic");
    p.extensions.insert(std::string("GL_KHR_shader_subgroup_") + kind);
    TypeKind scalar = p.program.types.kind(p.program.types.scalar_of(type));
    if (scalar == TypeKind::half) p.extensions.insert("GL_EXT_shader_subgroup_extended_types_float16");
    if (scalar == TypeKind::int64 || scalar == TypeKind::uint64)
        p.extensions.insert("GL_EXT_shader_subgroup_extended_types_int64");
}

Text call(Printer& p, const char* kind, const char* name, const Expr& expr) {
    use_extensions(p, kind, expr.type);
    return {std::string(name) + "(" + join_arguments(p, expr.operands) + ")"};
}

Text ballot_count(Printer& p, const char* count, const Expr& expr) {
    use_extensions(p, "ballot", expr.type);
    return {std::string(count) + "(subgroupBallot(" + print_any(p, expr.operands[0]) + "))"};
}

Text exchange(Printer& p, Helper helper, const Expr& expr) {
    return {need(p, helper, expr.type) + "(" + join_arguments(p, expr.operands) + ")"};
}

/// GLSL's subgroupBroadcast requires the same lane number in all lanes, which is known only of constants. With any
/// other number a shuffle is printed.
Text broadcast(Printer& p, const Expr& expr) {
    return exchange(p, is_constant(p, expr.operands[1]) ? Helper::broadcast : Helper::shuffled, expr);
}

Text broadcast_first(Printer& p, const Expr& expr) {
    const ir::Types& types = p.program.types;
    if (is_exchanged_whole(types, expr.type) && !types.is_floating(types.scalar_of(expr.type)))
        return call(p, "ballot", "subgroupBroadcastFirst", expr);
    return exchange(p, Helper::broadcast_first, expr);
}

/// A part of a value that is not exchanged whole; `text` is written behind `value` to select it.
struct Part {
    std::string text;
    TypeId type;
};

std::vector<Part> parts_of(const Printer& p, TypeId id) {
    const ir::Type& type = p.program.types[id];
    std::vector<Part> parts;
    if (type.kind == TypeKind::array) parts = {{"[i]", type.element}};
    if (type.kind == TypeKind::optional) parts = {{".has", p.program.types.bool_}, {".value", type.element}};
    if (type.kind == TypeKind::struct_) {
        const auto& fields = p.program.structs[type.struct_].fields;
        for (std::size_t i = 0; i < fields.size(); ++i)
            parts.push_back({"." + p.field_names[type.struct_][i], fields[i].type});
    }
    std::erase_if(parts, [&](const Part& part) { return is_empty(p.program, part.type); });
    return parts;
}

/// The function for a scalar or vector (`columns` is 0), or for a matrix, column by column.
std::string whole_definition(const std::string& head, const std::string& type, const Exchange& e,
                             std::uint32_t columns) {
    const std::string second = *e.argument ? std::string(", ") + e.argument : std::string(e.lane);
    std::string text = head + "    " + type + " other";
    if (columns == 0) text += std::string(" = ") + e.function + "(value" + second + ");\n";
    else
        text += ";\n    for (int i = 0; i < " + std::to_string(columns) + "; ++i) other[i] = " + e.function +
                "(value[i]" + second + ");\n";
    return text + "    return " + (*e.inside ? std::string(e.inside) + " ? other : value" : "other") + ";\n}\n";
}

}  // namespace

void need_inner_of_subgroup(Printer& p, const HelperUse& use) {
    const ir::Types& types = p.program.types;
    if (is_exchanged_whole(types, use.a) || types.is_matrix(use.a))
        return use_extensions(p, exchange_of(p, use).extension, use.a);
    for (const Part& part : parts_of(p, use.a)) need(p, use.helper, part.type);
}

std::string subgroup_definition(Printer& p, const HelperUse& use) {
    const ir::Types& types = p.program.types;
    const Exchange e = exchange_of(p, use);
    const std::string type = type_text(p, use.a), name = need(p, use.helper, use.a);
    const std::string second = *e.argument ? std::string(", ") + e.argument : "";
    const std::string head = type + " " + name + "(" + declaration(p, use.a, "value") + (*e.argument ? ", uint " : "") +
                             e.argument + ") {\n";
    if (is_exchanged_whole(types, use.a)) return whole_definition(head, type, e, 0);
    if (types.is_matrix(use.a)) return whole_definition(head, type, e, types[use.a].count);
    std::string text = head;
    const bool is_array = types.kind(use.a) == TypeKind::array;
    for (const Part& part : parts_of(p, use.a))
        text += (is_array ? "    for (int i = 0; i < " + std::to_string(types[use.a].count) + "; ++i) value"
                          : "    value") +
                part.text + " = " + name + "(value" + part.text + second + ");\n";
    return text + "    return value;\n}\n";
}

Text print_subgroup(Printer& p, const Expr& expr) {
    switch (expr.intrinsic) {
    case Intrinsic::subgroupAdd: return call(p, "arithmetic", "subgroupAdd", expr);
    case Intrinsic::subgroupMin: return call(p, "arithmetic", "subgroupMin", expr);
    case Intrinsic::subgroupMax: return call(p, "arithmetic", "subgroupMax", expr);
    case Intrinsic::subgroupMul: return call(p, "arithmetic", "subgroupMul", expr);
    case Intrinsic::subgroupAnd: return call(p, "arithmetic", "subgroupAnd", expr);
    case Intrinsic::subgroupOr: return call(p, "arithmetic", "subgroupOr", expr);
    case Intrinsic::subgroupXor: return call(p, "arithmetic", "subgroupXor", expr);
    case Intrinsic::subgroupExclusiveAdd: return call(p, "arithmetic", "subgroupExclusiveAdd", expr);
    case Intrinsic::subgroupExclusiveMin: return call(p, "arithmetic", "subgroupExclusiveMin", expr);
    case Intrinsic::subgroupExclusiveMax: return call(p, "arithmetic", "subgroupExclusiveMax", expr);
    case Intrinsic::subgroupInclusiveAdd: return call(p, "arithmetic", "subgroupInclusiveAdd", expr);
    case Intrinsic::subgroupInclusiveMin: return call(p, "arithmetic", "subgroupInclusiveMin", expr);
    case Intrinsic::subgroupInclusiveMax: return call(p, "arithmetic", "subgroupInclusiveMax", expr);
    case Intrinsic::subgroupAll: return call(p, "vote", "subgroupAll", expr);
    case Intrinsic::subgroupAny: return call(p, "vote", "subgroupAny", expr);
    case Intrinsic::subgroupElect: return call(p, "basic", "subgroupElect", expr);
    case Intrinsic::subgroupBroadcast: return broadcast(p, expr);
    case Intrinsic::subgroupBroadcastFirst: return broadcast_first(p, expr);
    case Intrinsic::subgroupShuffle: return exchange(p, Helper::shuffled, expr);
    case Intrinsic::subgroupShuffleXor: return exchange(p, Helper::shuffled_xor, expr);
    case Intrinsic::subgroupShuffleUp: return exchange(p, Helper::shuffled_up, expr);
    case Intrinsic::subgroupShuffleDown: return exchange(p, Helper::shuffled_down, expr);
    case Intrinsic::subgroupBallot: return call(p, "ballot", "subgroupBallot", expr);
    case Intrinsic::subgroupBallotCount: return ballot_count(p, "subgroupBallotBitCount", expr);
    case Intrinsic::subgroupBallotExclusiveCount: return ballot_count(p, "subgroupBallotExclusiveBitCount", expr);
    default: break;
    }
    throw std::logic_error("emit/glsl: not a subgroup operation");
}

}  // namespace gliftc::glsl
