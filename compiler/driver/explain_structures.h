// What is known of structures and translators, as text: the properties that sema infers or that tests find (trials.h).
// `gliftc explain` prints them; the language server shows them.
#pragma once

#include "driver/compile.h"

#include <string>
#include <utility>
#include <vector>

namespace gliftc {

/// The properties of a translator (ir::Properties) as text. `is_affine` is known only after lowering.
struct ExplainedTranslator {
    std::string name, from, to, place;
    std::string memory, access, consistency, location, totality, outside, mapping, invertible;
    bool is_affine = false;
};

struct ExplainedStructure {
    std::string kind;  ///< structure, view (it computes its elements), container (it has none)
    std::string name, type, place, addresses, elements;
    std::vector<std::pair<std::string, std::string>> parts;  ///< of containers: members and functions
    std::vector<std::pair<std::string, std::string>> memories;
    std::vector<ExplainedTranslator> via;
    std::string blocks;  ///< text about its blocks (ir::blocks_of); empty: the whole domain is one block
};

/// Of an instance of a structure, under the first name that a module gives it. Tests its translators on all addresses
/// of small domains.
ExplainedStructure explained(const Compilation& compilation, const ir::Structure& structure);
/// Of a translator that no structure is known to use.
ExplainedTranslator explained(const Compilation& compilation, const ir::Translator& translator);

}  // namespace gliftc
