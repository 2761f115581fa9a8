// The error for ranks that do not answer, which every Transport throws.
#pragma once

#include <glift/ranks/transport.h>

#include <vector>

namespace glift::detail {

/// Throws lost_rank, with the numbers and the names of the ranks that did not answer for `limit`.
[[noreturn]] GLIFT_API void throw_lost_ranks(const ranks::Transport& transport, std::vector<unsigned> silent,
                                             ranks::Transport::Seconds limit);

}  // namespace glift::detail
