#include "emit/cpp/kernel_parts.h"

#include <algorithm>

namespace gliftc::cpp {

std::vector<NamedParameter> parameters_in_order(const Globals& globals, const ir::Pass& pass) {
    const std::vector<std::string> names = block_names(globals, pass);
    std::vector<NamedParameter> ordered;
    for (std::size_t i = 0; i < names.size(); ++i) ordered.push_back({&pass.parameters[i], names[i]});
    std::ranges::stable_sort(ordered, {}, [](const NamedParameter& named) { return named.parameter->offset; });
    return ordered;
}

std::string parameters_of(const Globals& globals, const ir::Pass& pass, const std::string& name) {
    if (pass.parameters.empty()) return "";
    const std::vector<NamedParameter> ordered = parameters_in_order(globals, pass);
    Writer out;
    out.open("struct " + name + "_parameters");
    for (const auto& [parameter, member] : ordered)
        out.line(storage_text(globals, parameter->type) + " " + member + ";");
    out.close(";");
    out.line("static_assert(sizeof(" + name + "_parameters) == " + std::to_string(pass.parameter_bytes) + ");");
    return out.take();
}

}  // namespace gliftc::cpp
