// Calls, in pipelines and from C++, of functions that the host cannot evaluate, such as those that read memory: a
// generated pipeline calls the function in a pass of one invocation, and returns a value that lies on the device. A
// method in C++ waits for that value.
#include "ir/levels.h"
#include "ir/walk.h"
#include "sema/pipelines/values.h"
#include "sema/structures/components.h"
#include "sema/structures/constructors.h"
#include "sema/types/instances.h"
#include "sema/types/typing.h"

#include <algorithm>

namespace gliftc::sema {

bool reads_memory(const ir::Program& program, const std::vector<ir::StmtId>& body) {
    bool reads = false;
    ir::for_each_expression(program, body, [&](ir::ExprId node) {
        const ir::Expr& expr = program.exprs[node];
        reads = reads || ir::level_of(expr.op) == ir::Level::structure ||
                (expr.op == ir::Op::call && program.functions[expr.function].reads_memory);
    });
    return reads;
}

namespace {

/// The function's key, then the keys of the structures that it is called for. Overloads have the same key.
std::string key_of(const Context& c, const ir::Function& function) {
    std::string key = function.key;
    for (ir::StructureId structure : function.structures) key += "<" + c.program.structures[structure].key + ">";
    return key;
}

/// A kernel that assigns a call of the function to the parameter `result: out each<Box>`. Its other parameters are the
/// function's structures and values.
ir::Kernel kernel_of(Context& c, ir::FunctionId id, ir::StructureId box) {
    ir::Program& program = c.program;
    const ir::Function function = program.functions[id];
    ir::Kernel kernel;
    kernel.name = function.name;
    kernel.display = function.display;
    kernel.key = key_of(c, function);
    kernel.span = function.span;
    kernel.module = function.module;
    kernel.domain_type = c.types().uint;
    const auto add_param = [&](ir::KernelParam param) {
        param.span = function.span;
        param.alike = static_cast<std::uint32_t>(kernel.params.size());
        kernel.params.push_back(std::move(param));
    };
    ir::Operands values;
    std::vector<ir::Place> places;
    for (ir::StructureId structure : function.structures) {
        places.push_back({static_cast<std::uint32_t>(kernel.params.size()), {}});
        add_param({.name = c.names.intern("self"), .pattern = ir::Pattern::any, .structure = structure});
    }
    for (ir::LocalId param : function.params) {
        const ir::Local local = program.locals[param];
        const ir::LocalId value = add_local(program, local.name, local.type, local.span);
        values.push_back(make_local(program, value, function.span));
        add_param({.name = local.name, .pattern = ir::Pattern::value, .local = value});
    }
    const ir::ExprId call = add(program, ir::Op::call, function.result, function.span, std::move(values));
    program.exprs[call].function = id;
    program.exprs[call].places = std::move(places);
    const ir::StmtId set = add(program, ir::StmtOp::set_element, function.span);
    program.stmts[set].place.root = static_cast<std::uint32_t>(kernel.params.size());
    program.stmts[set].value = call;
    kernel.body.push_back(set);
    add_param({.name = c.names.intern("result"),
               .pattern = ir::Pattern::each,
               .direction = ir::Direction::out,
               .structure = box});
    return kernel;
}

}  // namespace

std::optional<ir::TypeId> type_not_for_passes(const ir::Program& program, const ir::Function& function) {
    std::vector<ir::TypeId> types{function.result};
    for (ir::LocalId param : function.params) types.push_back(program.locals[param].type);
    const auto found = std::ranges::find_if_not(types, [&](ir::TypeId type) { return memory_holds(program, type); });
    return found == types.end() ? std::nullopt : std::optional(*found);
}

ir::PipelineParam structure_param(Context& c, ir::StructureId structure, Span span) {
    const ir::TypeId type = c.types().of_structure(structure);
    const bool is_whole = c.program.structures[structure].kind == ir::StructureKind::no_elements;
    ir::PipelineParam param;
    param.name = c.names.intern("self");
    param.span = span;
    param.pattern = is_whole ? ir::HostPattern::structure : ir::HostPattern::range;
    param.structure = structure;
    param.local = add_local(c.program, param.name, is_whole ? type : c.types().slice(type), span);
    return param;
}

ir::ExprId structure_argument(Context& c, ir::LocalId local, Span span) {
    const ir::ExprId argument = make_local(c.program, local, span);
    if (c.types().kind(c.program.locals[local].type) == ir::TypeKind::structure)
        c.program.exprs[argument].op = ir::Op::structure_value;
    return argument;
}

ir::PipelineId pipeline_of_kernel(Context& c, ir::Kernel kernel, ir::Pipeline pipeline, ir::Operands arguments,
                                  ir::StructureId box) {
    const Span span = kernel.span;
    const ir::LocalId result = add_local(c.program, c.names.intern("result"), c.types().of_structure(box), span);
    arguments.push_back(structure_argument(c, result, span));
    const ir::StmtId temp = add(c.program, ir::StmtOp::temp, span);
    c.program.stmts[temp].local = result;
    c.program.stmts[temp].arguments = {make_uint(c.program, 1, span)};
    c.program.stmts[temp].uninitialized = true;
    const ir::StmtId dispatch = add(c.program, ir::StmtOp::dispatch, span);
    c.program.stmts[dispatch].slot = c.program.kernels.add(std::move(kernel)).index;
    c.program.stmts[dispatch].arguments = std::move(arguments);
    pipeline.result = c.types().device(c.program.structures[box].element);
    const ir::ExprId element =
        add(c.program, ir::Op::device_read, pipeline.result, span, {make_uint(c.program, 0, span)});
    c.program.exprs[element].local = result;
    const ir::StmtId give = add(c.program, ir::StmtOp::return_, span);
    c.program.stmts[give].value = element;
    pipeline.body = {temp, dispatch, give};
    return c.program.pipelines.add(std::move(pipeline));
}

ir::PipelineId pipeline_of_function(Context& c, ir::FunctionId id, Span use, const std::vector<bool>& on_device) {
    std::string key = "pass of " + std::to_string(id.index);
    for (std::size_t i = 0; i < on_device.size(); ++i) key += on_device[i] ? " " + std::to_string(i) : "";
    Instance& instance = c.instances[key];
    if (instance.state == Instance::State::done) return {instance.index};
    const ir::Function function = c.program.functions[id];
    const ir::StructureId box = box_of(c, 1, function.result, use);
    if (!box) return {};
    require_transfers(c, box, use);
    ir::Pipeline pipeline;
    pipeline.name = function.name;
    pipeline.display = function.display;
    pipeline.key = key_of(c, function);
    pipeline.span = function.span;
    pipeline.module = function.module;
    ir::Operands arguments;
    for (ir::StructureId structure : function.structures) {
        pipeline.params.push_back(structure_param(c, structure, function.span));
        arguments.push_back(structure_argument(c, pipeline.params.back().local, function.span));
    }
    ir::Kernel kernel = kernel_of(c, id, box);
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const ir::Local local = c.program.locals[function.params[i]];
        const bool is_argument = i < on_device.size() && on_device[i];
        if (is_argument) make_argument(c, kernel, function.structures.size() + i, use);
        const ir::TypeId type = is_argument ? c.types().device(local.type) : local.type;
        const ir::LocalId value = add_local(c.program, local.name, type, local.span);
        pipeline.params.push_back({.name = local.name, .span = local.span, .local = value});
        arguments.push_back(make_local(c.program, value, function.span));
    }
    const ir::PipelineId made =
        pipeline_of_kernel(c, std::move(kernel), std::move(pipeline), std::move(arguments), box);
    c.instances[key] = {.state = Instance::State::done, .index = made.index};
    return made;
}

/// The instance of a function of the structure that code outside of kernels can call; absent: it cannot. Functions that
/// write are called only by kernels, and by functions that kernels call. Optionals are neither types of C++ nor of
/// GLSL.
static std::optional<ir::FunctionId> callable_function(Context& c, ir::StructureId index, ast::DeclId id) {
    const Env& env = *c.structure_env.at(index);
    const ast::Decl& decl = c[id];
    const auto& written = std::get<ast::Function>(decl.body);
    if (!decl.is_pub || !decl.generics.empty()) return std::nullopt;
    const bool takes_structures = std::ranges::any_of(written.params, [&](const ast::Param& param) {
        return param.pattern != ast::Pattern::none ||
               (param.type && c.types().kind(type_of(c, env, param.type)) == ir::TypeKind::structure);
    });
    if (takes_structures || !written.group.empty()) return std::nullopt;
    const auto function = instantiate_function(c, id, env, {index}, decl.name.span);
    if (!function) return std::nullopt;
    const ir::Function& made = c.program.functions[*function];
    if (!made.effects.empty() || made.prints || c.types().kind(made.result) == ir::TypeKind::optional)
        return std::nullopt;
    return *function;
}

/// Adds the function to the structure's methods, if a pass can evaluate it.
static void add_method(Context& c, ir::StructureId index, ir::FunctionId function) {
    const ir::Function& made = c.program.functions[function];
    if (made.reads_memory && type_not_for_passes(c.program, made)) return;
    ir::Method method{function, {}};
    if (made.reads_memory) {
        method.pipeline = pipeline_of_function(c, function, made.span);
        if (!method.pipeline) return;
    }
    c.program.structures[index].methods.push_back(method);
}

void check_functions(Context& c, ir::StructureId index) {
    for (const ast::Item* item : items_of(c, index)) {
        if (item->kind != ast::ItemKind::function) continue;
        const std::optional<ir::FunctionId> function = callable_function(c, index, item->decl);
        if (!function) continue;
        c.program.structures[index].functions.push_back(*function);
        if (c.program.structures[index].is_container) add_method(c, index, *function);
    }
}

}  // namespace gliftc::sema
