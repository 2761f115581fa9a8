// Structures of every kind are filled at random, saved from one device and loaded on another one: equal bit for bit.
#include "folder.h"
#include "snapshot.h"

#include "stored.glift.hpp"

#include <glift/files.h>

namespace {

using namespace glift;
using files_test::device;
using files_test::devices;

class RoundTrip : public files_test::InFolder {
protected:
    /// Made with these arguments on each device, and loaded on each.
    template <class S, class... Arguments> void round_trip(const Arguments&... arguments) {
        std::uint32_t seed = 1;
        for (const std::string& from : devices()) {
            const S saved(device(from), arguments...);
            snapshot::fill_at_random(saved, seed++);
            const snapshot::Snapshot before = snapshot::of(saved);
            save(path(), "it", saved);
            for (const std::string& to : devices()) {
                const S made = load<S>(path(), "it", device(to));
                EXPECT_EQ(snapshot::difference(before, snapshot::of(made)), "") << from << " to " << to;
                S existing(device(to), arguments...);
                snapshot::fill_at_random(existing, 99);
                const LoadReport report = load(path(), "it", existing);
                EXPECT_FALSE(report.is_by_address);
                EXPECT_TRUE(report.added.empty() && report.removed.empty());
                EXPECT_EQ(snapshot::difference(before, snapshot::of(existing)), "") << from << " to " << to;
            }
        }
    }
};

TEST_F(RoundTrip, Array) { round_trip<stored::Plane>(uint2(17, 9)); }
TEST_F(RoundTrip, ArrayWithoutElements) { round_trip<stored::Plane>(uint2(0, 9)); }
TEST_F(RoundTrip, ArrayOfStructs) { round_trip<stored::Cells>(uint3(7, 5, 3)); }
TEST_F(RoundTrip, ArrayOfHalves) { round_trip<stored::Halves>(101u); }
TEST_F(RoundTrip, ComponentsApart) { round_trip<stored::CellsApart>(uint3(7, 5, 3)); }
TEST_F(RoundTrip, ArrayInImage) { round_trip<stored::InImage>(uint2(17, 9)); }
TEST_F(RoundTrip, ArrayInVolume) { round_trip<stored::Volume>(uint3(17, 9, 5)); }
TEST_F(RoundTrip, Tiled) { round_trip<stored::Tiles>(uint2(32, 12)); }
TEST_F(RoundTrip, Morton) { round_trip<stored::Morton>(uint2(16, 16)); }
TEST_F(RoundTrip, ImageOfBytes) { round_trip<stored::Bits>(uint2(13, 7)); }
TEST_F(RoundTrip, ImageOfColours) { round_trip<stored::Colours>(uint2(13, 7)); }
TEST_F(RoundTrip, ImageWithLevels) { round_trip<stored::Levels>(uint2(16, 8), 4u); }
TEST_F(RoundTrip, ImageWithLayers) { round_trip<stored::Layers>(uint2(9, 8), 5u); }
TEST_F(RoundTrip, Cube) { round_trip<stored::Sky>(9u); }
TEST_F(RoundTrip, Depth) { round_trip<stored::Depth>(uint2(9, 8)); }
TEST_F(RoundTrip, Sparse) { round_trip<stored::Grid>(uint2(40, 30), 12u); }
TEST_F(RoundTrip, SparseGrowing) { round_trip<stored::Growing>(uint2(40, 30), 12u); }
TEST_F(RoundTrip, SparseApart) { round_trip<stored::GrowingApart>(uint2(40, 30), 12u); }
TEST_F(RoundTrip, SparseEvicting) { round_trip<stored::Evicting>(uint2(40, 30), 12u); }
TEST_F(RoundTrip, TwoLevels) { round_trip<stored::TwoLevel>(uint3(40, 30, 20), 12u); }
TEST_F(RoundTrip, Bump) { round_trip<stored::Bumped>(uint2(40, 30), 12u); }
TEST_F(RoundTrip, Hashed) { round_trip<stored::Hashed>(12u); }
TEST_F(RoundTrip, HashedApart) { round_trip<stored::HashedApart>(12u); }
TEST_F(RoundTrip, HashMap) { round_trip<stored::Map>(50u); }
TEST_F(RoundTrip, OrderedHashMap) { round_trip<stored::Ordered>(50u); }
TEST_F(RoundTrip, HashSet) { round_trip<stored::Set>(50u); }
TEST_F(RoundTrip, Stack) { round_trip<stored::Stacked>(50u); }
TEST_F(RoundTrip, Queue) { round_trip<stored::Queued>(50u); }
TEST_F(RoundTrip, NStack) { round_trip<stored::Stacks>(5u, 10u); }
TEST_F(RoundTrip, Lists) { round_trip<stored::Boxes>(5u, 10u); }
TEST_F(RoundTrip, Quadtree) { round_trip<stored::Quadtree>(3u, 10u); }
TEST_F(RoundTrip, Octree) { round_trip<stored::Octree>(3u, 10u); }
TEST_F(RoundTrip, UsersContainer) { round_trip<stored::World>(uint2(12, 10), 2.5f); }
TEST_F(RoundTrip, UsersTranslator) { round_trip<stored::Flipped>(uint2(12, 10)); }
TEST_F(RoundTrip, UsersContainerOfContainers) { round_trip<stored::Worlds>(uint2(12, 10)); }

/// Several chunks of 4 MiB along the last axis, the last one not whole.
TEST_F(RoundTrip, SeveralChunks) { round_trip<stored::Plane>(uint2(1000, 1200)); }
TEST_F(RoundTrip, RowsLongerThanChunks) { round_trip<stored::Plane>(uint2(1100000, 2)); }

/// What a container keeps on the host, and members that it replaced by larger ones, come back; later changes do the
/// same to both.
TEST_F(RoundTrip, AfterGrowth) {
    for (const std::string& from : devices()) {
        stored::World saved(device(from), uint2(40, 30), 2.0f);
        saved.advance(device(from));
        saved.grow_ground(device(from), uint2(0, 0), uint2(20, 20));
        ASSERT_GT(saved.ground().status(device(from)).capacity, 2u);
        stored::fill(device(from), saved.ground());
        save(path(), "world", saved);
        for (const std::string& to : devices()) {
            stored::World loaded = load<stored::World>(path(), "world", device(to));
            EXPECT_EQ(loaded.rounds(), 1u);
            EXPECT_EQ(snapshot::difference(snapshot::of(saved), snapshot::of(loaded)), "") << from << " to " << to;
            stored::World again(device(from), uint2(40, 30), 2.0f);
            load(path(), "world", again);
            for (stored::World* world : {&again, &loaded}) {
                const Device& own = world->device();
                world->grow_ground(own, uint2(10, 10), uint2(40, 30));
                stored::fill(own, world->ground());
            }
            EXPECT_EQ(snapshot::difference(snapshot::of(again), snapshot::of(loaded)), "") << from << " to " << to;
        }
    }
}

/// Copies of a container share what was loaded into one of them.
TEST_F(RoundTrip, CopiesShare) {
    stored::World saved(device("host"), uint2(40, 30), 2.0f);
    saved.grow_ground(device("host"), uint2(0, 0), uint2(20, 20));
    save(path(), "world", saved);
    stored::World loaded(device("host"), uint2(40, 30), 2.0f);
    const stored::World copy = loaded;
    load(path(), "world", loaded);
    EXPECT_EQ(copy.ground().status(device("host")).capacity, saved.ground().status(device("host")).capacity);
    EXPECT_EQ(snapshot::difference(snapshot::of(saved), snapshot::of(copy)), "");
}

TEST_F(RoundTrip, SeveralStructuresInAFile) {
    const stored::Plane plane(device("host"), uint2(3, 4));
    const stored::Map map(device("host"), 10u);
    snapshot::fill_at_random(plane, 1);
    snapshot::fill_at_random(map, 2);
    NewFile file(path());
    file.save("plane", plane);
    file.save("map", map);
    EXPECT_FALSE(std::filesystem::exists(path()));
    file.commit();
    File saved(path());
    EXPECT_EQ(saved.names(), (std::vector<std::string>{"map", "plane"}));
    EXPECT_EQ(
        snapshot::difference(snapshot::of(plane), snapshot::of(saved.load<stored::Plane>("plane", device("host")))),
        "");
    EXPECT_EQ(snapshot::difference(snapshot::of(map), snapshot::of(saved.load<stored::Map>("map", device("host")))),
              "");
}

TEST_F(RoundTrip, Progress) {
    const stored::Cells cells(device("host"), uint3(30, 20, 10));
    std::uint64_t last = 0, all = 0;
    save(path(), "cells", cells, [&](std::uint64_t done, std::uint64_t total) {
        EXPECT_GT(done, last);
        last = done, all = total;
    });
    EXPECT_EQ(last, all);
}

}  // namespace
