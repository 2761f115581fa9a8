#include "lower/shader_variants.h"

#include "ir/walk.h"
#include "lower/run_passes.h"
#include "lower/transform/coarsen.h"
#include "lower/transform/privatise.h"
#include "lower/transform/stage.h"
#include "lower/transform/tile.h"

#include <optional>
#include <string_view>
#include <utility>

namespace gliftc::lower {

using namespace ir;

namespace {

/// Adds the variant that `pass` has made; false: there is no gain.
bool add(Context& cx, std::string_view pass, std::optional<SeveralElements> made, const std::vector<ExprId>& facts) {
    if (!made) return false;
    finished(cx, pass, made->body, {}, "several elements");
    cx.pass.group = made->group;
    const bool is_in_range = !has_any_barrier(cx.p, made->body);  // else invocations beyond the range run it, too
    made->body = simplified(cx, "several elements", std::move(made->body), is_in_range ? facts : std::vector<ExprId>{});
    cx.pass.variants.push_back({Part::whole, Devices::shaders, {made->elements, std::nullopt}, std::move(made->body)});
    if (cx.is_direct() || made->host_body.empty()) return true;
    made->host_body = simplified(cx, "for the host device", std::move(made->host_body), facts);
    cx.pass.variants.push_back({Part::whole, Devices::host, cx.pass.plain().assumes, std::move(made->host_body)});
    return true;
}

/// Adds the variant for shaders in which invocations take several elements, if there is a gain.
void add_coarsened(Context& cx, const std::vector<StmtId>& expanded, const Expander& expander, Elements elements,
                   const std::vector<ExprId>& facts) {
    Coarsened several;
    if (cx.kernel.space) {
        several = coarsened_in_block(cx, expanded, Expander(cx, Guards::block).kernel_body());
        cx.traits.clear();
    } else if (elements != Elements::two_in_turn) {
        several = coarsened(cx, expanded, expander, elements == Elements::many_where_it_helps ? 4 : 2);
    } else {
        several = coarsened_in_turn(cx, expanded);
    }
    if (several.body.empty()) return;
    finished(cx, "coarsen", several.body, facts, "two elements");
    several.body = simplified(cx, "two elements", std::move(several.body), {facts[0], several.in_range});
    cx.pass.variants.push_back(
        {Part::whole, Devices::shaders, {several.elements, std::nullopt}, std::move(several.body)});
}

}  // namespace

void add_several(Context& cx, const std::vector<StmtId>& expanded, const Expander& expander, Elements elements,
                 const std::vector<ExprId>& facts) {
    if (elements == Elements::one || add(cx, "privatise", privatised(cx, expanded), facts)) return;
    if (elements == Elements::many_where_it_helps &&
        (add(cx, "tile", tiled(cx, expanded), facts) || add(cx, "stage", staged(cx, expanded), facts)))
        return;
    add_coarsened(cx, expanded, expander, elements, facts);
}

}  // namespace gliftc::lower
