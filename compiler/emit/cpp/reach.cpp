// What a module's C++ must contain: its public structs, enums, structures, kernels and pipelines (in a test program the
// pipelines of its tests instead of the public ones), and all that these need.
#include "base/parallel.h"
#include "emit/cpp/translators.h"
#include "emit/cpp/unit.h"
#include "ir/aliases.h"
#include "ir/chain.h"
#include "ir/evaluate.h"
#include "ir/walk.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace gliftc::cpp {

namespace {

/// The kinds of devices on which a statement of a pipeline may run.
struct Devices {
    bool host = true, vulkan = true;

    Devices only(Devices others) const { return {host && others.host, vulkan && others.vulkan}; }
};

struct Collector {
    const ir::Program& program;
    Reach reach;
    std::set<ir::StructureId> seen{};
    std::set<ir::FunctionId> functions{};
    Devices devices{};       ///< those on which the visited statement may run
    bool moves_all = false;  ///< a test program, which may copy boxes of any structure to the host
    ir::StructureId owner;   ///< the visited pipeline's container, at which Expr::place begins if Expr::local is absent

    void type(ir::TypeId id, bool visible);
    void struct_(ir::StructId id);
    void code(const std::vector<ir::StmtId>& body);
    void value(ir::ExprId id);
    void function(ir::FunctionId id);
    void passes(const ir::Lowered::Forms& forms);
    void expression(const ir::Expr& expr);
    void structure(ir::StructureId index, bool visible);
    void kernel(ir::KernelId index, bool visible);
    void pipeline(ir::PipelineId index, bool visible);
    void signature(const ir::Pipeline&, bool visible);
    void step(const ir::Stmt& stmt);
    Devices steps(const std::vector<ir::StmtId>& body, Devices come);
    void transfers(ir::StructureId structure);
    void element_read(const ir::Expr& read);
};

/// The value of a device property, if the kind of device decides it: for the host device all but the size of its
/// workgroup memory, for Vulkan devices only that they are not the host.
std::optional<std::uint64_t> property_on(bool host, ir::DeviceProperty property) {
    if (property == ir::DeviceProperty::is_host) return host;
    if (!host) return std::nullopt;
    switch (property) {
    case ir::DeviceProperty::is_host:
    case ir::DeviceProperty::subgroup_size:
    case ir::DeviceProperty::subgroup_arithmetic:
    case ir::DeviceProperty::int64: return 1;
    case ir::DeviceProperty::is_gpu: return 0;
    case ir::DeviceProperty::shared_memory_bytes: return std::nullopt;
    }
    return std::nullopt;
}

std::optional<std::uint64_t> value_on(bool host, const ir::Program& program, ir::ExprId id);

std::optional<std::uint64_t> binary_on(bool host, const ir::Program& program, const ir::Expr& expr) {
    const std::optional<std::uint64_t> a = value_on(host, program, expr.operands[0]);
    const std::optional<std::uint64_t> b = value_on(host, program, expr.operands[1]);
    if (expr.binary == ir::BinaryOp::logical_and || expr.binary == ir::BinaryOp::logical_or) {
        const std::uint64_t decides = expr.binary == ir::BinaryOp::logical_or;
        if (a == decides || b == decides) return decides;
    }
    if (!a || !b) return std::nullopt;
    const ir::TypeId type = program.exprs[expr.operands[0]].type;
    return ir::apply(program.types, expr.binary, type, {*a, 0}, {*b, 0}).bits;
}

/// The value of a pipeline's bool or uint expression on a kind of device (`host`: the host device, else Vulkan
/// devices), if constants and properties whose value property_on() knows determine it by `!` and binary operators; else
/// none.
std::optional<std::uint64_t> value_on(bool host, const ir::Program& program, ir::ExprId id) {
    const ir::Expr& expr = program.exprs[id];
    const ir::TypeKind kind = program.types.kind(expr.type);
    if (kind != ir::TypeKind::bool_ && kind != ir::TypeKind::uint) return std::nullopt;
    if (expr.op == ir::Op::constant) return expr.bits;
    if (expr.op == ir::Op::device_property) return property_on(host, static_cast<ir::DeviceProperty>(expr.slot));
    if (expr.op == ir::Op::unary && expr.unary == ir::UnaryOp::logical_not) {
        const std::optional<std::uint64_t> operand = value_on(host, program, expr.operands[0]);
        if (operand) return !*operand;
    }
    if (expr.op == ir::Op::binary) return binary_on(host, program, expr);
    return std::nullopt;
}

void Collector::type(ir::TypeId id, bool visible) {
    if (!id) return;
    const ir::Type& type = program.types[id];
    switch (type.kind) {
    case ir::TypeKind::struct_: return struct_(type.struct_);
    case ir::TypeKind::enum_: reach.enums.insert(type.enum_); return;
    case ir::TypeKind::structure: return structure(type.structure, visible);
    case ir::TypeKind::vector:
    case ir::TypeKind::matrix:
    case ir::TypeKind::array:
    case ir::TypeKind::optional:
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

void Collector::struct_(ir::StructId id) {
    if (std::ranges::find(reach.structs, id) != reach.structs.end()) return;
    for (const ir::StructField& field : program.structs[id].fields) type(field.type, true);
    reach.structs.push_back(id);
}

void Collector::expression(const ir::Expr& expr) {
    type(expr.type, false);
    if (expr.op == ir::Op::call) function(expr.function);
}

/// Adds the types of all values in a body, and the functions that it calls.
void Collector::code(const std::vector<ir::StmtId>& body) {
    ir::for_each_statement(program, body, [&](const ir::Stmt& stmt) {
        if (stmt.local) type(program.locals[stmt.local].type, false);
    });
    ir::for_each_expression_of_trees(program, body, [&](ir::ExprId node) { expression(program.exprs[node]); });
}

void Collector::value(ir::ExprId id) {
    ir::for_each_node(program, id, [&](ir::ExprId node) { expression(program.exprs[node]); });
}

void Collector::function(ir::FunctionId id) {
    if (!functions.insert(id).second) return;
    const ir::Function& called = program.functions[id];
    type(called.result, false);
    for (ir::LocalId local : called.params) type(program.locals[local].type, false);
    code(called.body);
}

void Collector::passes(const ir::Lowered::Forms& forms) {
    for (const ir::Pass* pass : forms.all()) {
        for (const ir::Variant& variant : pass->variants)
            if (variant.devices != ir::Devices::shaders) {
                if (variant.block) code(*variant.block);
                code(variant.body);
            }
        for (ir::LocalId local : pass->shared) type(program.locals[local].type, false);
        for (ir::FunctionId id : pass->functions) function(id);
        for (const ir::PassParameter& parameter : pass->parameters) value(parameter.value);
    }
}

/// Adds the kernels and structures that move boxes of the structure between host and device, for all kinds of devices:
/// the program calls them, on whatever device it made the structure on.
void Collector::transfers(ir::StructureId structure) {
    if (!reach.moved.insert(structure).second) return;
    const Devices before = std::exchange(devices, {});
    for (const ir::Program::Transfer& transfer : program.transfers) {
        if (transfer.structure != structure) continue;
        this->structure(transfer.box_structure, false);
        kernel(transfer.read_kernel, false);
        kernel(transfer.write_kernel, false);
        kernel(transfer.fill_kernel, false);
        if (!transfer.list_kernel) continue;
        for (ir::StructureId list : {transfer.addresses, transfer.places, transfer.values, transfer.counter})
            this->structure(list, false);
        kernel(transfer.list_kernel, false);
    }
    devices = before;
}

/// Adds what a read of one element as a value needs: nothing if the element can stay where it lies, else the kernels
/// that move it as a box.
void Collector::element_read(const ir::Expr& read) {
    ir::StructureId root = owner;
    if (read.local) {
        const ir::Type& type = program.types[program.locals[read.local].type];
        root = type.kind == ir::TypeKind::slice ? program.types[type.element].structure : type.structure;
    }
    const ir::StructureId structure = structure_at(program, root, read.place);
    const bool is_in_place = read.op == ir::Op::host_read || read.slot != 0;
    if (!is_in_place || !has_rows(program, program.structures[structure])) transfers(structure);
}

void Collector::structure(ir::StructureId index, bool visible) {
    const ir::Structure& structure = program.structures[index];
    const bool newly_visible = visible && reach.in_header.insert(index).second;
    if (!seen.insert(index).second && !newly_visible) return;
    for (const ir::MemberStructure& member : structure.members)
        if (!member.is_component) this->structure(member.structure, visible);
    // The class declares its pipelines, so that the structures in their signatures come before it.
    for (ir::PipelineId pipeline : structure.pipelines) signature(program.pipelines[pipeline], visible);
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
    const Devices before = std::exchange(devices, {});
    for (ir::PipelineId pipeline : structure.pipelines) this->pipeline(pipeline, visible);
    for (const ir::Method& method : structure.methods) {
        const ir::Function& called = program.functions[method.function];
        type(called.result, visible);
        for (ir::LocalId local : called.params) type(program.locals[local].type, visible);
        if (method.pipeline) this->pipeline(method.pipeline, false);
        else function(method.function);
    }
    devices = before;
    if (visible || moves_all) transfers(index);
}

void Collector::kernel(ir::KernelId index, bool visible) {
    if (!index) return;
    if (visible) reach.pub_kernels.insert(index);
    if (devices.host) reach.host_kernels.insert(index);
    if (devices.vulkan) reach.vulkan_kernels.insert(index);
    if (const ir::Blocks* blocks = visited_blocks(program, program.kernels[index]); blocks && blocks->counter)
        pipeline(blocks->counter, false);
    const bool is_new = reach.kernels.insert(index).second;
    if (!is_new && !visible) return;
    for (const ir::KernelParam& param : program.kernels[index].params) {
        if (param.pattern == ir::Pattern::value) type(program.locals[param.local].type, visible);
        else structure(param.structure, visible);
        if (param.pattern == ir::Pattern::argument) type(program.locals[param.local].type, visible);
    }
}

void Collector::signature(const ir::Pipeline& pipeline, bool visible) {
    for (const ir::PipelineParam& param : pipeline.params) type(program.locals[param.local].type, visible);
    type(pipeline.result, visible);
}

void Collector::pipeline(ir::PipelineId index, bool visible) {
    const bool is_new = reach.pipelines.insert(index).second;
    const bool is_new_on_host = devices.host && reach.host_pipelines.insert(index).second;
    const bool is_new_on_vulkan = devices.vulkan && reach.vulkan_pipelines.insert(index).second;
    const ir::Pipeline& pipeline = program.pipelines[index];
    if (visible || is_new) {
        if (pipeline.owner) structure(pipeline.owner, visible);
        signature(pipeline, visible);
    }
    if (!is_new && !is_new_on_host && !is_new_on_vulkan) return;
    const ir::StructureId before = std::exchange(owner, pipeline.owner);
    steps(pipeline.body, devices);
    owner = before;
}

/// Visits the statements. `come` are the kinds of devices that may reach their beginning. Returns those that may reach
/// their end.
Devices Collector::steps(const std::vector<ir::StmtId>& body, Devices come) {
    const Devices before = std::exchange(devices, come);
    for (ir::StmtId id : body) step(program.stmts[id]);
    return std::exchange(devices, before);
}

void Collector::step(const ir::Stmt& stmt) {
    if (stmt.op == ir::StmtOp::dispatch) kernel(stmt.kernel(), false);
    if (stmt.local) type(program.locals[stmt.local].type, false);
    ir::for_each_root(stmt, [&](ir::ExprId root) {
        ir::for_each_node(program, root, [&](ir::ExprId node) {
            const ir::Expr& expr = program.exprs[node];
            if (expr.op == ir::Op::pipeline_call) this->pipeline(expr.pipeline(), false);
            if (expr.op == ir::Op::device_read || expr.op == ir::Op::host_read) element_read(expr);
            expression(expr);
        });
    });
    switch (stmt.op) {
    case ir::StmtOp::if_: {
        const std::optional<std::uint64_t> host = value_on(true, program, stmt.value);
        const std::optional<std::uint64_t> vulkan = value_on(false, program, stmt.value);
        const Devices a = steps(stmt.body, devices.only({host != 0, vulkan != 0}));
        const Devices b = steps(stmt.otherwise, devices.only({host != 1, vulkan != 1}));
        devices = {a.host || b.host, a.vulkan || b.vulkan};
        return;
    }
    case ir::StmtOp::arms:
        steps(stmt.body, devices);
        steps(stmt.otherwise, devices);
        return;
    case ir::StmtOp::block: devices = steps(stmt.body, devices); return;
    case ir::StmtOp::return_: devices = {false, false}; return;
    default: steps(stmt.body, devices); return;  // a loop may run no iteration: what follows it is reached anyway
    }
}

}  // namespace

namespace {

Reach reach_of_alone(const ir::Program& program, ir::ModuleId module, const Options& options) {
    Collector collector{.program = program, .reach = {}, .moves_all = options.tests};
    for (ir::StructId i : program.structs.ids()) {
        if (program.structs[i].module == module && program.structs[i].is_pub) collector.struct_(i);
    }
    for (ir::EnumId i : program.enums.ids()) {
        if (program.enums[i].module == module && program.enums[i].is_pub) collector.reach.enums.insert(i);
    }
    for (ir::StructureId i : program.structures.ids()) {
        if (ir::is_public(program.structures[i], module)) collector.structure(i, true);
    }
    for (ir::KernelId i : program.kernels.ids()) {
        if (program.kernels[i].module == module && program.kernels[i].is_pub) collector.kernel(i, true);
    }
    if (options.tests) {  // in a test program only tests call pipelines
        for (const ir::Test& test : program.tests) {
            if (test.module == module) collector.pipeline(test.pipeline, false);
        }
        return std::move(collector.reach);
    }
    for (ir::PipelineId i : program.pipelines.ids()) {
        const ir::Pipeline& pipeline = program.pipelines[i];
        if (pipeline.module == module && pipeline.is_pub && !pipeline.owner) collector.pipeline(i, true);
    }
    return std::move(collector.reach);
}

}  // namespace

/// Adds to `to` those of `theirs` that are among `known`.
template <class T> static void add_known(std::set<T>& to, const std::set<T>& known, const std::set<T>& theirs) {
    std::ranges::set_intersection(known, theirs, std::inserter(to, to.end()));
}

/// What several modules of the run use is defined once, by one of them, with code for all kinds of devices on which any
/// of them uses it.
Reach reach_of(const ir::Program& program, ir::ModuleId module, const Options& options) {
    Reach reach = reach_of_alone(program, module, options);
    if (options.tests) return reach;
    for (ir::ModuleId other : program.modules.ids()) {
        if (other == module || !program.modules[other].is_root) continue;
        const Reach theirs = reach_of_alone(program, other, options);
        add_known(reach.host_kernels, reach.kernels, theirs.host_kernels);
        add_known(reach.vulkan_kernels, reach.kernels, theirs.vulkan_kernels);
        add_known(reach.host_pipelines, reach.pipelines, theirs.host_pipelines);
        add_known(reach.vulkan_pipelines, reach.pipelines, theirs.vulkan_pipelines);
    }
    return reach;
}

void add_inner_structs(Reach& reach, const ir::Program& program, const ir::Lowered& lowered) {
    constexpr std::size_t share = 64;  // kernels per thread: starting a thread for fewer takes longer than it saves
    const std::vector<ir::KernelId> kernels(reach.kernels.begin(), reach.kernels.end());
    std::vector<Reach> found(kernels.size());
    for_each_parallel(kernels.size(), share, [&](std::size_t i) {
        Collector inner{.program = program, .reach = {}};
        inner.passes(lowered.passes[kernels[i]]);
        found[i] = std::move(inner.reach);
    });
    Collector collector{.program = program, .reach = std::move(reach)};
    for (const Reach& inner : found) {
        for (ir::StructId index : inner.structs) collector.struct_(index);
        for (ir::StructureId index : inner.structures) collector.structure(index, false);
        collector.reach.enums.insert(inner.enums.begin(), inner.enums.end());
    }
    reach = std::move(collector.reach);
}

std::vector<ir::KernelId> vulkan_kernels_of(const ir::Program& program, ir::ModuleId module, const Options& options,
                                            const Defined& defined) {
    const Reach reach = reach_of(program, module, options);
    std::vector<ir::KernelId> kernels;
    std::ranges::set_difference(reach.vulkan_kernels, defined.kernels, std::back_inserter(kernels));
    return kernels;
}

}  // namespace gliftc::cpp
