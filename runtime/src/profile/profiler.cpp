#include "profiler.h"

#include <algorithm>

namespace glift::detail {

namespace {

constexpr std::size_t most_events = std::size_t(1) << 18;

}  // namespace

Run Profiler::run_of_thread() {
    static std::atomic<std::uint32_t> threads{0};
    thread_local const std::uint32_t number = ++threads;
    return {number};
}

Run Profiler::next_replay() { return {run_of_thread().thread, ++last_replay_}; }

void Profiler::turn_on() {
    const std::lock_guard lock(mutex_);
    if (!marks_) marks_.emplace();
    ++users_;
}

void Profiler::turn_off() {
    const std::lock_guard lock(mutex_);
    if (--users_ != 0) return;
    marks_.reset();
    data_.totals.assign(data_.totals.size(), {});
    data_.spans.clear();
    data_.events.clear();
    data_.dropped = 0;
    open_.clear();
}

NameId Profiler::intern(const char* name, const char* file, std::uint32_t line, const std::string& place) {
    const auto [found, is_new] = ids_.try_emplace({name, place}, NameId(data_.names.size()));
    if (is_new) {
        data_.names.push_back({name, place, file, line});
        data_.totals.emplace_back();
    }
    return found->second;
}

Tag Profiler::tag(const Work& work) {
    const std::string place = work.line != 0 ? work.file + (":" + std::to_string(work.line)) : std::string();
    Tag tag{NameId(), work.bytes, work.has_uncounted_bytes, path()};
    const std::lock_guard lock(mutex_);
    tag.name = intern(work.name, work.file, work.line, place);
    return tag;
}

std::vector<PathStep> Profiler::path() {
    const std::lock_guard lock(mutex_);
    std::vector<PathStep> path;
    for (const PipelineMark* mark : open_marks())
        path.push_back({intern(mark->name(), "", 0, mark->place()), mark->serial()});
    return path;
}

/// The innermost span of a path. Pipelines that were open at the thread's last event still are, as long as the path
/// begins with them; a span begins for each of the others.
SpanId Profiler::span_of(const std::vector<PathStep>& path, Run run) {
    std::vector<OpenSpan>& open = open_[run.thread];
    std::size_t same = 0;
    while (same < open.size() && same < path.size() && open[same].serial == path[same].serial &&
           open[same].replay == run.replay)
        ++same;
    open.resize(same);
    for (; same < path.size(); ++same) {
        const SpanId outer = open.empty() ? SpanId::none : open.back().span;
        open.push_back({path[same].serial, run.replay, SpanId(data_.spans.size())});
        data_.spans.push_back({path[same].name, outer});
    }
    return open.empty() ? SpanId::none : open.back().span;
}

void Profiler::add(const Tag& tag, Run run, Nanoseconds begin, Nanoseconds end) {
    const std::lock_guard lock(mutex_);
    if (!is_on()) return;
    PassProfile& total = data_.totals[static_cast<std::size_t>(tag.name)];
    ++total.calls;
    total.seconds += static_cast<double>(end - begin) * 1e-9;
    total.bytes += tag.bytes;
    total.has_uncounted_bytes = total.has_uncounted_bytes || tag.has_uncounted_bytes;
    if (data_.events.size() >= most_events) {
        ++data_.dropped;
        return;
    }
    data_.events.push_back({tag.name, span_of(tag.path, run), run.thread, tag.bytes, begin, end});
}

ProfileData Profiler::data() const {
    const std::lock_guard lock(mutex_);
    return data_;
}

ProfileData since(const ProfileData& before, ProfileData now) {
    for (std::size_t k = 0; k < before.totals.size(); ++k) {
        now.totals[k].calls -= before.totals[k].calls;
        now.totals[k].seconds -= before.totals[k].seconds;
        now.totals[k].bytes -= before.totals[k].bytes;
    }
    now.events.erase(now.events.begin(), now.events.begin() + static_cast<std::ptrdiff_t>(before.events.size()));
    now.dropped -= before.dropped;
    return now;
}

}  // namespace glift::detail
