#include "report.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace glift::detail {

namespace {

constexpr std::size_t columns = 7;
using Row = std::array<std::string, columns>;

/// Three significant digits and a unit: `12.3 ms`, `4.56 MiB`.
std::string scaled_text(double value, double step, std::span<const char* const> units) {
    std::size_t unit = 0;
    while (value >= 0.9995 * step && unit + 1 < units.size()) value /= step, ++unit;
    const int digits = value < 9.995 ? 2 : value < 99.95 ? 1 : 0;
    char text[64];
    std::snprintf(text, sizeof text, "%.*f %s", digits, value, units[unit]);
    return text;
}

std::string time_text(double seconds) {
    static constexpr const char* units[] = {"ns", "us", "ms", "s"};
    return scaled_text(seconds * 1e9, 1000, units);
}

std::string bytes_text(const PassProfile& pass) {
    static constexpr const char* units[] = {"B", "KiB", "MiB", "GiB", "TiB"};
    if (pass.bytes == 0) return pass.has_uncounted_bytes ? "?" : "0";
    return scaled_text(static_cast<double>(pass.bytes), 1024, units) + (pass.has_uncounted_bytes ? "+" : "");
}

Row row_of(const PassProfile& pass, double all) {
    char share[32];
    std::snprintf(share, sizeof share, "%.1f %%", all > 0 ? 100 * pass.seconds / all : 0);
    return {pass.name,
            pass.line != 0 ? pass.file + ":" + std::to_string(pass.line) : "",
            std::to_string(pass.calls),
            time_text(pass.seconds),
            time_text(pass.seconds / static_cast<double>(pass.calls)),
            bytes_text(pass),
            share};
}

/// The first two columns are aligned to the left, the others to the right.
std::string aligned(const std::vector<Row>& rows) {
    std::array<std::size_t, columns> widths{};
    for (const Row& row : rows)
        for (std::size_t k = 0; k < columns; ++k) widths[k] = std::max(widths[k], row[k].size());
    std::string text;
    for (const Row& row : rows) {
        for (std::size_t k = 0; k < columns; ++k) {
            const std::string gap(widths[k] - row[k].size(), ' ');
            text += "  " + (k < 2 ? row[k] + gap : gap + row[k]);
        }
        text += "\n";
    }
    return text;
}

}  // namespace

std::vector<PassProfile> passes_of(const ProfileData& data) {
    std::vector<PassProfile> passes;
    for (std::size_t k = 0; k < data.totals.size(); ++k) {
        if (data.totals[k].calls == 0) continue;
        passes.push_back(data.totals[k]);
        passes.back().name = data.names[k].name;
        passes.back().file = data.names[k].file;
        passes.back().line = data.names[k].line;
    }
    std::ranges::stable_sort(passes, std::ranges::greater(), &PassProfile::seconds);
    return passes;
}

std::string summary_of(const ProfileData& data) {
    const std::vector<PassProfile> passes = passes_of(data);
    double all = 0;
    std::uint64_t calls = 0;
    for (const PassProfile& pass : passes) all += pass.seconds, calls += pass.calls;
    std::string text = "glift profile: " + data.device + ", " + std::to_string(calls) + " passes and copies in " +
                       time_text(all) + "\n";
    std::vector<Row> rows = {{"pass", "source", "calls", "total", "per call", "bytes", "share"}};
    for (const PassProfile& pass : passes) rows.push_back(row_of(pass, all));
    return passes.empty() ? text : text + aligned(rows);
}

}  // namespace glift::detail
