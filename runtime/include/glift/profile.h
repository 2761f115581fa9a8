// How long passes take on a device: as numbers, as a table, as a trace. GLIFT_PROFILE does the same for a whole
// program.
#pragma once

#include <glift/api.h>
#include <glift/device.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glift {

/// What all calls of one kernel took, or all commands of one kind (`fill`, `clear`, `copy`, `upload`, `download`).
struct PassProfile {
    std::string name;        ///< the kernel's, or the kind
    std::string file;        ///< of the kernel's source; else empty
    std::uint32_t line = 0;  ///< of the kernel's source; else 0
    std::uint64_t calls = 0;
    double seconds = 0;  ///< in total
    /// In total: of the elements that the passes visit, once for each load and store of them; of what is copied or
    /// filled.
    std::uint64_t bytes = 0;
    /// Whether the passes also access bytes that are not counted: at any address, or of a number of elements that lies
    /// on the device.
    bool has_uncounted_bytes = false;
};

/// Measures what a device runs, from construction to destruction. On Vulkan devices the times are the device's own
/// (timestamp queries), of each pass from the end of the work before it: of passes that overlap, the later one has the
/// time by which it takes longer. A replay counts each pass of its recording; one whose recording was made before the
/// profile counts as one pass `recording`. Commands for a user's command buffer (vulkan.h) are not measured.
///
/// Cost: two timestamps for each pass and copy, and on Vulkan devices each replay waits for the last one of the same
/// recording. Devices that are not profiled pay one comparison for each.
class GLIFT_API Profile {
public:
    /// Waits for what was put into the device's own stream. Throws missing_feature where the device's queue has no
    /// timestamps, wrong_argument in a body of Device::record.
    explicit Profile(const Device& device);
    ~Profile();
    Profile(const Profile&) = delete;
    Profile& operator=(const Profile&) = delete;

    /// Each of these submits, and waits for, what was put into the device's own stream. Throw wrong_argument in a body
    /// of Device::record.
    std::vector<PassProfile> passes() const;  ///< the longest total first
    std::string summary() const;              ///< as a table of lines
    /// In the trace-event format, a JSON text that ui.perfetto.dev and chrome://tracing open: a track for each thread
    /// that gave commands, passes inside of their pipelines, times from the first pass on. It holds the first 2^18
    /// passes, and says how many came later.
    std::string trace() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace glift
