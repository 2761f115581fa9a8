// Collects what a device ran, and when. Each device has one; it does nothing until a Profile or GLIFT_PROFILE turns it
// on.
#pragma once

#include "marks.h"
#include "work.h"

#include <glift/profile.h>

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace glift::detail {

/// A time on the device's clock in nanoseconds; the origin is arbitrary.
using Nanoseconds = std::int64_t;

/// A name with its place in the source, as an index of ProfileData::names.
enum class NameId : std::uint32_t {};

/// A pipeline's call, as an index of ProfileData::spans.
enum class SpanId : std::uint32_t { none = UINT32_MAX };

/// A pipeline that was running when a command was given. `serial` is its mark's.
struct PathStep {
    NameId name;
    std::uint64_t serial;
};

/// One pass or copy, as it is known when the command is given.
struct Tag {
    NameId name;
    std::uint64_t bytes = 0;
    bool has_uncounted_bytes = false;
    std::vector<PathStep> path;  ///< outermost pipeline first
};

/// Where a command is given: `replay` numbers the submissions of recordings, from 1; 0: not from a recording.
struct Run {
    std::uint32_t thread;
    std::uint64_t replay = 0;
};

struct ProfileData {
    struct Name {
        std::string name, place;  ///< place: `file:line`, or empty
        std::string file;
        std::uint32_t line = 0;
    };
    struct Span {
        NameId name;
        SpanId outer;
    };
    struct Event {
        NameId name;
        SpanId span;  ///< the innermost pipeline
        std::uint32_t thread;
        std::uint64_t bytes;
        Nanoseconds begin, end;
    };

    std::string device;
    std::vector<Name> names;
    std::vector<PassProfile> totals;  ///< by name; pipelines have no calls
    std::vector<Span> spans;          ///< an outer one before those inside
    std::vector<Event> events;
    std::uint64_t dropped = 0;  ///< events beyond the most that are held
};

class Profiler {
public:
    bool is_on() const { return users_.load(std::memory_order_relaxed) != 0; }
    void turn_on();
    void turn_off();  ///< the last user's call forgets what was collected

    /// What is known of a command that this thread gives now.
    Tag tag(const Work& work);
    std::vector<PathStep> path();  ///< the pipelines that run on this thread
    /// Notes that the command ran. Commands of one run are noted in their order.
    void add(const Tag& tag, Run run, Nanoseconds begin, Nanoseconds end);
    /// For commands that this thread gives now, or for a recording that it submits now.
    static Run run_of_thread();
    Run next_replay();

    ProfileData data() const;

private:
    struct OpenSpan {
        std::uint64_t serial, replay;
        SpanId span;
    };

    NameId intern(const char* name, const char* file, std::uint32_t line, const std::string& place);
    SpanId span_of(const std::vector<PathStep>& path, Run run);

    std::atomic<std::uint32_t> users_{0};
    std::atomic<std::uint64_t> last_replay_{0};
    std::optional<MarkUser> marks_;
    mutable std::mutex mutex_;
    ProfileData data_;
    std::map<std::pair<std::string, std::string>, NameId> ids_;  ///< by name and place
    std::map<std::uint32_t, std::vector<OpenSpan>> open_;        ///< by thread: the path of its last event
};

/// What was collected after `before` was.
ProfileData since(const ProfileData& before, ProfileData now);

}  // namespace glift::detail
