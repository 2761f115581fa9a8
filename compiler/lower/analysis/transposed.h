// Transposed accesses: elements that are consecutive along y or z access consecutive memory, while those along x are
// far apart, as in `to[a.yx] = x` and `to = x[a.yx]` for arrays whose rows lie along x.
#pragma once

#include "lower/analysis/updates.h"

#include <optional>
#include <vector>

namespace gliftc::lower {

/// A transposed store, or a transposed load. `axis`: 1 or 2, the one along which the accessed memory is consecutive.
struct TransposedAccess {
    std::uint32_t binding = 0;
    std::uint32_t axis = 1;
    std::uint32_t bytes = 0;            ///< of an element, at most 16
    StmtId store;                       ///< absent: a load
    std::vector<Condition> conditions;  ///< of the ifs around the store, the outermost first
    bool is_conditional = false;        ///< some of these ifs are in the source, and are not guards of the address
    std::vector<ExprId> loads;          ///< the nodes that load the element: all of them have the same value

    bool is_store() const { return static_cast<bool>(store); }
};

/// Finds the transposed accesses of an expanded body.
class TransposedAccesses {
public:
    explicit TransposedAccesses(Context& context);

    /// The stores first. All have the same axis, and an address and guards that depend on the element's address alone.
    /// No element depends on the order of the stores, and the pass writes no memory that is loaded. Empty if the body
    /// has a statement that cannot be repeated (Updates::of), an effect besides stores and updates, or too much to do.
    std::vector<TransposedAccess> of(const std::vector<StmtId>& body);

    /// Whether the value is computed of the element's address and of uniform values, without loads.
    bool is_of_address(ExprId value);
    bool is_fixed(ExprId value) { return dependence_.is_fixed(value); }
    bool has_load(ExprId value) { return dependence_.has_load(value); }

private:
    bool may_be_tiled(const std::vector<StmtId>& body);
    void find_stores(const std::vector<StmtId>& body);
    void find_loads(ExprId id);
    void note_store(StmtId id);
    void note_load(ExprId id);
    bool is_only_access(std::uint32_t binding, const std::vector<StmtId>& body) const;
    std::optional<TransposedAccess> transposed(std::uint32_t binding, TypeId type, ExprId address);

    Context& cx;
    Updates dependence_;
    Numbers numbers_;
    std::vector<RowSlopes> slopes_;  ///< one an axis
    IdSet<ir::Expr> seen_;
    std::vector<Condition> conditions_;
    std::vector<Span> spans_;  ///< of the ifs with these conditions
    NodeMap<ExprId, bool> of_address_{cx.first_expr};
    std::vector<TransposedAccess> stores_, loads_;
};

}  // namespace gliftc::lower
