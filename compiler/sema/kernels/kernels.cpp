#include "ir/chain.h"
#include "ir/effects.h"
#include "sema/kernels/raster.h"
#include "sema/kernels/uniformity.h"
#include "sema/kernels/writing.h"
#include "sema/structures/blocks.h"
#include "sema/structures/components.h"
#include "sema/types/generics.h"
#include "sema/types/instances.h"
#include "sema/types/typing.h"
#include "syntax/print.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

ir::Pattern lowered(ast::Pattern pattern) {
    switch (pattern) {
    case ast::Pattern::none:
    case ast::Pattern::range: return ir::Pattern::value;
    case ast::Pattern::each: return ir::Pattern::each;
    case ast::Pattern::near: return ir::Pattern::near;
    case ast::Pattern::any: return ir::Pattern::any;
    case ast::Pattern::at: return ir::Pattern::at;
    case ast::Pattern::scatter: return ir::Pattern::scatter;
    case ast::Pattern::coherent: return ir::Pattern::coherent;
    case ast::Pattern::target: return ir::Pattern::target;
    case ast::Pattern::instance: return ir::Pattern::instance;
    case ast::Pattern::calls: return ir::Pattern::calls;
    }
    return ir::Pattern::value;
}

}  // namespace

ir::Radius window_radius(Context& c, const Env& env, const ast::Param& param, ir::TypeId domain) {
    constexpr ir::Radius one{{1, 1, 1, 1}};
    if (param.extra.empty()) {
        note(c.error(Diag::near_without_radius, param.pattern_span), param.pattern_span,
             "write near<S, 1> for a window of radius 1");
        return one;
    }
    const Span span = c[param.extra[0]].span;
    const std::optional<ir::Value> value = constant_of(c, env, param.extra[0]);
    if (!value) return one;
    ir::Radius radius;
    const ir::TypeId scalar = c.types().is_vector(value->type) ? c.types().scalar_of(value->type) : value->type;
    const bool fits = scalar == value->type || c.types().components(value->type) == c.types().components(domain);
    if (!fits || (scalar != c.types().uint && scalar != c.types().int_)) {
        c.error(Diag::type_mismatch, span, {c.text(domain), c.text(value->type)});
        return one;
    }
    for (std::size_t axis = 0; axis < radius.along.size(); ++axis) {
        const std::size_t lane = scalar == value->type ? 0 : axis;
        if (lane >= value->lanes.size()) break;
        const std::uint64_t along = value->lanes[lane].bits;
        if (along > 32) c.error(Diag::radius_range, span, {ir::to_text(c.program, *value)});
        radius.along[axis] = static_cast<std::uint32_t>(std::min<std::uint64_t>(along, 32));
    }
    if (radius.largest() == 0) c.error(Diag::radius_range, span, {ir::to_text(c.program, *value)});
    return radius;
}

void check_extra_count(Context& c, const ast::Param& param) {
    const bool takes_one = param.pattern == ast::Pattern::near || param.pattern == ast::Pattern::scatter ||
                           param.pattern == ast::Pattern::at || param.pattern == ast::Pattern::target;
    const std::size_t taken = takes_one ? 1 : 0;
    if (param.extra.size() > taken) c.error(Diag::pattern_arguments, c[param.extra[taken]].span);
}

namespace {

/// Reads the radius of `near` and the operation of `scatter`. The argument of `at` is for the whole kernel:
/// read_items(); that of `target` is the blending or depth test: add_target().
void check_extra(Context& c, const Env& env, const ast::Param& param, ir::KernelParam& made) {
    check_extra_count(c, param);
    if (made.pattern == ir::Pattern::near)
        made.radius = window_radius(c, env, param, c.program.structures[made.structure].domain_type);
    if (made.pattern == ir::Pattern::scatter && !param.extra.empty())
        made.combine = check_combine(c, param.extra[0], made.structure);
}

/// Reports `out each` and `inout each` over a many-to-one translator: two invocations, which run in no order, could
/// write one element.
void check_exclusive(Context& c, const ast::Param& param, const ir::KernelParam& made) {
    if (made.pattern != ir::Pattern::each || made.direction == ir::Direction::in) return;
    const ir::Translator* translator = ir::many_to_one_stage(c.program, made.structure);
    if (!translator) return;
    const std::string& structure = c.program.structures[made.structure].display;
    Diagnostic& diagnostic = c.error(Diag::each_many_to_one, param.name.span, {c.text(param.name.name), structure});
    note(diagnostic, translator->span, "declared @many_to_one here");
    note(diagnostic, param.pattern_span, "scatter<S, op> combines writes to one element: min, max, add, and, or, xor");
}

/// Whether a kernel can access a parameter of this type by this pattern; reports one that it cannot. Some have no
/// elements: `any` reads its members, `calls` calls its functions.
bool is_touched(Context& c, const ast::Param& param, ir::Pattern pattern, ir::TypeId type) {
    if (c.types().kind(type) != ir::TypeKind::structure) {
        if (type != c.types().error) c.error(Diag::pattern_needs_structure, c[param.type].span, {c.text(type)});
        return false;
    }
    const ir::Structure& structure = c.program.structures[c.types()[type].structure];
    if (structure.kind != ir::StructureKind::no_elements || pattern == ir::Pattern::any ||
        pattern == ir::Pattern::calls)
        return true;
    c.error(Diag::no_elements_in_kernel, c[param.type].span, {structure.display});
    return false;
}

/// Adds a parameter whose declaration has an error, with the error type, so that its uses report nothing more.
void add_broken(Body& body, const ast::Param& param, ir::KernelParam made, ir::Kernel& kernel) {
    const ir::TypeId error = body.types().error;
    Symbol broken;
    broken.kind = SymbolKind::local;
    broken.type = error;
    broken.local = add_local(body.context.program, param.name.name, error, param.name.span);
    declare(body, param.name, broken);
    made.pattern = ir::Pattern::value;
    made.local = broken.local;
    kernel.params.push_back(std::move(made));
}
// long: all checks of one declaration
void add_param(Body& body, const ast::Param& param, ir::Kernel& kernel) {
    Context& c = body.context;
    ir::KernelParam made;
    made.name = param.name.name;
    made.span = param.name.span;
    made.pattern = lowered(param.pattern);
    auto index = static_cast<std::uint32_t>(kernel.params.size());
    ir::TypeId type = c.types().error;
    if (param.pattern == ast::Pattern::range) c.error(Diag::range_in_kernel, param.pattern_span);
    else type = type_of(c, body.env, param);
    if (made.pattern == ir::Pattern::value) {
        bool is_structure = c.types().kind(type) == ir::TypeKind::structure;
        if (is_structure)
            note(c.error(Diag::structure_needs_pattern, c[param.type].span, {c.text(param.name.name)}),
                 c[param.type].span,
                 c.program.structures[c.types()[type].structure].kind == ir::StructureKind::no_elements
                     ? "say how the kernel calls its functions: calls<…>, or any<…> if they only read"
                     : "say how the kernel accesses it: each<…>, near<…, r>, any<…>, at<…>, scatter<…> or coherent<…>");
        if (type && !is_structure && holds_optional(c.program, type)) {
            note(c.error(Diag::optional_parameter, c[param.type].span, {c.text(param.name.name), c.text(type)}),
                 c[param.type].span, "pass the value and a bool that says whether there is one");
            type = c.types().error;
        }
        made.local = declare_local(body, param.name, is_structure ? c.types().error : type, false, false);
        kernel.params.push_back(std::move(made));
        return;
    }
    if (!is_touched(c, param, made.pattern, type) || !is_at_home(c, param, made.pattern, kernel.raster.has_value()))
        return add_broken(body, param, std::move(made), kernel);
    made.structure = c.types()[type].structure;
    const ir::Structure structure = c.program.structures[made.structure];
    check_direction(c, param, made);
    check_extra(c, body.env, param, made);
    check_exclusive(c, param, made);
    const bool writes = made.direction != ir::Direction::in && made.pattern != ir::Pattern::calls;
    if (writes) check_stored(c, param.name.span, made.structure);
    const bool stores = writes && made.pattern != ir::Pattern::target && made.pattern != ir::Pattern::coherent;
    if (stores) check_depth_written(c, param.name, made.structure);
    if (ir::visits(made.pattern) && !structure.domain) c.error(Diag::no_domain, param.name.span, {structure.display});
    if (made.pattern == ir::Pattern::coherent) {
        check_coherent(c, param.name, made.structure);
        body.coherent.push_back({index, {}});
    }
    Symbol symbol;
    const bool is_own = ir::follows_iteration(made.pattern) || ir::traits_of(made.pattern).reach == ir::Reach::element;
    symbol.kind = is_own ? SymbolKind::iterator : SymbolKind::structure;
    symbol.place.root = index;
    symbol.slot = index;
    symbol.structure = made.structure;
    if (symbol.kind == SymbolKind::structure) symbol.writing = {made.pattern, made.combine, made.span};
    declare(body, param.name, symbol);
    kernel.params.push_back(made);
    if (made.pattern == ir::Pattern::target) add_target(body, param, made, index);
}

/// Finds the address type of the domain that the kernel runs over. Reports `each`, `at` and `near` parameters with
/// another address type, and a kernel that has neither `each` nor `at`.
void find_domain(Context& c, const ast::Kernel& written, ir::Kernel& kernel, bool parameters_are_good) {
    const ir::KernelParam* first = nullptr;
    for (const ir::KernelParam& param : kernel.params) {
        if (!ir::visits(param.pattern)) continue;
        ir::TypeId domain = c.program.structures[param.structure].domain_type;
        if (!first) first = &param, kernel.domain_type = domain;
        else if (domain != kernel.domain_type) {
            note(c.error(Diag::domain_mismatch, param.span,
                         {c.text(param.name), c.text(domain), c.text(first->name), c.text(kernel.domain_type)}),
                 first->span, "the iteration follows this one");
        }
    }
    // The patterns as written count: a parameter with an error has the pattern `value` in the kernel (add_broken).
    const bool is_asked = std::ranges::any_of(written.params, [](const ast::Param& param) {
        return param.pattern == ast::Pattern::each || param.pattern == ast::Pattern::at;
    });
    if (!is_asked && parameters_are_good) {
        note(c.error(Diag::no_iteration, kernel.span, {kernel.display}), kernel.span,
             "a kernel runs once for each element of an 'each' or 'at' parameter: give it one");
    }
    if (!first) return;
    for (const ir::KernelParam& param : kernel.params) {
        if (param.pattern != ir::Pattern::near) continue;
        ir::TypeId domain = c.program.structures[param.structure].domain_type;
        if (domain != kernel.domain_type)
            note(c.error(Diag::domain_mismatch, param.span,
                         {c.text(param.name), c.text(domain), c.text(first->name), c.text(kernel.domain_type)}),
                 first->span, "the iteration follows this one");
    }
}

/// Whether two parameters of one structure type are likely to get arguments of the same size, so that they can share
/// pass parameters and address arithmetic: both ranges have the size of the visited one, or both are declared by the
/// same type text (`S` and `S`, not `S` and `D`). Different components of one structure type, or the structure and a
/// component, are likely to be of one structure.
bool are_alike(const Context& c, const ast::Kernel& written, const ir::Kernel& kernel, std::size_t i, std::size_t k) {
    const ir::KernelParam &one = kernel.params[i], &other = kernel.params[k];
    if (one.pattern == ir::Pattern::value || other.pattern == ir::Pattern::value) return false;
    const bool are_components = ir::have_one_whole(c.program, one, other);
    if (one.structure != other.structure && !are_components) return false;
    if (one.pattern == ir::Pattern::calls || other.pattern == ir::Pattern::calls) return false;
    if (c.program.structures[one.structure].kind == ir::StructureKind::no_elements) return false;
    // The ranges of corners, instances and pixels of a draw have sizes independent of each other.
    if (kernel.raster && one.pattern != other.pattern && (ir::visits(one.pattern) || ir::visits(other.pattern)))
        return false;
    if (ir::follows_iteration(one.pattern) && ir::follows_iteration(other.pattern)) return true;
    return are_components ||
           print(written.params[i].type, c.tree, c.names) == print(written.params[k].type, c.tree, c.names);
}

void find_alike(const Context& c, const ast::Kernel& written, ir::Kernel& kernel) {
    for (std::uint32_t i = 0; i < kernel.params.size(); ++i) {
        std::uint32_t k = 0;
        while (k < i && !are_alike(c, written, kernel, k, i)) ++k;
        kernel.params[i].alike = k == i ? i : kernel.params[k].alike;
    }
}

/// Reads `at<S, 16>`: the kernel runs once for 16 consecutive elements.
void read_items(Context& c, const Env& env, const ast::Kernel& written, ir::Kernel& kernel) {
    const ast::Param* first = nullptr;
    for (const ast::Param& param : written.params) {
        if (param.pattern != ast::Pattern::at || param.extra.empty()) continue;
        auto items = count_of(c, env, param.extra[0]);
        if (!items) return;
        Span span = c[param.extra[0]].span;
        if (*items == 0 || *items > 65536) c.error(Diag::items_range, span, {std::to_string(*items)});
        else if (first && *items != kernel.items)
            note(c.error(Diag::items_differ, span, {std::to_string(*items), std::to_string(kernel.items)}),
                 first->pattern_span, "the iteration is declared here");
        else if (kernel.domain_type && c.types().is_vector(kernel.domain_type))
            c.error(Diag::items_axes, span, {c.text(kernel.domain_type)});
        else kernel.items = *items, first = &param;
    }
    if (kernel.items == 1) return;
    for (const ir::KernelParam& param : kernel.params) {
        if (param.pattern != ir::Pattern::each && param.pattern != ir::Pattern::near) continue;
        note(c.error(Diag::items_each, param.span, {c.text(param.name), std::to_string(kernel.items)}),
             first->pattern_span,
             "the kernel runs once for several elements; take '" + c.text(param.name) + "' as any<…> or scatter<…>");
    }
}

/// The index of the parameter that an attribute names; absent if it names none.
std::optional<std::uint32_t> parameter_named(const Context& c, const ir::Kernel& kernel, ast::ExprId id) {
    const ast::Expr& name = c[id];
    for (std::uint32_t i = 0; i < kernel.params.size(); ++i)
        if (name.kind == ast::ExprKind::name && kernel.params[i].name == name.name) return i;
    return std::nullopt;
}

/// Reads `@disjoint(read, written)`.
void read_disjoint(Context& c, const ast::Attribute& attribute, ir::Kernel& kernel) {
    std::optional<std::uint32_t> read, written;
    if (attribute.arguments.size() == 2) {
        read = parameter_named(c, kernel, attribute.arguments[0]);
        written = parameter_named(c, kernel, attribute.arguments[1]);
    }
    const auto accesses = [&](const std::optional<std::uint32_t>& param, bool writes) {
        if (!param) return false;
        const ir::KernelParam& named = kernel.params[*param];
        const bool is_accessed =
            ir::traits_of(named.pattern).reach != ir::Reach::nothing || named.pattern == ir::Pattern::calls;
        return is_accessed && (named.direction != ir::Direction::in) == writes;
    };
    if (accesses(read, false) && accesses(written, true)) kernel.disjoint.emplace_back(*read, *written);
    else
        note(c.error(Diag::disjoint_names, attribute.span), attribute.span,
             "the first is an 'in' parameter of a structure, the second one that is 'out' or 'inout'");
}

/// The member that an attribute without arguments sets; null: there is no such attribute.
bool ir::Kernel::*flag_of(const std::string& attribute) {
    if (attribute == "accesses_outside") return &ir::Kernel::accesses_outside;
    if (attribute == "fast_math") return &ir::Kernel::fast_math;
    return nullptr;
}

/// Reads the attributes of a kernel: `@disjoint(read, written)`, `@accesses_outside`, `@fast_math`; reports any other.
void read_attributes(Context& c, const ast::Decl& decl, ir::Kernel& kernel) {
    for (const ast::Attribute& attribute : decl.attributes) {
        const std::string& name = c.text(attribute.name.name);
        if (name == "disjoint") {
            read_disjoint(c, attribute, kernel);
        } else if (const auto flag = flag_of(name)) {
            kernel.*flag = true;
            if (!attribute.arguments.empty()) c.error(Diag::attribute_alone, attribute.span, {name});
        } else {
            c.error(Diag::unknown_attribute, attribute.span, {name});
        }
    }
}

}  // namespace

constexpr std::uint64_t most_invocations = 1024;  // of a workgroup

std::array<std::uint32_t, 3> group_of(Context& c, const Env& env, const std::vector<ast::ExprId>& written) {
    if (written.empty()) return {0, 0, 0};
    std::uint64_t product = 1;
    std::array<std::uint32_t, 3> group = {1, 1, 1};
    for (std::size_t i = 0; i < written.size() && i < 3; ++i) {
        auto count = count_of(c, env, written[i]);
        if (!count) return {1, 1, 1};
        group[i] = *count;
        product *= *count;
        if (product == 0 || product > most_invocations) {  // not after the loop: the product of three may overflow
            c.error(Diag::group_range, c[written[0]].span, {std::to_string(product)});
            return {1, 1, 1};
        }
    }
    return group;
}

/// A suffix of the kernel's key: its number among the kernels of its name in its module; empty for the first.
static std::string overload_text(const Context& c, ast::DeclId id) {
    const auto& names = c.scopes[c.module_of.at(id)].names;
    const auto found = names.find(c[id].name.name);
    if (found == names.end()) return "";
    const std::vector<ast::DeclId>& same = found->second;
    const auto before = std::ranges::find(same, id);
    const auto kernels = std::count_if(
        same.begin(), before, [&](ast::DeclId other) { return std::holds_alternative<ast::Kernel>(c[other].body); });
    return kernels == 0 ? "" : "<overload " + std::to_string(kernels + 1) + ">";
}

/// Finds the domain and the blocks that a kernel which does not draw runs over, and the number of elements that an
/// invocation takes.
static void check_iteration(Body& body, const ast::Kernel& written, bool parameters_are_good) {
    find_domain(body.context, written, *body.kernel, parameters_are_good);
    read_items(body.context, body.env, written, *body.kernel);
    if (parameters_are_good) find_space(body.context, *body.kernel);
}

static void check_body(Body& body, const ast::Kernel& written) {
    open_scope(body);
    check_block(body, written.body);
    close_scope(body);
}

ir::KernelId instantiate_kernel(Context& c, ast::DeclId id, const Env& env, Span use) {
    const ast::Decl& decl = c[id];
    const auto& written = std::get<ast::Kernel>(decl.body);
    std::string key = key_of(c, id, env);
    if (auto found = c.instances.find(key); found != c.instances.end()) return {found->second.index};
    InstantiationScope scope(c, display_of(c, decl, env), use);
    if (scope.too_deep()) return {};
    c.instances[key] = {};
    std::size_t errors = c.diagnostics.own_error_count();
    ir::Kernel kernel;
    kernel.name = decl.name.name;
    kernel.display = display_of(c, decl, env);
    kernel.key = qualified_display_of(c, id, env) + overload_text(c, id);
    kernel.span = decl.name.span;
    kernel.module = c.module_of.at(id);
    kernel.is_pub = decl.is_pub && decl.generics.empty();
    kernel.doc = decl.doc;
    kernel.group = group_of(c, env, written.group);
    Span prints;
    Body body{.context = c,
              .env = env,
              .kind = BodyKind::kernel,
              .block = &kernel.body,
              .result = c.types().void_,
              .kernel = &kernel,
              .group = kernel.group,
              .shared = &kernel.shared,
              .effects = &kernel.effects,
              .prints = written.raster ? nullptr : &prints};
    if (written.raster) kernel.raster.emplace();
    for (const ast::Param& param : written.params) add_param(body, param, kernel);
    if (kernel.raster) check_raster(body, written);
    else check_iteration(body, written, c.diagnostics.own_error_count() == errors);
    if (c.diagnostics.own_error_count() == errors) read_attributes(c, decl, kernel);
    find_alike(c, written, kernel);
    if (!kernel.raster) check_body(body, written);
    kernel.has_messages = prints && c.settings.messages;
    if (c.diagnostics.own_error_count() == errors) check_effects(c, kernel);
    if (kernel.raster && c.diagnostics.own_error_count() == errors) check_assigned(c, kernel);
    if (kernel.grouped() && c.diagnostics.own_error_count() == errors) check_barriers(c, kernel);
    if (kernel.raster && c.diagnostics.own_error_count() == errors) check_derivatives(c, kernel);
    Instance& instance = c.instances[key];
    instance.state = c.diagnostics.own_error_count() == errors ? Instance::State::done : Instance::State::failed;
    if (instance.state == Instance::State::failed) return {};
    const ir::KernelId made = c.program.kernels.add(std::move(kernel));
    instance.index = made.index;
    return made;
}

}  // namespace gliftc::sema
