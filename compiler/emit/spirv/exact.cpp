// Needs: a valid module. Guarantees: the same module with decorations added and some extended instructions replaced.
#include "emit/spirv/exact.h"

#include <glslang/SPIRV/GLSL.std.450.h>
#include <glslang/SPIRV/spirv.hpp>

#include <cstddef>
#include <unordered_set>

namespace gliftc::spirv {

namespace {

constexpr std::size_t header_words = 5;

bool is_float_arithmetic(spv::Op op) {
    switch (op) {
    case spv::OpFNegate:
    case spv::OpFAdd:
    case spv::OpFSub:
    case spv::OpFMul:
    case spv::OpFDiv:
    case spv::OpFRem:
    case spv::OpFMod:
    case spv::OpVectorTimesScalar:
    case spv::OpMatrixTimesScalar:
    case spv::OpVectorTimesMatrix:
    case spv::OpMatrixTimesVector:
    case spv::OpMatrixTimesMatrix:
    case spv::OpOuterProduct:
    case spv::OpDot: return true;
    default: return false;
    }
}

bool is_after_annotations(spv::Op op) {
    return (op >= spv::OpTypeVoid && op <= spv::OpTypeForwardPointer) ||
           (op >= spv::OpConstantTrue && op <= spv::OpSpecConstantOp) || op == spv::OpVariable || op == spv::OpUndef ||
           op == spv::OpLine || op == spv::OpNoLine;
}

/// For FMin, FMax and FClamp the instruction that is also defined for NaN; for any other instruction itself.
std::uint32_t defined_form(std::uint32_t instruction) {
    switch (instruction) {
    case GLSLstd450FMin: return GLSLstd450NMin;
    case GLSLstd450FMax: return GLSLstd450NMax;
    case GLSLstd450FClamp: return GLSLstd450NClamp;
    default: return instruction;
    }
}

/// Where decorations may be added, and the results to decorate.
struct Findings {
    std::size_t decorations_end = 0;
    std::vector<std::uint32_t> results;
    std::unordered_set<std::uint32_t> decorated;
};

Findings survey(std::vector<std::uint32_t>& words) {
    Findings found;
    std::uint32_t glsl_set = 0;
    for (std::size_t at = header_words; at < words.size();) {
        auto op = static_cast<spv::Op>(words[at] & 0xffffu);
        std::size_t count = words[at] >> 16;
        if (count == 0) break;
        if (op == spv::OpExtInstImport && count >= 5 && words[at + 2] == 0x4c534c47u)
            glsl_set = words[at + 1];  // "GLSL"
        if (op == spv::OpExtInst && words[at + 3] == glsl_set) words[at + 4] = defined_form(words[at + 4]);
        if (op == spv::OpDecorate && words[at + 2] == static_cast<std::uint32_t>(spv::DecorationNoContraction))
            found.decorated.insert(words[at + 1]);
        if (found.decorations_end == 0 && is_after_annotations(op)) found.decorations_end = at;
        if (is_float_arithmetic(op)) found.results.push_back(words[at + 2]);
        at += count;
    }
    return found;
}

}  // namespace

std::vector<std::uint32_t> made_exact(const std::vector<std::uint32_t>& words, Contraction contraction) {
    std::vector<std::uint32_t> result = words;
    Findings found = survey(result);
    if (contraction == Contraction::on) return result;
    std::vector<std::uint32_t> decorations;
    for (std::uint32_t id : found.results) {
        if (found.decorated.contains(id)) continue;
        decorations.insert(decorations.end(), {3u << 16 | static_cast<std::uint32_t>(spv::OpDecorate), id,
                                               static_cast<std::uint32_t>(spv::DecorationNoContraction)});
    }
    result.insert(result.begin() + static_cast<std::ptrdiff_t>(found.decorations_end), decorations.begin(),
                  decorations.end());
    return result;
}

}  // namespace gliftc::spirv
