// Results of bench_algorithms, bench_rivals and bench_depth_of_field: rows, grouped by device, in the JSON format that
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
    double seconds = 0;             ///< of one execution of the algorithm: the median of the runs
    std::uint64_t bytes_moved = 0;  ///< what the algorithm reads and writes at least, as its bench counts it
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
