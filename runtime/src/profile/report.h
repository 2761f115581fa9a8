// A profile as text.
#pragma once

#include "profiler.h"

#include <span>
#include <string>
#include <vector>

namespace glift::detail {

/// The passes that ran, the longest total first.
std::vector<PassProfile> passes_of(const ProfileData& data);

/// A line for the device, one of headings, and one for each kernel and kind of command.
std::string summary_of(const ProfileData& data);

/// The trace-event format: https://docs.google.com/document/d/1CvAClvFfyA5R-PhYUmn5OOQtYMH4h6I0nSsKchNAySU. Each device
/// is a process of its own, whose times count from its first event. Spans hold their events and inner spans.
std::string trace_of(std::span<const ProfileData> devices);

}  // namespace glift::detail
