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

/// The texts of all names of one compilation. Owns them, except those of a table that it extends. Since every
/// identifier of the source passes through intern(), the hash table is a fast one: open addressing, never more than
/// half full.
class Names {
public:
    Names() : slots_(1024) { intern(""); }
    /// A table that shares the names of `base` and adds its own. The base must outlive the new table, and must not
    /// change until the last name has been added to the new one.
    static Names extending(const Names& base) { return Names(&base); }

    Name intern(std::string_view text) {
        const std::uint32_t hash = hash_of(text);
        if (base_ != nullptr)
            if (const Slot& known = base_->slots_[base_->place(hash, text)]; known.index != empty) return {known.index};
        Slot& slot = slots_[place(hash, text)];
        if (slot.index != empty) return {slot.index};
        const std::uint32_t index = size();
        slot = {hash, index};
        texts_.emplace_back(text);
        if (texts_.size() * 2 > slots_.size()) grow();
        return {index};
    }
    const std::string& operator[](Name name) const {
        return name.index < first_ ? (*base_)[name] : texts_[name.index - first_];
    }
    std::uint32_t size() const { return first_ + static_cast<std::uint32_t>(texts_.size()); }

private:
    explicit Names(const Names* base) : base_(base), first_(base->size()), slots_(256) {}

    static constexpr std::uint32_t empty = 0xffffffffu;
    struct Slot {
        std::uint32_t hash = 0, index = empty;
    };

    /// FNV-1a with a final mix, since the low bits choose the slot.
    static std::uint32_t hash_of(std::string_view text) {
        std::uint32_t hash = 2166136261u;
        for (char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
        return hash ^ (hash >> 15);
    }

    /// The index of the slot that holds the text, or of the free one where it belongs.
    std::size_t place(std::uint32_t hash, std::string_view text) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t i = hash & mask;
        while (slots_[i].index != empty && !(slots_[i].hash == hash && (*this)[{slots_[i].index}] == text))
            i = (i + 1) & mask;
        return i;
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

    const Names* base_ = nullptr;
    std::uint32_t first_ = 0;        ///< index of the first name that is not in `base_`
    std::deque<std::string> texts_;  ///< of the names from first_ on
    std::vector<Slot> slots_;
};

}  // namespace gliftc

template <> struct std::hash<gliftc::Name> {
    std::size_t operator()(gliftc::Name name) const noexcept { return name.index; }
};
