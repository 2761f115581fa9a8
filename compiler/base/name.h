// Interned identifiers: comparing two names is comparing two numbers.
#pragma once

#include <compare>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace gliftc {

/// An interned identifier; the default Name is the empty one.
struct Name {
    std::uint32_t index = 0;
    explicit operator bool() const { return index != 0; }
    auto operator<=>(const Name&) const = default;
};

/// Owns the text of all names of one compilation.
class Names {
public:
    Names() { intern(""); }

    Name intern(std::string_view text) {
        if (auto found = index_.find(text); found != index_.end()) return {found->second};
        texts_.emplace_back(text);
        auto index = static_cast<std::uint32_t>(texts_.size() - 1);
        index_.emplace(texts_.back(), index);
        return {index};
    }
    const std::string& operator[](Name name) const { return texts_[name.index]; }

private:
    std::deque<std::string> texts_;
    std::unordered_map<std::string_view, std::uint32_t> index_;
};

}  // namespace gliftc

template <>
struct std::hash<gliftc::Name> {
    std::size_t operator()(gliftc::Name name) const noexcept { return name.index; }
};
