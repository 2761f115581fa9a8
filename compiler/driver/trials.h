// Tests translators with the compiler's evaluator, on all addresses of a few domains of at most 2^14 addresses each.
#pragma once

#include "ir/ir.h"

#include <string>

namespace gliftc {

/// The result for one translator of a structure.
struct Trial {
    std::size_t addresses = 0;  ///< number of addresses of the largest domain tried; 0: none could be tried
    std::string collision;      ///< "{0} and {1} both map to {0}"; empty: none
    std::string outside;        ///< "{0} maps to {4}, outside of the memory"; empty: none does
    std::string wrong_inverse;  ///< "invert(translate({1, 0})) is {0, 1}"; empty: none
};

/// Tests one translator of a structure's `via`, if the structure is stored, has constructor arguments, all of the type
/// of its addresses (each is then given the same extent), the translator's domain is declared (by the structure for the
/// first translator, or by the translator itself), and ir::evaluate and ir::call can compute it and the translations,
/// for which the translator must not read elements; else Trial::addresses is 0.
Trial try_translator(const ir::Program& program, const ir::Structure& structure, const ir::Stage& stage);

}  // namespace gliftc
