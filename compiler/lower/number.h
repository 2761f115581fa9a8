// Value numbers: two expressions with one number have one value where both stand.
#pragma once

#include "lower/context.h"

#include <vector>

namespace gliftc::lower {

using ValueNumber = std::uint32_t;

/// Numbers expressions while the statements are walked in order; assignments and writes start new versions.
class Numbers {
public:
    explicit Numbers(Context& context) : cx(context) {}

    ValueNumber of(ExprId id);

    /// The let's local has this number from here on.
    void define(LocalId local, ValueNumber number) {
        locals_[local] = number;
        ++time_;
    }
    /// To walk the same statements again: numbers stay.
    void restart() {
        versions_.clear();
        bindings_.clear();
        ++time_;
    }
    ValueNumber count() const { return next_ + 1; }
    /// The local, or the memory behind a binding, may have changed.
    void change(LocalId local) {
        ++versions_[local];
        ++time_;
    }
    void change_binding(std::uint32_t binding) {
        ++bindings_[binding];
        ++time_;
    }
    /// Everything that the statements may change.
    void change_all(const std::vector<StmtId>& body);
    void change_all(const ir::Stmt& stmt);

    /// Whether equal numbers mean equal values: false for what has an effect or differs at each evaluation.
    bool is_pure(ExprId id);
    bool has_load(ExprId id);
    /// Whether the value cannot change within the pass: no mutable local, no load from memory that is written.
    bool is_fixed(ExprId id);

private:
    void change_by(const ir::Stmt& stmt);
    std::uint8_t traits_of(ExprId id);
    Context& cx;
    /// The shape of a node, hashed to 128 bits: two shapes with one hash do not happen.
    struct Key {
        std::uint64_t high = 0, low = 0;
        bool operator==(const Key&) const = default;
        void mix(std::uint64_t word);
    };
    std::uint32_t version_of(LocalId local) const {
        const std::uint32_t* found = versions_.find(local);
        return found == nullptr ? 0 : *found;
    }
    std::uint32_t version_of(std::uint32_t binding) const {
        const std::uint32_t* found = bindings_.find(binding);
        return found == nullptr ? 0 : *found;
    }
    Key shape_of(const ir::Expr& node);

    /// The numbers of shapes: open addressing, never more than half full. Number 0 is an empty place.
    struct Slot {
        Key key;
        ValueNumber number = 0;
    };
    ValueNumber& number_at(const Key& key);

    /// The number of a node, valid at one time, or always where its value is fixed.
    struct Known {
        ValueNumber number = 0;
        std::uint32_t time = 0;
    };
    static constexpr std::uint32_t always = 0xffffffffu;

    std::vector<Slot> table_;
    std::size_t shapes_ = 0;
    NodeMap<ExprId, Known> known_{cx.first_expr};
    std::uint32_t time_ = 0;  ///< counts what may give nodes other numbers
    NodeMap<LocalId, ValueNumber> locals_{cx.first_local};
    NodeMap<LocalId, std::uint32_t> versions_{cx.first_local};
    FlatMap<std::uint32_t, std::uint32_t> bindings_;
    ValueNumber next_ = 0;
};

}  // namespace gliftc::lower
