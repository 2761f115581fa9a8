// The threads of host kernels: oneTBB, which programs need not include.
#include <glift/host/parallel.h>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace glift::host::detail {

void spread(std::size_t count, std::size_t grain, void (*run)(const void* body, std::size_t, std::size_t),
            const void* body) {
    // Isolated: while this thread waits, it takes no work of the program's, which might call another kernel in between.
    tbb::this_task_arena::isolate([=] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                          [=](const tbb::blocked_range<std::size_t>& part) { run(body, part.begin(), part.end()); });
    });
}

std::size_t thread_count() { return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()); }

}  // namespace glift::host::detail
