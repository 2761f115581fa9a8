// Targets of draws on the host device: as its kernels access them, and as recordings keep them.
#pragma once

#include <glift/pass.h>

#include <utility>
#include <vector>

namespace glift::detail {

/// Where the texels of a call's targets lie. `targets()` is valid while this object lives.
class HostTargetViews {
public:
    HostTargetViews(const Kernel& kernel, const DrawTargets& targets);
    HostTargetViews(const HostTargetViews&) = delete;

    const HostTargets& targets() const { return targets_; }

private:
    std::vector<HostTargets::Texels> colours_;
    HostTargets targets_;
};

/// A copy of a call's targets, for calls that are recorded.
class KeptTargets {
public:
    KeptTargets(std::vector<Attachment> colours, Attachment depth, uint2 origin, uint2 extent)
        : colours_(std::move(colours)), depth_(std::move(depth)), origin_(origin), extent_(extent) {}
    DrawTargets targets() const { return {colours_, depth_, origin_, extent_}; }

private:
    std::vector<Attachment> colours_;
    Attachment depth_;
    uint2 origin_, extent_;
};

}  // namespace glift::detail
