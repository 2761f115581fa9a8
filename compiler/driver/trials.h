// Translators tried by the compiler's interpreter, over all addresses of domains of a few thousand.
#pragma once

#include "ir/ir.h"

#include <string>

namespace gliftc {

/// What came out for one translator of a structure.
struct Trial {
    std::size_t addresses = 0;  ///< of the largest domain that was tried as a whole; 0: none could be
    std::string meeting;        ///< "{0} and {1} both map to {0}"; empty: no two did
    std::string wrong_inverse;  ///< "invert(translate({1, 0})) is {0, 1}"; empty: all came back
};

/// Tries a stage of a structure's `via` where the structure is made of extents alone and reads no table.
Trial try_translator(const ir::Program& program, const ir::Structure& structure, const ir::Stage& stage);

}  // namespace gliftc
