// The pointer inside every public handle (Device, Memory, Commands, ...). A handle that was default-constructed or
// moved from is empty: it may be copied and tested (Device and Memory also compared); calls that need its object throw.
#pragma once

#include <glift/api.h>

#include <memory>
#include <utility>

namespace glift::detail {

/// Throws wrong_argument. `call` names the handle's class and the function called: `Recording::submit`.
[[noreturn]] GLIFT_API void throw_empty_handle(const char* call);

/// A shared pointer; access by `in` throws where it is null.
template <class Object> class Held {
public:
    Held() = default;
    explicit Held(std::shared_ptr<Object> object) : object_(std::move(object)) {}

    Object& in(const char* call) const {
        if (!object_) throw_empty_handle(call);
        return *object_;
    }
    /// Null for an empty handle.
    const std::shared_ptr<Object>& share() const { return object_; }
    explicit operator bool() const { return object_ != nullptr; }
    bool operator==(const Held&) const = default;

private:
    std::shared_ptr<Object> object_;
};

}  // namespace glift::detail
