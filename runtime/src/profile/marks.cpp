#include "marks.h"

#include <vector>

namespace glift {

namespace detail {

std::atomic<std::uint32_t> mark_users{0};

namespace {

std::vector<const PipelineMark*>& marks_of_thread() {
    thread_local std::vector<const PipelineMark*> marks;
    return marks;
}

}  // namespace

std::span<const PipelineMark* const> open_marks() { return marks_of_thread(); }

}  // namespace detail

void PipelineMark::begin() {
    static std::atomic<std::uint64_t> last_serial{0};
    serial_ = ++last_serial;
    detail::marks_of_thread().push_back(this);
}

void PipelineMark::end() { detail::marks_of_thread().pop_back(); }

}  // namespace glift
