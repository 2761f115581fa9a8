#include "sema/kernels/writing.h"

#include "ir/chain.h"
#include "ir/effects.h"
#include "ir/reads.h"
#include "ir/spelling.h"
#include "sema/names/record.h"
#include "sema/types/instances.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

std::optional<ir::Combine> combine_of(std::string_view name) {
    if (name == "min") return ir::Combine::min;
    if (name == "max") return ir::Combine::max;
    if (name == "add") return ir::Combine::add;
    if (name == "and") return ir::Combine::bit_and;
    if (name == "or") return ir::Combine::bit_or;
    if (name == "xor") return ir::Combine::bit_xor;
    return std::nullopt;
}

std::string_view word_of(ir::Combine combine) {
    switch (combine) {
    case ir::Combine::replace: return "";
    case ir::Combine::min: return "min";
    case ir::Combine::max: return "max";
    case ir::Combine::add: return "add";
    case ir::Combine::bit_and: return "and";
    case ir::Combine::bit_or: return "or";
    case ir::Combine::bit_xor: return "xor";
    }
    return "";
}

/// The source text of a pattern: `scatter<name, or>`.
std::string pattern_text(ir::Pattern pattern, ir::Combine combine, const std::string& of) {
    std::string text = std::string(ir::traits_of(pattern).name) + "<" + of;
    if (combine != ir::Combine::replace) text += ", " + std::string(word_of(combine));
    return text + ">";
}

/// The source text of a path of members from a name: `grid.wanted`.
std::string path_text(const Context& c, std::string name, ir::StructureId structure, const ir::Place& place) {
    for (std::uint32_t member : place.members) {
        const ir::MemberStructure& next = c.program.structures[structure].members[member];
        if (!name.empty()) name += ".";
        name += c.text(next.name);
        structure = next.structure;
    }
    return name;
}

/// Whether devices have atomic operations on texels of this format.
bool has_atomics(ir::Format format) {
    return format == ir::Format::r32f || format == ir::Format::r32i || format == ir::Format::r32ui;
}

bool are_alike(const ir::Effect& one, const ir::Effect& other) {
    return one.place == other.place && one.pattern == other.pattern && one.combine == other.combine;
}

bool has_effect(const std::vector<ir::Effect>& effects, const ir::Effect& wanted) {
    return std::ranges::any_of(effects, [&](const ir::Effect& effect) { return are_alike(effect, wanted); });
}

}  // namespace

ir::Pattern written_pattern(ast::Pattern pattern) {
    if (pattern == ast::Pattern::scatter) return ir::Pattern::scatter;
    return pattern == ast::Pattern::coherent ? ir::Pattern::coherent : ir::Pattern::calls;
}

void check_direction(Context& c, const ast::Param& param, ir::KernelParam& made) {
    const ir::Directions allowed = ir::traits_of(made.pattern).directions;
    const bool reads_only = allowed == ir::Directions::in;
    const bool writes_only = allowed == ir::Directions::out;
    const bool does_both = allowed == ir::Directions::inout;
    const bool has_none = allowed == ir::Directions::none;
    switch (param.direction) {
    case ast::Direction::none:
        // `inout` unless the pattern only reads or only writes, so that uses in the body give no further errors.
        made.direction = writes_only ? ir::Direction::out : reads_only ? ir::Direction::in : ir::Direction::inout;
        if (!reads_only && !has_none)
            note(c.error(Diag::direction_missing, param.name.span, {c.text(param.name.name)}), param.name.span,
                 "write 'in', 'out' or 'inout' before the pattern");
        break;
    case ast::Direction::in: made.direction = ir::Direction::in; break;
    case ast::Direction::out: made.direction = ir::Direction::out; break;
    case ast::Direction::inout: made.direction = ir::Direction::inout; break;
    }
    const bool wrong =
        (reads_only && made.direction != ir::Direction::in) || (writes_only && made.direction != ir::Direction::out) ||
        (does_both && made.direction != ir::Direction::inout) || (has_none && param.direction != ast::Direction::none);
    if (wrong) {
        Diagnostic& diagnostic = c.error(Diag::direction, param.direction_span, {c.text(param.name.name)});
        note(diagnostic, param.pattern_span,
             reads_only    ? "near, any and at only read: 'in'; scatter<S> writes anywhere"
             : writes_only ? "scatter only writes: 'out'"
             : has_none    ? "what calls<S> reads and writes is what the functions that are called say: no direction"
                           : "coherent memory is read and written: 'inout'");
    }
}

namespace {

/// Reports as the target of combined writes an image, if devices have no atomic operations on its texels, and a field
/// of elements that are kept whole.
void check_combined_memory(Context& c, const ast::Expr& op, ir::StructureId index) {
    const ir::Structure& structure = c.program.structures[index];
    if (structure.kind != ir::StructureKind::stored) return;  // a view: check_stored() reports it
    const ir::Memory& memory = ir::root_memory(c.program, structure);
    const ir::Structure& root = ir::root_structure(c.program, structure);
    if (!root.apart && !ir::fields_in(c.program, structure, root).empty())
        note(c.error(Diag::scatter_component, op.span, {c.text(op.name), structure.display, root.display}), op.span,
             "keep each field in memory of its own (layout: apart), or take the component as 'inout coherent' and "
             "use an atomic function");
    if (memory.shape == ir::MemoryShape::buffer || has_atomics(memory.format)) return;
    note(c.error(Diag::scatter_image, op.span,
                 {c.text(op.name), structure.display, std::string(ir::spelling(memory.format))}),
         op.span, "devices combine texels of r32f, r32i and r32ui; or keep the elements in a buffer, as Array does");
}

}  // namespace

ir::Combine check_combine(Context& c, ast::ExprId operation, ir::StructureId structure) {
    const ast::Expr& op = c[operation];
    const auto combine = op.kind == ast::ExprKind::name ? combine_of(c.text(op.name)) : std::nullopt;
    if (!combine) {
        note(c.error(Diag::scatter_operation, op.span), op.span,
             "one of min, max, add, and, or, xor; without one, invocations must not write the same element");
        return ir::Combine::replace;
    }
    const ir::TypeId element = c.program.structures[structure].element;
    const bool bits = *combine >= ir::Combine::bit_and;
    const bool fits = element == c.types().int_ || element == c.types().uint || (element == c.types().float_ && !bits);
    if (!fits) c.error(Diag::scatter_element, op.span, {c.text(op.name), c.text(element)});
    else check_combined_memory(c, op, structure);
    return *combine;
}

void check_coherent(Context& c, ast::Identifier name, ir::StructureId index) {
    const ir::Structure& structure = c.program.structures[index];
    if (structure.kind != ir::StructureKind::stored) return;  // a view: check_stored() reports it
    const ir::Memory& memory = ir::root_memory(c.program, structure);
    const bool is_gathered =
        ir::root_structure(c.program, structure).apart && c.types().kind(structure.element) == ir::TypeKind::struct_;
    if (is_gathered)
        note(c.error(Diag::coherent_apart, name.span, {structure.display}), name.span,
             "take the components that are shared, one by one");
    if (memory.shape == ir::MemoryShape::buffer || memory.format == ir::Format::r32i ||
        memory.format == ir::Format::r32ui)
        return;
    note(c.error(Diag::coherent_memory, name.span, {std::string(ir::spelling(memory.format)), structure.display}),
         name.span, "invocations share buffers, and images of r32i and r32ui");
}

void check_stored(Context& c, Span span, ir::StructureId index) {
    const ir::Structure& structure = c.program.structures[index];
    if (structure.kind != ir::StructureKind::computed) return;
    Diagnostic& diagnostic = c.error(Diag::view_written, span, {structure.display});
    if (!structure.base.empty())
        note(diagnostic, structure.base_span,
             "its memory is the view " + ir::root_structure(c.program, structure).display + ", which is computed");
}

void check_depth_written(Context& c, ast::Identifier name, ir::StructureId index) {
    if (!ir::has_depth_format(c.program, c.program.structures[index])) return;
    note(c.error(Diag::depth_written, name.span, {c.text(name.name)}), name.span,
         "a raster writes depths, to an 'inout target<S, always>' for instance; clear_depth of std.image fills all");
}

void declare_writing(Body& body, const ast::Param& param, ir::KernelParam made, ir::Place place,
                     ir::Function& function) {
    Context& c = body.context;
    const bool is_old_form = made.pattern == ir::Pattern::coherent && param.direction == ast::Direction::none;
    if (!is_old_form) check_direction(c, param, made);
    if (made.pattern != ir::Pattern::calls) check_stored(c, param.name.span, made.structure);
    if (made.pattern == ir::Pattern::scatter) check_depth_written(c, param.name, made.structure);
    if (made.pattern == ir::Pattern::coherent) check_coherent(c, param.name, made.structure);
    if (made.pattern == ir::Pattern::scatter && !param.extra.empty())
        made.combine = check_combine(c, param.extra[0], made.structure);
    Symbol symbol;
    symbol.kind = SymbolKind::structure;
    symbol.place = place;
    symbol.structure = made.structure;
    symbol.writing = {made.pattern, made.combine, param.name.span};
    declare(body, param.name, symbol);
    if (made.pattern == ir::Pattern::calls) return;
    if (made.pattern == ir::Pattern::coherent) body.coherent.push_back(place);
    function.effects.push_back({.place = std::move(place),
                                .pattern = made.pattern,
                                .combine = made.combine,
                                .span = param.pattern_span,
                                .by = function.name,
                                .is_own = true});
}

namespace {

/// The member named in a `with`; null, after an error, if the name is no structure among the members, or has no
/// elements and the pattern is not `calls`.
Symbol* written_member(Body& body, const ast::MemberPattern& pattern) {
    Context& c = body.context;
    Symbol* symbol = body.container ? find_symbol(body, pattern.member.name) : nullptr;
    const bool is_whole = symbol != nullptr && symbol->kind == SymbolKind::structure &&
                          c.program.structures[symbol->structure].kind == ir::StructureKind::no_elements;
    const bool is_member = symbol != nullptr && symbol->kind == SymbolKind::structure &&
                           (!is_whole || pattern.pattern == ast::Pattern::calls);
    if (is_member) {
        record_use(c, pattern.member.span, symbol->span);
        return symbol;
    }
    Diagnostic& diagnostic = c.error(Diag::with_member, pattern.member.span, {c.text(pattern.member.name)});
    if (!body.container)
        note(diagnostic, pattern.pattern_span,
             "'with' names members of the structure that the function is declared in; parameters say for "
             "themselves how they are written: 'out scatter<S, op>', 'inout coherent<S>', 'calls<S>'");
    else if (is_whole)
        note(diagnostic, pattern.pattern_span, "it has no elements, only functions that are called: 'calls<…>'");
    else note(diagnostic, pattern.pattern_span, "name a 'structure' of it, or its memory where that is a structure");
    return nullptr;
}

}  // namespace

void declare_with(Body& body, const ast::Function& written, ir::Function& function) {
    Context& c = body.context;
    for (const ast::MemberPattern& pattern : written.with) {
        Symbol* symbol = written_member(body, pattern);
        if (symbol == nullptr) continue;
        const ir::Pattern made = written_pattern(pattern.pattern);
        if (symbol->writing.pattern != ir::Pattern::any) {
            note(c.error(Diag::duplicate_name, pattern.member.span, {c.text(pattern.member.name)}),
                 symbol->writing.span, "a function has one pattern for a member");
            continue;
        }
        ir::Combine combine = ir::Combine::replace;
        if (made != ir::Pattern::calls) check_stored(c, pattern.member.span, symbol->structure);
        if (made == ir::Pattern::scatter) check_depth_written(c, pattern.member, symbol->structure);
        if (made == ir::Pattern::coherent) check_coherent(c, pattern.member, symbol->structure);
        const bool takes_operation = made == ir::Pattern::scatter && pattern.extra.size() <= 1;
        if (!pattern.extra.empty() && !takes_operation) c.error(Diag::pattern_arguments, c[pattern.extra[0]].span);
        else if (!pattern.extra.empty()) combine = check_combine(c, pattern.extra[0], symbol->structure);
        symbol->writing = {made, combine, pattern.member.span};
        if (made == ir::Pattern::calls) continue;
        if (made == ir::Pattern::coherent) body.coherent.push_back(symbol->place);
        function.effects.push_back({.place = symbol->place,
                                    .pattern = made,
                                    .combine = combine,
                                    .span = pattern.pattern_span,
                                    .by = function.name,
                                    .is_own = true});
    }
}

bool fits_writing(Body& body, const Env& env, const ast::Param& param, const Operand& argument) {
    Context& c = body.context;
    const bool writes = param.pattern == ast::Pattern::scatter || param.pattern == ast::Pattern::coherent ||
                        param.pattern == ast::Pattern::calls;
    if (!writes) return true;
    Writing wanted{written_pattern(param.pattern), ir::Combine::replace, param.name.span};
    const ir::TypeId type = type_of(c, env, param.type);
    if (wanted.is(ir::Pattern::scatter) && !param.extra.empty())
        wanted.combine = check_combine(c, param.extra[0], c.types()[type].structure);
    if (argument.writing.is(wanted.pattern) && argument.writing.combine == wanted.combine) return true;
    const std::string text =
        pattern_text(wanted.pattern, wanted.combine, c.program.structures[argument.structure].display);
    Diagnostic& diagnostic = c.error(Diag::pattern_differs, argument.span, {c.text(param.name.name), text});
    note(diagnostic, param.name.span, "declared here");
    if (argument.writing.span) note(diagnostic, argument.writing.span, "the argument has another pattern here");
    else note(diagnostic, argument.span, "pass a parameter or a member that has the same pattern");
    return false;
}

namespace {

/// Whether the caller may have this effect through the structure that it passes; reports if not.
bool may_have(Body& body, const ir::Function& called, const ir::Effect& effect, const Operand& through, Span span) {
    Context& c = body.context;
    if (body.effects == nullptr) {
        Diagnostic& diagnostic = c.error(Diag::writes_here, span, {c.text(called.name)});
        note(diagnostic, called.span, "declared here");
        note(diagnostic, span,
             body.kind == BodyKind::pipeline ? "call it in a kernel, through a parameter that is 'calls<…>'"
                                             : "what is read has no effect: call it in a kernel");
        return false;
    }
    if (has_effect(*body.effects, effect) || through.writing.is(ir::Pattern::calls)) return true;
    const ir::StructureId structure = through.structure;
    ir::Place from_there = effect.place;
    from_there.members = {effect.place.members.begin() + static_cast<std::ptrdiff_t>(through.place.members.size()),
                          effect.place.members.end()};
    const std::string member = path_text(c, "", structure, from_there);
    const std::string text = pattern_text(effect.pattern, effect.combine, member);
    const bool is_own = body.container && through.place.members.empty() && through.place.root == 0 && !body.kernel;
    Diagnostic& diagnostic = c.error(Diag::calls_missing, span, {c.text(called.name), text});
    note(diagnostic, called.span, "declared here");
    if (is_own) note(diagnostic, span, "say that this function does so, too: 'with " + text + "'");
    else if (through.place.members.empty() && through.writing.span)
        note(diagnostic, through.writing.span,
             "take it as 'calls<" + c.program.structures[structure].display + ">': functions that write are called");
    else
        note(diagnostic, span,
             "take the structure as 'calls<…>', or in a function of its container write 'with calls<…>'");
    return false;
}

}  // namespace

bool add_effects(Body& body, ir::FunctionId id, const std::vector<Operand>& given, bool is_method, Span span) {
    const ir::Function called = body.program().functions[id];
    for (ir::Effect effect : called.effects) {
        const Operand& through = given[effect.place.root];
        // If the callee has this effect through one of its parameters, fits_writing() has checked that the caller
        // declares the same pattern for the structure that it passes. So the caller has the effect already, or is a
        // kernel whose own parameter has that pattern.
        const bool is_param = effect.place.members.empty() && !(is_method && effect.place.root == 0);
        ir::Place place = through.place;
        place.members.append(effect.place.members);
        effect.place = std::move(place);
        effect.span = span;
        effect.by = called.name;
        effect.is_own = false;
        if (is_param && body.effects != nullptr && !through.writing.is(ir::Pattern::calls)) continue;
        if (!may_have(body, called, effect, through, span)) return false;
        if (!has_effect(*body.effects, effect)) body.effects->push_back(std::move(effect));
    }
    return true;
}

namespace {

struct Access {
    Span span;
    std::string text;
};

void report_two(Context& c, const std::string& what, const Access& one, const Access& other) {
    Diagnostic& diagnostic = c.error(Diag::two_patterns, other.span, {what});
    note(diagnostic, one.span, one.text);
    note(diagnostic, other.span, other.text);
    note(diagnostic, other.span, "do it in two passes, or let one function declare what both do");
}

std::string call_text(const Context& c, const ir::Effect& effect, const std::string& what) {
    return "'" + c.text(effect.by) + "' has " + pattern_text(effect.pattern, effect.combine, what) + ", called here";
}

}  // namespace

/// Reports the first read (ir::for_each_read: coherent ones are left out) of a memory that the kernel also writes by
/// scatter or through functions.
template <class MemoryOf, class TextOf>
static void check_reads(Context& c, const ir::Kernel& kernel, MemoryOf&& memory_of, TextOf&& text_of) {
    bool is_reported = false;
    ir::for_each_read(c.program, kernel, [&](const ir::Place& read, Span span) {
        for (std::uint32_t root = 0; root < kernel.params.size() && !is_reported; ++root) {
            const ir::KernelParam& param = kernel.params[root];
            if (param.pattern != ir::Pattern::scatter || memory_of({root, {}}) != read) continue;
            note(c.error(Diag::written_and_read, span, {c.text(param.name), c.text(kernel.name)}), param.span,
                 "a scatter parameter is only written; take the structure as 'inout coherent', or as a second "
                 "parameter with @disjoint");
            is_reported = true;
        }
        for (const ir::Effect& effect : kernel.effects) {
            if (is_reported || memory_of(effect.place) != read) continue;
            const std::string what = text_of(effect.place);
            report_two(c, what, {effect.span, call_text(c, effect, what)}, {span, "it is read here"});
            is_reported = true;
        }
    });
}

void check_effects(Context& c, const ir::Kernel& kernel) {
    const ir::Program& p = c.program;
    const auto memory_of = [&](const ir::Place& place) {
        const ir::Structure& whole = p.structures[kernel.params[place.root].structure];
        const ir::Place root = ir::root_of(p, ir::structure_at(p, whole, place.members), place);
        return ir::Place{root.root, ir::made_at(p, whole, {root.members.begin(), root.members.end()})};
    };
    const auto text_of = [&](const ir::Place& place) {
        const ir::KernelParam& param = kernel.params[place.root];
        return path_text(c, c.text(param.name), param.structure, place);
    };
    for (std::size_t k = 0; k < kernel.effects.size(); ++k) {
        const ir::Effect& effect = kernel.effects[k];
        const ir::Place memory = memory_of(effect.place);
        const std::string what = text_of(effect.place);
        const Access here{effect.span, call_text(c, effect, what)};
        for (std::size_t i = 0; i < k; ++i) {
            const ir::Effect& other = kernel.effects[i];
            if (memory_of(other.place) != memory) continue;
            if (other.pattern == effect.pattern && other.combine == effect.combine) continue;
            return report_two(c, what, {other.span, call_text(c, other, what)}, here);
        }
    }
    check_reads(c, kernel, memory_of, text_of);
}

}  // namespace gliftc::sema
