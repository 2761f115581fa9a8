// `gliftc explain FILE`: prints properties of translators, structures and draws, how kernels update and transpose, and
// with --made the sizes of memories. Of a translator's mapping and inverse it says whether they are declared or were
// tested (trials.h).
#include "driver/command_line.h"
#include "driver/commands.h"
#include "driver/compile.h"
#include "driver/explain_diagnostic.h"
#include "driver/explain_kernels.h"
#include "driver/explain_made.h"
#include "driver/explain_structures.h"
#include "emit/json/text.h"

#include <cstdio>
#include <set>

namespace gliftc {

namespace {

/// Collects what is to be shown of what sema instantiated: the structures that a module on the command line declares or
/// to which any module gives a name (`structure Field = Array<4, float>;`), all translators, and the draws in modules
/// on the command line.
class Explainer {
public:
    explicit Explainer(const Compilation& c)
        : draws(explained_draws(c)), updates(explained_updates(c)), tiles(explained_tiles(c)),
          arithmetic(explained_arithmetic(c)), c_(c), program_(c.program) {
        for (const ir::Structure& structure : program_.structures) explain(structure);
        for (ir::TranslatorId i : program_.translators.ids())
            if (shown_.insert(i).second) translators.push_back(explained(c_, program_.translators[i]));
    }

    std::vector<ExplainedStructure> structures;
    std::vector<ExplainedTranslator> translators;  ///< those that none of `structures` uses
    std::vector<ExplainedKernel> draws, updates, tiles, arithmetic;

private:
    void explain(const ir::Structure& structure) {
        if (!program_.modules[structure.module].is_root && structure.aliases.empty()) return;
        for (const ir::Stage& stage : structure.via) shown_.insert(stage.translator);
        structures.push_back(explained(c_, structure));
    }

    const Compilation& c_;
    const ir::Program& program_;
    std::set<ir::TranslatorId> shown_;
};

std::string line(const std::string& indent, const std::string& what, const std::string& value) {
    return indent + "  " + what + std::string(what.size() < 20 ? 20 - what.size() : 1, ' ') + value + "\n";
}

std::string text_of(const ExplainedTranslator& t, const std::string& indent) {
    return indent + "translator " + t.name + " : " + t.from + " -> " + t.to + "  (" + t.place + ")\n" +
           line(indent, "memory", t.memory) + line(indent, "access", t.access + ", " + t.consistency) +
           line(indent, "location", t.location) +
           line(indent, "mapping", t.totality + (t.outside.empty() ? "" : " (" + t.outside + ")") + ", " + t.mapping) +
           line(indent, "invertible", t.invertible) + line(indent, "affine", t.is_affine ? "yes" : "no");
}

std::string text_of(const ExplainedMade& m) {
    std::string text = m.name + " made with " + m.made.arguments + "\n" + line("", "bytes", bytes_text(m.bytes()));
    for (const MadeMemory& memory : m.made.memories)
        text += line("  ", memory.path,
                     (memory.bytes ? bytes_text(*memory.bytes) : "not known without what is given") +
                         (memory.role.empty() ? "" : ", " + memory.role));
    return text + "\n";
}

std::string as_text(const Explainer& explainer, const std::vector<ExplainedMade>& made) {
    std::string text;
    for (const ExplainedStructure& s : explainer.structures) {
        text += s.kind + " " + (s.name == s.type ? s.name : s.name + " = " + s.type) + "  (" + s.place + ")\n";
        if (!s.elements.empty())
            text += line("", "addresses", s.addresses) +
                    line("", "elements", s.elements + (s.kind == "view" ? ", computed" : ""));
        for (const auto& [what, how] : s.parts) text += line("", what, how);
        for (const auto& [name, shape] : s.memories) text += line("", "memory " + name, shape);
        if (!s.blocks.empty()) text += line("", "blocks", s.blocks);
        for (const ExplainedTranslator& translator : s.via) text += text_of(translator, "  ");
        text += "\n";
    }
    for (const ExplainedTranslator& translator : explainer.translators) text += text_of(translator, "") + "\n";
    const auto add = [&](const std::string& word, const std::vector<ExplainedKernel>& kernels) {
        for (const ExplainedKernel& kernel : kernels) {
            text += word + " " + kernel.name + "  (" + kernel.place + ")\n";
            for (const auto& [what, how] : kernel.facts) text += line("", what, how);
            text += "\n";
        }
    };
    add("raster", explainer.draws);
    add("kernel", explainer.updates);
    add("kernel", explainer.tiles);
    add("kernel", explainer.arithmetic);
    for (const ExplainedMade& m : made) text += text_of(m);
    return text;
}

void write(json::Text& out, const ExplainedTranslator& t) {
    out.object([&] {
        out.field("name", t.name);
        out.field("place", t.place);
        out.field("virtual", t.from);
        out.field("physical", t.to);
        out.field("memory_complexity", t.memory);
        out.field("access_complexity", t.access);
        out.field("access_consistency", t.consistency);
        out.field("location", t.location);
        out.field("totality", t.totality);
        out.field("outside", t.outside);
        out.field("mapping", t.mapping);
        out.field("invertible", t.invertible);
        out.field("affine", t.is_affine);
    });
}

void write(json::Text& out, const ExplainedStructure& s) {
    out.object([&] {
        out.field("kind", s.kind);
        out.field("name", s.name);
        out.field("type", s.type);
        out.field("place", s.place);
        if (!s.parts.empty()) {
            out.key("parts");
            out.array([&] {
                for (const auto& [what, how] : s.parts)
                    out.object([&] {
                        out.field("what", what);
                        out.field("how", how);
                    });
            });
        }
        if (!s.elements.empty()) {
            out.field("addresses", s.addresses);
            out.field("elements", s.elements);
        }
        if (!s.blocks.empty()) out.field("blocks", s.blocks);
        out.key("memories");
        out.array([&] {
            for (const auto& [name, shape] : s.memories)
                out.object([&] {
                    out.field("name", name);
                    out.field("shape", shape);
                });
        });
        out.key("via");
        out.array([&] {
            for (const ExplainedTranslator& translator : s.via) write(out, translator);
        });
    });
}

void write(json::Text& out, const ExplainedKernel& kernel) {
    out.object([&] {
        out.field("name", kernel.name);
        out.field("place", kernel.place);
        out.key("facts");
        out.array([&] {
            for (const auto& [what, how] : kernel.facts)
                out.object([&] {
                    out.field("what", what);
                    out.field("how", how);
                });
        });
    });
}

void write(json::Text& out, const ExplainedMade& m) {
    out.object([&] {
        out.field("name", m.name);
        out.field("arguments", m.made.arguments);
        out.field("bytes", m.bytes());
        out.key("memories");
        out.array([&] {
            for (const MadeMemory& memory : m.made.memories)
                out.object([&] {
                    out.field("path", memory.path);
                    if (memory.bytes) out.field("bytes", *memory.bytes);
                    if (!memory.role.empty()) out.field("role", memory.role);
                });
        });
    });
}

std::string as_json(const Explainer& explainer, const std::vector<ExplainedMade>& made) {
    json::Text out;
    out.object([&] {
        out.key("structures");
        out.array([&] {
            for (const ExplainedStructure& structure : explainer.structures) write(out, structure);
        });
        out.key("translators");
        out.array([&] {
            for (const ExplainedTranslator& translator : explainer.translators) write(out, translator);
        });
        if (!made.empty()) {
            out.key("made");
            out.array([&] {
                for (const ExplainedMade& m : made) write(out, m);
            });
        }
        const auto add = [&](const char* key, const std::vector<ExplainedKernel>& kernels) {
            if (kernels.empty()) return;
            out.key(key);
            out.array([&] {
                for (const ExplainedKernel& kernel : kernels) write(out, kernel);
            });
        };
        add("draws", explainer.draws);
        add("updates", explainer.updates);
        add("tiles", explainer.tiles);
        add("arithmetic", explainer.arithmetic);
    });
    return out.take();
}

}  // namespace

int run_explain(const Options& options) {
    if (names_diagnostic(options)) return explain_diagnostic(options);
    auto& compilation = *new Compilation;  // never destroyed: see run_compile
    configure(compilation.diagnostics, options);
    compile(options, disk(), compilation);
    int code = report(compilation, options);
    if (code != 0) return code;
    std::string problem;
    const std::vector<ExplainedMade> made = explained_made(compilation, options.explain_made, problem);
    if (!problem.empty()) {
        std::fputs(("gliftc explain: " + problem + "\n").c_str(), stderr);
        return static_cast<int>(ExitCode::wrong_usage);
    }
    const Explainer explainer(compilation);
    std::string text = options.explain_as_json ? as_json(explainer, made) : as_text(explainer, made);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return code;
}

}  // namespace gliftc
