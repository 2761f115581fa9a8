// Value numbering: two expressions with the same number have the same value where they are used.
#pragma once

#include "lower/context.h"

#include <memory>
#include <vector>

namespace gliftc::lower {

using ValueNumber = std::uint32_t;

/// Numbers expressions while the statements are walked in order. Assignments and writes start new versions of locals
/// and memories, so that the same expression gets another number afterwards.
class Numbers {
public:
    explicit Numbers(Context& context) : cx(context), memory_(context.take_number_memory()) {}
    Numbers(const Numbers&) = delete;
    Numbers& operator=(const Numbers&) = delete;
    ~Numbers() { cx.spare_number_memory.push_back(std::move(memory_)); }

    ValueNumber of(ExprId id);

    /// Says that the local of a `let` has this number from here on.
    void define(LocalId local, ValueNumber number) {
        locals_[local] = number;
        memory_->note_change();
    }
    /// change() says that the local may have changed, change_binding() that the memory of the binding, and of all
    /// bindings that may alias it, may have changed.
    void change(LocalId local) {
        ++versions_[local];
        memory_->note_change();
    }
    void change_binding(std::uint32_t binding) {
        ++bindings_[cx.pass.bindings[binding].one_place];
        memory_->note_change();
    }
    /// Says that everything that the statements may change may have changed.
    void change_all(const std::vector<StmtId>& body);
    void change_all(const ir::Stmt& stmt);

    /// Whether equal numbers mean equal values: false for what has an effect or differs at each evaluation.
    bool is_pure(ExprId id) { return !(traits_of(id) & impure); }
    bool has_load(ExprId id) { return traits_of(id) & loads; }
    /// Whether the value cannot change within the pass, except that a variable of a `for` loop, and an immutable local
    /// declared in a loop, have one for each iteration: neither the expression nor a function that it calls is impure
    /// (is_pure) or loads from memory that the pass writes, and the expression uses no mutable local or workgroup
    /// memory.
    bool is_fixed(ExprId id) { return !(traits_of(id) & (changes | impure)); }

private:
    enum Trait : std::uint8_t { known = 1, impure = 2, loads = 4, changes = 8 };

    void change_by(const ir::Stmt& stmt);
    bool is_written(std::uint32_t binding) const;
    std::uint8_t traits_of(ExprId id) {
        const std::uint8_t* found = cx.traits.find(id);
        return found != nullptr ? *found : find_traits(id);
    }
    std::uint8_t find_traits(ExprId id);
    std::uint8_t traits_of_body(ir::FunctionId function, std::unordered_set<ir::FunctionId>& seen) const;
    std::uint32_t version_of(LocalId local) const {
        const std::uint32_t* found = versions_.find(local);
        return found == nullptr ? 0 : *found;
    }
    std::uint32_t version_of(std::uint32_t place) const {
        const std::uint32_t* found = bindings_.find(place);
        return found == nullptr ? 0 : *found;
    }
    ShapeKey shape_of(const ir::Expr& node) const;

    Context& cx;
    std::unique_ptr<NumberMemory> memory_;
    NodeMap<LocalId, ValueNumber> locals_{cx.first_local};
    NodeMap<LocalId, std::uint32_t> versions_{cx.first_local};
    FlatMap<std::uint32_t, std::uint32_t> bindings_;  ///< versions of memories, by PassBinding::one_place
    ValueNumber next_ = 0;
};

}  // namespace gliftc::lower
