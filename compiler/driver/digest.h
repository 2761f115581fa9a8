// A hash of texts for keys of caches.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace gliftc {

/// A hash of a sequence of texts, of 128 bits: 64-bit FNV-1a from two offset bases. Not cryptographic.
class Digest {
public:
    void add(std::string_view text) {
        for (unsigned char c : text) {
            a_ = (a_ ^ c) * prime;
            b_ = (b_ ^ c) * prime;
        }
        a_ = (a_ ^ 0x100) * prime;  // an end mark: {"ab", "c"} and {"a", "bc"} differ
        b_ = (b_ ^ 0x100) * prime;
    }
    std::string digits() const {
        char text[33];
        std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(a_),
                      static_cast<unsigned long long>(b_));
        return text;
    }

private:
    static constexpr std::uint64_t prime = 0x100000001b3u;
    std::uint64_t a_ = 0xcbf29ce484222325u, b_ = 0x84222325cbf29ce4u;
};

}  // namespace gliftc
