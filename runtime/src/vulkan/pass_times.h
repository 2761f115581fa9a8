// Timestamps around passes and copies, for the profiler.
#pragma once

#include "../profile/profiler.h"
#include "queries.h"

#include <deque>
#include <memory>
#include <vector>

namespace glift::detail {

/// A pass or copy, and the queries that its begin and end are written to.
struct TimedWork {
    Tag tag;
    Query begin, end;
};

/// The timestamps of a recording, in query pools of its own: the recording's commands reset them. Each replay writes
/// them anew.
class RecordedTimes {
public:
    explicit RecordedTimes(Context& context) : context_(context) {}
    ~RecordedTimes();
    RecordedTimes(const RecordedTimes&) = delete;

    Query take(VkCommandBuffer commands);
    void add(TimedWork work) { works_.push_back(std::move(work)); }
    const std::vector<TimedWork>& works() const { return works_; }

private:
    Context& context_;
    std::vector<VkQueryPool> pools_;
    std::uint32_t used_ = 0;  ///< queries of the last pool
    std::vector<TimedWork> works_;
};

/// Timestamps that the device has not written yet, or that were not read yet, in the order of submission. The device's
/// lock is held in all calls.
class PassTimes {
public:
    PassTimes(Queries& queries, Profiler& profiler) : queries_(queries), profiler_(profiler) {}

    /// `value`: the timeline's value once the device is done with it.
    void add(TimedWork work, std::uint64_t value);
    /// Called when a recording is submitted, before read() of its last submission's value.
    void add(std::shared_ptr<RecordedTimes> times, std::uint64_t value);
    /// The timeline's value after which the timestamps of the recording's last replay can be read; 0: they were.
    std::uint64_t unread(const RecordedTimes& times) const;
    /// Gives the profiler what the device has written by this value of the timeline. Commands whose submission failed
    /// are left out.
    void read(std::uint64_t completed);

private:
    struct Pending {
        std::uint64_t value;
        Run run;
        std::optional<TimedWork> work;
        std::shared_ptr<RecordedTimes> recorded;  ///< if there is no work
    };

    void note(const TimedWork& work, Run run);

    Queries& queries_;
    Profiler& profiler_;
    std::deque<Pending> pending_;
};

}  // namespace glift::detail
