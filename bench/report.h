// Prints the results of glift_bench as a table and as JSON.
#pragma once

#include "measure.h"

namespace bench {

struct Row {
    std::string name;
    std::uint64_t elements;
    Measured measured;
    std::size_t generated_instructions, handwritten_instructions;
};

void print_table(const std::string& device, const std::vector<Row>& rows);
std::string json_of(const glift::DeviceProperties& device, int runs, const std::vector<Row>& rows);

}  // namespace bench
