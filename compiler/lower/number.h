// Value numbers: two expressions with one number have one value where both stand.
#pragma once

#include "lower/context.h"

#include <map>
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
    Context& cx;
    std::map<std::vector<std::uint64_t>, ValueNumber> table_;
    std::unordered_map<ExprId, ValueNumber> fixed_;
    std::unordered_map<ExprId, std::uint8_t> traits_;
    std::unordered_map<LocalId, ValueNumber> locals_;
    std::unordered_map<LocalId, std::uint32_t> versions_;
    std::unordered_map<std::uint32_t, std::uint32_t> bindings_;
    ValueNumber next_ = 0;
};

}  // namespace gliftc::lower
