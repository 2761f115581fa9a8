// Variants: the bodies of a lowered kernel. Each says what it assumes and on which devices it runs; printers of a
// device take those that it may run.
#pragma once

#include "ir/ir.h"

#include <array>
#include <optional>
#include <vector>

namespace gliftc::ir {

struct Pass;

inline constexpr std::uint32_t no_parameter = 0xffffffffu;

enum class Devices : std::uint8_t { any, shaders, host };

/// The assumption that the invocation's virtual address lies at least `radius` elements from each side of a domain, so
/// that all neighbours within the radius are inside the domain.
struct Interior {
    std::uint32_t radius = 0;
    std::uint32_t domain = no_parameter;  ///< pass parameter that holds the domain's extent
    std::uint32_t origin = no_parameter;  ///< pass parameter that holds the range's origin; no_parameter: zero
};

/// The assumption low <= value <= high, of type int; if `low` or `high` is absent, that side is not limited.
struct Bounds {
    ExprId value, low, high;
};

struct Assumptions {
    std::array<std::uint32_t, 3> elements = {1, 1, 1};  ///< number of elements that an invocation takes along each axis
    std::optional<Interior> interior;                   ///< none: neighbours may be outside the domain
    /// The values advance by one from each element of a row to the next, and their limits are the same for the whole
    /// row, so that a printer can compute the part of the row where all bounds hold. The expressions use locals of
    /// the variant with the same assumptions and no bounds.
    std::vector<Bounds> bounds;
    /// In kernels over blocks: the number of elements in a row. Rows begin at positions in the block that are multiples
    /// of it. 0: the block is one row.
    std::uint32_t row = 0;
};

/// The order in which the host device may execute the elements of a row.
enum class RowOrder : std::uint8_t {
    ascending,
    any,        ///< no element depends on what another one does
    in_blocks,  ///< any order, and elements may be executed twice, so that vectors of them may overlap
};

struct Variant {
    Part part = Part::whole;
    Devices devices = Devices::any;
    Assumptions assumes;
    std::vector<StmtId> body;
    /// Present in the variant for blocks all of whose elements are visited: the statements that are executed once per
    /// block, before the body. An `evaluate` statement among them is the condition that all elements of the block are
    /// visited; the statements after it and the body are executed only if it holds.
    std::optional<std::vector<StmtId>> block;
    RowOrder order = RowOrder::ascending;  ///< used on the host device, for kernels without a group
};

/// The variant that a device runs by default: the last one for the device that is valid at every address, so without
/// `interior`, `bounds` or `block`. For a draw the vertex part.
const Variant& variant_for(const Pass& pass, Devices devices);

/// The fragment part of a draw; null: it has none.
const Variant* fragment_for(const Pass& pass, Devices devices);

/// The variant that a device may run instead of variant_for() on blocks all of whose elements are visited; null: none.
const Variant* block_variant_for(const Pass& pass, Devices devices);

/// The variant that a device may run instead of variant_for() where all neighbours are inside the domain (Interior);
/// null: none.
const Variant* interior_variant_for(const Pass& pass, Devices devices);

/// The variant that a device may run instead of `variant` where its Assumptions::bounds hold; null: none.
const Variant* bounded_variant_of(const Pass& pass, const Variant& variant);

/// The statements of `block`, if present, then those of the body.
std::vector<StmtId> statements_of(const Variant& variant);

/// The prologue, then for each variant its `block`, if present, and its body.
std::vector<std::vector<StmtId>*> bodies_of(Pass& pass);
std::vector<const std::vector<StmtId>*> bodies_of(const Pass& pass);

}  // namespace gliftc::ir
