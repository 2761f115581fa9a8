#include "driver/explain_kernels.h"

#include "ir/derivatives.h"
#include "ir/effects.h"
#include "ir/evaluate.h"
#include "ir/spelling.h"

namespace gliftc {

namespace {

std::string words(std::string_view spelling) {
    std::string text(spelling);
    for (char& c : text)
        if (c == '_') c = ' ';
    return text;
}

std::string place_of(const Compilation& c, const ir::Kernel& kernel) {
    return c.sources[kernel.span.file].path + ":" + std::to_string(c.sources.position(kernel.span).line);
}

class Draw {
public:
    Draw(const Compilation& c, ir::KernelId index)
        : c_(c), kernel_(c.program.kernels[index]), raster_(*kernel_.raster), pass_(c.lowered.passes[index].general) {}

    ExplainedKernel explained() const {
        ExplainedKernel shown;
        shown.name = kernel_.display;
        shown.place = place_of(c_, kernel_);
        shown.facts.emplace_back("draws", primitives());
        for (const ir::Varying& varying : raster_.varyings)
            shown.facts.emplace_back("hands on", c_.names[varying.name] + ": " + to_text(c_.program, varying.type) +
                                                     ", " + std::string(spelling(varying.interpolation)));
        for (const ir::ColourTarget& target : raster_.colours)
            shown.facts.emplace_back("colour", target_of(target.param) + ", " +
                                                   (target.blend == ir::Blend::replace
                                                        ? std::string("replaced")
                                                        : "blended: " + std::string(spelling(target.blend))));
        if (raster_.depth) shown.facts.emplace_back("depth", depth());
        if (raster_.colours.empty() && !raster_.depth) shown.facts.emplace_back("targets", "none");
        if (ir::derives_loads(c_.program, pass_))
            shown.facts.emplace_back(
                "derives", "what it loads from buffers: not on devices without helpers_load, such as lavapipe");
        for (const ir::PassBinding& binding : pass_.bindings)
            if (binding.access != ir::Access::read) shown.facts.emplace_back("writes", binding.name);
        return shown;
    }

private:
    std::string names_of(ir::Pattern pattern) const {
        std::string text;
        for (const ir::KernelParam& param : kernel_.params)
            if (param.pattern == pattern) text += (text.empty() ? "" : ", ") + c_.names[param.name];
        return text;
    }

    std::string primitives() const {
        std::string text = std::string(spelling(raster_.topology)) + " of " + names_of(ir::Pattern::each);
        if (const std::string instances = names_of(ir::Pattern::instance); !instances.empty())
            text += ", for each of " + instances;
        if (raster_.cull != ir::Cull::none) text += ", but " + std::string(spelling(raster_.cull)) + " faces";
        if (!raster_.clip_distances.empty())
            text += ", clip distances: " + std::to_string(raster_.clip_distances.size());
        return text;
    }

    std::string target_of(std::uint32_t param) const {
        const ir::Structure& structure = c_.program.structures[kernel_.params[param].structure];
        return c_.names[kernel_.params[param].name] + ": " +
               std::string(spelling(structure.memories[structure.via_memory].format));
    }

    std::string depth() const {
        const ir::DepthTarget& depth = *raster_.depth;
        const bool always = depth.test == ir::DepthTest::always;
        std::string text =
            target_of(depth.param) + (always ? ", always passes" : ", passes if " + words(spelling(depth.test)));
        text += depth.is_written ? ", written" : ", not written";
        if (depth.is_set) return text + " as the fragment part says, tested after it";
        return text + (depth_order(c_.program, pass_) == ir::DepthOrder::after ? ", tested after the fragment part"
                                                                               : ", tested before the fragment part");
    }

    const Compilation& c_;
    const ir::Kernel& kernel_;
    const ir::Raster& raster_;
    const ir::Pass& pass_;
};

/// How many elements are added in one order, and what it depends on.
std::string order_text(const ir::PassUpdate& update) {
    const ir::SumOrder& order = *update.order;
    std::string axes;
    for (std::uint32_t axis = 0; axis < 3; ++axis)
        if ((order.axes >> axis & 1) != 0) axes += (axes.empty() ? "" : ", ") + std::string(1, "xyz"[axis]);
    return "; floats are added in one order on every device, in parts of " + std::to_string(order.part) + " along " +
           axes + (update.is_exact ? "" : " (if the addresses of different sums differ)");
}

std::string text_of(const ir::PassUpdate& update, const ir::Pass& pass) {
    if (update.order) {
        ir::PassUpdate in_any_order = update;
        in_any_order.order.reset();
        return text_of(in_any_order, pass) + order_text(update);
    }
    const std::string axis = pass.of_blocks ? "the numbers of blocks" : std::string(1, "xyz"[update.axis]);
    const auto counted = [](std::uint32_t n) { return std::to_string(n) + (n == 1 ? " element" : " elements"); };
    const std::uint32_t invocations = pass.group[0] * pass.group[1] * pass.group[2];
    switch (update.way) {
    case ir::UpdateWay::tree:
        return "combined along " + axis + ": " + counted(update.elements) + " by an invocation, " +
               std::to_string(invocations * update.elements) + " by a workgroup, which updates memory once";
    case ir::UpdateWay::column:
        return "combined along " + axis + ": " + counted(update.elements) +
               " by an invocation, which updates memory once";
    case ir::UpdateWay::run:
        return "combined where neighbours along x have one address: of " + counted(update.elements) +
               " by an invocation, which updates memory once for each address";
    case ir::UpdateWay::copies:
        return "in copies in workgroup memory if at most " + std::to_string(update.copied - 1) +
               " elements can be written (by the extent, or by a remainder or mask in the address), else one by one";
    case ir::UpdateWay::plain: return "one by one";
    }
    return "";
}

std::string text_of(const ir::PassTile& tile) {
    return std::string("through a tile of 32 x 32 elements in workgroup memory: its address exchanges x and ") +
           "xyz"[tile.axis];
}

std::string text_of(const ir::PassStaged& staged) {
    return "staged in workgroup memory: " + std::to_string(staged.entries) + " elements for " +
           std::to_string(staged.rounds) + " rounds of the loop, each loaded once by a workgroup";
}

}  // namespace

std::vector<ExplainedKernel> explained_tiles(const Compilation& c) {
    std::vector<ExplainedKernel> shown;
    for (ir::KernelId i : c.program.kernels.ids()) {
        const ir::Kernel& kernel = c.program.kernels[i];
        const ir::Pass& pass = c.lowered.passes[i].direct;
        if ((pass.tiles.empty() && pass.staged.empty()) || !c.program.modules[kernel.module].is_root) continue;
        ExplainedKernel& one = shown.emplace_back(ExplainedKernel{kernel.display, place_of(c, kernel), {}});
        for (const ir::PassTile& tile : pass.tiles) {
            const std::string what = tile.is_store ? "stores to " : "loads from ";
            one.facts.emplace_back(what + pass.bindings[tile.binding].name, text_of(tile));
        }
        for (const ir::PassStaged& staged : pass.staged)
            one.facts.emplace_back("loads from " + pass.bindings[staged.binding].name, text_of(staged));
    }
    return shown;
}

std::vector<ExplainedKernel> explained_updates(const Compilation& c) {
    std::vector<ExplainedKernel> shown;
    for (ir::KernelId i : c.program.kernels.ids()) {
        const ir::Kernel& kernel = c.program.kernels[i];
        const ir::Pass& pass = c.lowered.passes[i].direct;
        if (pass.updates.empty() || !c.program.modules[kernel.module].is_root) continue;
        ExplainedKernel& one = shown.emplace_back(ExplainedKernel{kernel.display, place_of(c, kernel), {}});
        for (const ir::PassUpdate& update : pass.updates)
            one.facts.emplace_back("updates " + pass.bindings[update.binding].name, text_of(update, pass));
    }
    return shown;
}

std::vector<ExplainedKernel> explained_arithmetic(const Compilation& c) {
    std::vector<ExplainedKernel> shown;
    for (const ir::Kernel& kernel : c.program.kernels) {
        if (!kernel.fast_math || !c.program.modules[kernel.module].is_root) continue;
        shown.push_back(
            {kernel.display,
             place_of(c, kernel),
             {{"arithmetic", "the device's own in shaders: quotients and roots of floats are up to 2.5 units "
                             "in the last place off, products and sums may be fused; gliftc test compares "
                             "what it affects within 1e-3 of the larger of 1 and the value"}}});
    }
    return shown;
}

std::vector<ExplainedKernel> explained_draws(const Compilation& c) {
    std::vector<ExplainedKernel> draws;
    for (ir::KernelId i : c.program.kernels.ids()) {
        const ir::Kernel& kernel = c.program.kernels[i];
        if (kernel.raster && c.program.modules[kernel.module].is_root) draws.push_back(Draw(c, i).explained());
    }
    return draws;
}

}  // namespace gliftc
