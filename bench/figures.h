// Results of the algorithm benches and of bench_depth_of_field: rows, grouped by device, in the format that
// bench/figures.py reads.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

struct Figure {
    std::string by;  ///< who made the implementation: `Glift`, or the name of a rival
    std::string algorithm, variant;
    std::uint64_t elements = 0;
    double seconds = 0;             ///< median
    std::uint64_t bytes_moved = 0;  ///< the least memory traffic of the algorithm, as each bench says
    int runs = 0;
    double error = -1;  ///< largest relative error; negative: it was not measured (most results are exact)
};

/// Prints a row to stderr.
void print(const Figure& figure);

struct DeviceFigures {
    std::string device;
    std::vector<Figure> rows;
};

void write_json(const std::string& file, const std::vector<DeviceFigures>& devices);

}  // namespace bench
