// The stage "lower": turns kernels, whose operations access structures, into passes, whose operations access memory, in
// two forms (ir/pass.h).
#pragma once

#include "diag/diagnostics.h"
#include "ir/pass.h"
#include "lower/trace.h"

namespace gliftc::lower {

/// Which checks at run time are compiled into kernels.
enum class Checks : std::uint8_t {
    none,
    ranges,  ///< report accesses by address outside a structure that does not define what lies outside: check.cpp
};

/// Physical addresses of 32 bits reach 2^32 elements of a memory; those of 64 bits cost registers and time.
enum class AddressBits : std::uint8_t { b32, b64 };

struct Settings {
    Checks checks = Checks::none;
    AddressBits address_bits = AddressBits::b32;
    Trace* trace = nullptr;  ///< null: nothing is traced
};

/// Lowers every kernel. Adds nodes to the program; kernels stay as they were. Also folds constants and drops dead code
/// in functions without structures, makes extents exact (widen.h), adds release statements for pipelines' temporaries,
/// and fills in properties of translators and structures (affine, contained_axes, Stage::wide).
ir::Lowered lower(ir::Program& program, Diagnostics& diagnostics, Settings settings = {});

/// Lowers a kernel as the body of a library function with these parameters. The function has no dispatch and no range,
/// and accesses the structures' state and memory by name.
ir::Pass lower_function(ir::Program& program, Diagnostics& diagnostics, const ir::Kernel& kernel,
                        std::vector<ir::LocalId> params);

}  // namespace gliftc::lower
