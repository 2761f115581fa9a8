// Tables whose values are referred to by typed ids (indices): the structures, kernels and pipelines of a program.
#pragma once

#include "base/arena.h"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace gliftc {

/// The ids of a table in ascending order, for loops.
template <class T> class Ids {
public:
    class Iterator {
    public:
        using value_type = Id<T>;
        using difference_type = std::ptrdiff_t;
        Iterator() = default;
        explicit Iterator(std::uint32_t at) : at_(at) {}
        Id<T> operator*() const { return {at_}; }
        Iterator& operator++() {
            ++at_;
            return *this;
        }
        Iterator operator++(int) { return Iterator(at_++); }
        bool operator==(const Iterator&) const = default;

    private:
        std::uint32_t at_ = 0;
    };

    explicit Ids(std::uint32_t size) : size_(size) {}
    Iterator begin() const { return Iterator(0); }
    Iterator end() const { return Iterator(size_); }

private:
    std::uint32_t size_;
};

/// A vector that is indexed by ids. Unlike those of an Arena, references become invalid as it grows. A table with
/// another `Key` than its values' type lies beside a Table<Key>: it has a value for each of that one's.
template <class T, class Key = T> class Table : private std::vector<T> {
    using Values = std::vector<T>;

public:
    using typename Values::const_iterator;
    using typename Values::iterator;
    using typename Values::value_type;
    using Values::back, Values::begin, Values::clear, Values::emplace_back, Values::empty, Values::end, Values::front,
        Values::push_back, Values::reserve, Values::resize;
    using Values::Values;

    Id<Key> add(T value) {
        push_back(std::move(value));
        return {size() - 1};
    }
    T& operator[](Id<Key> id) {
        assert(id.index < size());
        return Values::operator[](id.index);
    }
    const T& operator[](Id<Key> id) const {
        assert(id.index < size());
        return Values::operator[](id.index);
    }
    std::uint32_t size() const { return static_cast<std::uint32_t>(Values::size()); }
    bool contains(Id<Key> id) const { return id.index < size(); }
    Ids<Key> ids() const { return Ids<Key>(size()); }
    /// The id of a value of this table.
    Id<Key> id_of(const T& value) const {
        assert(&value >= Values::data() && &value < Values::data() + Values::size());
        return {static_cast<std::uint32_t>(&value - Values::data())};
    }
};

}  // namespace gliftc
