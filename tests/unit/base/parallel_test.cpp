#include "base/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace gliftc {
namespace {

TEST(Parallel, WorksOnEachOnce) {
    for (std::size_t count : {0u, 1u, 7u, 1000u}) {
        std::vector<std::atomic<int>> visits(count);
        for_each_parallel(count, 1, [&](std::size_t i) { ++visits[i]; });
        for (const auto& visit : visits) EXPECT_EQ(visit, 1);
    }
}

TEST(Parallel, UsesTheThreadsThatItIsAskedFor) {
    std::atomic<int> started = 0;
    // Each thread waits until all have started, which shows that they run at once.
    on_threads(4, [&] {
        ++started;
        while (started < 4) std::this_thread::yield();
    });
    EXPECT_EQ(started, 4);
    EXPECT_EQ(threads_for(7, 8), 1u);
    EXPECT_EQ(threads_for(0, 8), 1u);
}

TEST(Parallel, ThrowsWhatAThreadThrew) {
    std::atomic<int> ended = 0;
    const auto work = [&] {
        if (ended++ == 1) throw std::runtime_error("one of them");
    };
    EXPECT_THROW(on_threads(3, work), std::runtime_error);
    EXPECT_EQ(ended, 3);
}

}  // namespace
}  // namespace gliftc
