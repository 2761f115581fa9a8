// Several threads use one device at once. tools/check runs this under the thread sanitizer.
#include "test_device.h"

#include <thread>

namespace {

using namespace kernels;

constexpr int threads = 4, rounds = 4;
constexpr std::uint32_t n = 64;

/// Runs body(k) on several threads at once.
template <class Body> void on_threads(Body body) {
    std::vector<std::thread> all;
    for (int k = 0; k < threads; ++k) all.emplace_back([&body, k] { body(k); });
    for (std::thread& thread : all) thread.join();
}

class Threads : public OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(Threads);

TEST_P(Threads, HaveMemoriesOfTheirOwn) {
    std::array<std::uint32_t, threads> results{};
    on_threads([&](int k) {
        for (int round = 0; round < rounds; ++round) {
            const auto g = buffer(device, "g.data", 4 * n);
            const std::vector<std::uint32_t> values(n, static_cast<std::uint32_t>(k));
            device.commands().upload(g, 0, bytes_of(values));
            run_add(device, g, n, 1);
            results[static_cast<std::size_t>(k)] = read<std::uint32_t>(device, g, n)[n - 1];
            device.statistics();
        }
    });
    for (std::uint32_t k = 0; k < threads; ++k) EXPECT_EQ(results[k], 2 * k + 1);
}

// Passes of several threads over one memory run one after the other, in some order.
TEST_P(Threads, ShareAMemory) {
    const auto g = buffer(device, "g.data", 4 * n);
    device.commands().fill(g, 0, 4 * n, 1);
    on_threads([&](int) {
        for (int round = 0; round < rounds; ++round) run_add(device, g, n, 0);
    });
    for (const std::uint32_t value : read<std::uint32_t>(device, g, n)) ASSERT_EQ(value, 1u << threads * rounds);
}

TEST_P(Threads, SubmitOneRecording) {
    const auto g = buffer(device, "g.data", 4 * n);
    device.commands().fill(g, 0, 4 * n, 1);
    const auto recording = device.record([&](const glift::Commands& commands) {
        run_add(commands, g, n, 0);
        run_add(commands, g, n, 0);
    });
    on_threads([&](int) {
        recording.submit();
        device.wait();
    });
    EXPECT_EQ(read<std::uint32_t>(device, g, n)[n - 1], 1u << 2 * threads);
}

TEST_P(Threads, RecordAtOnce) {
    std::array<std::uint32_t, threads> results{};
    on_threads([&](int k) {
        const auto g = buffer(device, "g.data", 4 * n);
        const auto recording = device.record([&](const glift::Commands& commands) {
            const auto temporary = commands.allocate({.name = "t", .bytes = 4 * n});
            run_add(commands, temporary, n, static_cast<std::uint32_t>(k));
            commands.copy(temporary, 0, g, 0, 4 * n);
        });
        recording.submit();
        results[static_cast<std::size_t>(k)] = read<std::uint32_t>(device, g, n)[0];
    });
    for (std::uint32_t k = 0; k < threads; ++k) EXPECT_EQ(results[k], k);
}

TEST_P(Threads, PutCommandsIntoOneRecording) {
    const auto g = buffer(device, "g.data", 4 * n);
    device.commands().fill(g, 0, 4 * n, 1);
    const auto recording = device.record([&](const glift::Commands& commands) {
        on_threads([&](int) {
            for (int round = 0; round < rounds; ++round) run_add(commands, g, n, 0);
        });
    });
    recording.submit();
    EXPECT_EQ(read<std::uint32_t>(device, g, n)[n - 1], 1u << threads * rounds);
}

// While a recording is made, commands given to the device itself are recorded if they come from the thread that makes
// the recording; those of other threads run as usual.
TEST_P(Threads, AreNotRecordedByAnother) {
    const auto g = buffer(device, "g.data", 4 * n), h = buffer(device, "h.data", 4 * n);
    const auto recording = device.record([&](const glift::Commands&) {
        run_add(device, g, n, 1);
        std::thread([&] { run_add(device, h, n, 1); }).join();
    });
    EXPECT_EQ(read<std::uint32_t>(device, g, n)[0], 0u);
    EXPECT_EQ(read<std::uint32_t>(device, h, n)[0], 1u);
    recording.submit();
    EXPECT_EQ(read<std::uint32_t>(device, g, n)[0], 1u);
}

TEST(Log, IsSetAndUsedByThreads) {
    glift::Log before = glift::set_log({});
    std::atomic<int> told{0};
    on_threads([&](int) {
        glift::set_log([&](std::string_view) { ++told; });
        glift::detail::log("a message");
    });
    glift::set_log(std::move(before));
    EXPECT_EQ(told, threads);
}

}  // namespace
