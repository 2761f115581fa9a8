#include "algorithm_cases.h"

#include "algorithms.glift.hpp"

namespace bench {

std::vector<AlgorithmCase> algorithm_cases(const glift::Device& device, std::uint32_t n) {
    const algorithms::Keys y(device, n);
    std::vector<AlgorithmCase> all;
    const auto add = [&](const char* algorithm, const std::string& variant, std::uint64_t bytes, const auto& pipeline,
                         const algorithms::Keys& x) {
        all.push_back(
            {algorithm, variant, n, bytes * n, [=](const glift::Commands& commands) { pipeline(commands, x, y); }});
    };
    const auto input = [&](std::uint32_t run) {
        algorithms::Keys x(device, n);
        algorithms::make_input(device, run, x);
        return x;
    };
    const algorithms::Keys x = input(1);
    algorithms::Keys bytes(device, n);
    algorithms::keep_low_byte(device, x, bytes);
    add("copy", "kernel", 8, algorithms::copy_keys, x);
    add("scan", "exclusive_sum_u32", 8, algorithms::scan, x);
    add("reduce", "sum_u32", 4, algorithms::reduce_sum, x);
    add("select", "if_1_in_8", 4, algorithms::select_if, x);
    for (std::uint32_t run : {1u, 8u, 256u})
        add("unique", "runs_" + std::to_string(run), 4, algorithms::select_unique, input(run));
    add("histogram", "below_256", 4, algorithms::count_bytes, bytes);
    add("radix_sort", "keys_u32", 8, algorithms::sort_keys, x);
    const algorithms::Keys values = input(1), values_to(device, n);
    all.push_back({"radix_sort", "pairs_u32", n, std::uint64_t{16} * n, [=](const glift::Commands& commands) {
                       algorithms::sort_with_values(commands, x, values, y, values_to);
                   }});
    return all;
}

}  // namespace bench
