// The temporaries of a pipeline: their size is known before it runs, and sharing storage does not change results.
#include "test_device.h"
#include "workspace.glift.hpp"

#include <algorithm>
#include <numeric>

namespace {

using Pipeline = void (*)(const glift::Commands&, const workspace::Line&, const workspace::Line&);
using Values = std::vector<glift::uint>;

class Workspaces : public OnEveryDevice {
protected:
    static constexpr glift::uint n = 100'000;

    std::uint64_t measured(Pipeline pipeline) const {
        return device.workspace_bytes([&](const glift::Commands& commands) { pipeline(commands, x, y); });
    }
    glift::Recording recorded(Pipeline pipeline) const {
        return device.record([&](const glift::Commands& commands) { pipeline(commands, x, y); });
    }
    /// Makes the runtime free the storage of memories without handles: it does so when it begins a batch of commands
    /// after the device is done with them, which is in the second round. Sets y's first element to 0.
    void collect() const {
        for (int time = 0; time < 2; ++time) {
            device.commands().fill(y.data(), 0, 4);
            device.wait();
        }
    }
    /// The bytes that a second recording adds. The first one also allocates buffers for parameters, which are kept.
    std::uint64_t taken(Pipeline pipeline) const {
        recorded(pipeline);
        collect();
        const std::uint64_t before = device.statistics().bytes_used;
        const glift::Recording recording = recorded(pipeline);
        return device.statistics().bytes_used - before;
    }
    Values replayed(Pipeline pipeline) {
        Values values(n);
        std::iota(values.begin(), values.end(), 7u);
        x.write(values);
        const glift::Recording recording = recorded(pipeline);
        recording.submit();
        recording.submit();
        return y.read();
    }

    workspace::Line x{device, n}, y{device, n};
};
GLIFT_ON_EVERY_DEVICE(Workspaces);

TEST_P(Workspaces, AreWhatARecordingTakes) {
    for (Pipeline pipeline :
         {workspace::chained, workspace::shrinking, workspace::zeros, workspace::plain, workspace::image,
          workspace::scan, workspace::sum, workspace::sorted, workspace::histogram_of_bytes, workspace::odd}) {
        const std::uint64_t bytes = measured(pipeline);
        EXPECT_EQ(bytes, recorded(pipeline).workspace_bytes());
        EXPECT_EQ(bytes, taken(pipeline));
    }
}

TEST_P(Workspaces, OfLivesThatDoNotMeetAreShared) {
    EXPECT_GE(measured(workspace::chained), 2u * 4 * n);
    EXPECT_LT(measured(workspace::chained), 2u * 4 * n + 1024);  // 3 n elements without sharing
    EXPECT_GE(measured(workspace::shrinking), 4u * 4 * n);
    EXPECT_LT(measured(workspace::shrinking), 4u * 4 * n + 1024);  // 6 n elements without sharing
    EXPECT_LT(measured(workspace::zeros), 4u * n + 1024);
    EXPECT_LT(measured(workspace::sorted), 4u * 4 * n);
}

TEST_P(Workspaces, AreZeroWhereThereAreNoTemporaries) { EXPECT_EQ(measured(workspace::plain), 0u); }

TEST_P(Workspaces, AreMeasuredWithoutAllocatingOrRunning) {
    y.fill(1);
    device.wait();
    const glift::Statistics before = device.statistics();
    EXPECT_GT(measured(workspace::sorted), 4u * n);
    const glift::Statistics after = device.statistics();
    EXPECT_EQ(after.bytes_used, before.bytes_used);
    EXPECT_EQ(after.bytes_reserved, before.bytes_reserved);
    EXPECT_EQ(after.memories, before.memories);
    EXPECT_EQ(after.passes, before.passes);
    EXPECT_EQ(after.pipelines, before.pipelines);
    EXPECT_EQ(after.submissions, before.submissions);
    EXPECT_EQ(y.read(), Values(n, 1));
}

TEST_P(Workspaces, ShareStorageUnharmed) {
    Values chained(n), zeros(n), scanned(n);
    std::iota(chained.begin(), chained.end(), 7u + 4);
    EXPECT_EQ(replayed(workspace::chained), chained);
    std::iota(chained.begin(), chained.end(), 7u + 3);
    EXPECT_EQ(replayed(workspace::shrinking), chained);
    std::iota(zeros.begin(), zeros.end(), 7u + 1);
    EXPECT_EQ(replayed(workspace::zeros), zeros);
    for (glift::uint i = 1; i < n; ++i) scanned[i] = scanned[i - 1] + i - 1 + 7;
    EXPECT_EQ(replayed(workspace::scan), scanned);
}

/// Two temporaries share storage, in four passes: the first is zeroed and written, then the second is zeroed and
/// written. A barrier must separate each pass from the next: three barriers.
TEST_P(Workspaces, ComeToTheNextAfterABarrier) {
    if (device.is_host()) GTEST_SKIP() << "no barriers";
    const std::uint64_t before = device.statistics().barriers;
    EXPECT_LT(recorded(workspace::apart).workspace_bytes(), 4u * n + 1024);
    EXPECT_EQ(device.statistics().barriers - before, 3u);
}

TEST_P(Workspaces, AreUnknownWhereAValueIsAwaited) {
    const glift::Error error = error_of([&] { measured(workspace::waits); });
    EXPECT_EQ(error.code(), glift::ErrorCode::wrong_argument);
    EXPECT_NE(std::string(error.what()).find("workspace"), std::string::npos);
}

/// A temporary that the program keeps a handle of does not share its storage.
TEST_P(Workspaces, LeaveAloneWhatAProgramHolds) {
    x.fill(5);
    std::optional<workspace::Line> held;
    std::optional<glift::Recording> recording = device.record([&](const glift::Commands& commands) {
        held.emplace(commands, n);
        workspace::plain(commands, x, *held);
        workspace::chained(commands, x, y);
    });
    EXPECT_GE(recording->workspace_bytes(), 3u * 4 * n);
    recording->submit();
    recording.reset();
    EXPECT_EQ(held->read(), Values(n, 6));
    EXPECT_EQ(y.read(), Values(n, 9));
}

/// Structures made while the workspace is measured have no storage.
TEST_P(Workspaces, OfMeasuringAreOfNoUseElsewhere) {
    std::optional<workspace::Line> held;
    device.workspace_bytes([&](const glift::Commands& commands) { held.emplace(commands, n); });
    EXPECT_EQ(error_of([&] { workspace::plain(device, x, *held); }).code(), glift::ErrorCode::wrong_argument);
    EXPECT_EQ(error_of([&] { held->read(); }).code(), glift::ErrorCode::wrong_argument);
}

}  // namespace
