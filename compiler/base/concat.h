// Text of several parts, made at once: with + every part that does not fit moves what stands before it.
#pragma once

#include <string>
#include <string_view>

namespace gliftc {

template <class... Parts> std::string concat(const Parts&... parts) {
    std::string text;
    text.reserve((std::string_view(parts).size() + ...));
    (text.append(std::string_view(parts)), ...);
    return text;
}

}  // namespace gliftc
