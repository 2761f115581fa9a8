#include "figures.h"

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace bench {

void print(const Figure& figure) {
    const auto elements = static_cast<double>(figure.elements), bytes = static_cast<double>(figure.bytes_moved);
    std::fprintf(stderr, "%-12s %-12s %-18s %10llu %12.2f us %9.3f G elements/s %8.1f GB/s", figure.by.c_str(),
                 figure.algorithm.c_str(), figure.variant.c_str(), static_cast<unsigned long long>(figure.elements),
                 figure.seconds * 1e6, elements / figure.seconds * 1e-9, bytes / figure.seconds * 1e-9);
    if (figure.error >= 0) std::fprintf(stderr, "  error %.1e", figure.error);
    std::fprintf(stderr, "\n");
}

void write_json(const std::string& file, const std::vector<DeviceFigures>& devices) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const DeviceFigures& one : devices) {
        nlohmann::ordered_json rows = nlohmann::ordered_json::array();
        for (const Figure& figure : one.rows) {
            rows.push_back({{"by", figure.by},
                            {"algorithm", figure.algorithm},
                            {"variant", figure.variant},
                            {"elements", figure.elements},
                            {"seconds", figure.seconds},
                            {"bytes_moved", figure.bytes_moved},
                            {"runs", figure.runs}});
            if (figure.error >= 0) rows.back()["error"] = figure.error;
        }
        json.push_back({{"device", one.device}, {"rows", rows}});
    }
    std::ofstream out(file);
    out << json.dump(1) << "\n";
    if (!out.good()) throw std::runtime_error("cannot write " + file);
}

}  // namespace bench
