#include "report.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>

namespace glift::detail {

namespace {

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') result += '\\';
        if (code >= 0x20) {
            result += c;
        } else {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", code);
            result += escape;
        }
    }
    return result + "\"";
}

/// Microseconds, the format's unit, without rounding: rounded spans might end before the events inside them.
std::string microseconds(Nanoseconds time) {
    char text[40];
    std::snprintf(text, sizeof text, "%lld.%03lld", static_cast<long long>(time / 1000),
                  static_cast<long long>(time % 1000));
    return text;
}

struct Interval {
    std::uint32_t thread = 0;
    Nanoseconds begin = std::numeric_limits<Nanoseconds>::max();
    Nanoseconds end = std::numeric_limits<Nanoseconds>::min();
};

/// From the first event in each span to the last one; nothing for spans without events.
std::vector<std::optional<Interval>> intervals_of(const ProfileData& data) {
    std::vector<std::optional<Interval>> intervals(data.spans.size());
    for (const ProfileData::Event& event : data.events) {
        for (SpanId span = event.span; span != SpanId::none;) {
            const auto at = static_cast<std::size_t>(span);
            if (!intervals[at]) intervals[at].emplace();
            intervals[at]->thread = event.thread;
            intervals[at]->begin = std::min(intervals[at]->begin, event.begin);
            intervals[at]->end = std::max(intervals[at]->end, event.end);
            span = data.spans[at].outer;
        }
    }
    return intervals;
}

class Trace {
public:
    explicit Trace(std::string& text) : text_(text) {}

    void metadata(std::size_t process, const char* kind, std::uint32_t thread, const std::string& name) {
        line("{\"ph\":\"M\",\"pid\":" + std::to_string(process) + ",\"tid\":" + std::to_string(thread) +
             ",\"name\":\"" + kind + "\",\"args\":{\"name\":" + quoted(name) + "}}");
    }

    void complete(std::size_t process, const Interval& interval, Nanoseconds origin, const ProfileData::Name& name,
                  const char* category, const std::string& arguments) {
        line("{\"ph\":\"X\",\"pid\":" + std::to_string(process) + ",\"tid\":" + std::to_string(interval.thread) +
             ",\"cat\":\"" + category + "\",\"name\":" + quoted(name.name) + ",\"ts\":" +
             microseconds(interval.begin - origin) + ",\"dur\":" + microseconds(interval.end - interval.begin) +
             ",\"args\":{\"source\":" + quoted(name.place) + arguments + "}}");
    }

private:
    void line(const std::string& event) {
        text_ += (is_first_ ? "\n" : ",\n") + event;
        is_first_ = false;
    }

    std::string& text_;
    bool is_first_ = true;
};

void add_device(Trace& trace, std::size_t process, const ProfileData& data) {
    trace.metadata(process, "process_name", 0, data.device);
    std::vector<std::uint32_t> threads;
    Nanoseconds origin = std::numeric_limits<Nanoseconds>::max();
    for (const ProfileData::Event& event : data.events) {
        origin = std::min(origin, event.begin);
        if (std::ranges::find(threads, event.thread) == threads.end()) threads.push_back(event.thread);
    }
    for (const std::uint32_t thread : threads)
        trace.metadata(process, "thread_name", thread, "commands of thread " + std::to_string(thread));
    const auto name = [&](NameId id) -> const ProfileData::Name& { return data.names[static_cast<std::size_t>(id)]; };
    const auto intervals = intervals_of(data);
    for (std::size_t k = 0; k < intervals.size(); ++k)
        if (intervals[k]) trace.complete(process, *intervals[k], origin, name(data.spans[k].name), "pipeline", "");
    for (const ProfileData::Event& event : data.events)
        trace.complete(process, {event.thread, event.begin, event.end}, origin, name(event.name), "pass",
                       ",\"bytes\":" + std::to_string(event.bytes));
}

}  // namespace

std::string trace_of(std::span<const ProfileData> devices) {
    std::string text = "{\"displayTimeUnit\":\"ns\",\"traceEvents\":[";
    Trace trace(text);
    std::uint64_t dropped = 0;
    for (std::size_t k = 0; k < devices.size(); ++k) {
        add_device(trace, k + 1, devices[k]);
        dropped += devices[k].dropped;
    }
    return text + "\n],\"otherData\":{\"dropped_events\":" + std::to_string(dropped) + "}}\n";
}

}  // namespace glift::detail
