#include "emit/cpp/spirv_file.h"

#include <cstdio>

namespace gliftc::cpp {

namespace {

/// A symbol that contains a hash of the file's words (as FNV-1a, word by word), so that the source changes when the
/// file does.
std::string symbol_of(const std::vector<std::uint32_t>& words) {
    std::uint64_t hash = 14695981039346656037u;
    for (std::uint32_t word : words) hash = (hash ^ word) * 1099511628211u;
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
    return std::string("glift_spirv_") + digits;
}

}  // namespace

SpirvFile::SpirvFile(std::string name, const KernelCodes& code, const std::vector<ir::KernelId>& kernels)
    : name_(std::move(name)) {
    const auto add = [&](ir::KernelId kernel, ir::Form form, ir::Part part, const std::vector<std::uint32_t>& words) {
        places_[{kernel, form, part}] = {words_.size(), words.size()};
        words_.insert(words_.end(), words.begin(), words.end());
    };
    for (ir::KernelId kernel : kernels) {
        if (!code.contains(kernel)) continue;
        const KernelCode& of = code[kernel];
        add(kernel, ir::Form::direct, ir::Part::vertex, of.direct.shader);
        add(kernel, ir::Form::direct, ir::Part::fragment, of.direct.fragment);
        if (of.general == of.direct) continue;
        add(kernel, ir::Form::general, ir::Part::vertex, of.general.shader);
        add(kernel, ir::Form::general, ir::Part::fragment, of.general.fragment);
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

std::string SpirvFile::place_of(ir::KernelId kernel, ir::Form form, ir::Part part) const {
    const Place& place = places_.at({kernel, form, part});
    return symbol_ + " + " + std::to_string(place.first) + ", " + std::to_string(place.count);
}

}  // namespace gliftc::cpp
