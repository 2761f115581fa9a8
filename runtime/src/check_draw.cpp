#include "check_draw.h"

#include "image_layout.h"
#include "objects.h"
#include "report.h"
#include "text.h"

#include <glift/error.h>

namespace glift::detail {

namespace {

[[noreturn]] void wrong(const Kernel& kernel, std::string problem, std::string why = {}, std::string remedy = {}) {
    throw Error(ErrorCode::wrong_argument, std::move(problem), kernel_text(kernel), std::move(why), std::move(remedy));
}

[[noreturn]] void too_large(const DeviceObject* device, const Kernel& kernel, std::string problem,
                            const std::string& given, const std::string& allowed, std::string remedy) {
    throw Error(ErrorCode::too_large, std::move(problem), kernel_text(kernel),
                given + "; " + device->properties().name + " allows " + allowed, std::move(remedy));
}

std::string pixels_text(uint2 extent) { return std::to_string(extent.x) + " x " + std::to_string(extent.y); }

/// Whether origin + extent <= limit, without overflow.
bool fits(uint origin, uint extent, std::uint32_t limit) { return origin <= limit && extent <= limit - origin; }

void check_target(const DeviceObject* device, const Kernel& kernel, const char* name, Format format,
                  const Attachment& target, const DrawTargets& targets) {
    const std::string what = std::string("target ") + name;
    if (!target.memory) wrong(kernel, what + " is an empty memory handle", {}, "pass an image of the device");
    const MemoryObject& object = *target.memory.object();
    const MemoryDescription& d = object.description();
    if (object.device().get() != device)
        wrong(kernel, what + " is of another device", memory_text(d), "allocate it on the device that draws");
    if (d.kind != MemoryKind::image2d && d.kind != MemoryKind::imagecube && d.kind != MemoryKind::image2darray)
        wrong(kernel, what + " is no 2-D image", memory_text(d),
              "draw to a 2-D image, to a layer or to a face of a cube");
    if (object.is_replaced()) throw_given_up(object, std::string(kernel_text(kernel)) + ", " + what);
    if (d.format != format)
        wrong(kernel, what + " has another texel format than the kernel draws", memory_text(d),
              "pass an image of the target's format");
    if (target.mip >= d.mips || target.face >= face_count(d))
        wrong(kernel, what + " has no such level or face", memory_text(d));
    const MemoryDescription& whole = object.whole() ? object.whole()->description() : d;
    const uint2 size(whole.extent[0], whole.extent[1]), most = device->draw_limits().target;
    if (size.x > most.x || size.y > most.y)
        too_large(device, kernel, what + " is larger than the device can draw to", pixels_text(size) + " pixels",
                  pixels_text(most), "draw to smaller images, or store to this one");
    const auto extent = mip_extent(d, target.mip);
    if (!fits(targets.origin.x, targets.extent.x, extent[0]) || !fits(targets.origin.y, targets.extent.y, extent[1]))
        wrong(kernel, "the viewport lies outside of " + what,
              pixels_text(targets.extent) + " pixels from (" + std::to_string(targets.origin.x) + ", " +
                  std::to_string(targets.origin.y) + ") on; " + memory_text(d),
              "draw to a range of the target");
}

/// Calls `visit(name, attachment)` for each target.
template <class Visit> void for_each_target(const Drawing& drawing, const DrawTargets& targets, Visit&& visit) {
    for (std::size_t k = 0; k < targets.colours.size(); ++k) visit(drawing.colours[k].name, targets.colours[k]);
    if (drawing.depth) visit(drawing.depth, targets.depth);
}

void check_apart(const Kernel& kernel, const Call& call) {
    const DrawTargets& targets = *call.targets;
    const auto refuse = [&](const char* target, const char* other) {
        throw Error(ErrorCode::aliased_memory, "an image that is drawn to was passed a second time in one call",
                    kernel_text(kernel), std::string("it is target ") + target + " and " + other,
                    "read a copy, or draw to another image, level or face");
    };
    const auto same = [](const Attachment& a, const Attachment& b) {
        const bool is_one = a.memory.object() == b.memory.object();
        return is_one ? a.mip == b.mip && a.face == b.face : shares_texels(a.memory.object(), b.memory.object());
    };
    for_each_target(*kernel.drawing, targets, [&](const char* name, const Attachment& target) {
        for (std::size_t k = 0; k < call.memories.size(); ++k)
            if (shares_texels(call.memories[k].object(), target.memory.object())) refuse(name, kernel.bindings[k].name);
        for_each_target(*kernel.drawing, targets, [&](const char* other, const Attachment& second) {
            if (&second != &target && same(target, second)) refuse(name, other);
        });
    });
}

}  // namespace

void check_draw(const DeviceObject* device, const Kernel& kernel, const Call& call) {
    if (!kernel.drawing) {
        if (call.targets) wrong(kernel, "targets were passed to a kernel that does not draw");
        return;
    }
    if (!call.targets) wrong(kernel, "a kernel that draws was called without targets");
    const Drawing& drawing = *kernel.drawing;
    const DrawTargets& targets = *call.targets;
    if (targets.colours.size() != drawing.colours.size())
        wrong(kernel, "the number of targets does not fit the kernel",
              "it draws to " + std::to_string(drawing.colours.size()) + ", given " +
                  std::to_string(targets.colours.size()));
    const DrawLimits limits = device->draw_limits();
    if (drawing.colours.size() > limits.colours)
        too_large(device, kernel, "the kernel draws to more targets than the device has at once",
                  std::to_string(drawing.colours.size()) + " colour targets", std::to_string(limits.colours),
                  "draw to some of them at a time, by several kernels");
    for (std::size_t k = 0; k < drawing.colours.size(); ++k)
        check_target(device, kernel, drawing.colours[k].name, drawing.colours[k].format, targets.colours[k], targets);
    if (drawing.depth) check_target(device, kernel, drawing.depth, Format::d32, targets.depth, targets);
    if (targets.extent.x > limits.viewport.x || targets.extent.y > limits.viewport.y)
        too_large(device, kernel, "a viewport is larger than the device allows",
                  pixels_text(targets.extent) + " pixels", pixels_text(limits.viewport),
                  "draw in parts: to ranges of the targets");
    check_apart(kernel, call);
}

}  // namespace glift::detail
