// Interned identifiers: comparing two names is comparing two numbers.
#pragma once

#include <compare>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace gliftc {

/// An interned identifier; the default Name is the empty one.
struct Name {
    std::uint32_t index = 0;
    explicit operator bool() const { return index != 0; }
    auto operator<=>(const Name&) const = default;
};

/// Owns the text of all names of one compilation. Every identifier of the source passes through intern(), so it has its
/// own table: open addressing, never more than half full.
class Names {
public:
    Names() : slots_(1024) { intern(""); }

    Name intern(std::string_view text) {
        std::uint32_t hash = hash_of(text);
        std::size_t mask = slots_.size() - 1;
        for (std::size_t i = hash & mask;; i = (i + 1) & mask) {
            Slot& slot = slots_[i];
            if (slot.index == empty) {
                auto index = static_cast<std::uint32_t>(texts_.size());
                slot = {hash, index};
                texts_.emplace_back(text);
                if (texts_.size() * 2 > slots_.size()) grow();
                return {index};
            }
            if (slot.hash == hash && texts_[slot.index] == text) return {slot.index};
        }
    }
    const std::string& operator[](Name name) const { return texts_[name.index]; }

private:
    static constexpr std::uint32_t empty = 0xffffffffu;
    struct Slot {
        std::uint32_t hash = 0, index = empty;
    };

    /// FNV-1a with a last mix, since the low bits choose the slot.
    static std::uint32_t hash_of(std::string_view text) {
        std::uint32_t hash = 2166136261u;
        for (char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
        return hash ^ (hash >> 15);
    }

    void grow() {
        std::vector<Slot> before(slots_.size() * 2);
        before.swap(slots_);
        std::size_t mask = slots_.size() - 1;
        for (Slot slot : before) {
            if (slot.index == empty) continue;
            std::size_t i = slot.hash & mask;
            while (slots_[i].index != empty) i = (i + 1) & mask;
            slots_[i] = slot;
        }
    }

    std::deque<std::string> texts_;
    std::vector<Slot> slots_;
};

}  // namespace gliftc

template <> struct std::hash<gliftc::Name> {
    std::size_t operator()(gliftc::Name name) const noexcept { return name.index; }
};
