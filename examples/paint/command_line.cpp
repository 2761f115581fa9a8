#include "command_line.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace command_line {

std::string is_finite(const std::string& number) {
    return std::isfinite(std::strtof(number.c_str(), nullptr)) ? std::string() : number + " is no finite number";
}

std::string is_picture(const std::string& path) {
    const std::string end = std::filesystem::path(path).extension();
    return end == ".png" || end == ".exr" ? std::string() : path + ": pictures are .png or .exr files";
}

std::string can_be_made(const std::string& path) {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (std::filesystem::is_directory(path, error)) return path + ": is a folder";
    if (!folder.empty() && !std::filesystem::is_directory(folder, error)) return path + ": there is no such folder";
    return {};
}

std::string quoted(const std::string& word) {
    constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

}  // namespace command_line
