// The bodies of a lowered kernel: each says what it assumes and on which devices it runs. Printers take those that
// their device may run.
#pragma once

#include "ir/ir.h"

#include <array>
#include <optional>
#include <vector>

namespace gliftc::ir {

struct Pass;

inline constexpr std::uint32_t no_parameter = 0xffffffffu;

enum class Devices : std::uint8_t { any, shaders, host };

/// The invocation's virtual address lies at least `radius` elements from each side of a domain.
struct Interior {
    std::uint32_t radius = 0;
    std::uint32_t domain = no_parameter;  ///< parameter that holds the domain's extent
    std::uint32_t origin = no_parameter;  ///< parameter that holds the origin of the address' range; none: zero
};

/// low <= value <= high, each an int; an absent one is no limit.
struct Bounds {
    ExprId value, low, high;
};

struct Assumptions {
    std::array<std::uint32_t, 3> elements = {1, 1, 1};  ///< that an invocation takes along each axis
    std::optional<Interior> interior;                   ///< none: true of every address
    /// Of values that advance by one from each element of a row to the next, while their limits stay the same. They
    /// name locals of the variant that assumes the same but for them.
    std::vector<Bounds> bounds;
    /// Of blocks: elements are done in rows of so many, which begin at positions that are multiples of it; 0: the
    /// block is one row.
    std::uint32_t row = 0;
};

/// How the elements of a row may be done.
enum class RowOrder : std::uint8_t {
    ascending,
    any,        ///< no element depends on what another one does
    in_blocks,  ///< and some may be done twice, so that blocks of them may overlap
};

struct Variant {
    Part part = Part::whole;
    Devices devices = Devices::any;
    Assumptions assumes;
    std::vector<StmtId> body;
    /// Of blocks all of whose elements are visited: what is done once a block, before the body. A statement evaluates
    /// whether the block is such a one; what follows it is done where it is. Absent: of any element.
    std::optional<std::vector<StmtId>> block;
    RowOrder order = RowOrder::ascending;  ///< the host device's, of kernels without a group
};

/// What a device runs at any address: the last of its variants that assumes nothing about addresses. Of draws the
/// vertex part.
const Variant& variant_for(const Pass& pass, Devices devices);

/// The fragment part of a draw, if it has one.
const Variant* fragment_for(const Pass& pass, Devices devices);

/// What it may run for whole blocks instead, if there is such a variant.
const Variant* block_variant_for(const Pass& pass, Devices devices);

/// What it may run in the interior instead, if there is such a variant.
const Variant* interior_variant_for(const Pass& pass, Devices devices);

/// What it may run instead of a variant where bounds hold, if there is such a variant.
const Variant* bounded_variant_of(const Pass& pass, const Variant& variant);

/// What the variant does for an element, what it does once a block included.
std::vector<StmtId> statements_of(const Variant& variant);

/// The prologue, then the body of each variant.
std::vector<std::vector<StmtId>*> bodies_of(Pass& pass);
std::vector<const std::vector<StmtId>*> bodies_of(const Pass& pass);

}  // namespace gliftc::ir
