// Values in arenas behind typed ids: how every tree in the compiler is held.
#pragma once

#include <cassert>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

namespace gliftc {

/// An index into an Arena<T>. A default Id refers to nothing.
template <class T>
struct Id {
    static constexpr std::uint32_t none = 0xffffffffu;
    std::uint32_t index = none;

    explicit operator bool() const { return index != none; }
    bool operator==(const Id&) const = default;
    auto operator<=>(const Id&) const = default;
};

/// Owns values of one type; ids and references stay valid as it grows.
template <class T>
class Arena {
public:
    Id<T> add(T value) {
        values_.push_back(std::move(value));
        return {static_cast<std::uint32_t>(values_.size() - 1)};
    }
    T& operator[](Id<T> id) {
        assert(id.index < values_.size());
        return values_[id.index];
    }
    const T& operator[](Id<T> id) const {
        assert(id.index < values_.size());
        return values_[id.index];
    }
    std::uint32_t size() const { return static_cast<std::uint32_t>(values_.size()); }
    auto begin() { return values_.begin(); }
    auto end() { return values_.end(); }
    auto begin() const { return values_.begin(); }
    auto end() const { return values_.end(); }

private:
    std::deque<T> values_;
};

}  // namespace gliftc

template <class T>
struct std::hash<gliftc::Id<T>> {
    std::size_t operator()(gliftc::Id<T> id) const noexcept { return id.index; }
};
