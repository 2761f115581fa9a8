#include "environment.h"

#include <glift/device.h>
#include <glift/error.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <string>

namespace glift::detail {

namespace {

[[noreturn]] void throw_value(const char* name, std::string_view text, const char* remedy) {
    throw Error(ErrorCode::wrong_argument, std::string("the environment variable ") + name + " has an invalid value",
                std::string(name) + "=" + std::string(text), {}, remedy);
}

}  // namespace

bool environment_flag(const char* name) {
    const char* const value = std::getenv(name);
    const std::string_view text = value ? value : "";
    if (text.empty() || text == "0") return false;
    if (text != "1") throw_value(name, text, "set it to 1 or 0");
    return true;
}

bool forces_general_form() {
    static const bool forced = environment_flag("GLIFT_GENERAL_FORM");
    return forced;
}

std::uint64_t bytes_of_text(const char* name, std::string_view text) {
    constexpr const char* remedy = "give bytes, or a number and K, M, G or T: 500000, 512M, 2G";
    constexpr std::string_view units = "KMGT";
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) throw_value(name, text, remedy);
    std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
    if (unit.empty()) return number;
    const std::size_t power = units.find(unit[0]);
    unit.remove_prefix(1);
    if (power == units.npos || !(unit.empty() || unit == "B" || unit == "iB")) throw_value(name, text, remedy);
    const unsigned shift = 10 * static_cast<unsigned>(power + 1);
    if (number > UINT64_MAX >> shift) throw_value(name, text, remedy);
    return number << shift;
}

std::uint64_t memory_limit() {
    const char* const text = std::getenv("GLIFT_MEMORY_LIMIT");
    return text && *text ? bytes_of_text("GLIFT_MEMORY_LIMIT", text) : unlimited;
}

}  // namespace glift::detail
