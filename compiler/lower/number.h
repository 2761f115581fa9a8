// Value numbers: two expressions with one number have one value where both stand.
#pragma once

#include "lower/context.h"

#include <unordered_map>

namespace gliftc::lower {

using ValueNumber = std::uint32_t;

/// Numbers expressions while the statements are walked in order; assignments and writes start new versions.
class Numbers {
public:
    explicit Numbers(Context& context) : cx(context) {}

    ValueNumber of(ExprId id);

    /// The let's local has this number from here on.
    void define(LocalId local, ValueNumber number) { locals_[local] = number; }
    /// To walk the same statements again: numbers stay.
    void restart() {
        versions_.clear();
        bindings_.clear();
    }
    ValueNumber count() const { return next_ + 1; }
    /// The local, or the memory behind a binding, may have changed.
    void change(LocalId local) { ++versions_[local]; }
    void change_binding(std::uint32_t binding) { ++bindings_[binding]; }
    /// Everything that the statements may change.
    void change_all(const std::vector<StmtId>& body);

    /// Whether equal numbers mean equal values: false for what has an effect or differs at each evaluation.
    bool is_pure(ExprId id);
    bool has_load(ExprId id);
    /// Whether the value cannot change within the pass: no mutable local, no load from memory that is written.
    bool is_fixed(ExprId id);

private:
    std::uint8_t traits_of(ExprId id);
    Context& cx;
    /// The shape of a node, hashed to 128 bits: two shapes with one hash do not happen.
    struct Key {
        std::uint64_t high = 0, low = 0;
        bool operator==(const Key&) const = default;
        void mix(std::uint64_t word);
    };
    struct KeyHash {
        std::size_t operator()(const Key& key) const { return key.low; }
    };
    Key shape_of(const ir::Expr& node);

    std::unordered_map<Key, ValueNumber, KeyHash> table_;
    FlatMap<ExprId, ValueNumber> fixed_;
    FlatMap<LocalId, ValueNumber> locals_;
    FlatMap<LocalId, std::uint32_t> versions_;
    FlatMap<std::uint32_t, std::uint32_t> bindings_;
    ValueNumber next_ = 0;
};

}  // namespace gliftc::lower
