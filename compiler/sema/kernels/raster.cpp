#include "sema/kernels/raster.h"

#include "ir/effects.h"
#include "sema/structures/components.h"
#include "sema/structures/image_parts.h"
#include "sema/types/generics.h"
#include "sema/types/typing.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gliftc::sema {

namespace {

template <class Value, std::size_t N> using Words = std::array<std::pair<std::string_view, Value>, N>;

constexpr Words<ir::Cull, 3> culls{{{"none", ir::Cull::none}, {"back", ir::Cull::back}, {"front", ir::Cull::front}}};
constexpr Words<ir::Topology, 3> topologies{
    {{"triangles", ir::Topology::triangles}, {"lines", ir::Topology::lines}, {"points", ir::Topology::points}}};
constexpr Words<ir::Blend, 5> blends{{{"over", ir::Blend::over},
                                      {"add", ir::Blend::add},
                                      {"min", ir::Blend::min},
                                      {"max", ir::Blend::max},
                                      {"multiply", ir::Blend::multiply}}};
constexpr Words<ir::DepthTest, 5> tests{{{"less", ir::DepthTest::less},
                                         {"less_equal", ir::DepthTest::less_equal},
                                         {"greater", ir::DepthTest::greater},
                                         {"equal", ir::DepthTest::equal},
                                         {"always", ir::DepthTest::always}}};

template <class Value, std::size_t N>
std::optional<Value> find_word(const Words<Value, N>& words, std::string_view text) {
    for (const auto& [word, value] : words)
        if (word == text) return value;
    return std::nullopt;
}

template <class Value, std::size_t N> std::string list_of(const Words<Value, N>& words) {
    std::string text;
    for (std::size_t i = 0; i < N; ++i)
        text += std::string(i == 0 ? "" : i + 1 == N ? " and " : ", ") + std::string(words[i].first);
    return text;
}

/// The second argument of a pattern, a word such as `less`; empty if there is none, "?" if it is no name.
std::string_view operation_of(const Context& c, const ast::Param& param) {
    if (param.extra.empty()) return {};
    const ast::Expr& expr = c[param.extra[0]];
    return expr.kind == ast::ExprKind::name ? std::string_view(c.text(expr.name)) : std::string_view("?");
}

Span operation_span(const Context& c, const ast::Param& param) {
    return param.extra.empty() ? param.pattern_span : c[param.extra[0]].span;
}

/// Whether element a of the structure is texel a of a 2-D image.
bool is_image(const Context& c, const ir::Structure& structure) {
    return keeps_texels(c, structure) && structure.memories[structure.via_memory].shape == ir::MemoryShape::image2d;
}

void check_blend(Context& c, const ast::Param& param, const ir::Structure& structure, ir::Blend blend) {
    const ir::TypeId element = structure.element;
    const bool is_float = c.types().scalar_of(element) == c.types().float_;
    const bool fits = blend == ir::Blend::over ? is_float && c.types().components(element) == 4 : is_float;
    if (fits || blend == ir::Blend::replace) return;
    note(c.error(Diag::target_blend, operation_span(c, param), {operation_of(c, param), c.text(element)}),
         operation_span(c, param),
         is_float ? "'over' needs colours with a fourth component, which says how much they hide"
                  : "integers are replaced: 'out target<S>'");
}

void add_depth(Body& body, const ast::Param& param, const ir::KernelParam& made, std::uint32_t index,
               ir::LocalId value) {
    Context& c = body.context;
    ir::Raster& raster = *body.kernel->raster;
    const auto test = find_word(tests, operation_of(c, param));
    if (!test || made.direction == ir::Direction::out) {
        note(c.error(Diag::target_operation, operation_span(c, param), {c.text(param.name.name)}),
             operation_span(c, param),
             "depth is tested: 'inout target<S, less>' also writes it, 'in target<S, less>' does not; tests are " +
                 list_of(tests));
        return;
    }
    if (raster.depth) {
        note(c.error(Diag::target_depth, param.name.span), body.kernel->params[raster.depth->param].span,
             "this is the first one");
        return;
    }
    raster.depth = {index, *test, made.direction == ir::Direction::inout, value};
}

void add_colour(Body& body, const ast::Param& param, const ir::KernelParam& made, const ir::Structure& structure,
                std::uint32_t index, ir::LocalId value) {
    Context& c = body.context;
    ir::Blend blend = ir::Blend::replace;
    const auto found = find_word(blends, operation_of(c, param));
    const bool replaces = made.direction == ir::Direction::out && param.extra.empty();
    if (!replaces && !(made.direction == ir::Direction::inout && found)) {
        note(c.error(Diag::target_operation, operation_span(c, param), {c.text(param.name.name)}),
             operation_span(c, param),
             "colours are replaced, 'out target<S>', or blended, 'inout target<S, over>'; ways to blend are " +
                 list_of(blends));
        return;
    }
    if (found) blend = *found;
    check_blend(c, param, structure, blend);
    body.kernel->raster->colours.push_back({index, blend, value});
}

void read_states(Context& c, const ast::Raster& written, ir::Raster& raster) {
    const auto read = [&](const ast::RasterState& state, const auto& words, auto& value) {
        if (auto found = find_word(words, c.text(state.value.name))) value = *found;
        else
            note(c.error(Diag::raster_state, state.value.span, {c.text(state.value.name)}), state.value.span,
                 "it is one of " + list_of(words));
    };
    for (std::size_t i = 0; i < written.states.size(); ++i) {
        const ast::RasterState& state = written.states[i];
        for (std::size_t k = 0; k < i; ++k)
            if (written.states[k].word == state.word)
                note(c.error(Diag::raster_repeated, state.span, {state.word == Word::cull ? "cull" : "draw"}),
                     written.states[k].span, "this is the first one");
        if (state.word == Word::cull) read(state, culls, raster.cull);
        else read(state, topologies, raster.topology);
    }
}

ir::Interpolation interpolation_of(Word word) {
    return word == Word::flat     ? ir::Interpolation::flat
           : word == Word::linear ? ir::Interpolation::linear
                                  : ir::Interpolation::smooth;
}

void add_varying(Body& body, const ast::Varying& written) {
    Context& c = body.context;
    ir::Types& types = c.types();
    ir::Varying made;
    made.name = written.name.name;
    made.span = written.name.span;
    made.interpolation = interpolation_of(written.interpolation);
    made.type = type_of(c, body.env, written.type);
    const ir::TypeId scalar =
        types.is_scalar(made.type) || types.is_vector(made.type) ? types.scalar_of(made.type) : types.error;
    const bool is_integer = scalar == types.int_ || scalar == types.uint;
    if (made.type != types.error && scalar != types.float_ && !is_integer) {
        note(c.error(Diag::varying_type, c[written.type].span, {c.text(made.type)}), c[written.type].span,
             "float, int, uint and vectors of them are handed on");
        made.type = types.error;
    }
    if (is_integer && made.interpolation != ir::Interpolation::flat) {
        note(c.error(Diag::varying_integer, written.name.span, {c.text(made.name)}), written.name.span,
             "'flat " + c.text(made.name) + ": " + c.text(made.type) + ";' is that of the first corner");
    }
    made.written = add_local(c.program, made.name, made.type, made.span, true);
    made.read = add_local(c.program, made.name, made.type, made.span, false);
    body.kernel->raster->varyings.push_back(made);
}

/// Checks the address types of corners, instances and pixels, and that the draw has corners and pixels; sets
/// Raster::pixels, the parameter whose range is drawn to.
void check_iteration(Context& c, const ast::Kernel& written, ir::Kernel& kernel) {
    kernel.domain_type = c.types().vector(c.types().uint, 2);
    bool has_corners = false;
    for (const ast::Param& param : written.params) {
        has_corners = has_corners || param.pattern == ast::Pattern::each;
        const bool takes_several = param.pattern == ast::Pattern::at && !param.extra.empty();
        if (takes_several) c.error(Diag::pattern_arguments, c[param.extra[0]].span);
    }
    for (std::uint32_t i = 0; i < kernel.params.size(); ++i) {
        const ir::KernelParam& param = kernel.params[i];
        const bool is_counted = param.pattern == ir::Pattern::each || param.pattern == ir::Pattern::instance;
        const bool is_seen = param.pattern == ir::Pattern::at || param.pattern == ir::Pattern::target;
        if (!is_counted && !is_seen) continue;
        const ir::Structure& structure = c.program.structures[param.structure];
        const ir::TypeId wanted = is_counted ? c.types().uint : kernel.domain_type;
        if (structure.domain_type != wanted)
            note(c.error(Diag::raster_addresses, param.span, {c.text(param.name), c.text(structure.domain_type)}),
                 param.span,
                 is_counted ? "corners and instances are counted by one uint: take a structure of one axis"
                            : "a pixel's address is a uint2");
        if (param.pattern == ir::Pattern::each && param.direction != ir::Direction::in)
            note(c.error(Diag::raster_each, param.span, {c.text(param.name)}), param.span,
                 "corners are read: 'in each<S>'");
        const bool is_first_target =
            param.pattern == ir::Pattern::target &&
            (!kernel.raster->pixels || kernel.params[*kernel.raster->pixels].pattern == ir::Pattern::at);
        if (is_first_target || (is_seen && !kernel.raster->pixels)) kernel.raster->pixels = i;
    }
    if (!has_corners)
        note(c.error(Diag::raster_corners, kernel.span, {kernel.display}), kernel.span,
             "the vertex part runs for each element of an 'in each<S>' parameter: give it one");
    const bool has_pixels = std::ranges::any_of(written.params, [](const ast::Param& param) {
        return param.pattern == ast::Pattern::target || param.pattern == ast::Pattern::at;
    });
    if (!has_pixels)
        note(c.error(Diag::raster_pixels, kernel.span, {kernel.display}), kernel.span,
             "give it a target, or 'pixel: at<S>' to run for each pixel without one");
}

ir::LocalId named_local(Body& body, std::string_view name, ir::TypeId type) {
    return add_local(body.program(), body.context.names.intern(name), type, body.kernel->span, true);
}

void check_part(Body& body, ir::Part part, const std::vector<ast::StmtId>& written, std::vector<ir::StmtId>& to) {
    body.part = part;
    body.block = &to;
    open_scope(body);
    for (const ir::Varying& varying : body.kernel->raster->varyings) {
        Symbol symbol;
        symbol.kind = SymbolKind::local;
        symbol.type = varying.type;
        symbol.local = part == ir::Part::vertex ? varying.written : varying.read;
        declare(body, {varying.name, varying.span}, symbol);
    }
    open_scope(body);
    check_block(body, written);
    close_scope(body);
    close_scope(body);
    body.part = ir::Part::whole;
}

}  // namespace

bool is_at_home(Context& c, const ast::Param& param, ir::Pattern pattern, bool in_raster) {
    const bool of_draws = pattern == ir::Pattern::target || pattern == ir::Pattern::instance;
    if (in_raster ? pattern != ir::Pattern::near : !of_draws) return true;
    note(c.error(Diag::pattern_not_here, param.pattern_span, {ir::traits_of(pattern).name}), param.pattern_span,
         in_raster ? "a corner has no neighbours: read others by 'any<S>'"
                   : "draws have targets and instances: 'raster name(…) { … }'");
    return false;
}

void add_target(Body& body, const ast::Param& param, const ir::KernelParam& made, std::uint32_t index) {
    Context& c = body.context;
    const ir::Structure structure = c.program.structures[made.structure];
    if (!is_image(c, structure)) {
        note(c.error(Diag::target_structure, param.name.span, {structure.display}), param.name.span,
             "targets are structures whose elements lie in a 2-D image at their own addresses, as those of "
             "std.image.Image do");
        return;
    }
    const ir::LocalId value = add_local(c.program, param.name.name, structure.element, param.name.span, true);
    if (ir::has_depth_format(c.program, structure)) add_depth(body, param, made, index, value);
    else add_colour(body, param, made, structure, index, value);
}

ir::LocalId target_value(const ir::Kernel& kernel, std::uint32_t param) {
    for (const ir::ColourTarget& target : kernel.raster->colours)
        if (target.param == param) return target.value;
    if (kernel.raster->depth && kernel.raster->depth->param == param) return kernel.raster->depth->value;
    return {};
}

void check_raster(Body& body, const ast::Kernel& written) {
    Context& c = body.context;
    ir::Kernel& kernel = *body.kernel;
    ir::Raster& raster = *kernel.raster;
    check_iteration(c, written, kernel);
    read_states(c, *written.raster, raster);
    for (const ast::Varying& varying : written.raster->varyings) add_varying(body, varying);
    raster.place = named_local(body, "place", c.types().vector(c.types().float_, 4));
    raster.has_fragment = bool(written.raster->fragment_span);
    check_part(body, ir::Part::vertex, written.body, kernel.body);
    check_part(body, ir::Part::fragment, written.raster->fragment, raster.fragment);
}

}  // namespace gliftc::sema
