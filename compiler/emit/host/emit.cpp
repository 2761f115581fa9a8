#include "emit/host/emit.h"

#include "emit/host/body.h"

#include <algorithm>

namespace gliftc::host {

std::string parameters_of(const cpp::Globals& globals, const ir::Pass& pass, const std::string& name) {
    if (pass.parameters.empty()) return "";
    std::vector<const ir::PassParameter*> ordered;
    for (const ir::PassParameter& parameter : pass.parameters) ordered.push_back(&parameter);
    std::ranges::stable_sort(ordered, {}, &ir::PassParameter::offset);
    cpp::Writer out;
    out.open("struct " + name + "_parameters");
    for (const ir::PassParameter* parameter : ordered) {
        const std::string member = cpp::identifier(parameter->name);
        out.line(cpp::storage_text(globals, parameter->type) + " " + member + ";");
    }
    out.close(";");
    for (const ir::PassParameter* parameter : ordered) {
        out.line("static_assert(offsetof(" + name + "_parameters, " + cpp::identifier(parameter->name) +
                 ") == " + std::to_string(parameter->offset) + ");");
    }
    return out.take();
}

std::string kernel_of(cpp::Globals& globals, const ir::Pass& pass, const std::string& name) {
    return globals.program.kernels[pass.kernel].grouped() ? group_kernel(globals, pass, name) : row_kernel(globals, pass, name);
}

}  // namespace gliftc::host
