// Passes recorded once and replayed.
#include "test_device.h"

namespace {

using namespace kernels;

class Recordings : public OnEveryDevice {};
GLIFT_ON_EVERY_DEVICE(Recordings);

TEST_P(Recordings, AThousandPassesReplayWithOneSubmission) {
    constexpr std::uint32_t n = 64;
    const auto g = buffer(device, "g.data", 4 * n);
    const auto recording = device.record([&](const glift::Commands& commands) {
        for (std::uint32_t k = 0; k < 1000; ++k) run_add(commands, g, n, k);
    });
    std::uint32_t expected = 0;
    const auto replay = [&] {
        for (std::uint32_t k = 0; k < 1000; ++k) expected = expected * 2 + k;
    };
    device.wait();
    const auto before = device.statistics();
    recording.submit();
    replay();
    const auto after = device.statistics();
    EXPECT_EQ(after.submissions - before.submissions, device.is_host() ? 0u : 1u);
    EXPECT_EQ(after.passes - before.passes, 1000u);
    recording.submit();  // submitted at once: the first replay may still run
    replay();
    EXPECT_EQ(read<std::uint32_t>(device, g, n)[n - 1], expected);
}

TEST_P(Recordings, CountTheirPassesWhenTheyRunAndOnlyThen) {
    const auto g = buffer(device, "g.data", 256);
    const auto before = device.statistics();
    const auto recording = device.record([&](const glift::Commands& commands) {
        for (const std::uint32_t elements : {64u, 0u, 64u}) run_add(commands, g, elements, 1);
    });
    EXPECT_EQ(device.statistics().passes, before.passes);
    for (int replay = 0; replay < 2; ++replay) recording.submit();
    for (const std::uint32_t elements : {64u, 0u, 64u}) run_add(device, g, elements, 1);
    EXPECT_EQ(device.statistics().passes - before.passes, 9u);
}

TEST_P(Recordings, ThatAreNeverSubmittedLeaveNothingBehind) {
    constexpr std::uint32_t n = 64;
    const std::vector<std::uint32_t> values(1 << 18);
    const auto g = buffer(device, "g.data", 4 * n), f = buffer(device, "f.data", 4 * values.size());
    const auto record = [&] {
        device.record([&](const glift::Commands& commands) {
            run_add(commands, g, n, 1);
            commands.upload(f, 0, bytes_of(values));
        });
    };
    for (int round = 0; round < 4; ++round) record();
    const auto before = device.statistics();
    for (int round = 0; round < 100; ++round) record();
    const auto after = device.statistics();
    EXPECT_LE(after.bytes_reserved, before.bytes_reserved + (8 << 20));
}

TEST_P(Recordings, StandInOrderWithTheDevicesOwnStream) {
    constexpr std::uint32_t n = 64;
    const auto g = buffer(device, "g.data", 4 * n);
    run_store(device, g, n, 1);
    const auto recording = device.record([&](const glift::Commands& commands) { run_add(commands, g, n, 10); });
    EXPECT_EQ(read<std::uint32_t>(device, g, n)[0], 1u);  // recorded, not run
    recording.submit();
    run_add(device, g, n, 100);
    recording.submit();
    EXPECT_EQ(read<std::uint32_t>(device, g, n)[0], ((1u * 2 + 10) * 2 + 100) * 2 + 10);
}

TEST_P(Recordings, ReadDeviceValuesAnew) {
    constexpr std::uint32_t n = 256;
    const glift::Memory memories[] = {buffer(device, "f.data", 4 * n), buffer(device, "g.data", 4 * n)};
    const auto count = buffer(device, "count.data", 4);
    device.commands().fill(memories[0], 0, 4 * n, 0x3F800000);
    const ScaleParameters block = {n, 2.0f};
    const glift::Patch patch = {{count, 0}, 0};
    const auto recording = device.record([&](const glift::Commands& commands) {
        commands.fill(memories[1], 0, 4 * n);
        commands.dispatch(scale, {.form = glift::FormName::general,
                                  .memories = memories,
                                  .parameters = bytes_of(block),
                                  .size = {n, 1, 1, 1},
                                  .patches = {&patch, 1}});
    });
    for (const std::uint32_t wanted : {3u, 200u, 0u}) {
        run_store(device, count, 1, wanted);
        recording.submit();
        const auto result = read<float>(device, memories[1], n);
        for (std::uint32_t i = 0; i < n; ++i) ASSERT_EQ(result[i], i < wanted ? 2.0f : 0.0f) << wanted << " " << i;
    }
}

TEST_P(Recordings, HoldTheirMemories) {
    const auto f = buffer(device, "f.data", 256);
    glift::Recording recording;
    {
        recording = device.record([&](const glift::Commands& commands) {
            const auto temporary = commands.device().allocate({.name = "temp", .bytes = 256});
            run_store(commands, temporary, 64, 42);
            commands.copy(temporary, 0, f, 0, 256);
        });
    }
    const auto other = buffer(device, "other", 256);
    device.commands().fill(other, 0, 256, 1);
    recording.submit();
    EXPECT_EQ(read<std::uint32_t>(device, f, 64)[63], 42u);
    recording = {};
    EXPECT_EQ(read<std::uint32_t>(device, other, 64)[63], 1u);
}

TEST_P(Recordings, RefuseWhatNeedsTheDevicesOwnStream) {
    const auto f = buffer(device, "f.data", 256);
    EXPECT_EQ(
        error_of([&] { device.record([&](const glift::Commands& commands) { commands.download(f, 0, 4); }); }).code(),
        glift::ErrorCode::wrong_argument);
    EXPECT_EQ(error_of([&] { device.record([&](const glift::Commands& commands) { commands.wait(); }); }).code(),
              glift::ErrorCode::wrong_argument);
}

}  // namespace
