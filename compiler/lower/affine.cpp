#include "lower/affine.h"

namespace gliftc::lower {

using namespace ir;

bool is_affine(const Program&, const Translator&) { return false; }

void mark_affine(Program& program) {
    for (Translator& translator : program.translators) translator.properties.affine = is_affine(program, translator);
}

}  // namespace gliftc::lower
