#pragma once

#include <algorithm>
#include <vector>

namespace bench {

/// For an even number of values the mean of the two middle ones, so that neither mode of a bimodal sample is preferred.
inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace bench
