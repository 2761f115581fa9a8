// Parses, checks and lowers a text, for tests. The text can import no module.
#pragma once

#include "ir/print.h"
#include "lower/lower.h"
#include "sema/check.h"
#include "syntax/parser.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace gliftc {

/// Structures and translators that the tests use; they are put before each text.
inline const std::string library = R"(module test;
fn linearize3(a: uint3, e: uint3) -> uint { return (a.z * e.y + a.y) * e.x + a.x; }
translator Linear3 : uint3 -> uint {
    extent: uint3;
    domain() { return extent; }
    translate(va) { return linearize3(va, extent); }
}
translator Rows : uint3 -> uint2 {
    extent: uint3;
    width: uint;
    domain() { return extent; }
    translate(va) { let i = linearize3(va, extent); return uint2(i % width, i / width); }
}
translator Edge : uint3 -> uint3? {
    extent: uint3;
    domain() { return extent; }
    translate(va) { if !all(lessThan(va, extent)) { return none; } return va; }
}
structure Field(extent: uint3) {
    memory data = buffer<float>[extent.x * extent.y * extent.z];
    via Linear3(extent);
}
structure Flat(extent: uint3) {
    memory data = image2d<float>(uint2(64, extent.x * extent.y * extent.z / 64 + 1));
    via Rows(extent, data.extent.x);
}
structure Edged(extent: uint3) {
    memory data = buffer<float>[extent.x * extent.y * extent.z];
    via Edge(extent) then Linear3(extent);
}
struct PageEntry { frame: uint3; resident: bool; }
structure Entries(extent: uint3) {
    memory data = buffer<PageEntry>[extent.x * extent.y * extent.z];
    via Linear3(extent);
}
translator Paged : uint3 -> uint3? {
    table: Entries;
    domain() { return table.domain() * 8u; }
    translate(va) {
        let entry = table[va / 8u];
        if !entry.resident { return none; }
        return entry.frame * 8u + va % 8u;
    }
}
structure Sparse(extent: uint3, frames: uint3) {
    structure table = Entries(extent / 8u);
    memory pages = buffer<float>[frames.x * frames.y * frames.z * 512u];
    via Paged(table) then Linear3(frames * 8u);
}
)";

struct Lowering {
    Sources sources;
    Names names;
    ast::Tree tree;
    Diagnostics diagnostics;
    ast::Module module;
    ir::Program program;
    ir::Lowered lowered;

    explicit Lowering(const std::string& text, lower::Checks checks = lower::Checks::none) {
        module = parse(sources.add("test.glift", library + text), sources, names, tree, diagnostics);
        program = sema::check({{&module, true, {}}}, tree, names, diagnostics);
        for (const Diagnostic& diagnostic : diagnostics.all())
            ADD_FAILURE() << sources.text(diagnostic.span) << ": " << diagnostic.text;
        if (diagnostics.has_errors()) return;
        lowered = lower::lower(program, diagnostics, {.checks = checks});
    }

    const ir::Lowered::Forms& forms(std::string_view kernel) const {
        for (ir::KernelId i : program.kernels.ids())
            if (names[program.kernels[i].name] == kernel) return lowered.passes[i];
        throw std::runtime_error("no such kernel");
    }
    std::string direct(std::string_view kernel) const { return for_one_element(forms(kernel).direct); }
    std::string general(std::string_view kernel) const { return for_one_element(forms(kernel).general); }
    std::string for_one_element(ir::Pass pass) const {
        pass.variants.resize(1);
        return ir::print(program, pass);
    }
};

inline std::size_t count(const std::string& text, std::string_view part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

}  // namespace gliftc
