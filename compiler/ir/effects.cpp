#include "ir/effects.h"

#include "ir/chain.h"
#include "ir/walk.h"

#include <algorithm>

namespace gliftc::ir {

const PatternTraits& traits_of(Pattern pattern) {
    static constexpr PatternTraits table[] = {
#define PATTERN(name, reach, course, directions) {#name, Reach::reach, Course::course, Directions::directions},
#include "ir/patterns.def"
#undef PATTERN
    };
    return table[static_cast<std::size_t>(pattern)];
}

bool is_addressed(const Program& program, const Kernel& kernel, const PassBinding& binding) {
    if (binding.is_workspace) return false;
    const Structure& structure = program.structures[kernel.params[binding.place.root].structure];
    const Structure& root = root_structure(program, structure);
    return binding.place == root_of(program, structure, {binding.place.root, {}}) &&
           (root.apart || binding.memory == root.via_memory);
}

bool may_be_one_place(const Program& program, const Kernel& kernel, const PassBinding& one, const PassBinding& other) {
    if (one.is_workspace || other.is_workspace) return false;
    const KernelParam &param = kernel.params[one.place.root], &other_param = kernel.params[other.place.root];
    return param.structure == other_param.structure && one.memory == other.memory &&
           traits_of(param.pattern).reach == Reach::element && traits_of(other_param.pattern).reach == Reach::element &&
           is_addressed(program, kernel, one) && is_addressed(program, kernel, other);
}

bool has_one_place(const Pass& pass) {
    for (std::uint32_t i = 0; i < pass.bindings.size(); ++i)
        if (pass.bindings[i].one_place != i) return true;
    return false;
}

bool may_meet(const KernelParam& one, const KernelParam& other) {
    const Reach reach = traits_of(one.pattern).reach, other_reach = traits_of(other.pattern).reach;
    if (reach == Reach::nothing || other_reach == Reach::nothing) return false;
    if (one.direction == Direction::in && other.direction == Direction::in) return false;
    const bool draws = one.pattern == Pattern::target || other.pattern == Pattern::target;
    if (reach == Reach::element && other_reach == Reach::element) return draws;
    if (one.pattern == Pattern::coherent && other.pattern == Pattern::coherent) return false;
    return one.pattern != other.pattern || one.combine != other.combine || one.combine == Combine::replace;
}

bool is_promised_apart(const Kernel& kernel, std::uint32_t one, std::uint32_t other) {
    return std::ranges::any_of(kernel.disjoint, [&](const auto& pair) {
        return pair == std::pair(one, other) || pair == std::pair(other, one);
    });
}

DepthOrder depth_order(const Program& program, const Pass& pass) {
    const DepthTarget& depth = *program.kernels[pass.kernel].raster->depth;
    const Variant* fragment = fragment_for(pass, Devices::shaders);
    if (depth.is_set) return DepthOrder::after;
    if (fragment == nullptr) return DepthOrder::before;
    bool writes = false, discards = false;
    for_each_statement(program, fragment->body, [&](const Stmt& stmt) {
        writes |= stmt.op == StmtOp::store || stmt.op == StmtOp::image_store || stmt.op == StmtOp::atomic;
        discards |= stmt.op == StmtOp::discard;
    });
    for_each_expression(program, fragment->body, [&](ExprId id) {
        writes |= program.exprs[id].op == Op::intrinsic && signature_of(program.exprs[id].intrinsic)[0] == '@';
    });
    if (writes) return DepthOrder::declared;
    return discards && depth.is_written ? DepthOrder::after : DepthOrder::before;
}

const Translator* many_to_one_stage(const Program& program, StructureId structure) {
    for (const Structure* link = &program.structures[structure];; link = &structure_at(program, *link, link->base)) {
        for (const Stage& stage : link->via) {
            const Translator& translator = program.translators[stage.translator];
            if (translator.properties.mapping == Mapping::many_to_one) return &translator;
        }
        if (link->base.empty()) return nullptr;
    }
}

bool has_depth_format(const Program& program, const Structure& structure) {
    const Structure& root = root_structure(program, structure);
    return root.kind == StructureKind::stored && !root.memories.empty() &&
           root.memories[root.via_memory].format == Format::d32;
}

bool is_written_in_boxes(const Program& program, StructureId structure) {
    const Structure& written = program.structures[structure];
    return written.kind == StructureKind::stored && !many_to_one_stage(program, structure) &&
           !has_depth_format(program, written);
}

}  // namespace gliftc::ir
