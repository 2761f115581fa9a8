// Settings of glibc's malloc that suit gliftc.
#pragma once

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gliftc {

/// Makes malloc extend the first thread's heap in steps of 32 MiB, begin each heap of other threads with 32 MiB, keep
/// up to 1 GiB of free memory at a heap's end, and serve blocks of less than 32 MiB from heaps. A run of gliftc is
/// short, so memory need not go back to the system. With glibc's defaults a heap of another thread begins with
/// 132 KiB and then grows by the few pages that each request needs: thousands of system calls, which the kernel
/// serialises. With these settings such a heap grows in the same way, but only beyond its first 32 MiB.
inline void grow_heap_in_large_steps() {
#ifdef __GLIBC__
    mallopt(M_TOP_PAD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
#endif
}

}  // namespace gliftc
