#include "cuts.h"

#include <algorithm>

namespace glift::detail {

Cuts::Cuts(std::uint32_t planes, unsigned ranks) {
    const std::uint32_t step = planes / ranks >= 32 ? 8 : 1;
    for (std::uint64_t rank = 0; rank < ranks; ++rank)
        cuts_.push_back(static_cast<std::uint32_t>((planes * rank / ranks + step / 2) / step * step));
    cuts_.push_back(planes);
}

Cuts::Cuts(std::span<const std::uint64_t> before, unsigned ranks) {
    const auto planes = static_cast<std::uint32_t>(before.size() - 1);
    const std::uint64_t all = before.back();
    cuts_.push_back(0);
    for (unsigned rank = 1; rank < ranks; ++rank) {
        const std::uint64_t wanted = all * rank / ranks;
        auto at = static_cast<std::uint32_t>(std::lower_bound(before.begin(), before.end(), wanted) - before.begin());
        if (at > 0 && wanted - before[at - 1] < before[at] - wanted) --at;
        cuts_.push_back(std::clamp(at, cuts_.back(), planes));
    }
    cuts_.push_back(planes);
}

unsigned Cuts::owner(std::uint32_t plane) const {
    return static_cast<unsigned>(std::upper_bound(cuts_.begin() + 1, cuts_.end() - 1, plane) - cuts_.begin() - 1);
}

}  // namespace glift::detail
