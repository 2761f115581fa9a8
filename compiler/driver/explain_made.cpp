#include "driver/explain_made.h"

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace gliftc {

namespace {

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Reads `Grid(uint2(18, 16), 20, -1.0)`: a name, then numbers in parentheses. Among the numbers, words (`uint2`,
/// `float[2]`), parentheses, braces, commas and spaces are skipped, wherever they stand. False if there is anything
/// else, or no name, or no ')' at the end.
bool read_call(const std::string& call, std::string& name, std::vector<double>& numbers) {
    const std::size_t open = call.find('(');
    name = call.substr(0, open);
    if (open == std::string::npos || open == 0 || call.back() != ')') return false;
    const char* at = call.c_str() + open;
    while (*at) {
        if (is_of_word(*at) && !std::isdigit(static_cast<unsigned char>(*at))) {
            while (is_of_word(*at)) ++at;
            if (*at == '[') at = std::strchr(at, ']');
            if (!at) return false;
            if (*at == ']') ++at;
        } else if (std::string_view(" ,(){}").find(*at) != std::string_view::npos) {
            ++at;
        } else {
            char* end = nullptr;
            numbers.push_back(std::strtod(at, &end));
            if (end == at) return false;
            at = end;
            if (*at == 'u') ++at;
        }
    }
    return true;
}

const ir::Structure* find(const Compilation& c, const std::string& name) {
    for (const ir::Structure& structure : c.program.structures) {
        if (structure.display == name) return &structure;
        for (const ir::Alias& alias : structure.aliases)
            if (c.names[alias.name] == name) return &structure;
    }
    return nullptr;
}

}  // namespace

std::uint64_t ExplainedMade::bytes() const {
    std::uint64_t sum = 0;
    for (const MadeMemory& memory : made.memories) sum += memory.bytes.value_or(0);
    return sum;
}

std::string bytes_text(std::uint64_t bytes) {
    static constexpr const char* units[] = {"bytes", "KiB", "MiB", "GiB", "TiB"};
    double amount = static_cast<double>(bytes);
    std::size_t unit = 0;
    for (; amount >= 1024 && unit + 1 < std::size(units); ++unit) amount /= 1024;
    char text[40];
    std::snprintf(text, sizeof text, "%.4g %s", amount, units[unit]);
    return text;
}

std::vector<ExplainedMade> explained_made(const Compilation& c, const std::vector<std::string>& calls,
                                          std::string& problem) {
    std::vector<ExplainedMade> all;
    for (const std::string& call : calls) {
        std::string name;
        std::vector<double> numbers;
        if (!read_call(call, name, numbers)) {
            problem = "--made '" + call + "' is not a name and numbers: 'Grid(1024, 1024, 4096, 0.0)'";
            return {};
        }
        const ir::Structure* structure = find(c, name);
        if (!structure) {
            problem = "--made '" + call + "': the files declare no structure '" + name + "'";
            return {};
        }
        auto made = made_with(c.program, *structure, numbers, problem);
        if (!made) {
            problem = "--made '" + call + "': " + problem;
            return {};
        }
        all.push_back({name, std::move(*made)});
    }
    return all;
}

}  // namespace gliftc
