// Parses a text and prints its syntax tree.
#pragma once

#include "diag/render.h"
#include "syntax/parser.h"
#include "syntax/print.h"

#include <string>

namespace gliftc::test {

struct Parsed {
    Sources sources;
    Names names;
    ast::Tree tree;
    Diagnostics diagnostics;
    ast::Module module;

    explicit Parsed(const std::string& text) {
        std::uint32_t file = sources.add("test.glift", text);
        module = parse(file, sources, names, tree, diagnostics);
    }
    std::string printed() const { return print(module, tree, names); }
    /// The errors, one per line, such as: 3:14 expected ';', found 'return'
    std::string errors() const {
        std::string all;
        for (const Diagnostic& d : diagnostics.all()) {
            Position at = sources.position(d.span);
            all += std::to_string(at.line) + ":" + std::to_string(at.column) + " " + d.text + "\n";
        }
        return all;
    }
};

/// The expression of `const c = TEXT;` as an S-expression, or the errors.
inline std::string expression(const std::string& text) {
    Parsed parsed("module m; const c = " + text + ";");
    if (parsed.diagnostics.has_errors()) return parsed.errors();
    return print(std::get<ast::Const>(parsed.tree.decls[parsed.module.decls[0]].body).value, parsed.tree, parsed.names);
}

/// The type of `const c: TEXT = 0;` as an S-expression, or the errors.
inline std::string type(const std::string& text) {
    Parsed parsed("module m; const c: " + text + " = 0;");
    if (parsed.diagnostics.has_errors()) return parsed.errors();
    return print(std::get<ast::Const>(parsed.tree.decls[parsed.module.decls[0]].body).type, parsed.tree, parsed.names);
}

/// Declarations after `module m;`, printed without the module around them; or the errors.
inline std::string declarations(const std::string& text) {
    Parsed parsed("module m;\n" + text);
    if (parsed.diagnostics.has_errors()) return parsed.errors();
    std::string all = parsed.printed();
    return all.substr(std::string("(module m\n").size(), all.size() - std::string("(module m\n").size() - 2);
}

}  // namespace gliftc::test
