// Hand-written GLSL versions ("twins") of stdlib/algorithms, tuned for lavapipe, correct on every device with full
// subgroups of one size. No workgroup waits for another.
//
// What was tried, in millions of u32 a second: twice the elements divided by the CPU time of both threads, so that the
// load of other programs does not count; lavapipe 22.3 on 2 Sapphire Rapids threads, 2^24 elements (sort: 2^22).
// "taken": the variant that the shaders have.
//
//   copy, uvec4 an invocation                                        930   the limit: a read is 0.9 ns, a write 1.3
//   scan, a lane has 64 elements in sequence, shared memory          455
//     the same, lanes' sums kept in the first pass                   534 to 600
//     no shared memory or barrier, a tile each subgroup              566
//     the same, neighbouring lanes read neighbouring uvec4:
//       16, 32, 64, 96, 128, 256 elements a lane       545, 631, 661 (taken), 585, 558, 662
//       workgroups of 256 in place of 64                             the same
//     elements loaded and stored in pairs as uint64_t                10 % less where loaded, 40 % where stored
//   compact, 1 in 8 kept: as the scan, elements read twice           376, 426 with 256 elements a lane
//     a bit each, read again row by row                              269 to 372
//     a word of 32 bits a lane, kept elements taken one by one:
//       1, 2, 4, 8, 16 words a lane                    643, 640, 688, 706 (taken), 707
//     a lane takes its words as one sequence                         612 to 726, by their number
//   radix sort, 256 counters a lane in registers (that is, on the stack), 2048 keys a lane: 16 keys at once 77 (taken),
//   4: 69
//     counters in a buffer                                           26
//     digits of 6, 7 and 11 bits in place of 8                       57, 64, 65 (8: 65 in the same, loaded, run)
//     1024, 2048, 4096, 8192, 16384 keys a lane                      44, 65, 66, 64, 57 (the same run)
//
// On a GPU, a workgroup should sort its keys in shared memory; there the baseline is CUB (bench/cuda).
#pragma once

#include <glift/glift.h>

#include <cstdint>

namespace bench {

/// Exclusive scan: y[i] = x[0] + .. + x[i - 1], modulo 2^32.
class ScanTwin {
public:
    ScanTwin(const glift::Device& device, std::uint32_t most);  ///< for at most `most` elements, below 2^31
    void record(const glift::Commands& commands, const glift::Memory& x, const glift::Memory& y,
                std::uint32_t count) const;

private:
    std::uint32_t tile_;  ///< elements that one subgroup scans
    glift::Memory sums_;
};

/// Compaction: writes the multiples of 8 of x, in their order, to y, and their number to `kept`.
class CompactTwin {
public:
    CompactTwin(const glift::Device& device, std::uint32_t most);
    void record(const glift::Commands& commands, const glift::Memory& x, const glift::Memory& y,
                const glift::Memory& kept, std::uint32_t count) const;

private:
    std::uint32_t tile_;
    glift::Memory sums_, bits_;
};

/// Sorts x in ascending order into y.
class RadixSortTwin {
public:
    RadixSortTwin(const glift::Device& device, std::uint32_t most);
    void record(const glift::Commands& commands, const glift::Memory& x, const glift::Memory& y,
                std::uint32_t count) const;

private:
    glift::Memory half_sorted_, counts_, offsets_;
    ScanTwin scan_;
};

}  // namespace bench
