// What copies of a container share. A container is a class that gliftc generates for an `container`.
#pragma once

#include <memory>
#include <utility>

namespace glift {

/// A value that all copies of this object share: a container's member that may get other memory, or a value of the
/// container's host state.
template <class T> class Shared {
public:
    Shared() : value_(std::make_shared<T>()) {}
    explicit Shared(T value) : value_(std::make_shared<T>(std::move(value))) {}

    T& get() { return *value_; }
    const T& get() const { return *value_; }

private:
    std::shared_ptr<T> value_;
};

}  // namespace glift
