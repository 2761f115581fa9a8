// The variant of a kernel in which an invocation of a shader takes several elements.
#pragma once

#include "lower/expand/expand.h"

#include <vector>

namespace gliftc::lower {

/// How many elements an invocation of a shader takes. many_where_it_helps: those of a tile or of staged loads (tile.h,
/// stage.h), or up to four as coarsened() of coarsen.h chooses. two_where_it_helps: at most two, as it chooses.
/// two_in_turn: two, the second computed after the first has been stored. In kernels over blocks all three mean up to
/// eight, as coarsened_in_block() chooses. All but `one` allow many elements, if privatised() of privatise.h finds a
/// gain.
enum class Elements { one, two_in_turn, two_where_it_helps, many_where_it_helps };

/// Adds the variant, if there is a gain. `expanded` is the body after "expand", `expander` what made it; `facts` are
/// conditions that hold for invocations in the range.
void add_several(Context& cx, const std::vector<StmtId>& expanded, const Expander& expander, Elements elements,
                 const std::vector<ExprId>& facts);

}  // namespace gliftc::lower
