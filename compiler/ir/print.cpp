#include "ir/print.h"

#include "ir/evaluate.h"
#include "ir/printer.h"

namespace gliftc::ir {

/// Reserves the names of the pass's bindings and of the kernel's parameters other than values (which are locals
/// themselves), so that no local gets them.
Printer::Printer(const Program& program, const Pass* pass, const Kernel* kernel)
    : p(program), pass_(pass), kernel_(kernel) {
    if (pass == nullptr) return;
    if (pass->kernel) kernel_ = &program.kernels[pass->kernel];
    for (const PassBinding& of : pass->bindings) taken_[of.name] = 1;
    if (kernel_)
        for (const KernelParam& of : kernel_->params)
            if (of.pattern != Pattern::value) taken_[name(of.name)] = 1;
}

void Printer::kernel() {
    std::string text = "kernel " + name(kernel_->name) + "(";
    for (std::size_t i = 0; i < kernel_->params.size(); ++i) {
        const KernelParam& param = kernel_->params[i];
        bool is_value = param.pattern == Pattern::value;
        text += (i ? ", " : "") + name(param.name) + ": " +
                (is_value ? to_text(p, p.locals[param.local].type) : p.structures[param.structure].display);
    }
    line(text + ") {");
    body(kernel_->body);
    line("}");
}

std::string print(const Program& program, ExprId expr, const Pass* pass) { return Printer(program, pass).expr(expr); }

std::string print(const Program& program, const std::vector<StmtId>& body, const Pass* pass) {
    Printer printer(program, pass);
    printer.body(body);
    return printer.take();
}

std::string print(const Program& program, FunctionId function, const Pass* pass) {
    Printer printer(program, pass);
    printer.function(function);
    return printer.take();
}

std::string print(const Program& program, const Pass& pass, const std::vector<ExprId>& facts) {
    Printer printer(program, &pass);
    printer.pass(facts);
    return printer.take();
}

std::string print(const Program& program, const Lowered& lowered) {
    std::string text;
    for (const Lowered::Forms& forms : lowered.passes) {
        if (!program.modules[program.kernels[forms.direct.kernel].module].is_root) continue;
        for (const Pass* pass : forms.all()) text += print(program, *pass) + "\n";
    }
    return text;
}

std::string print(const Program& program) {
    std::string text;
    for (std::uint32_t i = 0; i < program.functions.size(); ++i) text += print(program, FunctionId{i}) + "\n";
    for (const Structure& structure : program.structures) text += "structure " + structure.display + "\n";
    for (const Kernel& kernel : program.kernels) {
        Printer printer(program, nullptr, &kernel);
        printer.kernel();
        text += "\n" + printer.take();
    }
    for (const Pipeline& pipeline : program.pipelines) {
        Printer printer(program, nullptr);
        printer.line("\npipeline " + (*program.names)[pipeline.name] + " {");
        printer.body(pipeline.body);
        printer.line("}");
        text += printer.take();
    }
    return text;
}

}  // namespace gliftc::ir
