// The marks (mark.h) of this thread.
#pragma once

#include <glift/mark.h>

#include <span>

namespace glift::detail {

/// The open marks of this thread, outermost first.
std::span<const PipelineMark* const> open_marks();

/// Lets marks be noted as long as it lives.
class MarkUser {
public:
    MarkUser() { mark_users.fetch_add(1, std::memory_order_relaxed); }
    ~MarkUser() { mark_users.fetch_sub(1, std::memory_order_relaxed); }
    MarkUser(const MarkUser&) = delete;
};

}  // namespace glift::detail
