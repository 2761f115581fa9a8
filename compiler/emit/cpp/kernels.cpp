// Kernels: their code as data, and the functions that call them.
#include "emit/cpp/sharing.h"
#include "emit/cpp/unit.h"
#include "ir/effects.h"
#include "ir/walk.h"

#include <algorithm>
#include <charconv>
#include <map>

namespace gliftc::cpp {

namespace {

using ir::Kernel;
using ir::KernelParam;
using ir::ParameterSource;
using ir::Pass;
using ir::PassBinding;
using ir::PassParameter;
using ir::Pattern;

std::string memory_kind(ir::MemoryShape shape) {
    switch (shape) {
    case ir::MemoryShape::buffer: return "buffer";
    case ir::MemoryShape::image1d: return "image1d";
    case ir::MemoryShape::image2d: return "image2d";
    case ir::MemoryShape::image3d: return "image3d";
    case ir::MemoryShape::imagecube: return "imagecube";
    }
    return "buffer";
}

std::string access_text(const PassBinding& binding) {
    if (binding.atomic) return "read_write";
    switch (binding.access) {
    case ir::Access::read: return "read";
    case ir::Access::write: return "write";
    case ir::Access::read_write: return "read_write";
    }
    return "read_write";
}

/// f.data, f.table.data: as in the source.
std::string display_of(const Unit& unit, const Kernel& kernel, const PassBinding& binding) {
    std::string text = unit.name(kernel.params[binding.place.root].name);
    std::uint32_t structure = kernel.params[binding.place.root].structure;
    for (std::uint32_t member : binding.place.members) {
        text += "." + unit.name(unit.program.structures[structure].members[member].name);
        structure = unit.program.structures[structure].members[member].structure;
    }
    return text + "." + unit.name(unit.program.structures[structure].memories[binding.memory].name);
}

/// As a literal, which C++ compilers read in a fraction of the time that a list of numbers takes them.
void print_words(Writer& out, const std::string& name, const std::vector<std::uint32_t>& words) {
    constexpr std::size_t words_of_a_line = 12;
    std::string text = "constexpr std::u32string_view " + name + "(\n";
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i % words_of_a_line == 0) text += i == 0 ? "    U\"" : "\"\n    U\"";
        char digits[8];
        const auto end = std::to_chars(digits, digits + sizeof digits, words[i], 16).ptr;
        text.append("\\x").append(digits, end);
    }
    out.raw(text + "\", " + std::to_string(words.size()) + ");\n");
}

/// Names of the SPIR-V of the three forms; identical code is there once.
struct Words {
    std::string direct, general, wide;
};

Words print_code(Unit& unit, Writer& out, std::uint32_t kernel, const std::string& name) {
    Words words;
    if (kernel >= unit.code.size() || !unit.reach.vulkan_kernels.contains(kernel)) return words;
    const KernelCode& code = unit.code[kernel];
    const auto print = [&](const std::vector<std::uint32_t>& spirv, const char* form) -> std::string {
        if (spirv.empty()) return "";
        const std::string array = name + "_" + form + "_spirv";
        print_words(out, array, spirv);
        return array;
    };
    words.direct = print(code.direct, "direct");
    words.general = code.general == code.direct ? words.direct : print(code.general, "general");
    words.wide = code.wide == code.general ? words.general : print(code.wide, "wide");
    return words;
}

std::string form_text(const Pass& pass, const std::string& spirv, const std::string& host) {
    std::string text;
    const auto also = [&](const std::string& field) { text += (text.empty() ? "" : ", ") + field; };
    if (!spirv.empty()) also(".spirv = " + spirv);
    if (!host.empty()) also(".host = &" + host);
    if (pass.parameter_bytes != 0) also(".parameter_bytes = " + std::to_string(pass.parameter_bytes));
    if (pass.push_constants) also(".push_constants = true");
    for (const PassParameter& parameter : pass.parameters) {
        if (parameter.source == ParameterSource::size && parameter.offset != 0)
            also(".size_offset = " + std::to_string(parameter.offset));
        if (parameter.source == ParameterSource::base) also(".base_offset = " + std::to_string(parameter.offset));
    }
    return "{" + text + "}";
}

/// The files, other than the kernel's own, that reports may name.
void print_other_files(Unit& unit, Writer& out, const Pass& pass, const std::string& name) {
    if (pass.files.size() < 2) return;
    std::string list;
    for (std::size_t i = 1; i < pass.files.size(); ++i)
        list += (list.empty() ? "\"" : ", \"") + file_name(unit.sources, pass.files[i]) + "\"";
    out.line("const char* const " + name + "_other_files[] = {" + list + "};");
}

void print_bindings(Unit& unit, Writer& out, const ir::Lowered::Forms& forms, const Kernel& kernel,
                    const std::string& name) {
    if (forms.general.bindings.empty()) return;
    const bool shares = may_share(forms.general);
    out.line("const glift::Binding " + name + "_bindings[] = {");
    out.indent();
    for (std::size_t i = 0; i < forms.general.bindings.size(); ++i) {
        const PassBinding& binding = forms.general.bindings[i];
        std::string text = "{.name = " + quoted(display_of(unit, kernel, binding)) +
                           ", .kind = glift::MemoryKind::" + memory_kind(binding.shape) +
                           ", .access = glift::Access::" + access_text(binding);
        if (binding.sampled) text += ", .sampled = true";
        if (binding.sampled && binding.linear) text += ", .sampler = {.filter = glift::Filter::linear}";
        if (i < forms.wide.bindings.size() && forms.wide.bindings[i].address_parameter < forms.wide.parameters.size())
            text += ", .address_offset = " +
                    std::to_string(forms.wide.parameters[forms.wide.bindings[i].address_parameter].offset);
        if (binding.shape == ir::MemoryShape::buffer)
            text += ", .element_bytes = sizeof(" + storage_text(unit.globals, binding.element) + ")";
        if (shares) text += sharing_fields(unit.program, kernel, binding);
        out.line(text + "},");
    }
    out.dedent();
    out.line("};");
}

/// How the structure passed for a parameter is spelled in the kernel's function.
const std::string& param_name(const Unit& unit, const KernelParam& param) {
    return unit.globals.param_names.at(&param);
}

/// The structures passed, in order.
std::string structures_text(const Unit& unit, const Kernel& kernel) {
    std::string text;
    for (const KernelParam& param : kernel.params)
        if (param.pattern != Pattern::value) text += (text.empty() ? "" : ", ") + param_name(unit, param);
    return text;
}

std::string memories_text(Unit& unit, const Kernel& kernel, const Pass& pass) {
    std::string text;
    for (const PassBinding& binding : pass.bindings) {
        const KernelParam& param = kernel.params[binding.place.root];
        std::string object = param_name(unit, param) + "->";
        std::uint32_t structure = param.structure;
        for (std::uint32_t member : binding.place.members) {
            object += unit.globals.class_names[structure].members[member] + "().";
            structure = unit.program.structures[structure].members[member].structure;
        }
        text +=
            (text.empty() ? "" : ", ") + object + unit.globals.class_names[structure].memories[binding.memory] + "()";
    }
    return text;
}

/// The parameter whose range the kernel's size is.
const KernelParam* first_visited(const Kernel& kernel) {
    for (const KernelParam& param : kernel.params) {
        if (ir::visits(param.pattern)) return &param;
    }
    return nullptr;
}

std::string value_of(Unit& unit, const Kernel& kernel, const PassParameter& parameter) {
    switch (parameter.source) {
    case ParameterSource::uniform: {
        Printer p(unit.globals);
        for (const KernelParam& param : kernel.params) {
            p.names.declare(param_name(unit, param));
            if (param.pattern == Pattern::value) p.local_names[param.local] = param_name(unit, param);
        }
        p.outer_expression = [&](const ir::Expr& expr) -> Text {
            const KernelParam& param = kernel.params[expr.place.root];
            return structure_property(unit.globals, expr, param.structure, param_name(unit, param) + "->");
        };
        std::string text = print_any(p, parameter.value);
        if (is_bool_vector(unit.program, parameter.type))
            text = storage_text(unit.globals, parameter.type) + "(" + text + ")";
        return text;
    }
    case ParameterSource::origin: {
        const KernelParam& param = kernel.params[parameter.param];
        if (param.pattern == Pattern::near) return "iteration.centre(" + param_name(unit, param) + ")";
        return param_name(unit, param) + ".origin()";
    }
    case ParameterSource::size: {
        const KernelParam* first = first_visited(kernel);
        return first ? param_name(unit, *first) + ".size()" : "{}";
    }
    case ParameterSource::range_size: return param_name(unit, kernel.params[parameter.param]) + ".size()";
    case ParameterSource::address: return "0u";
    case ParameterSource::base: return "{}";
    }
    return "{}";
}

/// A parameter of a pass, and its name in the struct of them.
struct NamedParameter {
    const PassParameter* parameter;
    std::string member;
};

std::vector<NamedParameter> in_order(const Globals& globals, const Pass& pass) {
    const std::vector<std::string> names = block_names(globals, pass);
    std::vector<NamedParameter> ordered;
    for (std::size_t i = 0; i < names.size(); ++i) ordered.push_back({&pass.parameters[i], names[i]});
    std::ranges::stable_sort(ordered, {}, [](const NamedParameter& named) { return named.parameter->offset; });
    return ordered;
}

/// Tells kernels from each other, FNV-1a of their code and of all that is printed about them. Empty where there is no
/// code for devices that keep any.
std::string digest_text(const Unit& unit, std::uint32_t kernel, const std::string& printed) {
    if (kernel >= unit.code.size() || !unit.reach.vulkan_kernels.contains(kernel)) return "";
    std::uint64_t hash = 14695981039346656037u;
    const auto add = [&](std::uint64_t value) { hash = (hash ^ value) * 1099511628211u; };
    const KernelCode& code = unit.code[kernel];
    for (const std::vector<std::uint32_t>* form : {&code.direct, &code.general, &code.wide}) {
        for (std::uint32_t word : *form) add(word);
        add(form->size());
    }
    for (char c : printed) add(static_cast<unsigned char>(c));
    return std::to_string(hash | 1) + "u";  // 0 would say that there is none
}

const char* form_name(ir::Form form) {
    switch (form) {
    case ir::Form::direct: return "direct";
    case ir::Form::general: return "general";
    case ir::Form::wide: return "wide";
    }
    return "";
}

/// Declares `parameters` and dispatches one form.
void print_dispatch(Unit& unit, Writer& out, const Kernel& kernel, const Pass& pass, const std::string& name,
                    const char* form) {
    const std::vector<NamedParameter> ordered = in_order(unit.globals, pass);
    const std::string block = name + "_" + form + "_parameters";
    if (!ordered.empty()) {
        out.open("const " + block + " parameters =");
        for (const auto& [parameter, member] : ordered)
            out.line("." + member + " = " + value_of(unit, kernel, *parameter) + ",");
        out.close(";");
    }
    std::string call = std::string("{.form = glift::FormName::") + form +
                       ", .memories = " + (pass.bindings.empty() ? "{}" : "memories") +
                       ", .parameters = " + (ordered.empty() ? "{}" : "glift::bytes_of(parameters)") +
                       ", .size = iteration.size()";
    std::string counted;
    bool counts_ranges = false;
    if (pass.form != ir::Form::direct) {
        for (const auto& [parameter, member] : ordered) {
            const std::string offset = "offsetof(" + block + ", " + member + ")";
            if (parameter->source == ParameterSource::range_size &&
                !ir::visits(kernel.params[parameter->param].pattern)) {
                out.line("iteration.count(" + param_name(unit, kernel.params[parameter->param]) + ", " + offset + ");");
                counts_ranges = true;
            }
            const bool of_first =
                parameter->source == ParameterSource::range_size && ir::visits(kernel.params[parameter->param].pattern);
            if (parameter->source == ParameterSource::size || of_first)
                counted += (counted.empty() ? "" : ", ") + offset;
        }
    }
    if (!counted.empty() || counts_ranges) call += ", .patches = iteration.patches({" + counted + "})";
    if (may_share(pass)) call += ", .sharing = iteration.sharing()";
    out.line("commands.dispatch(" + name + "_kernel, " + call + "});");
}

/// Parameters that are taken to be made alike must have equal states in the direct form.
std::string direct_condition(const Unit& unit, const Kernel& kernel) {
    std::string condition = "iteration.is_whole()";
    for (std::size_t i = 0; i < kernel.params.size(); ++i) {
        if (kernel.params[i].pattern == Pattern::value) continue;
        for (std::size_t k = i + 1; k < kernel.params.size(); ++k) {
            if (kernel.params[k].pattern == Pattern::value) continue;
            if (kernel.params[k].alike != kernel.params[i].alike) continue;
            condition += " && " + param_name(unit, kernel.params[i]) + "->same_state(" +
                         param_name(unit, kernel.params[k]) + ".structure())";
            break;
        }
    }
    return condition;
}

/// The dispatch of the form that the call can take.
void print_choice(Unit& unit, Writer& out, const Kernel& kernel, const ir::Lowered::Forms& forms,
                  const std::string& name) {
    std::vector<std::pair<const Pass*, std::string>> choices;
    const bool shares = ir::has_one_place(forms.general);
    if (forms.wide.exists)
        choices.emplace_back(&forms.wide, "commands.needs_wide(" + name + "_kernel, " +
                                              (forms.wide.bindings.empty() ? "{}" : "memories") + ", iteration.size()" +
                                              (shares ? ", iteration.sharing())" : ")"));
    if (forms.direct.exists)
        choices.emplace_back(&forms.direct, direct_condition(unit, kernel) +
                                                (shares ? " && iteration.sharing() != glift::Sharing::one_place" : ""));
    if (forms.general.exists) choices.emplace_back(&forms.general, "");
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const auto& [pass, condition] = choices[i];
        const bool is_last = i + 1 == choices.size();
        if (i != 0) out.dedent();
        const std::string otherwise = i == 0 ? "" : "} else ";
        if (!is_last) out.open(otherwise + "if (" + condition + ")");
        else if (i != 0) out.open("} else");
        print_dispatch(unit, out, kernel, *pass, name, form_name(pass->form));
        if (is_last && i != 0) out.close();
    }
}

/// What Commands::specialised can name.
void print_parameters(const Globals& globals, Writer& out, const Pass& direct, const std::string& name) {
    const std::string block = name + "_direct_parameters";
    out.open("constexpr glift::Parameter " + name + "_parameters[] =");
    const std::vector<std::string> members = block_names(globals, direct);
    for (std::size_t i = 0; i < members.size(); ++i) {
        const PassParameter& parameter = direct.parameters[i];
        out.line("{" + quoted(parameter.name) + ", " + std::to_string(parameter.offset) + ", sizeof(" + block +
                 "::" + members[i] + ")},");
    }
    out.close(";");
}

}  // namespace

std::string parameters_of(const Globals& globals, const ir::Pass& pass, const std::string& name) {
    if (pass.parameters.empty()) return "";
    const std::vector<NamedParameter> ordered = in_order(globals, pass);
    Writer out;
    out.open("struct " + name + "_parameters");
    for (const auto& [parameter, member] : ordered)
        out.line(storage_text(globals, parameter->type) + " " + member + ";");
    out.close(";");
    for (const auto& [parameter, member] : ordered)
        out.line("static_assert(offsetof(" + name + "_parameters, " + member +
                 ") == " + std::to_string(parameter->offset) + ");");
    return out.take();
}

std::optional<std::size_t> range_of_first_at(const Kernel& kernel) {
    if (kernel.params.empty() || kernel.params[0].pattern != Pattern::at) return std::nullopt;
    return ir::range_giver(kernel.params, 0);
}

/// A value that no form of the kernel has a parameter for need not be used where the kernel is defined.
static std::string value_mark(const Unit& unit, std::uint32_t kernel, ir::LocalId value) {
    bool used = false;
    const ir::Lowered::Forms& forms = unit.lowered.passes[kernel];
    for (const Pass* pass : {&forms.direct, &forms.general, &forms.wide})
        for (const PassParameter& parameter : pass->parameters)
            ir::for_each_node(unit.program, parameter.value,
                              [&](ir::ExprId node) { used |= unit.program.exprs[node].local == value; });
    return used ? "" : "[[maybe_unused]] ";
}

std::string kernel_signature(Unit& unit, std::uint32_t index, bool qualified, std::size_t first) {
    const Kernel& kernel = unit.program.kernels[index];
    std::string parameters = "const glift::Commands& commands";
    for (std::size_t i = first; i < kernel.params.size(); ++i) {
        const KernelParam& param = kernel.params[i];
        if (param.pattern == Pattern::value)
            parameters += (qualified || first ? ", " : ", " + value_mark(unit, index, param.local)) +
                          unit.type(unit.program.locals[param.local].type, qualified) + " ";
        else parameters += ", const glift::Range<" + unit.class_name(param.structure) + ">& ";
        parameters += param_name(unit, param);
    }
    return "void " + unit.own.kernels[index] + "(" + parameters + ")";
}

bool code_adds_functions(const Unit& unit, std::uint32_t kernel) {
    const ir::Lowered::Forms& forms = unit.lowered.passes[kernel];
    const auto is_missing = [&](ir::FunctionId id) {
        return !unit.globals.function_names.contains(id) && is_pure(unit.program, id);
    };
    return std::ranges::any_of(forms.direct.functions, is_missing) ||
           std::ranges::any_of(forms.general.functions, is_missing) ||
           std::ranges::any_of(forms.wide.functions, is_missing);
}

bool function_adds_functions(const Unit& unit, std::uint32_t kernel) {
    bool adds = false;
    const ir::Lowered::Forms& forms = unit.lowered.passes[kernel];
    for (const Pass* pass : {&forms.direct, &forms.general, &forms.wide})
        for (const PassParameter& parameter : pass->parameters)
            ir::for_each_node(unit.program, parameter.value, [&](ir::ExprId node) {
                const ir::Expr& expr = unit.program.exprs[node];
                adds |= expr.op == ir::Op::call && !unit.globals.function_names.contains(expr.function);
            });
    return adds;
}

std::string kernel_code(Unit& unit, std::uint32_t index) {
    const Kernel& kernel = unit.program.kernels[index];
    const ir::Lowered::Forms& forms = unit.lowered.passes[index];
    const std::string& name = unit.globals.kernel_stems.at(index);
    Writer out;
    out.line("// " + std::string(100, '-'));
    out.line("// " + place_text(unit.sources, kernel.span) + ": " + kernel.display);
    out.gap();
    std::map<const Pass*, std::string> host;
    for (const Pass* pass : {&forms.direct, &forms.general, &forms.wide}) {
        if (!pass->exists) continue;
        const std::string form = name + "_" + form_name(pass->form);
        out.raw(parameters_of(unit.globals, *pass, form));
        if (!pass->parameters.empty()) out.gap();
        if (!unit.options.host_kernel || !unit.reach.host_kernels.contains(index)) continue;
        out.raw(unit.options.host_kernel(unit.globals, *pass, form));
        out.gap();
        host[pass] = form;
    }
    const Words words = print_code(unit, out, index, name);
    print_bindings(unit, out, forms, kernel, name);
    const bool has_parameters = forms.direct.exists && !forms.direct.parameters.empty();
    if (has_parameters) print_parameters(unit.globals, out, forms.direct, name);
    const Pass& any = forms.general.exists ? forms.general : forms.direct;
    print_other_files(unit, out, any, name);
    const std::string place = place_text(unit.sources, kernel.span);
    const std::size_t colon = place.rfind(':');
    out.open("const glift::Kernel " + name + "_kernel =");
    out.line(".name = \"" + unit.name(kernel.name) + "\",");
    out.line(".file = \"" + (colon == std::string::npos ? "" : place.substr(0, colon)) + "\",");
    out.line(".line = " + (colon == std::string::npos ? "0" : place.substr(colon + 1)) + ",");
    out.line(".rank = " + std::to_string(any.rank) + ",");
    out.line(".group = {" + std::to_string(any.group[0]) + ", " + std::to_string(any.group[1]) + ", " +
             std::to_string(any.group[2]) + "},");
    out.line(".loop_rounds = " + (any.loop_rounds == UINT64_MAX ? "UINT64_MAX" : std::to_string(any.loop_rounds)) +
             ",");
    out.line(".bindings = " + (any.bindings.empty() ? "{}" : name + "_bindings") + ",");
    out.line(".direct = " + (forms.direct.exists ? form_text(forms.direct, words.direct, host[&forms.direct]) : "{}") +
             ",");
    out.line(".general = " +
             (forms.general.exists ? form_text(forms.general, words.general, host[&forms.general]) : "{}") + ",");
    out.line(".wide = " + (forms.wide.exists ? form_text(forms.wide, words.wide, host[&forms.wide]) : "{}") + ",");
    if (has_parameters) out.line(".parameters = " + name + "_parameters,");
    if (any.taken != std::array{1u, 1u, 1u})
        out.line(".items = {" + std::to_string(any.taken[0]) + ", " + std::to_string(any.taken[1]) + ", " +
                 std::to_string(any.taken[2]) + "},");
    if (any.has_status()) out.line(".reports = true,");
    if (any.shared_bytes) out.line(".shared_bytes = " + std::to_string(any.shared_bytes) + ",");
    if (any.loop_rounds != 0 && any.longest_loop)
        out.line(".longest_loop = {\"" + file_name(unit.sources, any.longest_loop.file) + "\", " +
                 std::to_string(unit.sources.line_of(any.longest_loop)) + "},");
    if (any.files.size() > 1) out.line(".other_files = " + name + "_other_files,");
    if (const std::string digest = digest_text(unit, index, out.text()); !digest.empty())
        out.line(".digest = " + digest + ",");
    out.close(";");
    return out.take();
}

std::string kernel_function(Unit& unit, std::uint32_t index) {
    const Kernel& kernel = unit.program.kernels[index];
    const ir::Lowered::Forms& forms = unit.lowered.passes[index];
    const std::string& name = unit.globals.kernel_stems.at(index);
    const Pass& any = forms.general.exists ? forms.general : forms.direct;
    Writer out;
    out.open(unit.linkage(kernel.key) + kernel_signature(unit, index, false));
    out.line("glift::Iteration iteration(" + name + "_kernel);");
    for (bool near : {false, true}) {
        for (std::size_t i = 0; i < kernel.params.size(); ++i) {
            const KernelParam& param = kernel.params[i];
            const std::string argument = param_name(unit, param);
            if (!near && ir::visits(param.pattern))
                out.line("iteration.each(\"" + unit.name(param.name) + "\", " + argument + ");");
            if (near && param.pattern == Pattern::near)
                out.line("iteration.near(\"" + unit.name(param.name) + "\", " + argument + ");");
            if (near && ir::has_own_range(param.pattern))
                out.line("iteration.any(\"" + unit.name(param.name) + "\", " + argument + ");");
        }
    }
    if (!any.bindings.empty()) out.line("const glift::Memory memories[] = {" + memories_text(unit, kernel, any) + "};");
    if (may_share(any))
        out.line("if (iteration.is_shared(memories)) iteration.share(memories, {" + structures_text(unit, kernel) +
                 "});");
    print_choice(unit, out, kernel, forms, name);
    out.close();
    return out.take();
}

std::string short_kernel_function(Unit& unit, std::uint32_t index) {
    const Kernel& kernel = unit.program.kernels[index];
    const std::optional<std::size_t> range = range_of_first_at(kernel);
    if (!range) return "";
    std::string arguments = "commands, " + param_name(unit, kernel.params[*range]);
    for (std::size_t i = 1; i < kernel.params.size(); ++i) arguments += ", " + param_name(unit, kernel.params[i]);
    Writer out;
    out.open(unit.linkage(kernel.key) + kernel_signature(unit, index, false, 1));
    Printer p(unit.globals);
    for (const KernelParam& param : kernel.params) p.names.declare(param_name(unit, param));
    out.line(visible(p, unit.globals.kernel_names.at(index)) + "(" + arguments + ");");
    out.close();
    return out.take();
}

}  // namespace gliftc::cpp
