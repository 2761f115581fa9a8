// What the ranks of a world do together with a file. In programs of one device each function does only its own part.
#pragma once

#include <glift/error.h>
#include <glift/ranks/group.h>

#include <chrono>
#include <functional>
#include <future>
#include <string>

namespace glift::files {

class Together {
public:
    Together() = default;
    explicit Together(const Device& device) : group_(device) {}

    bool is_alone() const { return group_.size() == 1; }
    /// Whether this is the rank that writes files.
    bool is_writer() const { return group_.rank() == 0; }

    /// Runs it, and throws on every rank if it throws on one. Within it, note() may throw what other ranks threw.
    template <class Run> void run(Run run) {
        std::exception_ptr mine;
        try {
            run();
        } catch (...) {
            if (is_alone() || is_over_) throw;
            mine = std::current_exception();
        }
        if (!is_alone()) agree(mine);
    }

    /// Called as bytes are moved, by all ranks alike: now and then the ranks wait for each other, so that none of them
    /// waits for so long that it takes another one for lost. `mine`: what failed on this rank.
    void note(std::uint64_t bytes, const std::exception_ptr& mine = nullptr) {
        if (is_alone() || (bytes_ += bytes) < step) return;
        bytes_ = 0;
        agree(mine);
    }

    /// Runs it on the writer, while the others wait however long it takes; throws on every rank if it throws there.
    template <class Run> void run_on_writer(Run run) {
        if (is_alone()) return run();
        std::future<void> result;
        if (is_writer()) result = std::async(std::launch::async, run);
        for (bool is_done = false; !is_done;) {
            std::byte mine{0};
            if (is_writer())
                mine = std::byte{result.wait_for(std::chrono::milliseconds(500)) == std::future_status::ready};
            is_done = group_.all_gather({&mine, 1})[0][0] != std::byte{0};
        }
        this->run([&] {
            if (is_writer()) result.get();
        });
    }

    const ranks::Group& group() const { return group_; }

private:
    static constexpr std::uint64_t step = std::uint64_t{64} << 20;

    void agree(const std::exception_ptr& mine) {
        is_over_ = true;  // what this throws is thrown on all ranks
        group_.agree(mine);
        is_over_ = false;
    }

    ranks::Group group_;
    std::uint64_t bytes_ = 0;
    bool is_over_ = false;
};

/// Throws wrong_argument where a structure is one of several ranks, and the file was opened by each for itself.
inline void require_together(const Together& together, const Device& device, const std::string& path,
                             const std::string& remedy) {
    if (together.is_alone() && ranks::Group(device).size() > 1)
        throw Error(ErrorCode::wrong_argument,
                    "the structure is one of several ranks, the file is one of this rank alone", path,
                    "all ranks have to know whether the file can be used", "open it as " + remedy);
}

}  // namespace glift::files
