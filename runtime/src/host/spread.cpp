// Parallel loops of host kernels over oneTBB, whose headers programs need not include.
#include <glift/host/parallel.h>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>

namespace glift::host::detail {

void spread(std::size_t count, std::size_t grain, void (*run)(const void* body, std::size_t, std::size_t),
            const void* body) {
    // Isolated: while this thread waits, it must not steal tasks of the program, since such a task might call another
    // kernel, which would then run in the middle of this one.
    tbb::this_task_arena::isolate([=] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                          [=](const tbb::blocked_range<std::size_t>& part) { run(body, part.begin(), part.end()); });
    });
}

void spread_in_order(std::size_t count, std::size_t grain, void (*run)(const void* body, std::size_t, std::size_t),
                     const void* body) {
    const std::size_t parts = (count + grain - 1) / grain;
    std::atomic<std::size_t> next{0};
    const auto take_parts = [&](std::size_t, std::size_t) {
        for (std::size_t part = next++; part < parts; part = next++)
            run(body, part * grain, std::min((part + 1) * grain, count));
    };
    spread(std::min(parts, thread_count()), 1, take_parts);
}

std::size_t thread_count() { return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()); }

}  // namespace glift::host::detail
