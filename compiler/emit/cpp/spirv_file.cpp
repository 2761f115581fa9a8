#include "emit/cpp/spirv_file.h"

#include <cstdio>

namespace gliftc::cpp {

namespace {

/// Says what the file holds, FNV-1a: a source changes where its file does.
std::string symbol_of(const std::vector<std::uint32_t>& words) {
    std::uint64_t hash = 14695981039346656037u;
    for (std::uint32_t word : words) hash = (hash ^ word) * 1099511628211u;
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
    return std::string("glift_spirv_") + digits;
}

}  // namespace

SpirvFile::SpirvFile(std::string name, const std::vector<KernelCode>& code, const std::vector<std::uint32_t>& kernels)
    : name_(std::move(name)) {
    const auto add = [&](std::uint32_t kernel, ir::Form form, const std::vector<std::uint32_t>& words) {
        parts_[{kernel, form}] = {words_.size(), words.size()};
        words_.insert(words_.end(), words.begin(), words.end());
    };
    for (std::uint32_t kernel : kernels) {
        if (kernel >= code.size()) continue;
        add(kernel, ir::Form::direct, code[kernel].direct);
        if (code[kernel].general != code[kernel].direct) add(kernel, ir::Form::general, code[kernel].general);
        if (code[kernel].wide != code[kernel].general) add(kernel, ir::Form::wide, code[kernel].wide);
    }
    symbol_ = symbol_of(words_);
}

std::string SpirvFile::bytes() const {
    std::string bytes;
    bytes.reserve(words_.size() * 4);
    for (std::uint32_t word : words_)
        for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xff);
    return bytes;
}

std::string SpirvFile::statement() const {
    return "GLIFT_SPIRV_FILE(" + symbol_ + ", " + std::to_string(words_.size()) + ", GLIFT_SPIRV_FOLDER \"/" + name_ +
           "\");";
}

std::string SpirvFile::place_of(std::uint32_t kernel, ir::Form form) const {
    const Part& part = parts_.at({kernel, form});
    return symbol_ + " + " + std::to_string(part.first) + ", " + std::to_string(part.count);
}

}  // namespace gliftc::cpp
