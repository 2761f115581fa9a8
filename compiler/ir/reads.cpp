#include "ir/reads.h"

#include "ir/chain.h"
#include "ir/walk.h"

#include <algorithm>
#include <map>

namespace gliftc::ir {

namespace {

using Places = std::vector<Place>;

/// Finds the structures whose memory a body reads, as places seen from that body.
class Reads {
public:
    explicit Reads(const Program& program) : p(program) {}

    /// What one expression reads, its operands not included. `structures`: the instance at each Place root. `effects`:
    /// those of the body; memory to which the body itself declares coherent access (Effect::is_own) is left out.
    Places of(const Expr& node, const std::vector<StructureId>& structures, const std::vector<Effect>& effects) {
        Places found;
        switch (node.op) {
        case Op::read:
        case Op::element:
        case Op::near:
        case Op::gather:
        case Op::compare:
        case Op::sample: add_element(found, structures, node.place, effects); break;
        case Op::translate: add_tables(found, structures, node.place); break;
        case Op::call: {
            const Function& called = p.functions[node.function];
            add_inside(found, of_function(node.function, called.structures), node.places);
            break;
        }
        default: break;
        }
        return found;
    }

    /// The tables that translators read for a write to the structure at the place.
    Places of_write(const std::vector<StructureId>& structures, const Place& place) {
        Places found;
        add_tables(found, structures, place);
        return found;
    }

private:
    const Structure& at(const std::vector<StructureId>& structures, const Place& place) const {
        return structure_at(p, p.structures[structures[place.root]], place.members);
    }

    static Place beneath(const Place& outer, const RareVector<std::uint32_t>& members) {
        Place place = outer;
        place.members.append(members);
        return place;
    }

    /// Adds what a function reads, `inner`, as places of its caller, which passed the structures `given`.
    static void add_inside(Places& found, const Places& inner, const std::vector<Place>& given) {
        for (const Place& place : inner)
            if (place.root < given.size()) found.push_back(beneath(given[place.root], place.members));
    }

    void add_element(Places& found, const std::vector<StructureId>& structures, const Place& place,
                     const std::vector<Effect>& effects) {
        const Structure& structure = at(structures, place);
        if (structure.kind == StructureKind::no_elements && structure.base.empty()) return;
        add_tables(found, structures, place);
        const Place root = root_of(p, structure, place);
        const bool is_coherent = std::ranges::any_of(effects, [&](const Effect& effect) {
            return effect.is_own && effect.pattern == Pattern::coherent &&
                   root_of(p, at(structures, effect.place), effect.place) == root;
        });
        const Structure& computed = root_structure(p, structure);
        if (computed.at) {
            const auto view = p.structures.id_of(computed);
            add_inside(found, of_function(computed.at, {view}), {root});
        } else if (!is_coherent) {
            found.push_back(root);
        }
    }

    void add_tables(Places& found, const std::vector<StructureId>& structures, Place place) {
        for (const Structure* link = &at(structures, place);; link = &structure_at(p, *link, link->base)) {
            for (const Stage& stage : link->via) {
                const Translator& translator = p.translators[stage.translator];
                std::vector<Place> given;
                for (const Place& member : stage.structures) given.push_back(beneath(place, member.members));
                add_inside(found, of_function(translator.translate, translator.structures), given);
            }
            if (link->base.empty()) return;
            place = beneath(place, link->base);
        }
    }

    const Places& of_function(FunctionId id, const std::vector<StructureId>& structures) {
        if (const auto known = known_.find(id); known != known_.end()) return known->second;
        const Function& function = p.functions[id];
        Places found;
        for_each_expression(p, function.body, [&](ExprId node) {
            for (Place& place : of(p.exprs[node], structures, function.effects)) found.push_back(std::move(place));
        });
        for_each_statement(p, function.body, [&](const Stmt& stmt) {
            if (stmt.op == StmtOp::write) add_tables(found, structures, stmt.place);
        });
        return known_[id] = std::move(found);
    }

    const Program& p;
    std::map<FunctionId, Places> known_;
};

}  // namespace

void for_each_read(const Program& p, const Kernel& kernel, const std::function<void(const Place&, Span)>& visit) {
    Reads reads(p);
    std::vector<StructureId> structures;
    std::vector<Effect> coherent;
    for (const KernelParam& param : kernel.params) {
        if (param.pattern == Pattern::coherent)
            coherent.push_back({.place = {static_cast<std::uint32_t>(structures.size()), {}},
                                .pattern = Pattern::coherent,
                                .is_own = true});
        structures.push_back(param.structure);
    }
    const auto visit_body = [&](const std::vector<StmtId>& body) {
        for_each_expression(p, body, [&](ExprId id) {
            const Expr& node = p.exprs[id];
            for (const Place& place : reads.of(node, structures, coherent)) visit(place, node.span);
        });
        for_each_statement(p, body, [&](const Stmt& stmt) {
            if (stmt.op != StmtOp::write && stmt.op != StmtOp::set_element) return;
            for (const Place& place : reads.of_write(structures, stmt.place)) visit(place, stmt.span);
        });
    };
    visit_body(kernel.body);
    if (kernel.raster) visit_body(kernel.raster->fragment);
}

}  // namespace gliftc::ir
