#include <glift/draw_iteration.h>

#include <algorithm>
#include <string>

namespace glift {

namespace {

std::string place_of(const Kernel& kernel) {
    return std::string(kernel.file) + ":" + std::to_string(kernel.line) + ": " + kernel.name;
}

[[noreturn]] void throw_differ(const Kernel& kernel, const char* what, const std::string& a, const std::string& b,
                               const char* remedy) {
    throw Error(ErrorCode::wrong_argument, what, place_of(kernel), a + " and " + b, remedy);
}

std::string size_text(const detail::Box& box) { return box.name + (" is " + detail::text_of(box.size, box.rank)); }

std::string origin_text(const detail::Box& box) {
    return box.name + (" begins at " + detail::text_of(box.origin, box.rank));
}

}  // namespace

void DrawIteration::add_counted(std::size_t axis, const detail::Box& box, bool is_whole,
                                const std::vector<detail::DeviceCount>& counts) {
    if (!box.is_inside()) detail::throw_outside(place_of(kernel_), box);
    Axis& of = axes_[axis];
    if (of.is_given && of.box.size != box.size)
        throw_differ(kernel_,
                     axis == 0 ? "ranges of corners of different sizes" : "ranges of instances of different sizes",
                     size_text(of.box), size_text(box), "pass ranges of one size");
    if (!of.is_given) of.box = box;
    of.is_given = true;
    whole_ = whole_ && is_whole;
    for (const detail::DeviceCount& count : counts)
        if (std::ranges::find(of.counts, count) == of.counts.end()) of.counts.push_back(count);
}

void DrawIteration::add_any(const detail::Box& box, bool is_whole) {
    if (!is_whole && !box.is_inside()) detail::throw_outside(place_of(kernel_), box);
    whole_ = whole_ && is_whole;
}

void DrawIteration::add_pixels(const detail::Box& box, bool is_whole, const std::vector<detail::DeviceCount>& counts) {
    if (!box.is_inside()) detail::throw_outside(place_of(kernel_), box);
    if (!counts.empty())
        throw Error(ErrorCode::wrong_argument, "pixels that are counted on the device", place_of(kernel_), box.name,
                    "pass a range whose size the host knows: await the number first");
    if (has_pixels_ && pixels_.size != box.size)
        throw_differ(kernel_, "targets of different sizes", size_text(pixels_), size_text(box),
                     "draw to ranges of one size");
    if (!has_pixels_) pixels_ = box;
    has_pixels_ = true;
    whole_ = whole_ && is_whole;
    targets_.extent = uint2(box.size[0], box.size[1]);
}

/// A fragment has one pixel address in all its targets, so their ranges must begin at the same pixel.
void DrawIteration::add_origin(const detail::Box& box) {
    const uint2 origin(box.origin[0], box.origin[1]);
    if (has_origin_ && (origin.x != targets_.origin.x || origin.y != targets_.origin.y))
        throw_differ(kernel_, "targets that begin at different pixels",
                     "one begins at (" + std::to_string(targets_.origin.x) + ", " + std::to_string(targets_.origin.y) +
                         ")",
                     origin_text(box), "draw to ranges that begin at the same pixel of each image");
    has_origin_ = true;
    targets_.origin = origin;
}

bool DrawIteration::can_be_direct(const Commands& commands, std::span<const Memory> memories) const {
    return whole_ && commands.can_be_direct(kernel_, memories, size(), sharing_);
}

void DrawIteration::dispatch(const Commands& commands, FormName form, std::span<const Memory> memories,
                             std::span<const std::byte> parameters, std::initializer_list<std::size_t> sizes) {
    for (std::size_t offset : sizes)
        for (std::size_t axis = 0; axis < axes_.size(); ++axis)
            add_patches(axes_[axis].counts, offset + 4 * axis, {axes_[axis].count(), 1, 1, 1}, 1);
    targets_.colours = colours_;
    commands.dispatch(kernel_, {.form = form,
                                .memories = memories,
                                .parameters = parameters,
                                .size = size(),
                                .patches = patches_,
                                .sharing = sharing_,
                                .targets = &targets_});
}

/// Adds a patch for each axis and count.
void DrawIteration::add_patches(const std::vector<detail::DeviceCount>& counts, std::size_t offset,
                                const Extent& limits, unsigned axes) {
    for (unsigned axis = 0; axis < axes; ++axis)
        for (const detail::DeviceCount& count : counts)
            patches_.push_back({{count.value.memory, count.value.offset + 4 * axis},
                                static_cast<std::uint32_t>(offset + 4 * axis),
                                limits[axis],
                                count.before[axis],
                                &count != counts.data()});
}

}  // namespace glift
