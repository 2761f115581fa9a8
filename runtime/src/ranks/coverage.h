// Which elements of a memory are up to date on this rank.
#pragma once

#include "../objects.h"
#include "cuts.h"
#include "slab_layout.h"

#include <glift/pass.h>

#include <algorithm>
#include <memory>
#include <unordered_map>
#include <vector>

namespace glift::detail {

/// The pages of a sparse structure, of which all ranks know which are resident. Pages are cut by planes of pages along
/// the last axis, so that those of a rank, and those of a plane, are consecutive in the list.
struct Paging {
    Memory list;                                   ///< the numbers of resident pages, ascending
    DeviceValue count;                             ///< how many there are
    Memory table;                                  ///< for each page its frame + 1, or 0
    std::uint32_t pages_of_plane = 0, layers = 0;  ///< layers of elements of a page, along the last axis
    std::uint32_t capacity = 0;                    ///< frames

    /// Where each plane begins in the list, and the end, for the device; and the same for the host, which sees what the
    /// last pass wrote whose point it waited for.
    Memory planes;
    VisibleMemory seen;
    bool is_stale = true;  ///< after a pass that writes the list, the count or the table

    /// Lists of the pages of some planes, in place of `list`, for the planes that they were made for. The k-th word of
    /// `counts` says how many pages the k-th list has.
    struct Sublist {
        Planes lower, upper;
        Memory memory;
        std::uint32_t age = 0;  ///< how often the list has changed since this one was used
    };
    static constexpr std::size_t most_sublists = 64;
    static constexpr std::uint32_t oldest = 16;
    std::vector<Sublist> sublists;
    std::vector<Memory> spare;  ///< of sublists that are needed no more
    Memory counts;
    std::vector<Memory> unused;  ///< given to cut_pages where there are fewer lists than it can make

    void forget_sublists() {
        for (Sublist& list : sublists) list.age = oldest;
        forget_old_sublists();
    }
    void forget_old_sublists() {
        for (Sublist& list : sublists)
            if (++list.age > oldest) spare.push_back(std::move(list.memory));
        std::erase_if(sublists, [](const Sublist& list) { return list.age > oldest; });
    }
    std::uint32_t most_pages(Planes of) const {
        return static_cast<std::uint32_t>(
            std::min(std::uint64_t{pages_of_plane} * of.count(), std::uint64_t{capacity}));
    }
    /// The indices in the list of the pages of some planes, as the host sees them.
    Planes pages(Planes of) const {
        const auto* first = reinterpret_cast<const std::uint32_t*>(seen.bytes.data());
        return {first[of.first], first[of.end]};
    }
};

/// What is cut into parts: the planes of dense structures of one extent, or the planes of pages of a sparse one.
struct Space {
    Cuts cuts;
    std::unique_ptr<Paging> paging;  ///< null: dense
    /// Exchanges bring the elements up to this many away from a rank's own, even if a pass reads fewer. The rank then
    /// computes some of them itself in the passes that follow (ranks::Distribution::halo).
    std::uint32_t halo = 0;
};

/// A rank has its own elements, and those up to `ghost` elements away from them along the last axis.
struct Coverage {
    static constexpr std::uint32_t everywhere = UINT32_MAX;

    std::weak_ptr<MemoryObject> memory;
    std::shared_ptr<Space> space;
    std::uint32_t ghost = everywhere;
    SlabLayout ghost_layout;   ///< by which `ghost` is counted beyond the domain's edge
    SlabLayout layout;         ///< of a dense structure
    std::uint64_t number = 0;  ///< in the order of Coverages::set, which is the same on every rank
    std::uint64_t frame_bytes = 0, layer_bytes = 0;  ///< of a sparse one: of a page and of a layer of it

    bool is_partial() const { return ghost != everywhere; }
};

/// Memories that are not in it are up to date everywhere.
class Coverages {
public:
    /// Null: there is none.
    Coverage* find(const Memory& memory);
    Coverage& set(const Memory& memory, Coverage coverage);
    /// Those of memories that exist, in the same order on every rank.
    std::vector<std::pair<Memory, Coverage*>> of(const Space& space);

private:
    std::unordered_map<const MemoryObject*, Coverage> coverages_;
    std::uint64_t next_number_ = 0;
};

}  // namespace glift::detail
