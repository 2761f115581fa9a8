// Tests translators by the compiler's interpreter, exhaustively over domains of a few thousand addresses.
#pragma once

#include "ir/ir.h"

#include <string>

namespace gliftc {

/// The result for one translator of a structure.
struct Trial {
    std::size_t addresses = 0;  ///< of the largest domain that was tried as a whole; 0: none could be
    std::string collision;      ///< "{0} and {1} both map to {0}"; empty: none
    std::string wrong_inverse;  ///< "invert(translate({1, 0})) is {0, 1}"; empty: none
};

/// Tests a stage of a structure's `via`, if the structure's only arguments are extents and the stage reads no table.
Trial try_translator(const ir::Program& program, const ir::Structure& structure, const ir::Stage& stage);

}  // namespace gliftc
