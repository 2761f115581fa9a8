// The error for ranks that do not answer, which every Transport throws.
#pragma once

#include <glift/ranks/transport.h>

#include <functional>
#include <vector>

namespace glift::detail {

/// Throws lost_rank, with the numbers and the names of the ranks that did not answer for `limit`. `waits_for` says for
/// which rank a rank waits itself, -1: none is known; then that rank is named instead.
[[noreturn]] GLIFT_API void throw_lost_ranks(const ranks::Transport& transport, std::vector<unsigned> silent,
                                             const std::function<int(unsigned rank)>& waits_for,
                                             ranks::Transport::Seconds limit);

}  // namespace glift::detail
