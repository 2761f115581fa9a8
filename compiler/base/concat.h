// Concatenates strings with one allocation; a chain of + reallocates.
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
