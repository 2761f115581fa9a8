#include "algorithm_twins.h"

#include "compact.h"
#include "digit_counts.h"
#include "digit_scatter.h"
#include "kept_bits.h"
#include "scan.h"
#include "scan_sums.h"
#include "tile_sums.h"

#include <algorithm>
#include <bit>
#include <span>

namespace bench {

namespace {

using glift::Access;

constexpr glift::Binding buffer(const char* name, Access access) {
    return {.name = name, .kind = glift::MemoryKind::buffer, .access = access};
}

constexpr glift::Binding tile_sums_bindings[] = {buffer("x", Access::read), buffer("sums", Access::write)};
constexpr glift::Binding scan_sums_bindings[] = {buffer("sums", Access::read_write)};
constexpr glift::Binding scan_bindings[] = {buffer("x", Access::read), buffer("sums", Access::read),
                                            buffer("y", Access::write)};
constexpr glift::Binding kept_bits_bindings[] = {buffer("x", Access::read), buffer("sums", Access::write),
                                                 buffer("bits", Access::write)};
constexpr glift::Binding compact_bindings[] = {buffer("x", Access::read), buffer("sums", Access::read),
                                               buffer("bits", Access::read), buffer("y", Access::write),
                                               buffer("kept", Access::write)};
constexpr glift::Binding digit_counts_bindings[] = {buffer("x", Access::read), buffer("counts", Access::write)};
constexpr glift::Binding digit_scatter_bindings[] = {buffer("x", Access::read), buffer("offsets", Access::read),
                                                     buffer("y", Access::write)};

// Constants that have to agree with the shaders, where `scan_items` is `steps` uvec4 (4 elements each) and
// `compact_items` is `steps` words of 32 bits (a bit for each element).
constexpr std::uint32_t group = 64, scan_items = 64, compact_items = 256, digits = 256, digit_bits = 8;
constexpr std::uint32_t smallest_chunk = 512, largest_chunk = 4096;

const glift::Kernel tile_sums_kernel = {.name = "sums of tiles by hand",
                                        .file = "tile_sums.comp",
                                        .line = 1,
                                        .rank = 1,
                                        .group = {group, 1, 1},
                                        .loop_rounds = 128,
                                        .bindings = tile_sums_bindings,
                                        .direct = {.spirv = tile_sums, .parameter_bytes = 4, .push_constants = true},
                                        .items = scan_items};
const glift::Kernel scan_sums_kernel = {.name = "scan of sums by hand",
                                        .file = "scan_sums.comp",
                                        .line = 1,
                                        .rank = 1,
                                        .group = {256, 1, 1},
                                        .loop_rounds = 8192,  // enough for 2^25 elements (lavapipe's largest binding)
                                        .bindings = scan_sums_bindings,
                                        .direct = {.spirv = scan_sums, .parameter_bytes = 4, .push_constants = true}};
const glift::Kernel scan_kernel = {.name = "scan by hand",
                                   .file = "scan.comp",
                                   .line = 1,
                                   .rank = 1,
                                   .group = {group, 1, 1},
                                   .loop_rounds = 128,
                                   .bindings = scan_bindings,
                                   .direct = {.spirv = scan, .parameter_bytes = 4, .push_constants = true},
                                   .items = scan_items};
const glift::Kernel kept_bits_kernel = {.name = "bits of what is kept by hand",
                                        .file = "kept_bits.comp",
                                        .line = 1,
                                        .rank = 1,
                                        .group = {group, 1, 1},
                                        .loop_rounds = 512,
                                        .bindings = kept_bits_bindings,
                                        .direct = {.spirv = kept_bits, .parameter_bytes = 4, .push_constants = true},
                                        .items = compact_items};
const glift::Kernel compact_kernel = {.name = "compaction by hand",
                                      .file = "compact.comp",
                                      .line = 1,
                                      .rank = 1,
                                      .group = {group, 1, 1},
                                      .loop_rounds = 512,
                                      .bindings = compact_bindings,
                                      .direct = {.spirv = compact, .parameter_bytes = 8, .push_constants = true},
                                      .items = compact_items};
const glift::Kernel digit_counts_kernel = {
    .name = "counts of digits by hand",
    .file = "digit_counts.comp",
    .line = 1,
    .rank = 1,
    .group = {group, 1, 1},
    .loop_rounds = 1024,
    .bindings = digit_counts_bindings,
    .direct = {.spirv = digit_counts, .parameter_bytes = 16, .push_constants = true}};
const glift::Kernel digit_scatter_kernel = {
    .name = "scatter by digits by hand",
    .file = "digit_scatter.comp",
    .line = 1,
    .rank = 1,
    .group = {group, 1, 1},
    .loop_rounds = 1024,
    .bindings = digit_scatter_bindings,
    .direct = {.spirv = digit_scatter, .parameter_bytes = 16, .push_constants = true}};

template <class Block, std::size_t n> void dispatch(const glift::Commands& commands, const glift::Kernel& kernel,
                                                    const Block& block, const glift::Memory (&memories)[n],
                                                    std::uint32_t size) {
    commands.dispatch(kernel, {.form = glift::FormName::direct,
                               .memories = memories,
                               .parameters = std::as_bytes(std::span(&block, 1)),
                               .size = {size, 1, 1, 1}});
}

constexpr std::uint32_t rounded_up(std::uint32_t value, std::uint32_t step) { return (value + step - 1) / step * step; }

/// A memory that need not be zeroed, since the first pass to use it writes it.
glift::Memory scratch(const glift::Device& device, const char* name, std::uint64_t words) {
    return device.allocate({.name = name, .bytes = 4 * words, .zeroed = false});
}

/// How many keys one lane counts and moves in sequence: the power of two that gives 512 to 1026 lanes work, but at
/// least `smallest_chunk`, so that the table of counts stays small, and at most `largest_chunk`, so that the addresses
/// that neighbouring lanes read at the same time are close together.
std::uint32_t chunk_size(std::uint32_t count) {
    return std::clamp(std::bit_ceil(count / 1024), smallest_chunk, largest_chunk);
}

std::uint32_t chunks_of(std::uint32_t count) { return (count + chunk_size(count) - 1) / chunk_size(count); }

/// The size of a table of counts that is enough for any number of keys up to `most`. Fewer keys may have more chunks
/// than `most` keys: up to 1026, while the size of chunks still grows with the number of keys, in powers of two.
std::uint32_t most_counts(std::uint32_t most) {
    return digits * std::max(chunks_of(most), std::min(2048u, most / smallest_chunk + 1));
}

}  // namespace

ScanTwin::ScanTwin(const glift::Device& device, std::uint32_t most)
    : tile_(device.properties().subgroup_size * scan_items), sums_(scratch(device, "sums", most / tile_ + 2)) {}

void ScanTwin::record(const glift::Commands& commands, const glift::Memory& x, const glift::Memory& y,
                      std::uint32_t count) const {
    if (count == 0) return;
    dispatch(commands, tile_sums_kernel, count, {x, sums_}, count);
    dispatch(commands, scan_sums_kernel, rounded_up(count, tile_) / tile_, {sums_}, 1);
    dispatch(commands, scan_kernel, count, {x, sums_, y}, count);
}

CompactTwin::CompactTwin(const glift::Device& device, std::uint32_t most)
    : tile_(device.properties().subgroup_size * compact_items), sums_(scratch(device, "sums", most / tile_ + 2)),
      bits_(scratch(device, "bits", rounded_up(most, tile_) / 32 + 1)) {}

void CompactTwin::record(const glift::Commands& commands, const glift::Memory& x, const glift::Memory& y,
                         const glift::Memory& kept, std::uint32_t count) const {
    if (count == 0) {
        commands.fill(kept, 0, 4);
        return;
    }
    const std::uint32_t tiles = rounded_up(count, tile_) / tile_;
    const std::uint32_t block[] = {count, tiles};
    dispatch(commands, kept_bits_kernel, count, {x, sums_, bits_}, count);
    dispatch(commands, scan_sums_kernel, tiles, {sums_}, 1);
    dispatch(commands, compact_kernel, block, {x, sums_, bits_, y, kept}, count);
}

RadixSortTwin::RadixSortTwin(const glift::Device& device, std::uint32_t most)
    : half_sorted_(scratch(device, "half_sorted", most)), counts_(scratch(device, "counts", most_counts(most))),
      offsets_(scratch(device, "offsets", most_counts(most))), scan_(device, most_counts(most)) {}

void RadixSortTwin::record(const glift::Commands& commands, const glift::Memory& x, const glift::Memory& y,
                           std::uint32_t count) const {
    const std::uint32_t chunks = chunks_of(count);
    const glift::Memory* from = &x;
    for (std::uint32_t shift = 0; shift < 32; shift += digit_bits) {
        const std::uint32_t block[] = {count, chunks, chunk_size(count), shift};
        const glift::Memory& to = from == &half_sorted_ ? y : half_sorted_;
        dispatch(commands, digit_counts_kernel, block, {*from, counts_}, chunks);
        scan_.record(commands, counts_, offsets_, digits * chunks);
        dispatch(commands, digit_scatter_kernel, block, {*from, offsets_, to}, chunks);
        from = &to;
    }
}

}  // namespace bench
