// The ranks that a device stands for, for libraries beside the runtime that do something once for all of them, such as
// writing a file. All functions are collective: every rank has to call them, in the same order.
#pragma once

#include <glift/device.h>

#include <cstddef>
#include <exception>
#include <memory>
#include <span>
#include <vector>

namespace glift::detail {
class RankDevice;
}

namespace glift::ranks {

class GLIFT_API Group {
public:
    Group() = default;  ///< this process alone
    /// The ranks of a world, if the device is World::device(); else this process alone.
    explicit Group(const Device& device);

    unsigned rank() const;
    unsigned size() const;
    /// What each rank gives, in the order of the ranks; all give as many bytes. Throws lost_rank.
    std::vector<std::vector<std::byte>> all_gather(std::span<const std::byte> mine) const;
    /// Returns if no rank gives an exception. Else each rank throws: its own one, if it has one, or glift::Error of the
    /// first rank that has one. Throws lost_rank.
    void agree(const std::exception_ptr& mine = nullptr) const;

private:
    std::shared_ptr<detail::RankDevice> device_;
};

}  // namespace glift::ranks
