// The range that an `at` parameter takes if its argument is left out of a call.
#include "ir/ir.h"

namespace gliftc::ir {

std::optional<std::size_t> range_giver(const std::vector<KernelParam>& params, std::size_t at) {
    for (Pattern pattern : {Pattern::each, Pattern::near, Pattern::any, Pattern::scatter}) {
        for (std::size_t i = 0; i < params.size(); ++i) {
            if (params[i].pattern == pattern && params[i].structure == params[at].structure) return i;
        }
    }
    return std::nullopt;
}

}  // namespace gliftc::ir
