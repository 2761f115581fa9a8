// Which pipeline the commands of a thread belong to: for profiles (profile.h), and for the labels that debuggers of
// Vulkan show.
#pragma once

#include <glift/api.h>

#include <atomic>
#include <cstdint>

namespace glift {

namespace detail {
/// How many profiles, and devices that a debugger looks at, want marks. While there are none, marks do nothing.
extern GLIFT_API std::atomic<std::uint32_t> mark_users;
}  // namespace detail

/// A pipeline that is running on this thread. Generated code declares one at the beginning of each pipeline's function;
/// programs may do so for parts of their own. Marks of a thread nest: the last one to begin is the first one to end.
/// Both strings must live as long as the mark.
class GLIFT_API PipelineMark {
public:
    /// `place`: `file.glift:12`, or empty.
    PipelineMark(const char* name, const char* place) : name_(name), place_(place) {
        if (detail::mark_users.load(std::memory_order_relaxed) != 0) begin();
    }
    ~PipelineMark() {
        if (serial_ != 0) end();
    }
    PipelineMark(const PipelineMark&) = delete;
    PipelineMark& operator=(const PipelineMark&) = delete;

    const char* name() const { return name_; }
    const char* place() const { return place_; }
    std::uint64_t serial() const { return serial_; }  ///< differs between all marks of the process; 0: not wanted

private:
    void begin();
    void end();

    const char* name_;
    const char* place_;
    std::uint64_t serial_ = 0;
};

}  // namespace glift
