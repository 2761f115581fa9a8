// rivals: times CUB, cuSPARSE, and kernels that only move data, on this GPU, and writes the results as JSON.
//
//     rivals [--log2 20,22,24,26,28] [--runs N] [--only FAMILY] [--json FILE]
#include "rivals.cuh"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

namespace {

struct Family {
    const char* name;
    void (*measure)(rivals::Bench&);
};

constexpr Family families[] = {
    {"copy", rivals::copy},           {"scan", rivals::scan},     {"reduce", rivals::reduce},
    {"select", rivals::select},       {"unique", rivals::unique}, {"radix_sort", rivals::radix_sort},
    {"histogram", rivals::histogram}, {"merge", rivals::merge},   {"tridiagonal", rivals::tridiagonal},
    {"diffusion", rivals::diffusion}};

struct Options {
    std::vector<std::size_t> sizes = {1u << 20, 1u << 22, 1u << 24, 1u << 26, 1u << 28};
    int runs = 21;
    std::string only, json;
};

[[noreturn]] void usage() {
    std::fprintf(stderr, "usage: rivals [--log2 20,22,24,26,28] [--runs N] [--only FAMILY] [--json FILE]\nfamilies:");
    for (const Family& family : families) std::fprintf(stderr, " %s", family.name);
    std::fprintf(stderr, "\n");
    std::exit(2);
}

std::vector<std::size_t> sizes_in(const std::string& text) {
    std::vector<std::size_t> sizes;
    std::istringstream stream(text);
    for (std::string word; std::getline(stream, word, ',');) {
        const int log2 = std::atoi(word.c_str());
        if (log2 < 10 || log2 > 30) usage();
        sizes.push_back(std::size_t{1} << log2);
    }
    std::sort(sizes.begin(), sizes.end());
    if (sizes.empty()) usage();
    return sizes;
}

Options parse(int count, char** arguments) {
    Options options;
    if (count % 2 == 0) usage();
    for (int i = 1; i + 1 < count; i += 2) {
        const std::string name = arguments[i], value = arguments[i + 1];
        if (name == "--log2") options.sizes = sizes_in(value);
        else if (name == "--runs") options.runs = std::max(1, std::atoi(value.c_str()));
        else if (name == "--only") options.only = value;
        else if (name == "--json") options.json = value;
        else usage();
    }
    return options;
}

const char* rival_of(const std::string& algorithm) {
    if (algorithm == "copy" || algorithm == "move_equations") return "CUDA";
    const bool is_diffusion = algorithm.rfind("rows_", 0) == 0 || algorithm.rfind("columns_", 0) == 0;
    return is_diffusion || algorithm == "tridiagonal" ? "cuSPARSE" : "CUB";
}

/// Writes the rows as JSON in the format that bench/figures.py reads.
void print(std::ostream& out, const std::vector<rivals::Row>& rows) {
    cudaDeviceProp device;
    RIVALS_CUDA(cudaGetDeviceProperties(&device, 0));
    out.precision(9);
    out << "[{\"device\": \"" << device.name << "\", \"rows\": [";
    const char* before = "\n";
    for (const rivals::Row& row : rows) {
        out << before << "  {\"by\": \"" << rival_of(row.algorithm) << "\", \"algorithm\": \"" << row.algorithm
            << "\", \"variant\": \"" << row.variant << "\", \"elements\": " << row.elements
            << ", \"seconds\": " << row.seconds << ", \"bytes_moved\": " << row.bytes_moved
            << ", \"runs\": " << row.runs;
        if (row.error >= 0) out << ", \"error\": " << row.error;
        out << "}";
        before = ",\n";
    }
    out << "\n]}]\n";
}

}  // namespace

int main(int count, char** arguments) {
    const Options options = parse(count, arguments);
    rivals::Bench bench(options.sizes, options.runs);
    bool is_known = options.only.empty();
    for (const Family& family : families) {
        if (!options.only.empty() && options.only != family.name) continue;
        is_known = true;
        family.measure(bench);
    }
    if (!is_known) usage();
    if (options.json.empty()) {
        print(std::cout, bench.rows());
        return 0;
    }
    std::ofstream file(options.json);
    print(file, bench.rows());
    return file.good() ? 0 : 1;
}
