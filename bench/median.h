#pragma once

#include <algorithm>
#include <vector>

namespace bench {

/// Of an even number of values, the mean of the two in the middle: of runs in two modes, neither is preferred.
inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace bench
