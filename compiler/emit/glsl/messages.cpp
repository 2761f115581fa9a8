// Messages of `print` and `assert`: a shader appends them to the device's buffer (glift/message_format.h).
#include "emit/glsl/printer.h"

namespace gliftc::glsl {

void name_messages(Printer& p) {
    if (p.pass.messages.empty()) return;
    p.names.declare("Messages");
    p.messages.block = p.names.declare("messages");
    p.messages.begin = p.names.declare("begin_message");
    p.messages.place = p.names.declare("message_at");
}

std::string message_definitions(const Printer& p) {
    if (p.pass.messages.empty()) return "";
    const std::string& block = p.messages.block;
    return "layout(scalar, set = 0, binding = " + std::to_string(p.pass.bindings.size() + 2) +
           ") volatile buffer Messages {\n    uint used, lost, lost_high, capacity, words[];\n} " + block +
           ";\n\n"
           "// Begins a message with so many words after its number. Returns where these begin; 0: the buffer is "
           "full.\n"
           "uint " +
           p.messages.begin + "(uint number, uint count) {\n    if (" + block + ".used < " + block +
           ".capacity) {\n        uint at = atomicAdd(" + block + ".used, count + 1u);\n        if (at < " + block +
           ".capacity && count < " + block + ".capacity - at) {\n            " + block +
           ".words[at] = number + 1u;\n            return at + 1u;\n        }\n    }\n    if (atomicAdd(" + block +
           ".lost, 1u) == 0xffffffffu) atomicAdd(" + block + ".lost_high, 1u);\n    return 0u;\n}\n\n";
}

void print_message(Printer& p, const ir::Stmt& stmt) {
    const ir::Expr& words = p.program.exprs[stmt.value];
    const std::uint32_t count = p.program.types[words.type].count;
    const std::string at = p.messages.place;
    line(p, "{");
    ++p.indent;
    line(p, "uint " + at + " = " + p.messages.begin + "(" + std::to_string(p.pass.message_of(stmt)) + "u, " +
                std::to_string(count) + "u);");
    line(p, "if (" + at + " != 0u) {");
    ++p.indent;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::string word = words.op == ir::Op::construct
                                     ? print_any(p, words.operands[i])
                                     : print(p, stmt.value, Level::postfix) + "[" + std::to_string(i) + "]";
        line(p,
             p.messages.block + ".words[" + at + (i == 0 ? "" : " + " + std::to_string(i) + "u") + "] = " + word + ";");
    }
    --p.indent;
    line(p, "}");
    --p.indent;
    line(p, "}");
}

}  // namespace gliftc::glsl
