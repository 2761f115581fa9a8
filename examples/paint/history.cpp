#include "history.h"

#include <algorithm>
#include <iterator>

namespace {

using Pages = std::vector<glift::uint>;

constexpr glift::uint texels_of_page = 17 * 17 * 17;

journal::PageList list_of(const glift::Device& device, const Pages& pages) {
    journal::PageList list(device, static_cast<glift::uint>(pages.size()));
    list.write(pages);
    return list;
}

}  // namespace

void mark(const glift::Device& device, journal::Octree& octree, const journal::PageList& list) {
    octree.mark_pages(device, list);
    octree.list_marked(device);
}

std::uint64_t History::Texels::bytes() const { return std::uint64_t{4} * texels_of_page * pages.size(); }

void History::Texels::move_to_host() {
    if (!is_on_device) return;
    on_host = on_device.read();
    on_device = {};
    is_on_device = false;
}

void History::Texels::restore(const glift::Device& device, journal::Octree& octree) const {
    if (pages.empty()) return;
    journal::Texels texels = on_device;
    if (!is_on_device) {
        texels = journal::Texels(device, {texels_of_page, static_cast<glift::uint>(pages.size())});
        texels.write(on_host);
    }
    mark(device, octree, list_of(device, pages));
    journal::restore(device, octree, texels);
}

History::Texels History::room_for(const glift::Device& device, Pages pages) {
    if (pages.empty()) return {};
    Texels texels;
    texels.on_device = journal::Texels(device, {texels_of_page, static_cast<glift::uint>(pages.size())});
    texels.pages = std::move(pages);
    texels.is_on_device = true;
    return texels;
}

void History::add(const glift::Device& device, journal::Octree& octree, journal::Journal& journal) {
    journal::PageList list(device, octree.capacity());
    const auto read = [&](glift::uint n) { return n == 0 ? Pages() : list.read(0, n); };
    Step step;
    const Pages changed = read(journal.changed_pages(device, list).await(device));
    if (!changed.empty()) step.born = read(journal.born_pages(device, list).await(device));
    Pages old;
    std::ranges::set_difference(changed, step.born, std::back_inserter(old));
    step.before = room_for(device, old);
    step.after = room_for(device, changed);
    if (!old.empty()) {
        mark(device, octree, list_of(device, old));
        journal::store(device, octree, journal.before(), step.before.on_device);
    }
    if (!changed.empty()) {
        mark(device, octree, list_of(device, changed));
        journal::store(device, octree, octree.frames(), step.after.on_device);
    }
    steps_.resize(done_);
    steps_.push_back(std::move(step));
    ++done_;
    fit();
}

bool History::undo(const glift::Device& device, journal::Octree& octree) {
    if (done_ == 0) return false;
    const Step& step = steps_[--done_];
    if (!step.born.empty()) journal::release(device, octree, list_of(device, step.born));
    step.before.restore(device, octree);
    octree.join(device);  // hanging nodes follow from the others
    return true;
}

bool History::redo(const glift::Device& device, journal::Octree& octree) {
    if (done_ == steps_.size()) return false;
    const Step& step = steps_[done_++];
    if (!step.born.empty()) {
        octree.pages().request_pages(device, list_of(device, step.born));
        octree.allocate(device);
    }
    step.after.restore(device, octree);
    octree.join(device);  // hanging nodes follow from the others
    return true;
}

void History::fit() {
    for (Step& step : steps_) {
        if (device_bytes() <= budget_.device) break;
        step.before.move_to_host();
        step.after.move_to_host();
    }
    while (!steps_.empty() && host_bytes() > budget_.host) {
        steps_.pop_front();
        done_ = done_ == 0 ? 0 : done_ - 1;
    }
}

std::uint64_t History::device_bytes() const {
    std::uint64_t sum = 0;
    for (const Step& step : steps_)
        for (const Texels* texels : {&step.before, &step.after})
            if (texels->is_on_device) sum += texels->bytes();
    return sum;
}

std::uint64_t History::host_bytes() const {
    std::uint64_t sum = 0;
    for (const Step& step : steps_) sum += step.bytes();
    return sum - device_bytes();
}

void History::clear() {
    steps_.clear();
    done_ = 0;
}
