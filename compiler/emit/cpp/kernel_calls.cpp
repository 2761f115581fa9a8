// Kernels as functions that a program calls: each chooses a form, packs its parameters and dispatches it.
#include "emit/cpp/kernel_parts.h"
#include "emit/cpp/reloadable.h"
#include "emit/cpp/sharing.h"
#include "ir/chain.h"
#include "ir/effects.h"
#include "ir/spelling.h"
#include "ir/walk.h"

#include <algorithm>

namespace gliftc::cpp {

namespace {

using ir::Kernel;
using ir::KernelParam;
using ir::ParameterSource;
using ir::Pass;
using ir::PassBinding;
using ir::PassParameter;
using ir::Pattern;

/// How the argument passed for a parameter is spelled in the kernel's function.
const std::string& param_name(const Unit& unit, const KernelParam& param) {
    return unit.globals.param_names.at(&param);
}

/// Whether the parameter takes a container, not a range of one: a container, or a structure of which the kernel calls
/// functions (Pattern::calls).
bool is_container(const Unit& unit, const KernelParam& param) {
    if (!ir::is_structure(param)) return false;
    return param.pattern == Pattern::calls ||
           unit.program.structures[param.structure].kind == ir::StructureKind::no_elements;
}

/// The footprints (the elements that are accessed) that the runtime compares, in the order of the parameters: the
/// argument itself if it is a range. `{}` stands for a container or a value on the device, which has no range: the
/// runtime assumes that the kernel may access all elements of its memories.
std::string footprints_text(const Unit& unit, const Kernel& kernel) {
    std::string text;
    for (const KernelParam& param : kernel.params)
        if (param.pattern != Pattern::value)
            text += (text.empty() ? "" : ", ") +
                    (ir::is_structure(param) && !is_container(unit, param) ? param_name(unit, param) : "{}");
    return text;
}

/// What stands before a member's name in an access to the structure passed for a parameter: `name.` for a container,
/// `name->` for a range, whose operator-> gives its structure.
std::string object_of(const Unit& unit, const KernelParam& param) {
    return param_name(unit, param) + (is_container(unit, param) ? "." : "->");
}

/// The C++ expression of the buffer or image that holds the elements of the structure at `place`, a path of members
/// from the structure passed for the parameter. Empty if a view computes these elements.
std::string memory_text(Unit& unit, const KernelParam& param, const ir::Place& place) {
    const ir::Structure& whole = unit.program.structures[param.structure];
    const ir::Structure& at = ir::structure_at(unit.program, whole, place.members);
    if (ir::is_computed(unit.program, at)) return "";
    const ir::Place root = ir::root_of(unit.program, at, place);
    std::string object = object_of(unit, param);
    ir::StructureId structure = param.structure;
    for (std::uint32_t member : root.members) {
        object += unit.globals.class_names[structure].members[member] + "().";
        structure = unit.program.structures[structure].members[member].structure;
    }
    const std::uint32_t memory = unit.program.structures[structure].via_memory;
    return object + unit.globals.class_names[structure].memories[memory] + "()";
}

std::string memories_text(Unit& unit, const Kernel& kernel, const Pass& pass) {
    std::string text;
    for (const PassBinding& binding : pass.bindings) {
        if (binding.is_workspace) {
            text += (text.empty() ? "" : ", ") + std::string("iteration.partial_sums(commands)");
            continue;
        }
        const KernelParam& param = kernel.params[binding.place.root];
        if (param.pattern == Pattern::argument) {
            text += (text.empty() ? "" : ", ") + param_name(unit, param) + ".memory";
            continue;
        }
        std::string object = object_of(unit, param);
        ir::StructureId structure = param.structure;
        for (std::uint32_t member : binding.place.members) {
            object += unit.globals.class_names[structure].members[member] + "().";
            structure = unit.program.structures[structure].members[member].structure;
        }
        text +=
            (text.empty() ? "" : ", ") + object + unit.globals.class_names[structure].memories[binding.memory] + "()";
    }
    return text;
}

/// The first visited parameter; null if there is none. Its range gives the size of the iteration, except in draws and
/// kernels over blocks.
const KernelParam* first_visited(const Kernel& kernel) {
    for (const KernelParam& param : kernel.params) {
        if (ir::visits(param.pattern)) return &param;
    }
    return nullptr;
}

/// The expression of a value that the host computes for each call.
std::string uniform_text(Unit& unit, const Kernel& kernel, ir::ExprId value) {
    Printer p(unit.globals);
    reserve_locals_of_calls(p.names);
    for (const KernelParam& param : kernel.params) {
        p.names.declare(param_name(unit, param));
        if (param.pattern == Pattern::value) p.local_names[param.local] = param_name(unit, param);
    }
    p.outer_expression = [&](const ir::Expr& expr) -> Text {
        const KernelParam& param = kernel.params[expr.place.root];
        return structure_property(unit.globals, expr, param.structure, object_of(unit, param));
    };
    return print_any(p, value);
}

std::string value_of(Unit& unit, const Kernel& kernel, const PassParameter& parameter) {
    switch (parameter.source) {
    case ParameterSource::uniform: {
        const std::string text = uniform_text(unit, kernel, parameter.value);
        return is_bool_vector(unit.program, parameter.type)
                   ? storage_text(unit.globals, parameter.type) + "(" + text + ")"
                   : text;
    }
    case ParameterSource::origin: {
        const KernelParam& param = kernel.params[parameter.param];
        if (param.pattern == Pattern::near) return "iteration.centre(" + param_name(unit, param) + ")";
        return param_name(unit, param) + ".origin()";
    }
    case ParameterSource::size: {
        if (kernel.raster) return "iteration.counts()";
        if (kernel.space) return "iteration.visited()";
        const KernelParam* first = first_visited(kernel);
        return first ? param_name(unit, *first) + ".size()" : "{}";
    }
    case ParameterSource::range_size: return param_name(unit, kernel.params[parameter.param]) + ".size()";
    case ParameterSource::index: return param_name(unit, kernel.params[parameter.param]) + ".index()";
    case ParameterSource::address: return "0u";
    case ParameterSource::base: return "{}";
    }
    return "{}";
}

/// Prints `parameters`, the parameter block of a form, with its values. The addresses of buffers stand at its end; the
/// runtime fills them in.
void print_parameters(Unit& unit, Writer& out, const Kernel& kernel, const Pass& pass) {
    const std::vector<NamedParameter> ordered = parameters_in_order(unit.globals, pass);
    std::string values;
    std::size_t addresses = 0;
    out.open("const struct");
    for (const auto& [parameter, member] : ordered) {
        if (parameter->source == ParameterSource::address) {
            ++addresses;
            continue;
        }
        out.line(storage_text(unit.globals, parameter->type) + " " + member + ";");
        values += (values.empty() ? "" : ", ") + value_of(unit, kernel, *parameter);
    }
    if (addresses != 0) {
        out.line("std::uint64_t addresses[" + std::to_string(addresses) + "];");
        values += values.empty() ? "{}" : ", {}";
    }
    out.dedent();
    out.line("} parameters = {" + values + "};");
    out.line("static_assert(sizeof parameters == " + std::to_string(pass.parameter_bytes) + ");");
}

/// Prints the calls that patch sizes which the device computes into the parameters. Returns the offsets of the
/// iteration's size.
std::string print_counts(Unit& unit, Writer& out, const Kernel& kernel, const Pass& pass) {
    std::string sizes;
    if (pass.form == ir::Form::direct && !kernel.space) return sizes;
    for (const auto& [parameter, member] : parameters_in_order(unit.globals, pass)) {
        const std::string offset = std::to_string(parameter->offset);
        const bool is_range = parameter->source == ParameterSource::range_size;
        const bool is_size = parameter->source == ParameterSource::size;
        if (is_range && ir::has_own_range(kernel.params[parameter->param].pattern))
            out.line("iteration.count(" + param_name(unit, kernel.params[parameter->param]) + ", " + offset + ");");
        if (is_size && kernel.space) out.line("iteration.count_blocks(" + offset + ");");
        else if (is_size || (is_range && ir::visits(kernel.params[parameter->param].pattern)))
            sizes += (sizes.empty() ? "" : ", ") + offset;
    }
    return sizes;
}

/// Prints the dispatch of one form.
void print_dispatch(Unit& unit, Writer& out, const Kernel& kernel, const Pass& pass) {
    if (!pass.parameters.empty()) print_parameters(unit, out, kernel, pass);
    const std::string sizes = print_counts(unit, out, kernel, pass);
    out.line("iteration.dispatch(commands, glift::FormName::" + std::string(ir::spelling(pass.form)) + ", " +
             (pass.bindings.empty() ? "{}" : "memories") + ", " +
             (pass.parameters.empty() ? "{}" : "glift::bytes_of(parameters)") +
             (sizes.empty() ? ");" : ", {" + sizes + "});"));
}

/// Further conditions that the parameter `index` and the one which it is alike are of one structure: the states of the
/// structures are the same, and the memories that are bound for both.
std::string of_one_whole(Unit& unit, const Kernel& kernel, const Pass& direct, std::uint32_t index) {
    const std::uint32_t first = kernel.params[index].alike;
    const auto whole = [&](std::uint32_t root) {
        const bool is_component = unit.program.structures[kernel.params[root].structure].field.has_value();
        std::string text = param_name(unit, kernel.params[root]) + (is_component ? "->" : ".structure()");
        for (ir::StructureId id = kernel.params[root].structure; unit.program.structures[id].field;) {
            const std::uint32_t member = unit.program.structures[id].base[0];
            text += (text.ends_with("->") ? "" : ".") + unit.globals.class_names[id].members[member] + "()";
            id = unit.program.structures[id].members[member].structure;
        }
        return text;
    };
    std::string condition = " && " + whole(first) + ".same_state(" + whole(index) + ")";
    for (const PassBinding& binding : direct.bindings) {
        if (binding.is_workspace || binding.place.root != first || ir::is_addressed(unit.program, kernel, binding))
            continue;
        const std::optional<ir::Place> other = ir::seen_from(unit.program, kernel, binding.place, index);
        if (!other) continue;
        condition += " && " + memory_text(unit, kernel.params[first], binding.place) +
                     " == " + memory_text(unit, kernel.params[index], *other);
    }
    return condition;
}

/// The condition under which a call takes the direct form: the device can run it for these ranges and memories, and
/// parameters that the form assumes to have the same state (KernelParam::alike) do.
std::string direct_condition(Unit& unit, const Kernel& kernel, const Pass& direct) {
    std::string condition =
        std::string("iteration.can_be_direct(commands, ") + (direct.bindings.empty() ? "{}" : "memories") + ")";
    for (std::size_t i = 0; i < kernel.params.size(); ++i) {
        if (!ir::is_structure(kernel.params[i])) continue;
        for (std::size_t k = i + 1; k < kernel.params.size(); ++k) {
            if (!ir::is_structure(kernel.params[k])) continue;
            if (kernel.params[k].alike != kernel.params[i].alike) continue;
            if (kernel.params[k].structure != kernel.params[i].structure) continue;
            condition += " && " + param_name(unit, kernel.params[i]) + "->same_state(" +
                         param_name(unit, kernel.params[k]) + ".structure())";
            break;
        }
        if (ir::have_one_whole(unit.program, kernel.params[i], kernel.params[kernel.params[i].alike]))
            condition += of_one_whole(unit, kernel, direct, static_cast<std::uint32_t>(i));
    }
    return condition;
}

/// Prints the choice of a form for the call, and its dispatch.
void print_choice(Unit& unit, Writer& out, const Kernel& kernel, const ir::Lowered::Forms& forms) {
    out.open("if (" + direct_condition(unit, kernel, forms.direct) + ")");
    print_dispatch(unit, out, kernel, forms.direct);
    out.dedent();
    out.open("} else");
    print_dispatch(unit, out, kernel, forms.general);
    out.close();
}

}  // namespace

std::optional<std::size_t> range_of_first_at(const Kernel& kernel) {
    if (kernel.params.empty() || kernel.params[0].pattern != Pattern::at) return std::nullopt;
    return ir::range_giver(kernel.params, 0);
}

/// What stands before the declaration of a value parameter: `[[maybe_unused]] ` if nothing in the parameter blocks of
/// the kernel's forms (Pass::parameters) is computed from it, else nothing.
static std::string value_mark(const Unit& unit, ir::KernelId kernel, ir::LocalId value) {
    bool used = false;
    const ir::Lowered::Forms& forms = unit.lowered.passes[kernel];
    for (const Pass* pass : forms.all())
        for (const PassParameter& parameter : pass->parameters)
            ir::for_each_node(unit.program, parameter.value,
                              [&](ir::ExprId node) { used |= unit.program.exprs[node].local == value; });
    return used ? "" : "[[maybe_unused]] ";
}

std::string kernel_signature(Unit& unit, ir::KernelId index, bool qualified, std::size_t first) {
    const Kernel& kernel = unit.program.kernels[index];
    std::string parameters = "const glift::Commands& commands";
    for (std::size_t i = first; i < kernel.params.size(); ++i) {
        const KernelParam& param = kernel.params[i];
        if (param.pattern == Pattern::value)
            parameters += (qualified || first ? ", " : ", " + value_mark(unit, index, param.local)) +
                          unit.type(unit.program.locals[param.local].type, qualified) + " ";
        else if (param.pattern == Pattern::argument)
            parameters += ", const glift::DeviceScalar<" +
                          storage_text(unit.globals, unit.program.locals[param.local].type, qualified) + ">& ";
        else if (is_container(unit, param)) parameters += ", const " + unit.class_name(param.structure) + "& ";
        else parameters += ", const glift::Range<" + unit.class_name(param.structure) + ">& ";
        parameters += param_name(unit, param);
    }
    return "void " + unit.own.kernels[index] + "(" + parameters + ")";
}

bool function_adds_functions(const Unit& unit, ir::KernelId kernel) {
    bool adds = false;
    const ir::Lowered::Forms& forms = unit.lowered.passes[kernel];
    for (const Pass* pass : forms.all())
        for (const PassParameter& parameter : pass->parameters)
            ir::for_each_node(unit.program, parameter.value, [&](ir::ExprId node) {
                const ir::Expr& expr = unit.program.exprs[node];
                adds |= expr.op == ir::Op::call && !unit.globals.function_names.contains(expr.function);
            });
    return adds;
}

/// Prints the statements that pass the arguments of a call to its glift::Iteration: visited ranges first, since the
/// ranges of `near` parameters are compared with them.
static void print_iteration(const Unit& unit, Writer& out, const Kernel& kernel) {
    for (bool near : {false, true}) {
        for (std::size_t i = 0; i < kernel.params.size(); ++i) {
            const KernelParam& param = kernel.params[i];
            const std::string argument = param_name(unit, param);
            if (!near && ir::visits(param.pattern))
                out.line("iteration.each(\"" + unit.name(param.name) + "\", " + argument + ");");
            if (near && param.pattern == Pattern::near)
                out.line("iteration.near(\"" + unit.name(param.name) + "\", " + argument + ");");
            if (near && !is_container(unit, param) && ir::has_own_range(param.pattern))
                out.line("iteration.any(\"" + unit.name(param.name) + "\", " + argument + ");");
        }
    }
}

/// Prints the call that tells the glift::Iteration how many elements a block has and how many blocks are visited, with
/// a call of the pipeline that counts them if their number is computed on the device.
static void print_blocks_visited(Unit& unit, Writer& out, const Kernel& kernel, const Pass& pass) {
    const KernelParam& param = kernel.params[*kernel.space];
    const ir::Place owner = *ir::blocks_of(unit.program, unit.program.structures[param.structure], {*kernel.space, {}});
    std::string object = param_name(unit, param);
    if (!owner.members.empty()) object += "->";
    ir::StructureId structure = param.structure;
    for (std::uint32_t member : owner.members) {
        object += (object.ends_with("->") ? "" : ".") + unit.globals.class_names[structure].members[member] + "()";
        structure = unit.program.structures[structure].members[member].structure;
    }
    const ir::Blocks& blocks = *unit.program.structures[structure].blocks;
    const auto size = std::ranges::find(pass.parameters, ParameterSource::size, &PassParameter::source);
    std::string text = "iteration.blocks(" + uniform_text(unit, kernel, size->value);
    if (blocks.counter) text += ", " + unit.globals.pipeline_names[blocks.counter] + "(commands, " + object + ")";
    out.line(text + ");");
}

/// Prints the checks that the other visited parameters of a kernel over blocks have the same blocks as the parameter
/// whose blocks are visited: what blocks() and block(i) read (ir::places_of_blocks) must lie in the same memories.
/// Values that these functions use, such as extents, are not compared: those of that parameter are used.
static void print_same_blocks(Unit& unit, Writer& out, const Kernel& kernel) {
    const auto owner_in = [&](const KernelParam& param) {
        return *ir::blocks_of(unit.program, unit.program.structures[param.structure], {});
    };
    const KernelParam& first = kernel.params[*kernel.space];
    const ir::Structure& owner =
        ir::structure_at(unit.program, unit.program.structures[first.structure], owner_in(first).members);
    for (std::uint32_t index : kernel.same_space) {
        const KernelParam& other = kernel.params[index];
        std::string pairs;
        for (const ir::Place& place : ir::places_of_blocks(unit.program, owner)) {
            const auto in = [&](const KernelParam& param) {
                ir::Place whole = owner_in(param);
                whole.members.append(place.members);
                return memory_text(unit, param, whole);
            };
            pairs += (pairs.empty() ? "{" : ", {") + in(first) + ", " + in(other) + "}";
        }
        if (!pairs.empty())
            out.line("iteration.same_blocks(\"" + unit.name(first.name) + "\", \"" + unit.name(other.name) + "\", {" +
                     pairs + "});");
    }
}

std::string kernel_function(Unit& unit, ir::KernelId index) {
    const Kernel& kernel = unit.program.kernels[index];
    const ir::Lowered::Forms& forms = unit.lowered.passes[index];
    const std::string& name = unit.globals.kernel_stems.at(index);
    const Pass& any = forms.general;
    Writer body;
    body.indent();
    body.line((kernel.raster ? "glift::DrawIteration iteration(" : "glift::Iteration iteration(") + name + "_kernel);");
    if (kernel.raster) print_draw_arguments(unit, body, kernel);
    else print_iteration(unit, body, kernel);
    if (kernel.space) print_same_blocks(unit, body, kernel);
    if (kernel.space) print_blocks_visited(unit, body, kernel, any);
    if (!any.bindings.empty())
        body.line("const glift::Memory memories[] = {" + memories_text(unit, kernel, any) + "};");
    if (may_share(any))
        body.line("if (iteration.is_shared(memories)) iteration.share(memories, {" + footprints_text(unit, kernel) +
                  "});");
    print_choice(unit, body, kernel, forms);
    std::string arguments = "commands";
    for (const KernelParam& param : kernel.params) arguments += ", " + param_name(unit, param);
    Writer out;
    out.line("extern const glift::Kernel " + name + "_kernel;");
    out.gap();
    print_function(unit, out,
                   {unit.linkage(kernel.key), kernel_signature(unit, index, false), kernel_signature(unit, index, true),
                    unit.own.kernels[index], arguments, name, name + "_kernel"},
                   body.text());
    return out.take();
}

std::string short_kernel_function(Unit& unit, ir::KernelId index) {
    const Kernel& kernel = unit.program.kernels[index];
    const std::optional<std::size_t> range = range_of_first_at(kernel);
    if (!range) return "";
    std::string arguments = "commands, " + param_name(unit, kernel.params[*range]);
    for (std::size_t i = 1; i < kernel.params.size(); ++i) arguments += ", " + param_name(unit, kernel.params[i]);
    Writer out;
    out.open(unit.linkage(kernel.key) + kernel_signature(unit, index, false, 1));
    Printer p(unit.globals);
    for (const KernelParam& param : kernel.params) p.names.declare(param_name(unit, param));
    out.line(visible(p, unit.globals.kernel_names[index]) + "(" + arguments + ");");
    out.close();
    return out.take();
}

}  // namespace gliftc::cpp
