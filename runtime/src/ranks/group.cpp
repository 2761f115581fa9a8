#include <glift/ranks/group.h>

#include "rank_device.h"

#include <glift/error.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace glift::ranks {

namespace {

/// An error as bytes: its code, then its texts, each ended by a zero.
std::vector<std::byte> bytes_of(const Error& error) {
    std::vector<std::byte> bytes = {static_cast<std::byte>(error.code())};
    for (const std::string* text : {&error.problem(), &error.where(), &error.why(), &error.remedy()}) {
        const auto* begin = reinterpret_cast<const std::byte*>(text->c_str());
        bytes.insert(bytes.end(), begin, begin + text->size() + 1);
    }
    return bytes;
}

std::vector<std::byte> bytes_of(const std::exception_ptr& exception) {
    if (!exception) return {};
    try {
        std::rethrow_exception(exception);
    } catch (const Error& error) {
        return bytes_of(error);
    } catch (const std::exception& error) {
        return bytes_of(Error(ErrorCode::wrong_argument, error.what()));
    } catch (...) {
        return bytes_of(Error(ErrorCode::wrong_argument, "an exception of another type was thrown"));
    }
}

Error error_of(std::span<const std::byte> bytes, std::size_t rank) {
    std::array<std::string, 4> texts;
    std::size_t at = 1;
    for (std::string& text : texts) {
        const char* const begin = reinterpret_cast<const char*>(bytes.data()) + at;
        text = std::string(begin, strnlen(begin, bytes.size() - at));
        at = std::min(at + text.size() + 1, bytes.size());
    }
    return Error(static_cast<ErrorCode>(bytes[0]), texts[0], texts[1] + " (rank " + std::to_string(rank) + ")",
                 texts[2], texts[3]);
}

}  // namespace

Group::Group(const Device& device)
    : device_(std::dynamic_pointer_cast<detail::RankDevice>(detail::shared_device(device, "Group"))) {
    if (device_ && device_->ranks().messenger().size() == 1) device_ = nullptr;
}

unsigned Group::rank() const { return device_ ? device_->ranks().messenger().rank() : 0; }
unsigned Group::size() const { return device_ ? device_->ranks().messenger().size() : 1; }

std::vector<std::vector<std::byte>> Group::all_gather(std::span<const std::byte> mine) const {
    if (!device_) return {{mine.begin(), mine.end()}};
    return device_->ranks().messenger().all_gather(mine);
}

void Group::agree(const std::exception_ptr& mine) const {
    if (size() > 1) {
        std::vector<std::byte> bytes = bytes_of(mine);
        const std::uint64_t count = bytes.size();
        std::uint64_t most = 0;
        for (const std::vector<std::byte>& other : all_gather(std::as_bytes(std::span(&count, 1)))) {
            std::uint64_t theirs;
            std::memcpy(&theirs, other.data(), sizeof theirs);
            most = std::max(most, theirs);
        }
        if (most == 0) return;
        bytes.resize(most);
        const std::vector<std::vector<std::byte>> all = all_gather(bytes);
        if (!mine)
            for (std::size_t rank = 0; rank < all.size(); ++rank)
                // An error has four zeros at least, and no rank that has none gives anything else.
                if (std::ranges::any_of(all[rank], [](std::byte byte) { return byte != std::byte{0}; }))
                    throw error_of(all[rank], rank);
    }
    if (mine) std::rethrow_exception(mine);
}

}  // namespace glift::ranks
