#include "layout/private_memory.h"

#include "ir/walk.h"
#include "layout/layout.h"

namespace gliftc::layout {

using namespace ir;

namespace {

std::uint64_t bytes_in(const Program& program, const std::vector<StmtId>& body) {
    std::uint64_t bytes = 0;
    for_each_statement(program, body, [&](const Stmt& stmt) {
        if (stmt.op != StmtOp::let) return;
        const TypeId type = program.locals[stmt.local].type;
        if (program.types.kind(type) == TypeKind::array || program.types.kind(type) == TypeKind::struct_)
            bytes += size_of(program, type).size;
    });
    return bytes;
}

}  // namespace

void check_private_memory(const Program& program, const Lowered& lowered, Diagnostics& diagnostics) {
    for (KernelId i : lowered.passes.ids()) {
        const Pass& pass = lowered.passes[i].general;
        std::uint64_t bytes = bytes_in(program, pass.plain().body);
        for (FunctionId function : pass.functions) bytes += bytes_in(program, program.functions[function].body);
        if (bytes <= private_limit) continue;
        const Kernel& kernel = program.kernels[i];
        Diagnostic& report = diagnostics.report(Diag::private_memory, kernel.span,
                                                {kernel.display, std::to_string(bytes), std::to_string(private_limit)});
        report.notes.push_back({{}, "keep large tables in a structure, and pass it to the kernel"});
    }
}

}  // namespace gliftc::layout
