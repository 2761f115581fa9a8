// A vector for members that are empty in nearly every node: it takes one pointer, which is null while the vector is
// empty.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace gliftc {

/// Converts implicitly to a const std::vector, for reading.
template <class T> class RareVector {
public:
    RareVector() = default;
    RareVector(std::initializer_list<T> values) : RareVector(std::vector<T>(values)) {}
    template <class It> RareVector(It first, It last) : RareVector(std::vector<T>(first, last)) {}
    RareVector(std::vector<T> values) {
        if (!values.empty()) values_ = std::make_unique<std::vector<T>>(std::move(values));
    }
    RareVector(const RareVector& other) {
        if (other.values_) values_ = std::make_unique<std::vector<T>>(*other.values_);
    }
    RareVector(RareVector&&) noexcept = default;
    RareVector& operator=(const RareVector& other) { return *this = RareVector(other); }
    RareVector& operator=(RareVector&&) noexcept = default;
    ~RareVector() = default;

    operator const std::vector<T>&() const { return values_ ? *values_ : nothing; }
    bool empty() const { return size() == 0; }
    std::size_t size() const { return values_ ? values_->size() : 0; }
    T* begin() { return values_ ? values_->data() : nullptr; }
    T* end() { return begin() + size(); }
    const T* begin() const { return values_ ? values_->data() : nullptr; }
    const T* end() const { return begin() + size(); }
    const T& operator[](std::size_t i) const { return (*values_)[i]; }
    const T& back() const { return values_->back(); }

    void push_back(T value) { held().push_back(std::move(value)); }
    template <class It> void append(It first, It last) {
        if (first != last) held().insert(held().end(), first, last);
    }
    template <class List> void append(const List& other) { append(other.begin(), other.end()); }

    bool operator==(const RareVector& other) const { return *this == static_cast<const std::vector<T>&>(other); }
    bool operator==(const std::vector<T>& other) const { return static_cast<const std::vector<T>&>(*this) == other; }

private:
    std::vector<T>& held() {
        if (!values_) values_ = std::make_unique<std::vector<T>>();
        return *values_;
    }

    inline static const std::vector<T> nothing;
    std::unique_ptr<std::vector<T>> values_;
};

}  // namespace gliftc
