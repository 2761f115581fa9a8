#pragma once

#include <glift/glift.h>

#include <functional>
#include <vector>

namespace bench {

using Work = std::function<void(const glift::Commands&)>;

/// Seconds of one execution of a recording, by device timestamps. Waits for it.
double seconds_of(const glift::Device& device, const glift::Recording& recording);

/// Median seconds of one execution, by device timestamps. A run is a recording that repeats the work for about
/// `seconds` (200 times at most), so that the cost of its submission is negligible; 0: the recording has the work once.
double time_of(const glift::Device& device, const Work& work, int runs, double seconds);

/// As `time_of`, of several works that take turns, so that what slows the device down for a while slows all of them.
std::vector<double> times_of(const glift::Device& device, const std::vector<Work>& works, int runs, double seconds);

}  // namespace bench
