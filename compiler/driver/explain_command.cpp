// `gliftc explain FILE`: prints properties of translators, structures and draws, how kernels update and transpose, and
// with --made the sizes of memories. Of a translator's mapping and inverse it says whether they are declared or were
// tested (trials.h).
#include "driver/command_line.h"
#include "driver/commands.h"
#include "driver/compile.h"
#include "driver/explain_diagnostic.h"
#include "driver/explain_kernels.h"
#include "driver/explain_made.h"
#include "driver/trials.h"
#include "emit/json/text.h"
#include "ir/aliases.h"
#include "ir/chain.h"
#include "ir/evaluate.h"
#include "ir/spelling.h"

#include <cstdio>
#include <set>

namespace gliftc {

namespace {

/// The properties of a translator (ir::Properties) as text.
struct Explained {
    std::string name, from, to, place;
    std::string memory, access, consistency, location, totality, outside, mapping, invertible;
    bool is_affine = false;
};

struct ExplainedStructure {
    std::string kind;  ///< structure, view (it computes its elements), container (it has none)
    std::string name, type, place, addresses, elements;
    std::vector<std::pair<std::string, std::string>> parts;  ///< of containers: members and functions
    std::vector<std::pair<std::string, std::string>> memories;
    std::vector<Explained> via;
    std::string blocks;  ///< text about its blocks (ir::blocks_of); empty: the whole domain is one block
};

/// The text about how `s.compare` compares references with the image's texels; empty for the default, less_equal.
std::string comparison_of(const ir::Memory& memory) {
    if (memory.compare == ir::Compare::less_equal) return "";
    return ", compared by '" + std::string(ir::spelling(memory.compare)) + "'";
}

std::string shape_of(const ir::Program& program, const ir::Memory& memory) {
    std::string element = to_text(program, memory.element) + comparison_of(memory);
    switch (memory.shape) {
    case ir::MemoryShape::buffer: return "buffer of " + element;
    case ir::MemoryShape::image1d: return "1-D image of " + element;
    case ir::MemoryShape::image2d: return "2-D image of " + element;
    case ir::MemoryShape::image3d: return "3-D image of " + element;
    case ir::MemoryShape::imagecube: return "cube image of " + element;
    case ir::MemoryShape::image2darray: return "layers of 2-D images of " + element;
    }
    return element;
}

std::string checked_to(const Trial& trial) { return "checked to " + std::to_string(trial.addresses) + " addresses"; }

std::string mapping_of(const ir::Properties& properties, const Trial& trial) {
    if (properties.mapping == ir::Mapping::many_to_one) return "many to one (declared)";
    if (!trial.collision.empty()) return "many to one: " + trial.collision;
    if (trial.addresses > 0) return "one to one (" + checked_to(trial) + ")";
    if (properties.mapping == ir::Mapping::claimed_one_to_one) return "one to one (declared, not checked here)";
    return "one to one or many to one: not known";
}

std::string inverse_of(const ir::Properties& properties, const Trial& trial) {
    if (!properties.invertible) return "no";
    if (!trial.wrong_inverse.empty()) return "no: " + trial.wrong_inverse;
    return trial.addresses > 0 ? "yes (" + checked_to(trial) + ")" : "yes (declared, not checked here)";
}

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
            if (shown_.insert(i).second) translators.push_back(explained(program_.translators[i], {}));
    }

    std::vector<ExplainedStructure> structures;
    std::vector<Explained> translators;  ///< those that none of `structures` uses
    std::vector<ExplainedKernel> draws, updates, tiles, arithmetic;

private:
    std::string place(Span span) const {
        return span ? c_.sources[span.file].path + ":" + std::to_string(c_.sources.position(span).line)
                    : std::string("built in");
    }

    void explain(const ir::Structure& structure) {
        const std::vector<ir::Alias>& aliases = structure.aliases;
        if (!program_.modules[structure.module].is_root && aliases.empty()) return;
        ExplainedStructure shown;
        const bool has_elements = structure.kind != ir::StructureKind::no_elements;
        shown.kind = !has_elements ? "container" : structure.kind == ir::StructureKind::computed ? "view" : "structure";
        shown.name = aliases.empty() ? structure.display : c_.names[aliases.front().name];
        shown.type = structure.display;
        shown.place = place(structure.span);
        if (structure.is_container) explain_parts(structure, shown);
        if (!has_elements) {
            structures.push_back(std::move(shown));
            return;
        }
        shown.addresses = to_text(program_, structure.domain_type);
        shown.elements = to_text(program_, structure.element);
        for (const ir::Memory& memory : structure.memories)
            shown.memories.emplace_back(c_.names[memory.name], shape_of(program_, memory));
        if (!structure.base.empty())
            shown.memories.emplace_back(c_.names[structure.base_name],
                                        ir::structure_at(program_, structure, structure.base).display);
        shown.blocks = blocks_of(structure);
        for (const ir::Stage& stage : structure.via) {
            shown_.insert(stage.translator);
            shown.via.push_back(
                explained(program_.translators[stage.translator], try_translator(program_, structure, stage)));
        }
        structures.push_back(std::move(shown));
    }

    /// The container's members, and its public functions with what they write.
    void explain_parts(const ir::Structure& container, ExplainedStructure& shown) const {
        for (const ir::MemberStructure& member : container.members)
            if (!member.is_component)
                shown.parts.emplace_back("member " + c_.names[member.name],
                                         program_.structures[member.structure].display +
                                             (member.by_reference ? ", given" : ""));
        const auto index = program_.structures.id_of(container);
        for (ir::FunctionId id : ir::public_functions(program_, index)) {
            const ir::Function& function = program_.functions[id];
            std::string effects;
            for (const ir::Effect& effect : function.effects)
                effects += (effects.empty() ? "writes " : ", ") + path_of(container, effect.place) +
                           (effect.pattern == ir::Pattern::coherent ? " (coherent)" : " (scatter)");
            if (effects.empty()) effects = function.reads_memory ? "reads elements" : "reads no elements";
            shown.parts.emplace_back("fn " + c_.names[function.name], effects);
        }
    }

    std::string path_of(const ir::Structure& container, const ir::Place& place) const {
        std::string text;
        const ir::Structure* at = &container;
        for (std::uint32_t member : place.members) {
            text += (text.empty() ? "" : ".") + c_.names[at->members[member].name];
            at = &program_.structures[at->members[member].structure];
        }
        return text;
    }

    /// The text about the blocks of a structure, as ir::blocks_of() finds them; empty if it finds none: the whole
    /// domain is one block.
    std::string blocks_of(const ir::Structure& structure) const {
        const auto place = ir::blocks_of(program_, structure, {});
        if (!place) return "";
        const ir::Structure& owner = ir::structure_at(program_, structure, place->members);
        const auto size = ir::evaluate(program_, owner.blocks->extent);
        return std::string(owner.blocks->is_known ? "counted by the host" : "counted on the device") +
               (size ? ", each " + ir::to_text(program_, *size) : ", of one size") +
               (&owner == &structure ? "" : ", those of " + owner.display);
    }

    Explained explained(const ir::Translator& translator, const Trial& trial) const {
        const ir::Properties& p = translator.properties;
        Explained shown;
        shown.name = translator.display;
        shown.from = to_text(program_, translator.virtual_type);
        shown.to = to_text(program_, translator.physical_type) + (p.partial ? "?" : "");
        shown.place = place(translator.span);
        shown.memory = p.memory_complexity;
        if (!translator.structures.empty()) {
            std::string tables;
            for (Name name : translator.structure_names) tables += (tables.empty() ? "" : ", ") + c_.names[name];
            shown.memory += ": that of " + tables;
        }
        shown.access = p.access_complexity;
        shown.consistency = p.uniform ? "uniform" : "not uniform";
        shown.location = p.location;
        shown.totality = p.partial ? "partial" : "total";
        shown.outside = trial.outside;
        shown.mapping = mapping_of(p, trial);
        shown.invertible = inverse_of(p, trial);
        shown.is_affine = p.affine;
        return shown;
    }

    const Compilation& c_;
    const ir::Program& program_;
    std::set<ir::TranslatorId> shown_;
};

std::string line(const std::string& indent, const std::string& what, const std::string& value) {
    return indent + "  " + what + std::string(what.size() < 20 ? 20 - what.size() : 1, ' ') + value + "\n";
}

std::string text_of(const Explained& t, const std::string& indent) {
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
        for (const Explained& translator : s.via) text += text_of(translator, "  ");
        text += "\n";
    }
    for (const Explained& translator : explainer.translators) text += text_of(translator, "") + "\n";
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

void write(json::Text& out, const Explained& t) {
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
            for (const Explained& translator : s.via) write(out, translator);
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
            for (const Explained& translator : explainer.translators) write(out, translator);
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
