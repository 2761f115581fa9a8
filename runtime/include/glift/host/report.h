// What the host kernels of a checked build call (gliftc --checked).
#pragma once

#include <glift/host/atomic_ref.h>
#include <glift/kernel.h>
#include <glift/vector.h>

namespace glift::host {

/// Reports in call.status that the virtual `address`, of `rank` axes, lies outside a structure; line, file and binding
/// are those of `record`. Only the pass's first report is kept.
inline void report_outside(const HostCall& call, const StatusRecord& record, const uint* address, uint rank) {
    std::uint32_t fine = StatusRecord::fine;
    if (!AtomicRef(call.status->code).compare_exchange(fine, StatusRecord::out_of_range)) return;
    call.status->line = record.line;
    call.status->file = record.file;
    call.status->binding = record.binding;
    call.status->rank = rank;
    for (uint axis = 0; axis < rank; ++axis) call.status->address[axis] = address[axis];
}
inline void report_outside(const HostCall& call, const StatusRecord& record, uint address) {
    report_outside(call, record, &address, 1);
}
template <unsigned N>
void report_outside(const HostCall& call, const StatusRecord& record, const vec<uint, N>& address) {
    uint parts[N];
    for (unsigned axis = 0; axis < N; ++axis) parts[axis] = address[axis];
    report_outside(call, record, parts, N);
}

}  // namespace glift::host
