#include "expectations.h"

#include <filesystem>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace glift::test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

int number(const std::ssub_match& match) { return match.matched ? std::stoi(match.str()) : 0; }

/// Reads "error: text [id]", "warning: text [id]" or "note: text".
void read_message(const std::string& message, Report& report) {
    static const std::regex form(R"((error|warning|note): (.*?)(?: \[([a-z0-9-]+)\])?)");
    std::smatch match;
    if (!std::regex_match(message, match, form)) throw std::runtime_error("no severity in '" + message + "'");
    report.severity = match[1];
    report.text = match[2];
    report.id = match[3];
}

/// Reads a `//~` comment; `code_line` is the line that its carets refer to, if it has some.
Report read_expectation(const std::string& file, const std::string& line, int code_line) {
    static const std::regex carets(R"(\s*//~\s*(\^+)\s*(.*))");
    static const std::regex numbers(R"(\s*//~\s*@(?:([\w./-]+):)?(\d+):(\d+)(?:-(\d+))?\s+(.*))");
    static const std::regex nowhere(R"(\s*//~\s*nowhere\s+(.*))");
    Report report;
    std::smatch match;
    if (std::regex_match(line, match, carets)) {
        report.file = file;
        report.line = code_line;
        report.first_column = static_cast<int>(match.position(1)) + 1;
        report.last_column = report.first_column + static_cast<int>(match.length(1)) - 1;
        read_message(match[2], report);
    } else if (std::regex_match(line, match, numbers)) {
        report.file = match[1].matched ? std::filesystem::path(match[1].str()).filename().string() : file;
        report.line = number(match[2]);
        report.first_column = number(match[3]);
        report.last_column = match[4].matched ? number(match[4]) : report.first_column;
        read_message(match[5], report);
    } else if (std::regex_match(line, match, nowhere)) {
        read_message(match[1], report);
    } else {
        throw std::runtime_error(file + ": an expectation of no known form: " + line);
    }
    return report;
}

}  // namespace

std::string to_string(const Report& report) {
    std::ostringstream text;
    if (report.file.empty()) {
        text << "nowhere";
    } else {
        text << report.file << ':' << report.line << ':' << report.first_column << '-' << report.last_column;
    }
    text << ' ' << report.severity << ": " << report.text;
    if (!report.id.empty()) text << " [" << report.id << ']';
    return text.str();
}

std::vector<Report> read_expectations(const std::string& file, const std::string& text) {
    std::vector<Report> expectations;
    int line_number = 0, code_line = 0;
    for (const std::string& line : lines_of(text)) {
        ++line_number;
        const std::size_t start = line.find_first_not_of(" \t");
        if (start != std::string::npos && line.compare(start, 3, "//~") == 0) {
            expectations.push_back(read_expectation(file, line, code_line));
        } else {
            code_line = line_number;
        }
    }
    return expectations;
}

std::vector<Report> read_diagnostics(const std::string& printed) {
    static const std::regex head(R"((?:(.+?):(\d+):(\d+): |(?:gliftc: )?)((?:error|warning|note): .*))");
    static const std::regex carets(R"([\s|]*(\^[~^]*)\s*)");
    std::vector<Report> reports;
    std::smatch match;
    bool placed = false;
    for (const std::string& line : lines_of(printed)) {
        if (std::regex_match(line, match, head)) {
            Report report;
            if (match[1].matched) {
                report.file = std::filesystem::path(match[1].str()).filename().string();
                report.line = number(match[2]);
                report.first_column = report.last_column = number(match[3]);
            }
            read_message(match[4], report);
            reports.push_back(std::move(report));
            placed = false;
        } else if (!reports.empty() && !placed && std::regex_match(line, match, carets)) {
            reports.back().last_column = reports.back().first_column + static_cast<int>(match.length(1)) - 1;
            placed = true;
        }
    }
    return reports;
}

std::vector<std::string> extra_arguments(const std::string& text) {
    const std::string mark = "// gliftc:";
    if (!text.starts_with(mark)) return {};
    std::istringstream line(text.substr(mark.size(), text.find('\n') - mark.size()));
    std::vector<std::string> arguments;
    for (std::string word; line >> word;) arguments.push_back(word);
    return arguments;
}

}  // namespace glift::test
