#include "driver/command_line.h"
#include "driver/commands.h"
#include "driver/compile.h"

#include "ir/evaluate.h"

#include <cstdio>
#include <set>

namespace gliftc {

namespace {

const char* word(ir::Mapping mapping) {
    switch (mapping) {
    case ir::Mapping::unknown: return "one to one: not known";
    case ir::Mapping::one_to_one: return "one to one";
    case ir::Mapping::claimed_one_to_one: return "said to be one to one";
    case ir::Mapping::many_to_one: return "many to one";
    }
    return "";
}

/// The translators and structures that the modules on the command line declare or use: what sema instantiated.
class Explainer {
public:
    explicit Explainer(const Compilation& c) : c_(c), program_(c.program) {}

    std::string run() {
        for (const ir::Structure& structure : program_.structures)
            if (structure.kind != ir::StructureKind::adaptor) explain(structure);
        for (std::uint32_t i = 0; i < program_.translators.size(); ++i)
            if (shown_.insert(i).second) explain(program_.translators[i], "");
        return text_;
    }

private:
    std::string place(Span span) const {
        return span ? c_.sources[span.file].path + ":" + std::to_string(c_.sources.position(span).line)
                    : std::string("built in");
    }

    void line(const std::string& indent, const std::string& what, const std::string& value) {
        text_ += indent + "  " + what + std::string(what.size() < 20 ? 20 - what.size() : 1, ' ') + value + "\n";
    }

    void explain(const ir::Structure& structure) {
        const std::vector<ir::Alias>& aliases = structure.aliases;
        if (!program_.modules[structure.module].is_root && aliases.empty()) return;
        bool is_view = structure.kind == ir::StructureKind::view;
        std::string name = aliases.empty() ? "" : c_.names[aliases.front().name] + " = ";
        text_ += std::string(is_view ? "view " : "structure ") + name + structure.display + "  (" +
                 place(structure.span) + ")\n";
        line("", "addresses", to_text(program_, structure.domain_type));
        line("", "elements", to_text(program_, structure.element) + (is_view ? ", computed" : ""));
        for (const ir::Memory& memory : structure.memories)
            line("", "memory " + c_.names[memory.name], shape_of(memory));
        for (const ir::Stage& stage : structure.via) {
            shown_.insert(stage.translator);
            explain(program_.translators[stage.translator], "  ");
        }
        text_ += "\n";
    }

    std::string shape_of(const ir::Memory& memory) const {
        std::string element = to_text(program_, memory.element);
        switch (memory.shape) {
        case ir::MemoryShape::buffer: return "buffer of " + element;
        case ir::MemoryShape::image1d: return "1-D image of " + element;
        case ir::MemoryShape::image2d: return "2-D image of " + element;
        case ir::MemoryShape::image3d: return "3-D image of " + element;
        case ir::MemoryShape::imagecube: return "cube image of " + element;
        }
        return element;
    }

    void explain(const ir::Translator& translator, const std::string& indent) {
        const ir::Properties& p = translator.properties;
        text_ += indent + "translator " + translator.display + " : " + to_text(program_, translator.virtual_type) +
                 " -> " + to_text(program_, translator.physical_type) + (p.partial ? "?" : "") + "  (" +
                 place(translator.span) + ")\n";
        line(indent, "memory", p.memory_complexity);
        line(indent, "access", p.access_complexity + (p.uniform ? ", uniform" : ", not uniform"));
        line(indent, "location", p.location);
        line(indent, "mapping",
             std::string(p.partial ? "partial, " : "total, ") + word(p.mapping));
        line(indent, "invertible", p.invertible ? "yes" : "no");
        line(indent, "affine", p.affine ? "yes" : "no");
        if (indent.empty()) text_ += "\n";
    }

    const Compilation& c_;
    const ir::Program& program_;
    std::set<std::uint32_t> shown_;
    std::string text_;
};

}  // namespace

int run_explain(const Options& options) {
    auto& compilation = *new Compilation;  // ends with the process
    configure(compilation.diagnostics, options);
    compile(options, disk(), compilation);
    int code = report(compilation, options);
    if (code != 0) return code;
    std::string text = Explainer(compilation).run();
    std::fwrite(text.data(), 1, text.size(), stdout);
    return code;
}

}  // namespace gliftc
