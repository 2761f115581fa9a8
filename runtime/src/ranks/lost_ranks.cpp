#include <glift/ranks/lost_ranks.h>

#include <glift/error.h>

#include <algorithm>
#include <cstdio>

namespace glift::detail {

void throw_lost_ranks(const ranks::Transport& transport, std::vector<unsigned> silent,
                      const std::function<int(unsigned rank)>& waits_for, ranks::Transport::Seconds limit) {
    for (unsigned& rank : silent) {
        for (unsigned steps = 0; steps < transport.size(); ++steps) {
            const int next = waits_for(rank);
            if (next < 0 || static_cast<unsigned>(next) == transport.rank()) break;
            rank = static_cast<unsigned>(next);
        }
    }
    std::ranges::sort(silent);
    const auto repeated = std::unique(silent.begin(), silent.end());
    silent.erase(repeated, silent.end());
    std::string names;
    for (unsigned rank : silent)
        names += (names.empty() ? "rank " : ", rank ") + std::to_string(rank) + " (" + transport.name_of(rank) + ")";
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%g", limit.count());
    throw Error(ErrorCode::lost_rank, "another rank does not answer",
                "rank " + std::to_string(transport.rank()) + " waits for " + names,
                std::string("nothing came for ") + seconds +
                    " s: it hangs, has ended, or does not make the same calls in the same order",
                "see what it does (a debugger, its output); a longer limit is set by GLIFT_RANKS_TIMEOUT, in seconds");
}

}  // namespace glift::detail
