// Settings of glibc's malloc that suit gliftc.
#pragma once

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gliftc {

/// Makes malloc take memory from the system in large steps, keep up to 1 GiB of what is freed, and serve blocks of less
/// than 32 MiB from its heaps, since a run is short. By default glibc extends the heaps of all threads but the first by
/// 4 KiB at a time: thousands of system calls, which the kernel serialises.
inline void grow_heap_in_large_steps() {
#ifdef __GLIBC__
    mallopt(M_TOP_PAD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
#endif
}

}  // namespace gliftc
