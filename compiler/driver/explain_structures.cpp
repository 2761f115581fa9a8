#include "driver/explain_structures.h"

#include "driver/trials.h"
#include "ir/aliases.h"
#include "ir/chain.h"
#include "ir/evaluate.h"
#include "ir/spelling.h"

namespace gliftc {

namespace {

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

/// Makes the texts about one structure or translator.
class Explainer {
public:
    explicit Explainer(const Compilation& c) : c_(c), program_(c.program) {}

    std::string place(Span span) const {
        return span ? c_.sources[span.file].path + ":" + std::to_string(c_.sources.position(span).line)
                    : std::string("built in");
    }

    ExplainedStructure explained(const ir::Structure& structure) const {
        const std::vector<ir::Alias>& aliases = structure.aliases;
        ExplainedStructure shown;
        const bool has_elements = structure.kind != ir::StructureKind::no_elements;
        shown.kind = !has_elements ? "container" : structure.kind == ir::StructureKind::computed ? "view" : "structure";
        shown.name = aliases.empty() ? structure.display : c_.names[aliases.front().name];
        shown.type = structure.display;
        shown.place = place(structure.span);
        if (structure.is_container) explain_parts(structure, shown);
        if (!has_elements) return shown;
        shown.addresses = to_text(program_, structure.domain_type);
        shown.elements = to_text(program_, structure.element);
        for (const ir::Memory& memory : structure.memories)
            shown.memories.emplace_back(c_.names[memory.name], shape_of(program_, memory));
        if (!structure.base.empty())
            shown.memories.emplace_back(c_.names[structure.base_name],
                                        ir::structure_at(program_, structure, structure.base).display);
        shown.blocks = blocks_of(structure);
        for (const ir::Stage& stage : structure.via) {
            shown.via.push_back(
                explained(program_.translators[stage.translator], try_translator(program_, structure, stage)));
        }
        return shown;
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

    ExplainedTranslator explained(const ir::Translator& translator, const Trial& trial) const {
        const ir::Properties& p = translator.properties;
        ExplainedTranslator shown;
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

private:
    const Compilation& c_;
    const ir::Program& program_;
};

}  // namespace

ExplainedStructure explained(const Compilation& compilation, const ir::Structure& structure) {
    return Explainer(compilation).explained(structure);
}

ExplainedTranslator explained(const Compilation& compilation, const ir::Translator& translator) {
    return Explainer(compilation).explained(translator, {});
}

}  // namespace gliftc
