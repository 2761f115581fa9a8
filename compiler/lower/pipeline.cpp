// Lowers kernels: runs the passes in order. passes.cpp says what each pass needs and what it guarantees.
#include "base/parallel.h"
#include "ir/effects.h"
#include "ir/validate.h"
#include "ir/walk.h"
#include "lower/analysis/affine.h"
#include "lower/analysis/aliasing.h"
#include "lower/analysis/contained.h"
#include "lower/analysis/loops.h"
#include "lower/expand/dispatch.h"
#include "lower/expand/expand.h"
#include "lower/host/copy_rows.h"
#include "lower/host/find_rows.h"
#include "lower/host/lockstep.h"
#include "lower/host/row_updates.h"
#include "lower/host/split_blocks.h"
#include "lower/lower.h"
#include "lower/overlay.h"
#include "lower/passes.h"
#include "lower/run_passes.h"
#include "lower/shader_variants.h"
#include "lower/transform/coarsen.h"
#include "lower/transform/common_bindings.h"
#include "lower/transform/compact.h"
#include "lower/transform/dead.h"
#include "lower/transform/fold_constants.h"
#include "lower/transform/split_chains.h"
#include "lower/transform/temporaries.h"
#include "lower/transform/uniforms.h"
#include "lower/transform/widen.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdio>
#include <deque>
#include <iterator>
#include <stdexcept>

namespace gliftc::lower {

using namespace ir;

namespace {

/// The least number of kernels for a thread: with fewer, starting the thread and making its overlay of the program
/// (overlay.h) costs more time than it saves.
constexpr std::size_t kernels_of_a_thread = 8;

/// The slot of the parameter that the expression is, or no_parameter.
std::uint32_t parameter_of(const Context& cx, ExprId id) {
    const Expr& node = cx.p.exprs[id];
    return node.op == Op::parameter ? node.slot : no_parameter;
}

/// A statement that holds a uniform value until the pass move_uniforms makes it a parameter.
StmtId holder(Context& cx, ExprId value) {
    Stmt stmt = statement(StmtOp::evaluate, cx.kernel.span);
    stmt.value = value;
    return cx.add(std::move(stmt));
}

void finish_images(const Program& program, Pass& pass) {
    for (PassBinding& binding : pass.bindings)
        binding.sampled = binding.shape != MemoryShape::buffer && binding.access == Access::read &&
                          !loads_after_store(program, pass, binding.one_place);
}

/// In the general form: adds parameters for the addresses of the buffers.
void reach_by_address(Context& cx) {
    for (std::uint32_t i = 0; i < cx.pass.bindings.size(); ++i) {
        PassBinding& binding = cx.pass.bindings[i];
        if (binding.shape != MemoryShape::buffer) continue;
        binding.address_parameter =
            cx.parameter(ParameterSource::address, binding.name + "_address", cx.p.types.uint64, i);
    }
}

/// In kernels over blocks: adds the host device's variant for blocks all of whose elements are visited.
void add_whole_block(Context& cx, const Expander& checked, const std::vector<ExprId>& facts) {
    if (!cx.kernel.space || cx.is_direct()) return;
    Expander expander(cx, Guards::block);
    if (checked.near_offsets) expander.halos = halos_of(cx, *checked.near_offsets);
    const bool has_halos = !expander.halos.empty();
    std::vector<StmtId> body = expander.kernel_body();
    cx.traits.clear();
    Variant made{Part::whole, Devices::host, cx.pass.plain().assumes, {}};
    if (has_halos) made.assumes.row = expander.halos[0].block[0];
    made.body = simplified(cx, "whole block", std::move(body), facts);
    made.block.emplace();
    cx.pass.variants.push_back(std::move(made));
}

/// Adds the host device's variant for elements whose neighbours are all in the domain, if neighbour reads have guards,
/// all of one domain; not in kernels over blocks. Keeps the expression of the domain in `holders` until move_uniforms
/// has made a parameter of it.
void add_interior(Context& cx, Expander& checked, const std::vector<ExprId>& facts, std::vector<StmtId>& holders) {
    if (cx.is_direct() || cx.kernel.space || !checked.has_near_guards || !checked.near_domains_agree) return;
    Expander expander(cx, Guards::interior);
    std::vector<StmtId> body = expander.kernel_body();
    cx.traits.clear();
    holders.push_back(holder(cx, checked.near_domain));
    Interior interior;
    for (const KernelParam& param : cx.kernel.params)
        if (param.pattern == Pattern::near) interior.radius = std::max(interior.radius, param.radius.largest());
    body = simplified(cx, "interior", std::move(body), facts);
    cx.pass.variants.push_back(
        {Part::whole, Devices::host, {cx.pass.plain().assumes.elements, interior}, std::move(body)});
}

/// Fills in the parameters that hold the domain and origin of the interior variant, or drops the variant if the domain
/// is no parameter.
void fill_interior(Context& cx, const Expander& checked, const std::vector<StmtId>& holders) {
    if (holders.empty()) return;
    Interior& interior = *cx.pass.variants.back().assumes.interior;
    interior.domain = parameter_of(cx, cx.p.stmts[holders[0]].value);
    if (interior.domain == no_parameter) return cx.pass.variants.pop_back();
    interior.origin = cx.parameter(ParameterSource::origin, {}, cx.kernel.domain_type, *checked.near_root);
}

/// Runs the passes for the host device over a variant. Returns the variants that they make of it; none, if it is for
/// whole blocks and split_blocks is not able to split it.
std::vector<Variant> for_host(Context& cx, const Variant& variant) {
    Variant made{variant.part, Devices::host, variant.assumes, variant.body, variant.block};
    cx.part = variant.part;
    for (const BodyPass& pass : host_passes()) {
        if (cx.is_stopped || (pass.applies && !pass.applies(cx))) continue;
        made.body = pass.run(cx, made.body, {});
        finished(cx, pass.name, std::vector{made}, {}, "host");
    }
    const bool is_in_rows = !cx.kernel.grouped() && !cx.kernel.raster && cx.pass.items == 1;
    if (cx.is_stopped || !is_in_rows || cx.kernel.has_messages) return {std::move(made)};
    if (made.block) {
        std::optional<Variant> split = split_blocks(cx, made);
        if (!split) return {};
        made = std::move(*split);
        finished(cx, "split_blocks", std::vector{made}, {}, "whole block");
        made.block = copy_rows(cx, *made.block);
        finished(cx, "copy_rows", std::vector{made}, {}, "whole block");
    }
    if (std::optional<std::vector<StmtId>> body = made.block ? std::nullopt : in_lockstep(cx, made.body)) {
        made.body = std::move(*body);
        finished(cx, "lockstep", std::vector{made}, {}, "host");
    }
    std::vector<Variant> found = find_rows(cx, made);
    if (!cx.pass.sum_orders().empty()) found.resize(1);  // the elements of a row are added together
    finished(cx, "find_rows", found, {}, "host");
    for (Variant& one : found) find_row_updates(cx, one);
    finished(cx, "find_row_updates", found, {}, "host");
    return found;
}

/// Whether the pass has a variant of its own for the host device that may run at every address (SeveralElements).
bool has_host_body(const Pass& pass) {
    return std::ranges::any_of(pass.variants, [](const Variant& variant) {
        return variant.devices == Devices::host && !variant.assumes.interior && !variant.block;
    });
}

/// Runs the host device's passes. What they make of a variant for the host device replaces it; what they make of a
/// variant for any device is added, as a variant for the host device.
void add_host_variants(Context& cx) {
    std::vector<Variant> others, made;
    const bool is_replaced = has_host_body(cx.pass);
    for (Variant& variant : cx.pass.variants) {
        if (variant.assumes.interior && !cx.pass.sum_orders().empty()) continue;
        const bool is_for_shaders = is_replaced && variant.devices == Devices::any;
        if (is_for_shaders) variant.devices = Devices::shaders;
        if (variant.devices != Devices::shaders) std::ranges::move(for_host(cx, variant), std::back_inserter(made));
        if (variant.devices != Devices::host) others.push_back(std::move(variant));
    }
    cx.pass.variants = std::move(others);
    std::ranges::move(made, std::back_inserter(cx.pass.variants));
}

/// Runs the body passes over the functions that were made for the pass, and adds their bodies to `bodies`.
void simplify_functions(Context& cx, std::vector<std::vector<StmtId>*>& bodies) {
    for (auto& [key, function] : cx.instances) {
        auto& body = cx.p.functions[function].body;
        cx.params = cx.p.functions[function].params;
        body = simplified(cx, (*cx.p.names)[cx.p.functions[function].name], std::move(body));
        bodies.push_back(&body);
    }
}

void check_whole([[maybe_unused]] const Context& cx) {
#ifndef NDEBUG
    for (const std::string& problem : validate(cx.p, cx.pass)) {
        std::fprintf(stderr, "gliftc: lowering %s: %s\n", (*cx.p.names)[cx.kernel.name].c_str(), problem.c_str());
        assert(false && "a lowered pass is not valid");
    }
#endif
}

/// The last steps, after move_uniforms: variants for the host device, properties of bindings, the summary.
void complete(Context& cx) {
    if (!cx.is_direct()) add_host_variants(cx);
    if (cx.is_stopped) return;
    finish_images(cx.p, cx.pass);
    if (!cx.is_direct()) reach_by_address(cx);
    summarize(cx);
    check_whole(cx);
}

/// Lowers a kernel that draws: a body for each of its parts.
void lower_draw(Context& cx) {
    Pass& pass = cx.pass;
    const auto body = [&](Part part, const std::vector<StmtId>& written, std::string_view what) {
        Expander expander(cx, Guards::checked);
        if (part == Part::vertex && !cx.is_direct())
            cx.size = expander.iteration_size();  // parameters for the number of vertices and instances
        std::vector<StmtId> made = expander.draw_part(part, written);
        finished(cx, "expand", made, {}, what);
        cx.traits.clear();
        return simplified(cx, what, std::move(made));
    };
    pass.plain().part = Part::vertex;
    pass.plain().body = body(Part::vertex, cx.kernel.body, "vertex");
    if (cx.kernel.raster->has_fragment)
        pass.variants.push_back(
            {Part::fragment, Devices::any, {}, body(Part::fragment, cx.kernel.raster->fragment, "fragment")});
    std::vector<std::vector<StmtId>*> bodies = bodies_of(pass);
    simplify_functions(cx, bodies);
    if (cx.is_stopped) return;
    move_uniforms(cx, bodies);
    for (const Variant& variant : pass.variants) finished(cx, "move_uniforms", {variant}, {}, "part");
    if (!cx.is_stopped) complete(cx);
    pass.address = {};
    pass.in_range = {};
}

void lower_computation(Context& cx, Elements elements) {
    Pass& pass = cx.pass;
    Expander expander(cx, Guards::checked);
    cx.size = expander.iteration_size();
    // In a kernel without a group, invocations beyond the range have returned.
    std::vector<ExprId> facts;
    if (!cx.kernel.grouped()) facts.push_back(in_range_condition(cx));
    std::vector<StmtId> body = expander.kernel_body();
    finished(cx, "expand", body, facts, "body");
    cx.traits.clear();
    const std::vector<StmtId> expanded = body;
    pass.plain().body = simplified(cx, "body", std::move(body), facts);
    std::vector<StmtId> holders;
    // Variants for several elements execute statements for elements that are not visited, or twice.
    if (!cx.kernel.has_messages) {
        add_several(cx, expanded, expander, elements, facts);
        add_interior(cx, expander, facts, holders);
        add_whole_block(cx, expander, facts);
    }
    pass.prologue = std::move(expander.size_statements);
    for (StmtId id : dispatch_prologue(cx)) pass.prologue.push_back(id);

    std::vector<std::vector<StmtId>*> bodies = bodies_of(pass);
    simplify_functions(cx, bodies);
    if (cx.is_stopped) return;
    bodies.push_back(&holders);
    move_uniforms(cx, bodies);
    fill_interior(cx, expander, holders);
    finished(cx, "move_uniforms", pass.variants, {}, "body");
    if (!cx.is_stopped) complete(cx);
}

/// Lowers a kernel to one of its forms, beginning with the given bindings.
Pass lowered(Program& program, Diagnostics& diagnostics, KernelId kernel, Form form, Settings settings,
             Elements elements, const std::vector<PassBinding>& bindings) {
    Pass pass;
    pass.kernel = kernel;
    pass.form = form;
    pass.is_wide = form == Form::general && settings.address_bits == AddressBits::b64;
    Context cx(program, program.kernels[kernel], pass, diagnostics, settings);
    choose_dispatch(cx);
    add_bindings(cx, bindings);
    if (cx.kernel.raster) lower_draw(cx);
    else lower_computation(cx, elements);
    return pass;
}

Lowered::Forms all_forms(Program& program, Diagnostics& diagnostics, KernelId kernel, Settings settings) {
    Lowered::Forms forms;
    const Mark before(program);
    std::vector<PassBinding> bindings;
    const auto lower = [&](Form form, Elements elements) {
        return lowered(program, diagnostics, kernel, form, settings, elements, bindings);
    };
    forms.direct = lower(Form::direct, Elements::many_where_it_helps);
    forms.general = lower(Form::general, Elements::many_where_it_helps);
    const std::array all = forms.all();
    if (!have_common_bindings(all)) {
        bindings = union_of_bindings(all);
        for (Pass* pass : all) *pass = lower(pass->form, Elements::many_where_it_helps);
    }
    // A workgroup must cover the same elements in all forms, since they share one description of the kernel
    // (glift::Kernel::items, sums), and the host device visits them in the same order.
    const auto agrees = [&](const Pass* pass) {
        const auto elements = [](const Pass& of) { return variant_for(of, Devices::shaders).assumes.elements; };
        return elements(*pass) == elements(forms.direct) && pass->group == forms.direct.group &&
               pass->tiles == forms.direct.tiles && pass->sum_orders() == forms.direct.sum_orders();
    };
    if (!std::ranges::all_of(all, agrees))
        for (Pass* pass : all) *pass = lower(pass->form, Elements::two_where_it_helps);
    if (is_coarsened(forms.direct) && !is_coarsened(forms.general) && has_one_place(forms.general))
        forms.general = lower(Form::general, Elements::two_in_turn);
    if (!std::ranges::all_of(all, agrees))
        for (Pass* pass : all)
            if (is_coarsened(*pass)) *pass = lower(pass->form, Elements::one);
    if (settings.trace != nullptr && !settings.trace->stop_after.empty()) return forms;
    if (!have_common_bindings(all)) throw std::logic_error("lower: the forms of a kernel have different bindings");
    agree(program, all);
    compact(program, before, all);
    return forms;
}

Lowered::Forms lowered_forms(Program& program, Diagnostics& diagnostics, KernelId kernel, Settings settings) {
    try {
        return all_forms(program, diagnostics, kernel, settings);
    } catch (const KernelTooLarge& at) {
        const Kernel& large = program.kernels[kernel];
        Diagnostic& report =
            diagnostics.report(Diag::kernel_too_large, large.span, {large.display, std::to_string(most_nodes)});
        report.notes.push_back(
            {at.span, "it had become so large here: loops over windows and over arrays of the invocation's own are "
                      "unrolled, and "
                      "short functions inlined; make the window or the number of rounds smaller, or split the kernel"});
        return {};
    } catch (const TooManyNearReads& at) {
        const Kernel& large = program.kernels[kernel];
        const std::string& read = (*program.names)[large.params[at.param].name];
        Diagnostic& report = diagnostics.report(Diag::too_many_near_reads, at.span,
                                                {large.display, read, std::to_string(most_near_reads)});
        report.notes.push_back({large.span,
                                "each round of a loop over offsets counts: use a smaller window, one kernel "
                                "for each axis, or take the structure as any<…>"});
        return {};
    }
}

/// The result of lowering one kernel in an overlay.
struct LoweredInOverlay {
    std::optional<Growth> growth;
    Diagnostics diagnostics;
};

using FormsTable = Table<Lowered::Forms, Kernel>;

FormsTable lowered_in_order(Program& program, Diagnostics& diagnostics, Settings settings) {
    FormsTable passes;
    for (KernelId i : program.kernels.ids()) passes.push_back(lowered_forms(program, diagnostics, i, settings));
    return passes;
}

FormsTable lowered_on_threads(Program& program, Diagnostics& diagnostics, Settings settings) {
    const std::size_t count = program.kernels.size(), threads = threads_for(count, kernels_of_a_thread);
    prepare_for_overlays(program);
    FormsTable passes(count);
    Table<LoweredInOverlay, Kernel> results(count, {std::nullopt, diagnostics.emptied()});
    std::deque<Overlay> overlays;
    for (std::size_t i = 0; i < threads; ++i) overlays.emplace_back(program);
    Tickets kernels(count), unused(threads);
    on_threads(threads, [&] {
        Overlay& overlay = overlays[*unused.take()];
        while (auto kernel = kernels.take()) {
            const KernelId id{static_cast<std::uint32_t>(*kernel)};
            LoweredInOverlay& result = results[id];
            result.growth = record_growth(
                overlay, [&] { passes[id] = lowered_forms(overlay.program, result.diagnostics, id, settings); });
        }
    });
    for (LoweredInOverlay& one : results) {
        merge(program, *one.growth);
        diagnostics.append(std::move(one.diagnostics));
    }
    for_each_parallel(count, kernels_of_a_thread, [&](std::size_t i) {
        const KernelId id{static_cast<std::uint32_t>(i)};
        renumber(program, *results[id].growth, passes[id]);
    });
    return passes;
}

}  // namespace

Pass lower_function(Program& program, Diagnostics& diagnostics, const Kernel& kernel, std::vector<LocalId> params) {
    Pass pass;
    pass.params = std::move(params);
    Context cx(program, kernel, pass, diagnostics, {});
    cx.params = pass.params;
    choose_dispatch(cx);
    Expander expander(cx, Guards::checked);
    std::vector<StmtId> body = expander.kernel_body();
    cx.traits.clear();
    pass.plain().body = simplified(cx, "body", std::move(body));
    std::vector<std::vector<StmtId>*> bodies{&pass.plain().body};
    simplify_functions(cx, bodies);
    name_state(cx, bodies);
    summarize(cx);
    check_whole(cx);
    return pass;
}

Lowered lower(Program& program, Diagnostics& diagnostics, Settings settings) {
    const std::vector<FunctionId> folded = fold_constants(program);
    if (settings.trace != nullptr) {
        settings.trace->note("fold_constants", program, folded);
        if (settings.trace->stop_after == "fold_constants") return {};
    }
    const std::vector<FunctionId> shortened = drop_dead(program);
    if (settings.trace != nullptr) settings.trace->note("drop_dead", program, shortened);
    const std::vector<FunctionId> split = split_chains(program);
    if (settings.trace != nullptr) settings.trace->note("split_chains", program, split);
    mark_affine(program);
    mark_contained(program);
    widen_extents(program);  // after mark_contained, which needs extents as they are written
    if (settings.address_bits == AddressBits::b64) widen_translators(program);
    // This choice does not depend on the number of processors, so that all machines run the same code. A trace must be
    // in the order of the kernels.
    const bool are_few = program.kernels.size() < 2 * kernels_of_a_thread || settings.trace != nullptr;
    Lowered result{(are_few ? lowered_in_order : lowered_on_threads)(program, diagnostics, settings), {}};
    release_temporaries(program);
    return result;
}

}  // namespace gliftc::lower
