#include "emit/json/reach.h"

#include "ir/aliases.h"

namespace gliftc::json {

namespace {

struct Walk {
    const ir::Program& program;
    Reached reached;

    void type(ir::TypeId id) {
        if (!id) return;
        const ir::Type& t = program.types[id];
        if (t.element) type(t.element);
        if (t.kind == ir::TypeKind::enum_) reached.enums.insert(t.enum_);
        if (t.kind == ir::TypeKind::structure) structure(t.structure);
        if (t.kind == ir::TypeKind::struct_) struct_(t.struct_);
    }

    void struct_(ir::StructId id) {
        if (!reached.structs.insert(id).second) return;
        for (const ir::StructField& field : program.structs[id].fields) type(field.type);
    }

    void structure(ir::StructureId id) {
        if (!reached.structures.insert(id).second) return;
        const ir::Structure& s = program.structures[id];
        type(s.domain_type);
        type(s.element);
        for (ir::LocalId local : s.constructor) type(program.locals[local].type);
        for (const ir::Memory& memory : s.memories) type(memory.element);
        for (const ir::MemberStructure& member : s.members)
            if (!member.is_component) structure(member.structure);
        for (const ir::HostField& field : s.host) type(field.type);
        for (const ir::Stage& stage : s.via)
            for (const ir::StructField& field : program.translators[stage.translator].scalars) type(field.type);
        for (ir::FunctionId id : ir::public_functions(program, id)) {
            for (ir::LocalId local : program.functions[id].params) type(program.locals[local].type);
            type(program.functions[id].result);
        }
    }

    void pipeline(const ir::Pipeline& p) {
        for (const ir::PipelineParam& param : p.params) {
            if (param.pattern == ir::HostPattern::value) type(program.locals[param.local].type);
            else structure(param.structure);
        }
        type(p.result);
    }
};

}  // namespace

Reached reach(const ir::Program& program, ir::ModuleId module) {
    Walk walk{program, {}};
    for (ir::StructureId i : program.structures.ids())
        if (ir::is_public(program.structures[i], module)) walk.structure(i);
    for (const ir::Kernel& kernel : program.kernels) {
        if (kernel.module != module) continue;
        for (const ir::KernelParam& param : kernel.params) {
            if (param.pattern == ir::Pattern::value) walk.type(program.locals[param.local].type);
            else walk.structure(param.structure);
        }
    }
    for (const ir::Pipeline& pipeline : program.pipelines)
        if (pipeline.module == module) walk.pipeline(pipeline);
    for (ir::StructId i : program.structs.ids())
        if (program.structs[i].is_pub && program.structs[i].module == module) walk.struct_(i);
    for (ir::EnumId i : program.enums.ids())
        if (program.enums[i].is_pub && program.enums[i].module == module) walk.reached.enums.insert(i);
    return walk.reached;
}

}  // namespace gliftc::json
