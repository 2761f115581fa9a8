// Hand-written GLSL versions ("twins") of stdlib/algorithms, tuned for lavapipe, correct on every device with full
// subgroups of one size. No workgroup waits for another.
//
// What was tried, in millions of u32 per second: twice the elements divided by the CPU time of both threads, so that
// the load of other programs does not count; lavapipe 22.3 on 2 Sapphire Rapids threads, 2^24 elements (sort: 2^22).
// "taken": the variant that the shaders have.
//
//   copy, one uvec4 per invocation                                   930   the limit: an element takes 0.9 ns of CPU
//                                                                          time to read, 1.3 ns to write
//   scan, each lane has 64 consecutive elements, shared memory       455
//     the same, the lanes' sums stored by the first pass             534 to 600
//     no shared memory or barrier, one tile per subgroup             566
//     the same, neighbouring lanes read neighbouring uvec4:
//       16, 32, 64, 96, 128, 256 elements per lane     545, 631, 661 (taken), 585, 558, 662
//       workgroups of 256 in place of 64                             the same
//     elements loaded or stored in pairs as uint64_t                 10 % slower if loaded so, 40 % if stored so
//   compact, 1 in 8 kept: as the scan, both passes read all elements 376, 426 with 256 elements per lane
//     one bit per element, elements read again row by row            269 to 372
//     a word of 32 bits per lane and step, kept elements read again one by one:
//       1, 2, 4, 8, 16 words per lane                  643, 640, 688, 706 (taken), 707
//     the words of a lane are consecutive                            612 to 726, by their number
//   radix sort, 256 counters per lane in registers (that is, on the stack), 2048 keys per lane:
//     16 keys loaded at once                                         77 (taken)
//     4 keys loaded at once                                          69
//     counters in a buffer                                           26
//     digits of 6, 7 and 11 bits in place of 8                       57, 64, 65 (8 bits in the same run, with other
//                                                                    load on the machine: 65)
//     1024, 2048, 4096, 8192, 16384 keys per lane                    44, 65, 66, 64, 57 (in the same run)
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
