// A vector with inline storage for its first elements. Nodes have few operands, and passes build lists of them for
// every node: allocating these on the heap took a third of the time of lowering.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>

namespace gliftc {

/// Elements must be trivially copyable. Up to `Inside` of them are stored in the object; once there are more, or room
/// for more is reserved, all are on the heap.
template <class T, std::uint32_t Inside> class SmallVector {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
    using value_type = T;
    using iterator = T*;
    using const_iterator = const T*;

    SmallVector() = default;
    SmallVector(std::initializer_list<T> values) { append(values.begin(), values.size()); }
    template <std::forward_iterator It> SmallVector(It first, It last) {
        for (reserve(static_cast<std::size_t>(std::distance(first, last))); first != last; ++first) push_back(*first);
    }
    SmallVector(const SmallVector& other) {
        if (other.is_inside()) copy_inside(other);
        else append(other.data(), other.size_);
    }
    SmallVector(SmallVector&& other) noexcept { take(other); }
    SmallVector& operator=(const SmallVector& other) {
        if (this == &other) return *this;
        clear();
        if (is_inside() && other.is_inside()) copy_inside(other);
        else append(other.data(), other.size_);
        return *this;
    }
    SmallVector& operator=(SmallVector&& other) noexcept {
        if (this == &other) return *this;
        release();
        take(other);
        return *this;
    }
    ~SmallVector() { release(); }

    T* data() { return is_inside() ? reinterpret_cast<T*>(bytes_) : heap(); }
    const T* data() const { return const_cast<SmallVector*>(this)->data(); }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T* begin() { return data(); }
    T* end() { return data() + size_; }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size_; }
    T& operator[](std::size_t i) {
        assert(i < size_);
        return data()[i];
    }
    const T& operator[](std::size_t i) const {
        assert(i < size_);
        return data()[i];
    }
    T& back() { return (*this)[size_ - 1]; }
    const T& back() const { return (*this)[size_ - 1]; }

    void push_back(T value) {
        if (size_ == capacity_) grow(size_ + 1);
        new (data() + size_++) T(value);
    }
    void append(const T* values, std::size_t count) {
        reserve(size_ + count);
        if (count != 0) std::memcpy(static_cast<void*>(data() + size_), values, count * sizeof(T));
        size_ += static_cast<std::uint32_t>(count);
    }
    void append(const SmallVector& other) {
        reserve(std::size_t{size_} + other.size_);  // first, since `other` may be this vector, whose data() changes
        append(other.data(), other.size_);
    }
    void assign(std::size_t count, T value) {
        clear();
        for (reserve(count); size_ < count;) push_back(value);
    }
    void clear() { size_ = 0; }
    void reserve(std::size_t count) {
        if (count > capacity_) grow(count);
    }

    bool operator==(const SmallVector& other) const { return std::equal(begin(), end(), other.begin(), other.end()); }

private:
    bool is_inside() const { return capacity_ == Inside; }
    T*& heap() { return *reinterpret_cast<T**>(bytes_); }
    void release() {
        if (!is_inside()) std::allocator<T>().deallocate(heap(), capacity_);
    }
    /// Copies the other's elements; both vectors must be inline. Copies all bytes, as take() does.
    void copy_inside(const SmallVector& other) {
        std::memcpy(bytes_, other.bytes_, sizeof bytes_);
        size_ = other.size_;
    }
    /// Moves the other's elements here. Copies all bytes, used or not, to avoid a branch.
    void take(SmallVector& other) {
        std::memcpy(bytes_, other.bytes_, sizeof bytes_);
        size_ = std::exchange(other.size_, 0);
        capacity_ = std::exchange(other.capacity_, Inside);
    }
    void grow(std::size_t count) {
        auto capacity = static_cast<std::uint32_t>(std::max<std::size_t>(count, 2 * std::size_t{capacity_}));
        T* moved = std::allocator<T>().allocate(capacity);
        if (size_ != 0) std::memcpy(static_cast<void*>(moved), data(), size_ * sizeof(T));
        release();
        new (bytes_) T*(moved);
        capacity_ = capacity;
    }

    std::uint32_t size_ = 0, capacity_ = Inside;
    alignas(T) alignas(T*) std::byte bytes_[std::max(sizeof(T) * Inside, sizeof(T*))] = {};
};

}  // namespace gliftc
