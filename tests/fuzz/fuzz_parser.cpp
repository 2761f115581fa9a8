// Parses arbitrary bytes: there must be no crash, hang or sanitizer report.

#include "diag/render.h"
#include "syntax/parser.h"

#include <cstddef>
#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    gliftc::Sources sources;
    gliftc::Names names;
    gliftc::Diagnostics diagnostics;
    gliftc::ast::Tree tree;
    const std::uint32_t file = sources.add("fuzz.glift", std::string(reinterpret_cast<const char*>(data), size));
    gliftc::parse(file, sources, names, tree, diagnostics);
    gliftc::render_text(diagnostics, sources, gliftc::Colour::plain);
    return 0;
}
