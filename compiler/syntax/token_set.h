// Sets of token kinds and of contextual keywords, for questions like "can this begin a declaration?".
#pragma once

#include "syntax/token.h"

#include <initializer_list>

namespace gliftc {

/// A set of values of an enum with at most 128 of them.
template <class Enum> class EnumSet {
public:
    constexpr EnumSet(std::initializer_list<Enum> members) {
        for (Enum member : members) bits_[half(member)] |= bit(member);
    }
    constexpr bool has(Enum value) const { return (bits_[half(value)] & bit(value)) != 0; }

private:
    static constexpr std::size_t half(Enum value) { return static_cast<std::size_t>(value) / 64; }
    static constexpr std::uint64_t bit(Enum value) { return std::uint64_t{1} << (static_cast<unsigned>(value) % 64); }
    std::uint64_t bits_[2] = {};
};

using TokenSet = EnumSet<TokenKind>;
using WordSet = EnumSet<Word>;

}  // namespace gliftc
