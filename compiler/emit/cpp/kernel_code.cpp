// Kernels as data: functions for the host device, SPIR-V, and what describes them.
#include "base/lines.h"
#include "emit/cpp/kernel_parts.h"
#include "emit/cpp/sharing.h"
#include "emit/cpp/spirv_file.h"
#include "ir/derivatives.h"
#include "ir/effects.h"
#include "ir/spelling.h"
#include "layout/layout.h"

#include <algorithm>
#include <charconv>
#include <map>

namespace gliftc::cpp {

namespace {

using ir::Kernel;
using ir::ParameterSource;
using ir::Pass;
using ir::PassBinding;
using ir::PassParameter;

std::string memory_kind(ir::MemoryShape shape) {
    switch (shape) {
    case ir::MemoryShape::buffer: return "buffer";
    case ir::MemoryShape::image1d: return "image1d";
    case ir::MemoryShape::image2d: return "image2d";
    case ir::MemoryShape::image3d: return "image3d";
    case ir::MemoryShape::imagecube: return "imagecube";
    case ir::MemoryShape::image2darray: return "image2darray";
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

/// The memory of a binding as in the source: f.data, f.table.data.
std::string display_of(const Unit& unit, const Kernel& kernel, const PassBinding& binding) {
    if (binding.is_workspace) return "partial sums";
    std::string text = unit.name(kernel.params[binding.place.root].name);
    ir::StructureId structure = kernel.params[binding.place.root].structure;
    for (std::uint32_t member : binding.place.members) {
        text += "." + unit.name(unit.program.structures[structure].members[member].name);
        structure = unit.program.structures[structure].members[member].structure;
    }
    return text + "." + unit.name(unit.program.structures[structure].memories[binding.memory].name);
}

/// SPIR-V as a string literal, which C++ compilers read in a fraction of the time that a list of numbers takes them.
void print_literal(Writer& out, const std::string& name, const std::vector<std::uint32_t>& words) {
    constexpr std::size_t words_of_a_line = 12;
    std::string text = "constexpr char32_t " + name + "[] =\n";
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i % words_of_a_line == 0) text += i == 0 ? "    U\"" : "\"\n    U\"";
        char digits[8];
        const auto end = std::to_chars(digits, digits + sizeof digits, words[i], 16).ptr;
        text.append("\\x").append(digits, end);
    }
    out.raw(text + "\";\n");
}

/// The expressions of a form's SPIR-V: `fragment` is that of a draw's fragment shader. Empty: there is none.
struct Words {
    std::string spirv, fragment;
};

/// The expressions for both forms; the same ones where their code is equal.
struct FormWords {
    Words direct, general;
};

FormWords print_words(Unit& unit, Writer& out, ir::KernelId kernel, const std::string& name) {
    FormWords words;
    if (!unit.code.contains(kernel) || !unit.reach.vulkan_kernels.contains(kernel)) return words;
    const KernelCode& code = unit.code[kernel];
    const auto of_part = [&](ir::Part part, const std::string& ending) {
        return [&out, &unit, kernel, name, part, ending](const std::vector<std::uint32_t>& spirv,
                                                         ir::Form form) -> std::string {
            if (spirv.empty()) return "";
            const std::string constant = name + "_" + std::string(ir::spelling(form)) + ending;
            if (unit.spirv_file) return "{" + unit.spirv_file->place_of(kernel, form, part) + "}";
            print_literal(out, constant, spirv);
            return constant;
        };
    };
    const auto print = of_part(ir::Part::vertex, "_spirv"),
               print_fragment = of_part(ir::Part::fragment, "_fragment_spirv");
    const auto print_form = [&](const FormCode& of, ir::Form form) -> Words {
        return {print(of.shader, form), print_fragment(of.fragment, form)};
    };
    words.direct = print_form(code.direct, ir::Form::direct);
    words.general = code.general == code.direct ? words.direct : print_form(code.general, ir::Form::general);
    return words;
}

std::string form_text(const Pass& pass, const Words& words, const std::string& host) {
    std::string text;
    const auto also = [&](const std::string& field) { text += (text.empty() ? "" : ", ") + field; };
    if (!words.spirv.empty()) also(".spirv = " + words.spirv);
    if (!words.fragment.empty()) also(".fragment = " + words.fragment);
    if (!host.empty()) also(".host = &" + host);
    if (pass.parameter_bytes != 0) also(".parameter_bytes = " + std::to_string(pass.parameter_bytes));
    if (pass.push_constants) also(".push_constants = true");
    if (pass.uniform_buffer && pass.parameter_bytes != 0) also(".uniform_buffer = true");
    for (const PassParameter& parameter : pass.parameters) {
        if (parameter.source == ParameterSource::size && parameter.offset != 0)
            also(".size_offset = " + std::to_string(parameter.offset));
        if (parameter.source == ParameterSource::base) also(".base_offset = " + std::to_string(parameter.offset));
    }
    return "{" + text + "}";
}

/// The table of the files, other than the kernel's own, that reports may name.
void print_other_files(Unit& unit, Writer& out, const Pass& pass, const std::string& name) {
    if (pass.files.size() < 2) return;
    std::string list;
    for (std::size_t i = 1; i < pass.files.size(); ++i)
        list += (list.empty() ? "\"" : ", \"") + file_name(unit.sources, pass.files[i]) + "\"";
    out.line("const char* const " + name + "_other_files[] = {" + list + "};");
}

/// The table of what the kernel may print.
void print_messages(Unit& unit, Writer& out, const Pass& pass, const std::string& name) {
    if (pass.messages.empty()) return;
    out.line("constexpr glift::MessageFormat " + name + "_messages[] = {");
    out.indent();
    for (std::uint32_t index : pass.messages) {
        const ir::Message& message = unit.program.messages[index];
        out.line("{" + quoted(message.text) + ", \"" + file_name(unit.sources, message.span.file) + "\", " +
                 std::to_string(unit.sources.line_of(message.span)) + (message.is_assertion ? ", true" : "") + "},");
    }
    out.dedent();
    out.line("};");
}

void print_bindings(Unit& unit, Writer& out, const ir::Lowered::Forms& forms, const Kernel& kernel,
                    const std::string& name) {
    if (forms.general.bindings.empty()) return;
    out.line("const glift::Binding " + name + "_bindings[] = {");
    out.indent();
    for (std::size_t i = 0; i < forms.general.bindings.size(); ++i) {
        const PassBinding& binding = forms.general.bindings[i];
        std::string text = "{.name = " + quoted(display_of(unit, kernel, binding));
        if (binding.shape != ir::MemoryShape::buffer)
            text += std::string(", .kind = glift::MemoryKind::") + memory_kind(binding.shape);
        if (const std::string access = access_text(binding); access != "read")
            text += ", .access = glift::Access::" + access;
        if (binding.sampled) text += ", .sampled = true";
        if (binding.sampled && binding.linear)
            text += ", .sampler = {.filter = glift::Filter::linear" +
                    (binding.compare ? ", .compare = glift::Compare::" + std::string(ir::spelling(*binding.compare))
                                     : std::string()) +
                    "}";
        if (binding.ordered && binding.shape != ir::MemoryShape::buffer) text += ", .as_bits = true";
        if (binding.address_parameter < forms.general.parameters.size())
            text += ", .address_offset = " + std::to_string(forms.general.parameters[binding.address_parameter].offset);
        if (binding.shape == ir::MemoryShape::buffer)
            text += ", .element_bytes = sizeof(" + storage_text(unit.globals, binding.element) + ")";
        text += sharing_fields(unit.program, kernel, binding) + update_fields(unit.program, kernel, forms.general, i);
        out.line(text + "},");
    }
    out.dedent();
    out.line("};");
}

/// glift::Kernel::digest, by which the runtime finds the Vulkan pipelines of a kernel again: a hash (as FNV-1a) of the
/// words of the kernel's SPIR-V and of all else that is printed about it. Empty where there is no code for Vulkan
/// devices, unless a running program replaces kernels whose digest differs (Options::reload).
std::string digest_text(const Unit& unit, ir::KernelId kernel, const std::string& printed) {
    const bool is_on_vulkan = unit.code.contains(kernel) && unit.reach.vulkan_kernels.contains(kernel);
    if (!is_on_vulkan && !unit.options.reload) return "";
    std::uint64_t hash = 14695981039346656037u;
    const auto add = [&](std::uint64_t value) { hash = (hash ^ value) * 1099511628211u; };
    if (is_on_vulkan) {
        for (const FormCode* form : {&unit.code[kernel].direct, &unit.code[kernel].general}) {
            for (const std::vector<std::uint32_t>* words : {&form->shader, &form->fragment}) {
                for (std::uint32_t word : *words) add(word);
                add(words->size());
            }
        }
    }
    for (char c : printed) add(static_cast<unsigned char>(c));
    return std::to_string(hash | 1) + "u";  // 0 means: no digest
}

/// What is printed about a kernel, without what edits of other kernels change: comments, its line, and the names of
/// constants with SPIR-V.
std::string lasting_text(const std::string& printed, const FormWords& words) {
    std::string lasting = without_lines(printed, {"//", ".line"});
    for (const Words* form : {&words.direct, &words.general}) {
        for (const std::string* name : {&form->spirv, &form->fragment}) {
            if (const std::size_t at = name->empty() ? lasting.npos : lasting.find(*name); at != lasting.npos)
                lasting.erase(at, name->size());
        }
    }
    return lasting;
}

/// The table of parameters that Commands::specialised can name.
void print_parameters(const ir::Program& program, Writer& out, const Pass& direct, const std::string& name) {
    std::string rows;
    for (const PassParameter& parameter : direct.parameters)
        rows += (rows.empty() ? "{" : ", {") + quoted(parameter.name) + ", " + std::to_string(parameter.offset) + ", " +
                std::to_string(layout::size_of(program, parameter.type).size) + "}";
    out.line("constexpr glift::Parameter " + name + "_parameters[] = {" + rows + "};");
}

}  // namespace

bool code_adds_functions(const Unit& unit, ir::KernelId kernel) {
    const ir::Lowered::Forms& forms = unit.lowered.passes[kernel];
    const auto is_missing = [&](ir::FunctionId id) {
        return !unit.globals.function_names.contains(id) && is_pure(unit.program, id);
    };
    return std::ranges::any_of(forms.all(),
                               [&](const Pass* pass) { return std::ranges::any_of(pass->functions, is_missing); });
}

/// Prints the code for the host device, if it is wanted: the struct of parameters, and the function. Returns that
/// function's name, or nothing.
static std::string print_host_code(Unit& unit, Writer& out, const Pass& pass, ir::KernelId index) {
    if (!unit.options.host_kernel || !unit.reach.host_kernels.contains(index)) return "";
    const std::string function = unit.globals.kernel_stems.at(index) + "_" + std::string(ir::spelling(pass.form));
    out.raw(parameters_of(unit.globals, pass, function));
    if (!pass.parameters.empty()) out.gap();
    out.raw(unit.options.host_kernel(unit.globals, pass, function));
    out.gap();
    return function;
}

/// The table of the orders of sums, which the host device's code uses, too.
static void print_sums(Writer& out, const std::vector<ir::SumOrder>& orders, const std::string& name) {
    if (orders.empty()) return;
    std::string rows;
    for (const ir::SumOrder& order : orders)
        rows += (rows.empty() ? "{" : ", {") + std::to_string(order.axes) + ", " + std::to_string(order.axis) + ", " +
                std::to_string(order.part) + ", " + std::to_string(order.most_parts) + "}";
    out.line("constexpr glift::SumOrder " + name + "_sums[] = {" + rows + "};");
}

/// The bytes of workgroup memory of the form that needs most: arrays may share memory in one form and not in another.
static std::uint32_t shared_bytes_of(const ir::Lowered::Forms& forms) {
    return std::max(forms.direct.shared_bytes, forms.general.shared_bytes);
}

/// Prints further fields of glift::Kernel, each only where it differs from its default.
static void print_rare_fields(Unit& unit, Writer& out, const ir::Lowered::Forms& forms, const std::string& name) {
    const Pass& any = forms.general;
    const std::array<std::uint32_t, 3>& items = variant_for(any, ir::Devices::shaders).assumes.elements;
    if (items != std::array{1u, 1u, 1u})
        out.line(".items = {" + std::to_string(items[0]) + ", " + std::to_string(items[1]) + ", " +
                 std::to_string(items[2]) + "},");
    if (any.of_blocks) out.line(".of_blocks = true,");
    if (unit.program.kernels[any.kernel].grouped()) out.line(".declares_group = true,");
    if (any.has_status()) out.line(".reports = true,");
    if (const std::uint32_t bytes = shared_bytes_of(forms)) out.line(".shared_bytes = " + std::to_string(bytes) + ",");
    if (!any.sum_orders().empty()) out.line(".sums = " + name + "_sums,");
    if (any.loop_rounds != 0 && any.longest_loop)
        out.line(".longest_loop = {\"" + file_name(unit.sources, any.longest_loop.file) + "\", " +
                 std::to_string(unit.sources.line_of(any.longest_loop)) + "},");
    if (!any.messages.empty()) {
        out.line(".messages = " + name + "_messages,");
        const ir::TypeId address = unit.program.kernels[any.kernel].domain_type;
        out.line(".address_rank = " + std::to_string(unit.program.types.components(address)) + ",");
    }
    if (any.files.size() > 1) out.line(".other_files = " + name + "_other_files,");
}

std::string kernel_code(Unit& unit, ir::KernelId index) {
    const Kernel& kernel = unit.program.kernels[index];
    const ir::Lowered::Forms& forms = unit.lowered.passes[index];
    const std::string& name = unit.globals.kernel_stems.at(index);
    const Pass& any = forms.general;
    const bool has_parameters = !forms.direct.parameters.empty();
    Writer code, spirv, out;
    code.line("// " + place_text(unit.sources, kernel.span) + ": " + kernel.display);
    code.gap();
    code.line("namespace {");
    code.gap();
    print_sums(code, any.sum_orders(), name);
    const std::string host = print_host_code(unit, code, forms.general, index);
    print_bindings(unit, code, forms, kernel, name);
    if (has_parameters) print_parameters(unit.program, code, forms.direct, name);
    print_other_files(unit, code, any, name);
    print_messages(unit, code, any, name);
    if (kernel.raster) {
        const auto derives = [&](const Pass& pass) { return ir::derives_loads(unit.program, pass); };
        print_drawing(unit, code, kernel, name, derives(forms.direct) || derives(forms.general));
    }
    const FormWords words = print_words(unit, spirv, index, name);

    const std::string place = place_text(unit.sources, kernel.span);
    const std::size_t colon = place.rfind(':');
    out.line("}  // namespace");
    out.gap();
    out.line(std::string("extern ") + unit.linkage(kernel.key) + "const glift::Kernel " + name + "_kernel;");
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
    out.line(".direct = " + form_text(forms.direct, words.direct, "") + ",");
    out.line(".general = " + form_text(forms.general, words.general, host) + ",");
    if (any.is_wide) out.line(".address_bits = 64,");
    if (has_parameters) out.line(".parameters = " + name + "_parameters,");
    print_rare_fields(unit, out, forms, name);
    if (kernel.raster) out.line(".drawing = &" + name + "_drawing,");
    const std::string printed =
        unit.options.reload ? lasting_text(code.text() + out.text(), words) : code.text() + out.text();
    if (const std::string digest = digest_text(unit, index, printed); !digest.empty())
        out.line(".digest = " + digest + ",");
    out.close(";");
    return code.text() + spirv.text() + out.text();
}

}  // namespace gliftc::cpp
