#include "driver/trials.h"

#include "ir/chain.h"
#include "ir/evaluate.h"

#include <algorithm>
#include <map>
#include <vector>

namespace gliftc {

namespace {

using ir::Value;
using Words = std::vector<std::uint64_t>;

/// Extents to try, by number of axes. Sides of 1 are a border case; most other sides are no powers of two and differ,
/// to show mistakes that a power of two or a square hides.
const std::vector<Words>& extents_of(std::size_t axes) {
    static const std::vector<Words> extents[] = {
        {}, {{1}, {4}, {4093}}, {{1, 1}, {13, 7}, {61, 67}}, {{1, 1, 1}, {17, 16, 15}}, {{1, 1, 1, 1}, {9, 8, 8, 7}}};
    return extents[axes];
}

Value value_of(ir::TypeId type, const Words& words) {
    Value value{type, {}};
    for (std::uint64_t word : words) value.lanes.push_back({.bits = word});
    return value;
}

Words words_of(const Value& value) {
    Words words;
    for (const ir::Lane& lane : value.lanes) words.push_back(lane.bits);
    return words;
}

std::string text_of(const Words& words) {
    std::string text = "{";
    for (std::size_t i = 0; i < words.size(); ++i) text += (i ? ", " : "") + std::to_string(words[i]);
    return text + "}";
}

/// Evaluates expressions over a structure with given constructor arguments.
class Made {
public:
    Made(const ir::Program& program, const ir::Structure& structure, std::vector<Value> arguments)
        : program_(program), structure_(structure), arguments_(std::move(arguments)) {}

    std::optional<Value> value_of(ir::ExprId expr) const {
        return ir::evaluate(program_, expr, [this](const ir::Expr& asked) { return property(asked, asked.place); });
    }

    /// The value of `asked`: a constructor argument, a memory's extent or the domain of the structure at `place`. The
    /// first `depth` steps of that path led to the structure of this object.
    std::optional<Value> property(const ir::Expr& asked, const ir::Place& place, std::size_t depth = 0) const {
        if (depth < place.members.size()) {
            const ir::MemberStructure& member = structure_.members[place.members[depth]];
            std::vector<Value> arguments;
            for (ir::ExprId argument : member.arguments) {
                auto value = value_of(argument);
                if (!value) return std::nullopt;
                arguments.push_back(std::move(*value));
            }
            return Made(program_, program_.structures[member.structure], std::move(arguments))
                .property(asked, place, depth + 1);
        }
        if (asked.op == ir::Op::member && asked.slot < arguments_.size()) return arguments_[asked.slot];
        if (asked.op == ir::Op::memory_extent) return value_of(structure_.memories[asked.slot].extent);
        if (asked.op == ir::Op::domain && structure_.domain) return value_of(structure_.domain);
        return std::nullopt;
    }

private:
    const ir::Program& program_;
    const ir::Structure& structure_;
    std::vector<Value> arguments_;
};

/// One translator of a structure, with the state that the structure gives it.
class Tried {
public:
    /// `memory` is the extent of the memory that all physical addresses must lie in, if there is one.
    Tried(const ir::Program& program, const Made& made, const ir::Stage& stage, std::optional<Value> memory)
        : program_(program), made_(made), stage_(stage), translator_(program.translators[stage.translator]),
          memory_(std::move(memory)) {
        for (ir::ExprId scalar : stage.scalars) state_.push_back(made.value_of(scalar));
    }

    /// Translates all addresses of the domain and notes collisions and wrong inverses in `trial`. False if something
    /// cannot be evaluated.
    bool run(const Words& domain, Trial& trial) const {
        std::map<Words, Words> seen;  // virtual addresses by physical ones
        Words address(domain.size(), 0);
        std::size_t count = 1;
        for (std::uint64_t side : domain) count *= side;
        for (std::size_t i = 0; i < count; ++i) {
            std::size_t rest = i;
            for (std::size_t axis = 0; axis < domain.size(); rest /= domain[axis++])
                address[axis] = rest % domain[axis];
            auto there = call(translator_.translate, value_of(translator_.virtual_type, address));
            if (!there) return false;
            Words physical = words_of(*there);
            if (translator_.properties.partial) {
                if (physical[0] == 0) continue;
                physical.erase(physical.begin());
            }
            if (trial.outside.empty() && !is_inside_memory(physical))
                trial.outside = text_of(address) + " maps to " + text_of(physical) + ", outside of the memory";
            auto [earlier, is_new] = seen.emplace(physical, address);
            if (!is_new && trial.collision.empty())
                trial.collision =
                    text_of(earlier->second) + " and " + text_of(address) + " both map to " + text_of(physical);
            if (!translator_.invert || !trial.wrong_inverse.empty()) continue;
            auto back = call(translator_.invert, value_of(translator_.physical_type, physical));
            if (!back) return false;
            if (words_of(*back) != address)
                trial.wrong_inverse = "invert(translate(" + text_of(address) + ")) is " + text_of(words_of(*back));
        }
        trial.addresses = std::max(trial.addresses, count);
        return true;
    }

    std::optional<Value> domain() const {
        if (!translator_.domain) return std::nullopt;
        return ir::call(program_, translator_.domain, {}, [this](const ir::Expr& asked) { return known(asked); });
    }

private:
    static Value value_of(ir::TypeId type, const Words& words) { return gliftc::value_of(type, words); }

    bool is_inside_memory(const Words& physical) const {
        return !memory_ || std::ranges::equal(physical, words_of(*memory_), std::less());
    }

    std::optional<Value> call(ir::FunctionId function, Value argument) const {
        return ir::call(program_, function, {std::move(argument)},
                        [this](const ir::Expr& asked) { return known(asked); });
    }

    std::optional<Value> known(const ir::Expr& asked) const {
        if (asked.op == ir::Op::state) return state_[asked.slot];
        if (asked.op != ir::Op::member && asked.op != ir::Op::memory_extent && asked.op != ir::Op::domain)
            return std::nullopt;
        ir::Place place = stage_.structures[asked.place.root];
        place.members.append(asked.place.members);
        return made_.property(asked, place);
    }

    const ir::Program& program_;
    const Made& made_;
    const ir::Stage& stage_;
    const ir::Translator& translator_;
    std::optional<Value> memory_;
    std::vector<std::optional<Value>> state_;
};

}  // namespace

Trial try_translator(const ir::Program& program, const ir::Structure& structure, const ir::Stage& stage) {
    constexpr std::size_t most = 1u << 14;
    Trial trial;
    const bool is_made_of_extents = structure.kind == ir::StructureKind::stored && !structure.constructor.empty() &&
                                    std::ranges::all_of(structure.constructor, [&](ir::LocalId local) {
                                        return program.locals[local].type == structure.domain_type;
                                    });
    if (!is_made_of_extents) return trial;
    for (const Words& extent : extents_of(program.types.components(structure.domain_type))) {
        const Made made(program, structure,
                        std::vector<Value>(structure.constructor.size(), value_of(structure.domain_type, extent)));
        const bool leads_to_memory = &stage == &structure.via.back() && ir::stays_inside(program, structure);
        const Tried tried(program, made, stage,
                          leads_to_memory ? made.value_of(structure.memories[structure.via_memory].extent)
                                          : std::nullopt);
        auto domain =
            &stage == structure.via.data() && structure.domain ? made.value_of(structure.domain) : tried.domain();
        if (!domain) return {};
        std::size_t count = 1;
        for (const ir::Lane& lane : domain->lanes) count = std::min<std::size_t>(most + 1, count * lane.bits);
        if (count <= most && !tried.run(words_of(*domain), trial)) return {};
    }
    return trial;
}

}  // namespace gliftc
