// Arenas whose values are referred to by typed ids (indices): the storage of the nodes of the syntax tree and the IR.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace gliftc {

/// An index into an Arena<T>. A default Id refers to nothing.
template <class T> struct Id {
    static constexpr std::uint32_t none = 0xffffffffu;
    std::uint32_t index = none;

    explicit operator bool() const { return index != none; }
    bool operator==(const Id&) const = default;
    auto operator<=>(const Id&) const = default;
};

/// Owns values of one type, except those that it shares with an arena that it extends; ids and references stay valid as
/// it grows. Values lie in blocks of 64, so that finding one is a shift and a mask.
template <class T> class Arena {
    static constexpr std::uint32_t shift = 6, block_size = 1u << shift, mask = block_size - 1;

    template <class A, class V> class Iterator {
    public:
        using value_type = T;
        using difference_type = std::ptrdiff_t;
        Iterator() = default;
        Iterator(A* arena, std::uint32_t at) : arena_(arena), at_(at) {}
        V& operator*() const { return arena_->at(at_); }
        V* operator->() const { return &arena_->at(at_); }
        Iterator& operator++() {
            ++at_;
            return *this;
        }
        Iterator operator++(int) {
            Iterator before = *this;
            ++at_;
            return before;
        }
        bool operator==(const Iterator&) const = default;

    private:
        A* arena_ = nullptr;
        std::uint32_t at_ = 0;
    };

public:
    Arena() = default;
    Arena(Arena&& other) noexcept { *this = std::move(other); }
    Arena& operator=(Arena&& other) noexcept {
        std::swap(blocks_, other.blocks_);
        std::swap(own_, other.own_);
        std::swap(first_, other.first_);
        std::swap(size_, other.size_);
        return *this;
    }
    Arena(const Arena& other) {
        for (const T& value : other) add(value);
    }
    Arena& operator=(const Arena& other) { return *this = Arena(other); }
    ~Arena() {
        for (std::uint32_t i = first_; i < size_; ++i)
            if (own_[(i - first_) >> shift]) at(i).~T();
    }
    /// An arena that begins with the values of `base`: full blocks are shared, the rest is copied. The base must
    /// outlive it, and neither may change the shared values.
    static Arena extending(const Arena& base) {
        Arena made;
        const std::uint32_t full = base.size_ >> shift;
        made.blocks_.assign(base.blocks_.begin(), base.blocks_.begin() + full);
        made.first_ = made.size_ = full << shift;
        for (std::uint32_t i = made.first_; i < base.size_; ++i) made.add(base.at(i));
        return made;
    }

    Id<T> add(const T& value) { return emplace(value); }
    Id<T> add(T&& value) { return emplace(std::move(value)); }
    /// Pads the last block, so that the next value begins a block.
    void fill_block() {
        while (size_ & mask) add(T());
    }
    /// Moves the blocks of values [begin, end) from another arena to the end of this one. Their ids in the other arena
    /// become invalid. Both bounds, and this arena's size, must be multiples of the block size; the values must be the
    /// other arena's own, not shared with an arena that it extends.
    void adopt(Arena& from, std::uint32_t begin, std::uint32_t end) {
        assert(((size_ | begin | end) & mask) == 0 && begin >= from.first_);
        for (std::uint32_t i = begin; i < end; i += block_size) {
            own_.push_back(std::move(from.own_[(i - from.first_) >> shift]));
            blocks_.push_back(own_.back().get());
        }
        size_ += end - begin;
    }
    /// Destroys the values from index `size` on. Their memory is used by the next ones added.
    void truncate(std::uint32_t size) {
        while (size_ > size) at(--size_).~T();
    }
    T& operator[](Id<T> id) {
        assert(id.index < size_);
        return at(id.index);
    }
    const T& operator[](Id<T> id) const {
        assert(id.index < size_);
        return at(id.index);
    }
    std::uint32_t size() const { return size_; }
    auto begin() { return Iterator<Arena, T>(this, 0); }
    auto end() { return Iterator<Arena, T>(this, size_); }
    auto begin() const { return Iterator<const Arena, const T>(this, 0); }
    auto end() const { return Iterator<const Arena, const T>(this, size_); }

private:
    template <class Value> Id<T> emplace(Value&& value) {
        if (size_ >> shift == blocks_.size()) {
            own_.push_back(std::make_unique_for_overwrite<Block>());
            blocks_.push_back(own_.back().get());
        }
        new (place(size_)) T(std::forward<Value>(value));
        return {size_++};
    }

    struct Block {
        alignas(T) std::byte bytes[sizeof(T) * block_size];
    };
    std::byte* place(std::uint32_t i) { return blocks_[i >> shift]->bytes + sizeof(T) * (i & mask); }
    T& at(std::uint32_t i) { return *std::launder(reinterpret_cast<T*>(place(i))); }
    const T& at(std::uint32_t i) const { return const_cast<Arena*>(this)->at(i); }

    std::vector<Block*> blocks_;
    std::vector<std::unique_ptr<Block>> own_;  ///< the blocks from `first_` on; null: adopted by another arena
    std::uint32_t first_ = 0;                  ///< index of the first value in own_
    std::uint32_t size_ = 0;
};

}  // namespace gliftc

template <class T> struct std::hash<gliftc::Id<T>> {
    std::size_t operator()(gliftc::Id<T> id) const noexcept { return id.index; }
};
