// How gliftc has its memory from the kernel.
#pragma once

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gliftc {

/// In large pieces that it keeps: a run is short. The GNU C library would ask for four kilobytes at a time in all
/// threads but the first, thousands of times where there are many kernels, and the kernel lets one thread ask at a
/// time.
inline void take_memory_in_large_pieces() {
#ifdef __GLIBC__
    mallopt(M_TOP_PAD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
#endif
}

}  // namespace gliftc
