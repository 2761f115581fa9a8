// What the host kernels of `print` and `assert` call.
#pragma once

#include <glift/host/atomic_ref.h>
#include <glift/kernel.h>
#include <glift/vector.h>

#include <algorithm>
#include <initializer_list>

namespace glift::host {

/// Appends a message, with this number in Kernel::messages, to the buffer of the call.
inline void print(const HostCall& call, uint message, std::initializer_list<uint> words) {
    MessageHeader& header = *call.messages;
    const uint count = static_cast<uint>(words.size()) + 1;
    if (AtomicRef(header.used).load(__ATOMIC_RELAXED) < header.capacity) {
        const uint at = AtomicRef(header.used).fetch_add(count, __ATOMIC_RELAXED);
        if (at <= header.capacity && count <= header.capacity - at) {
            uint* const first = reinterpret_cast<uint*>(&header + 1) + at;
            *first = message + 1;
            std::copy(words.begin(), words.end(), first + 1);
            return;
        }
    }
    if (AtomicRef(header.lost).fetch_add(1, __ATOMIC_RELAXED) == UINT32_MAX)
        AtomicRef(header.lost_high).fetch_add(1, __ATOMIC_RELAXED);
}

}  // namespace glift::host
