// Several devices as one: a rank for each device, and structures that are distributed over them. See
// docs/how-to/ranks.md.
//
// Every rank runs the same program: the same calls with the same arguments in the same order. It opens a World and
// gives World::device() to structures and pipelines in place of a device. Structures are replicated at first: each rank
// has all elements, and computes all of them. World::distribute makes a structure distributed: each rank computes the
// elements that it owns, and the runtime sends the elements that other ranks read. Results are the same bits on any
// number of ranks.
#pragma once

#include <glift/device.h>
#include <glift/range_shape.h>
#include <glift/ranks/transport.h>

#include <chrono>
#include <concepts>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace glift::ranks {

struct Options {
    /// After this time without an answer of another rank, calls throw lost_rank. 0: what GLIFT_RANKS_TIMEOUT says, in
    /// seconds, else 60 seconds.
    std::chrono::duration<double> limit{0};
    /// A pass that reads elements of other ranks first computes the elements that do not need them, while these are on
    /// their way.
    bool overlaps = true;
};

/// How a structure is distributed.
struct Distribution {
    /// Exchanges bring the elements up to this many away from a rank's own, 8 at most, even if a pass reads fewer; the
    /// next passes then compute some of them once more, in place of another exchange. With 2, every other pass with a
    /// radius of 1 needs an exchange.
    std::uint32_t halo = 0;
};

/// What a rank has sent and computed since its World was made.
struct Statistics {
    std::uint64_t exchanges = 0;           ///< of elements around those that a rank owns, before passes
    std::uint64_t exchanged_bytes = 0;     ///< that this rank sent in them
    std::uint64_t gathers = 0;             ///< of whole memories, since a pass or the host reads any of their elements
    std::uint64_t gathered_bytes = 0;      ///< that this rank sent in them
    std::uint64_t combinations = 0;        ///< of what ranks wrote by `scatter` to one memory
    std::uint64_t combined_bytes = 0;      ///< that this rank sent in them
    std::uint64_t migrated_bytes = 0;      ///< that this rank sent as elements changed their owner (World::balance)
    std::uint64_t distributed_passes = 0;  ///< of which each rank computed its part
    std::uint64_t whole_passes = 0;        ///< that each rank computed wholly
    /// Of exchanges, from when the device has packed this rank's elements until the others' have arrived. The device
    /// computes meanwhile.
    double exchange_seconds = 0;
};

}  // namespace glift::ranks

namespace glift::detail {

class RankDevice;

/// The memories of a structure whose elements lie in pages: what World::distribute has to know of it.
struct PagedShape {
    const char* type_name;
    Memory list;                 ///< the numbers of resident pages, ascending
    DeviceValue count;           ///< how many there are
    Memory table;                ///< for each page its frame + 1, or 0
    std::vector<Memory> frames;  ///< each field's, or that of all fields
    std::uint32_t capacity;      ///< frames
    unsigned rank;
    Extent extent, page;
};

/// Structures with pages like those of std.sparse, with a page table in one piece.
template <class S>
concept HasPages = requires(const S& s) {
    requires S::has_blocks;
    { s.pages().active().data() } -> std::same_as<const Memory&>;
    { s.pages().state().data() } -> std::same_as<const Memory&>;
    { s.table().entries().data() } -> std::same_as<const Memory&>;
    {s.field().frames().extent()};
    {s.block_extent()};
};

/// Collects the memories that describe() of a structure names.
struct MemoryList {
    std::vector<Memory> memories;

    template <class T> void value(const char*, const T&) {}
    void memory(const char*, const Memory& memory) { memories.push_back(memory); }
    template <class S> void memory(const char*, const S&) {}
    template <class S> void member(const char*, const S&) {}
    template <class S> void given(const char*, const S&) {}
};

template <class S> std::vector<Memory> memories_of(const S& structure) {
    MemoryList list;
    structure.describe(list);
    return list.memories;
}

template <class S> PagedShape paged_shape_of(const S& structure) {
    return {S::type_name,
            structure.pages().active().data(),
            {structure.pages().state().data(), 0},
            structure.table().entries().data(),
            memories_of(structure.field().frames()),
            structure.field().frames().extent()[1],
            Axes<typename S::Address>::count,
            extent_of(structure.domain()),
            extent_of(structure.block_extent())};
}

}  // namespace glift::detail

namespace glift::ranks {

/// The ranks of a program, seen from one of them. One thread at a time may use a world and its device.
class GLIFT_API World {
public:
    /// `local` is this rank's own device.
    World(std::shared_ptr<Transport> transport, const Device& local, const Options& options = {});
    ~World();
    World(const World&) = delete;

    unsigned rank() const;  ///< of this process, from 0 on
    unsigned size() const;  ///< how many ranks there are
    /// The device that structures are made on and pipelines run on. What the host reads of it, values of the device
    /// included, is the same on every rank; all ranks have to read it. It makes no recordings.
    const Device& device() const;
    const Device& local_device() const;

    /// Distributes a structure that was made on device(). Of a dense array each rank owns consecutive planes of the
    /// last axis (of a matrix rows), of a sparse one consecutive planes of pages. Structures that a pass writes
    /// together with it are then distributed, too. Throws wrong_argument for a structure whose elements do not lie
    /// plane by plane.
    template <class S> void distribute(const S& structure, const Distribution& how = {}) {
        if constexpr (detail::HasPages<S>) distribute(detail::paged_shape_of(structure), how);
        else {
            const Range<S> range(structure);  // the shape refers to it
            const detail::RangeShape shape = detail::shape_of(range);
            std::vector<Memory> memories = {shape.indices.memory};
            if constexpr (detail::HasIndices<S>) {
                if (!shape.indices.memory) memories = detail::memories_of(structure);
            }
            distribute(S::type_name, shape, memories, how);
        }
    }
    /// Moves the boundaries between ranks so that all of them own about as many resident pages, and moves elements to
    /// their new owners. Returns imbalance().
    template <class S> double balance(const S& structure) {
        static_assert(detail::HasPages<S>, "balance() is for sparse structures: ranks own equal parts of dense ones");
        return balance(detail::paged_shape_of(structure));
    }

    /// The largest number of resident pages of a rank over the mean.
    template <class S> double imbalance(const S& structure) {
        static_assert(detail::HasPages<S>, "imbalance() is for sparse structures");
        return imbalance(detail::paged_shape_of(structure));
    }

    Statistics statistics() const;  ///< waits for exchanges that are under way
    void barrier();                 ///< returns when every rank has called it

private:
    void distribute(const char* type_name, const detail::RangeShape& shape, const std::vector<Memory>& memories,
                    const Distribution& how);
    void distribute(const detail::PagedShape& shape, const Distribution& how);
    double balance(const detail::PagedShape& shape);
    double imbalance(const detail::PagedShape& shape);

    std::shared_ptr<detail::RankDevice> object_;
    Device device_, local_;
};

}  // namespace glift::ranks
