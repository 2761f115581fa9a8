#pragma once

#include <glift/glift.h>

#include <functional>

namespace bench {

/// Median seconds of one execution, by the device's clock. A run is a recording that does the same thing for so many
/// `seconds` that submitting it does not show.
double time_of(const glift::Device& device, const std::function<void(const glift::Commands&)>& work, int runs,
               double seconds);

}  // namespace bench
