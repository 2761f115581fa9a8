#include "driver/made.h"

#include "ir/chain.h"
#include "ir/evaluate.h"
#include "layout/layout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

namespace gliftc {

namespace {

using ir::Value;

/// A structure that is made: the values that its constructor is given, and its members. A structure that a
/// program would pass to the constructor (`is_given`) has no `arguments`, since their values are not known.
struct Instance {
    const ir::Structure* structure = nullptr;
    std::string path;
    bool is_given = false;  ///< passed to the constructor: its sizes are not known
    std::vector<std::optional<Value>> arguments;
    std::vector<std::shared_ptr<Instance>> members;
};

class Maker {
public:
    explicit Maker(const ir::Program& program) : program_(program) {}

    /// `given`: the structures that are the members by reference, in their order; empty: they are not known.
    std::shared_ptr<Instance> make(const ir::Structure& structure, const std::string& path,
                                   std::vector<std::optional<Value>> arguments,
                                   std::vector<std::shared_ptr<Instance>> given) {
        auto made = std::make_shared<Instance>();
        made->structure = &structure;
        made->path = path;
        made->arguments = std::move(arguments);
        std::size_t next = 0;
        for (const ir::MemberStructure& member : structure.members) {
            const std::string inner = (path.empty() ? "" : path + ".") + (*program_.names)[member.name];
            if (member.by_reference) {
                made->members.push_back(next < given.size() ? given[next++] : outside(member.structure, inner));
                continue;
            }
            std::vector<std::optional<Value>> values;
            const ir::Structure& inside = program_.structures[member.structure];
            for (ir::ExprId argument : member.arguments) {
                if (program_.types.kind(program_.exprs[argument].type) == ir::TypeKind::structure) continue;
                values.push_back(value_of(*made, argument));
                // The expression may have a 64-bit type, which lower/transform/widen.h gave it to make it exact: the
                // value gets the type of the constructor's parameter.
                const ir::TypeId wanted = program_.locals[inside.constructor[values.size() - 1]].type;
                if (values.back()) values.back()->type = wanted;
            }
            std::vector<std::shared_ptr<Instance>> handed;
            for (const ir::Place& place : member.structures) {
                // A component is given its owner, which has it as a member: it does not own the owner.
                const std::shared_ptr<Instance> given_to = at(made, place);
                handed.push_back(member.is_component
                                     ? std::shared_ptr<Instance>(std::shared_ptr<Instance>{}, given_to.get())
                                     : given_to);
            }
            made->members.push_back(make(inside, inner, std::move(values), handed));
        }
        return made;
    }

    std::optional<Value> value_of(const Instance& instance, ir::ExprId expr) const {
        return ir::evaluate(program_, expr, [&](const ir::Expr& asked) { return property(instance, asked); });
    }

private:
    std::shared_ptr<Instance> outside(ir::StructureId structure, const std::string& path) {
        auto made = make(program_.structures[structure], path, {}, {});
        made->is_given = true;
        return made;
    }

    static std::shared_ptr<Instance> at(std::shared_ptr<Instance> instance, const ir::Place& place) {
        for (std::uint32_t member : place.members) instance = instance->members.at(member);
        return instance;
    }

    std::optional<Value> property(const Instance& instance, const ir::Expr& asked) const {
        const Instance* of = &instance;
        for (std::uint32_t member : asked.place.members) {
            if (member >= of->members.size()) return std::nullopt;
            of = of->members[member].get();
        }
        const ir::Structure& structure = *of->structure;
        if (asked.op == ir::Op::member)
            return asked.slot < of->arguments.size() ? of->arguments[asked.slot] : std::nullopt;
        if (asked.op == ir::Op::memory_extent) return value_of(*of, structure.memories[asked.slot].extent);
        if (asked.op == ir::Op::domain && structure.domain) return value_of(*of, structure.domain);
        return std::nullopt;
    }

    const ir::Program& program_;
};

std::uint64_t texel_bytes(ir::Format format) {
    switch (format) {
    case ir::Format::none: return 0;
    case ir::Format::r8:
    case ir::Format::r8ui: return 1;
    case ir::Format::rg8:
    case ir::Format::r16f:
    case ir::Format::r16ui: return 2;
    case ir::Format::rgba8:
    case ir::Format::rgba8ui:
    case ir::Format::rg16f:
    case ir::Format::r32f:
    case ir::Format::r32i:
    case ir::Format::r32ui:
    case ir::Format::d32: return 4;
    case ir::Format::rgba16f:
    case ir::Format::rg32f:
    case ir::Format::rg32i:
    case ir::Format::rg32ui: return 8;
    case ir::Format::rgba32f:
    case ir::Format::rgba32i:
    case ir::Format::rgba32ui: return 16;
    }
    return 0;
}

/// Lists the memories of the structures that are made, with their bytes. name_roles() is to be called before count(),
/// which adds the roles to the list.
class Counter {
public:
    Counter(const ir::Program& program, const Maker& maker) : program_(program), maker_(maker) {}

    void count(const Instance& instance) {
        if (instance.is_given || !seen_.insert(&instance).second) return;
        for (const ir::Memory& memory : instance.structure->memories)
            if (!memory.part)
                memories.push_back({path_of(instance, memory), bytes_of(instance, memory), role_of(instance)});
        for (const auto& member : instance.members) count(*member);
    }

    /// For each structure that translates by tables, records which structure holds its elements and which hold its
    /// tables.
    void name_roles(const Instance& instance) {
        if (!named_.insert(&instance).second) return;
        const std::string name = instance.path.empty() ? "it" : instance.path;
        for (const ir::Stage& stage : instance.structure->via) {
            if (stage.structures.empty()) continue;
            roles_.emplace(root_of(instance), "elements of " + name);
            for (const ir::Place& place : stage.structures) {
                const Instance* table = &instance;
                for (std::uint32_t member : place.members) table = table->members[member].get();
                roles_.emplace(root_of(*table), "table of " + name);
            }
        }
        for (const auto& member : instance.members) name_roles(*member);
    }

    std::vector<MadeMemory> memories;

private:
    static const Instance* root_of(const Instance& instance) {
        const Instance* root = &instance;
        while (!root->structure->base.empty()) {
            const Instance* base = root;
            for (std::uint32_t member : root->structure->base) base = base->members[member].get();
            root = base;
        }
        return root;
    }

    std::string role_of(const Instance& instance) const {
        const auto role = roles_.find(&instance);
        return role == roles_.end() ? "" : role->second;
    }

    std::string path_of(const Instance& instance, const ir::Memory& memory) const {
        return (instance.path.empty() ? "" : instance.path + ".") + (*program_.names)[memory.name];
    }

    std::optional<std::uint64_t> bytes_of(const Instance& instance, const ir::Memory& memory) const {
        const auto extent = maker_.value_of(instance, memory.extent);
        if (!extent) return std::nullopt;
        std::uint64_t elements = 1;
        for (const ir::Lane& lane : extent->lanes) elements *= std::max<std::uint64_t>(lane.bits, 1);
        if (memory.shape == ir::MemoryShape::buffer)
            return (elements * layout::size_of(program_, memory.element).size + 3) / 4 * 4;
        std::uint64_t texels = 0, levels = 1;
        if (memory.mips) {
            const auto mips = maker_.value_of(instance, memory.mips);
            if (!mips) return std::nullopt;
            levels = mips->bits();
        }
        const bool is_layered = memory.shape == ir::MemoryShape::image2darray;
        for (std::uint64_t level = 0; level < levels && level < 32; ++level) {
            std::uint64_t of_level = memory.shape == ir::MemoryShape::imagecube ? 6 : 1;
            for (std::size_t axis = 0; axis < extent->lanes.size(); ++axis) {
                const bool is_layer = is_layered && axis == 2;
                of_level *= std::max<std::uint64_t>(extent->lanes[axis].bits >> (is_layer ? 0 : level), 1);
            }
            texels += of_level;
        }
        return texels * texel_bytes(memory.format);
    }

    const ir::Program& program_;
    const Maker& maker_;
    std::set<const Instance*> seen_, named_;
    std::map<const Instance*, std::string> roles_;
};

bool is_whole(const ir::Types& types, ir::TypeId scalar) {
    return scalar != types.float_ && scalar != types.half && scalar != types.double_;
}

/// The numbers that are accepted for a scalar of the type, if it is whole (bools and enumerators are numbers, too):
/// those of 32 bits. A double holds more of them exactly, but no argument of a constructor needs them.
struct Limits {
    double low, high;
    const char* text;
};
Limits limits_of(const ir::Types& types, ir::TypeId scalar) {
    if (types.is_signed(scalar)) return {-2147483648.0, 2147483647.0, "from -2^31 to 2^31 - 1"};
    return {0, 4294967295.0, "from 0 to 2^32 - 1"};
}

std::string wanted(const ir::Program& program, const ir::Structure& structure, std::size_t numbers) {
    std::string text;
    for (ir::LocalId local : structure.constructor)
        text += (text.empty() ? "" : ", ") + (*program.names)[program.locals[local].name] + ": " +
                to_text(program, program.locals[local].type);
    return structure.display + "(" + text + ") takes " + std::to_string(numbers) + " numbers";
}

}  // namespace

std::optional<MadeStructure> made_with(const ir::Program& program, const ir::Structure& structure,
                                       const std::vector<double>& numbers, std::string& problem) {
    std::size_t count = 0;
    bool fits = false;  // what is left out has defaults
    for (std::size_t i = 0; i < structure.constructor.size(); ++i) {
        fits |= structure.defaults[i] && count == numbers.size();
        count += ir::lane_count(program, program.locals[structure.constructor[i]].type);
    }
    if (!fits && count != numbers.size()) {
        problem = wanted(program, structure, count) + ", not " + std::to_string(numbers.size()) +
                  ": write one for each component, as in float2(0.0, 0.0)";
        return std::nullopt;
    }
    MadeStructure result;
    std::vector<std::optional<Value>> arguments;
    std::size_t next = 0;
    const auto argument = [&](const ir::Expr& asked) { return arguments[asked.slot]; };
    for (ir::LocalId local : structure.constructor) {
        if (next == numbers.size()) {
            arguments.push_back(ir::evaluate(program, structure.defaults[arguments.size()], argument));
            continue;
        }
        const ir::TypeId type = program.locals[local].type;
        Value value{type, {}};
        const ir::TypeId scalar = program.types.scalar_of(type);
        const bool whole = is_whole(program.types, scalar);
        const Limits limits = limits_of(program.types, scalar);
        for (std::size_t i = 0; i < ir::lane_count(program, type); ++i, ++next) {
            const double number = numbers[next];
            if (whole && !(number >= limits.low && number <= limits.high && number == std::trunc(number))) {
                problem = wanted(program, structure, count) + ", of which number " + std::to_string(next + 1) +
                          " is whole, " + limits.text;
                return std::nullopt;
            }
            value.lanes.push_back({.bits = whole ? static_cast<std::uint64_t>(static_cast<std::int64_t>(number)) : 0,
                                   .number = whole ? 0 : number});
        }
        result.arguments += (result.arguments.empty() ? "" : ", ") + (*program.names)[program.locals[local].name] +
                            " " + to_text(program, value);
        arguments.push_back(std::move(value));
    }
    Maker maker(program);
    const auto made = maker.make(structure, "", std::move(arguments), {});
    Counter counter(program, maker);
    counter.name_roles(*made);
    counter.count(*made);
    result.memories = std::move(counter.memories);
    return result;
}

}  // namespace gliftc
