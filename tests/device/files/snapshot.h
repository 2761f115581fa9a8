// All that a structure consists of, as bytes: to compare structures, and to fill them at random.
#pragma once

#include <glift/files/collect.h>

#include <map>
#include <random>
#include <string>
#include <vector>

namespace snapshot {

/// By the path of each field of a value or memory.
using Snapshot = std::map<std::string, std::vector<std::byte>>;

Snapshot of(const glift::files::Part& part, const glift::Device& device);
/// Fills all memories of a structure; bools are 0 or 1, depths from 0 to 1.
void fill_at_random(const glift::files::Part& part, const glift::Device& device, std::uint32_t seed);

template <class S> Snapshot of(const S& structure) {
    S shared = structure;
    return of(glift::files::part_of(shared, "", glift::files::Role::root), shared.device());
}
template <class S> void fill_at_random(const S& structure, std::uint32_t seed) {
    S shared = structure;
    fill_at_random(glift::files::part_of(shared, "", glift::files::Role::root), shared.device(), seed);
}

/// The first path at which two snapshots differ; empty: none.
std::string difference(const Snapshot& a, const Snapshot& b);

}  // namespace snapshot
