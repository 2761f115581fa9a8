// What a module's C++ must contain: its public components, its pipelines, and all that these need.
#include "emit/cpp/unit.h"
#include "emit/cpp/visit.h"

#include <algorithm>

namespace gliftc::cpp {

namespace {

struct Collector {
    const ir::Program& program;
    Reach reach;
    std::set<std::uint32_t> seen;
    std::set<ir::FunctionId> functions;

    void type(ir::TypeId id, bool visible);
    void structure_type(std::uint32_t index);
    void code(const std::vector<ir::StmtId>& body);
    void value(ir::ExprId id);
    void function(ir::FunctionId id);
    void expression(const ir::Expr& expr);
    void structure(std::uint32_t index, bool visible);
    void kernel(std::uint32_t index, bool visible);
    void pipeline(std::uint32_t index, bool visible);
    void transfers(std::uint32_t structure);
};

void Collector::type(ir::TypeId id, bool visible) {
    if (!id) return;
    const ir::Type& type = program.types[id];
    switch (type.kind) {
    case ir::TypeKind::struct_: return structure_type(type.index);
    case ir::TypeKind::enum_: reach.enums.insert(type.index); return;
    case ir::TypeKind::structure: return structure(type.index, visible);
    case ir::TypeKind::vector:
    case ir::TypeKind::matrix:
    case ir::TypeKind::array:
    case ir::TypeKind::optional:
    case ir::TypeKind::range:
    case ir::TypeKind::slice:
    case ir::TypeKind::device: return this->type(type.element, visible);
    case ir::TypeKind::error:
    case ir::TypeKind::void_:
    case ir::TypeKind::bool_:
    case ir::TypeKind::int_:
    case ir::TypeKind::uint:
    case ir::TypeKind::float_:
    case ir::TypeKind::half:
    case ir::TypeKind::double_:
    case ir::TypeKind::int64:
    case ir::TypeKind::uint64: return;
    }
}

void Collector::structure_type(std::uint32_t index) {
    if (std::ranges::find(reach.structs, index) != reach.structs.end()) return;
    for (const ir::StructField& field : program.structs[index].fields) type(field.type, true);
    reach.structs.push_back(index);
}

void Collector::expression(const ir::Expr& expr) {
    type(expr.type, false);
    if (expr.op == ir::Op::call) function(expr.function);
}

/// The types of all values in a body, and in the functions that it calls.
void Collector::code(const std::vector<ir::StmtId>& body) {
    for_each_statement(program, body, [&](const ir::Stmt& stmt) {
        if (stmt.local) type(program.locals[stmt.local].type, false);
    });
    for_each_expression(program, body, [&](const ir::Expr& expr) { expression(expr); });
}

void Collector::value(ir::ExprId id) {
    for_each_expression(program, id, [&](const ir::Expr& expr) { expression(expr); });
}

void Collector::function(ir::FunctionId id) {
    if (!functions.insert(id).second) return;
    const ir::Function& called = program.functions[id];
    type(called.result, false);
    for (ir::LocalId local : called.params) type(program.locals[local].type, false);
    code(called.body);
}

void Collector::transfers(std::uint32_t structure) {
    for (const ir::Program::Transfer& transfer : program.transfers) {
        if (transfer.structure != structure) continue;
        this->structure(transfer.box_structure, false);
        kernel(transfer.read_kernel, false);
        kernel(transfer.write_kernel, false);
        kernel(transfer.fill_kernel, false);
    }
}

void Collector::structure(std::uint32_t index, bool visible) {
    const ir::Structure& structure = program.structures[index];
    const bool newly_visible = visible && reach.in_header.insert(index).second;
    if (!seen.insert(index).second && !newly_visible) return;
    for (const ir::MemberStructure& member : structure.members) this->structure(member.structure, visible);
    if (std::ranges::find(reach.structures, index) == reach.structures.end()) reach.structures.push_back(index);
    for (ir::LocalId local : structure.constructor) type(program.locals[local].type, visible);
    type(structure.element, visible);
    for (const ir::Memory& memory : structure.memories) {
        type(memory.element, visible);
        value(memory.extent);
    }
    for (const ir::MemberStructure& member : structure.members)
        for (ir::ExprId argument : member.arguments) value(argument);
    value(structure.domain);
    for (std::uint32_t pipeline : structure.pipelines) this->pipeline(pipeline, visible);
    transfers(index);
}

void Collector::kernel(std::uint32_t index, bool visible) {
    if (index >= program.kernels.size()) return;
    if (visible) reach.pub_kernels.insert(index);
    const bool is_new = reach.kernels.insert(index).second;
    if (!is_new && !visible) return;
    for (const ir::KernelParam& param : program.kernels[index].params) {
        if (param.pattern == ir::Pattern::value) type(program.locals[param.local].type, visible);
        else structure(param.structure, visible);
    }
}

void Collector::pipeline(std::uint32_t index, bool visible) {
    const bool is_new = reach.pipelines.insert(index).second;
    const ir::Pipeline& pipeline = program.pipelines[index];
    if (visible || is_new) {
        if (pipeline.owner) structure(*pipeline.owner, visible);
        for (const ir::PipelineParam& param : pipeline.params) type(program.locals[param.local].type, visible);
        type(pipeline.result, visible);
    }
    if (!is_new) return;
    for_each_statement(program, pipeline.body, [&](const ir::Stmt& stmt) {
        if (stmt.op == ir::StmtOp::dispatch) kernel(stmt.slot, false);
        if (stmt.local) type(program.locals[stmt.local].type, false);
    });
    for_each_expression(program, pipeline.body, [&](const ir::Expr& expr) {
        if (expr.op == ir::Op::pipeline_call) this->pipeline(expr.slot, false);
        expression(expr);
    });
}

}  // namespace

Reach reach_of(const ir::Program& program, std::uint32_t module, const Options& options) {
    Collector collector{program, {}, {}, {}};
    for (std::uint32_t i = 0; i < program.structs.size(); ++i) {
        if (program.structs[i].module == module && program.structs[i].is_pub) collector.structure_type(i);
    }
    for (std::uint32_t i = 0; i < program.enums.size(); ++i) {
        if (program.enums[i].module == module && program.enums[i].is_pub) collector.reach.enums.insert(i);
    }
    for (std::uint32_t i = 0; i < program.structures.size(); ++i) {
        if (program.structures[i].is_pub && program.structures[i].pub_module == module) collector.structure(i, true);
    }
    for (std::uint32_t i = 0; i < program.kernels.size(); ++i) {
        if (program.kernels[i].module == module && program.kernels[i].is_pub) collector.kernel(i, true);
    }
    for (std::uint32_t i = 0; i < program.pipelines.size(); ++i) {
        const ir::Pipeline& pipeline = program.pipelines[i];
        if (pipeline.module == module && pipeline.is_pub && !pipeline.owner) collector.pipeline(i, true);
    }
    if (options.tests) {
        for (const ir::Test& test : program.tests) {
            if (test.module == module) collector.pipeline(test.pipeline, false);
        }
    }
    return std::move(collector.reach);
}

void add_inner_structs(Reach& reach, const ir::Program& program, const ir::Lowered& lowered) {
    Collector collector{program, std::move(reach), {}, {}};
    for (std::uint32_t kernel : std::set(collector.reach.kernels)) {
        for (const ir::Pass* pass : {&lowered.passes[kernel].direct, &lowered.passes[kernel].general}) {
            for (const auto* body : {&pass->body, &pass->interior_body}) collector.code(*body);
            for (ir::LocalId local : pass->shared) collector.type(program.locals[local].type, false);
            for (ir::FunctionId id : pass->functions) collector.function(id);
            for (const ir::PassParameter& parameter : pass->parameters) collector.value(parameter.value);
        }
    }
    reach = std::move(collector.reach);
}

std::vector<std::uint32_t> kernels_of(const ir::Program& program, std::uint32_t module, const Options& options) {
    const Reach reach = reach_of(program, module, options);
    return {reach.kernels.begin(), reach.kernels.end()};
}

}  // namespace gliftc::cpp
