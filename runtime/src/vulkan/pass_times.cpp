#include "pass_times.h"

#include <algorithm>

namespace glift::detail {

namespace {

constexpr std::uint32_t pool_size = 512;

}  // namespace

RecordedTimes::~RecordedTimes() {
    for (VkQueryPool pool : pools_) context_.vk.vkDestroyQueryPool(context_.device, pool, nullptr);
}

Query RecordedTimes::take(VkCommandBuffer commands) {
    if (pools_.empty() || used_ == pool_size) {
        VkQueryPool pool = make_timestamps(context_, pool_size);
        pools_.push_back(pool);
        used_ = 0;
        context_.vk.vkCmdResetQueryPool(commands, pool, 0, pool_size);
    }
    return {pools_.back(), used_++};
}

void PassTimes::add(TimedWork work, std::uint64_t value) {
    pending_.push_back({value, Profiler::run_of_thread(), std::move(work), nullptr});
}

void PassTimes::add(std::shared_ptr<RecordedTimes> times, std::uint64_t value) {
    pending_.push_back({value, profiler_.next_replay(), std::nullopt, std::move(times)});
}

std::uint64_t PassTimes::unread(const RecordedTimes& times) const {
    for (const Pending& each : pending_)
        if (each.recorded.get() == &times) return each.value;
    return 0;
}

void PassTimes::note(const TimedWork& work, Run run) {
    const auto begin = queries_.nanoseconds(work.begin), end = queries_.nanoseconds(work.end);
    if (begin && end) profiler_.add(work.tag, run, *begin, std::max(*begin, *end));
}

void PassTimes::read(std::uint64_t completed) {
    for (; !pending_.empty() && pending_.front().value <= completed; pending_.pop_front()) {
        const Pending& first = pending_.front();
        if (first.work) {
            note(*first.work, first.run);
            queries_.give_back(first.work->begin);
            queries_.give_back(first.work->end);
        } else {
            for (const TimedWork& work : first.recorded->works()) note(work, first.run);
        }
    }
}

}  // namespace glift::detail
