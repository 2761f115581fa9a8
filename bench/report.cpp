#include "report.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace bench {

void print_table(const std::string& device, const std::vector<Row>& rows) {
    std::printf("%s\n\n", device.c_str());
    std::printf("| case | elements | generated | hand-written | time ratio | instructions | same result |\n");
    std::printf("| --- | ---: | ---: | ---: | ---: | ---: | --- |\n");
    for (const Row& row : rows)
        std::printf("| %s | %llu | %.4f ms | %.4f ms | %.3f | %zu / %zu | %s |\n", row.name.c_str(),
                    static_cast<unsigned long long>(row.elements), row.measured.generated * 1e3,
                    row.measured.handwritten * 1e3, row.measured.ratio, row.generated_instructions,
                    row.handwritten_instructions, row.measured.agree ? "yes" : "NO");
}

std::string json_of(const glift::DeviceProperties& device, int runs, const std::vector<Row>& rows) {
    nlohmann::ordered_json json = {{"device", device.name}, {"driver", device.driver}, {"runs", runs}};
    json["cases"] = nlohmann::ordered_json::array();
    for (const Row& row : rows)
        json["cases"].push_back({{"name", row.name},
                                 {"elements", row.elements},
                                 {"generated_seconds", row.measured.generated},
                                 {"handwritten_seconds", row.measured.handwritten},
                                 {"ratio", row.measured.ratio},
                                 {"generated_instructions", row.generated_instructions},
                                 {"handwritten_instructions", row.handwritten_instructions},
                                 {"agree", row.measured.agree}});
    return json.dump(2) + "\n";
}

}  // namespace bench
