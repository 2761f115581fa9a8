#include "host_targets.h"

#include "../image_layout.h"
#include "host_memory.h"

namespace glift::detail {

namespace {

HostTargets::Texels texels_of(const Attachment& attachment, uint2 origin) {
    const MemoryDescription& d = attachment.memory.description();
    const std::size_t texel = texel_bytes(d.format), row = mip_extent(d, attachment.mip)[0] * texel;
    std::byte* level = host_memory(attachment.memory).data() + mip_offset(d, attachment.mip) +
                       attachment.face * face_bytes(d, attachment.mip);
    return {level + origin.y * row + origin.x * texel, row};
}

}  // namespace

HostTargetViews::HostTargetViews(const Kernel& kernel, const DrawTargets& targets) {
    for (const Attachment& colour : targets.colours) colours_.push_back(texels_of(colour, targets.origin));
    targets_ = {colours_, {}, targets.origin, targets.extent};
    if (kernel.drawing->depth) targets_.depth = texels_of(targets.depth, targets.origin);
}

}  // namespace glift::detail
