// Grids of OpenVDB and NanoVDB, a fog and a level set: into sparse and dense structures, out of them, and through .vdb
// and .nvdb files. Values and active voxels are equal.
#include "folder.h"

#include "volumes.glift.hpp"

#include <glift/files.h>
#include <glift/files/openvdb.h>

#define NANOVDB_USE_OPENVDB
#include <nanovdb/util/IO.h>
#include <nanovdb/util/NanoToOpenVDB.h>
#include <nanovdb/util/OpenToNanoVDB.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/LevelSetUtil.h>

namespace {

using namespace glift;

class OpenVdb : public files_test::InFolder {
protected:
    OpenVdb() { openvdb::initialize(); }

    static void expect_equal(const openvdb::FloatGrid& a, const openvdb::FloatGrid& b) {
        ASSERT_EQ(a.activeVoxelCount(), b.activeVoxelCount());
        const auto other = b.getConstAccessor();
        for (auto it = a.cbeginValueOn(); it; ++it) {
            ASSERT_TRUE(other.isValueOn(it.getCoord())) << it.getCoord();
            ASSERT_EQ(other.getValue(it.getCoord()), *it) << it.getCoord();
        }
    }

    /// Into a sparse structure whose pages are requested, and out again: the active voxels, and the rest of their
    /// pages.
    void through_a_grid(const openvdb::FloatGrid& from) {
        const Device& host = files_test::device("host");
        const openvdb::Coord origin(-32, -32, -32);
        volumes::Grid grid(host, uint3(64, 64, 64), 512u, from.background());
        const std::vector<uint3> pages = openvdb_pages(from, uint3(64, 64, 64), uint3(8, 8, 8), origin);
        volumes::Places places(host, static_cast<uint>(pages.size()));
        places.write(pages);
        volumes::request(host, places, grid);
        EXPECT_EQ(grid.status(host).resident, pages.size());
        from_openvdb(grid, from, origin);
        const openvdb::FloatGrid::Ptr back = to_openvdb(grid, from.background(), origin);
        EXPECT_EQ(back->activeVoxelCount(), pages.size() * 512);
        // Voxels that were not active have the background in their page.
        for (auto it = back->beginValueOn(); it; ++it)
            if (!from.getConstAccessor().isValueOn(it.getCoord())) {
                ASSERT_EQ(*it, from.background());
                it.setValueOff();
            }
        expect_equal(from, *back);
    }

    void through_files(const openvdb::FloatGrid::Ptr& grid) {
        openvdb::io::File(path("grid.vdb")).write({grid});
        openvdb::io::File file(path("grid.vdb"));
        file.open();
        const auto read = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid(file.beginName().gridName()));
        expect_equal(*grid, *read);
        through_a_grid(*read);
        auto handle = nanovdb::openToNanoVDB(*grid);
        nanovdb::io::writeGrid(path("grid.nvdb"), handle);
        auto again = nanovdb::io::readGrid(path("grid.nvdb"));
        const auto opened = openvdb::gridPtrCast<openvdb::FloatGrid>(nanovdb::nanoToOpenVDB(again));
        expect_equal(*grid, *opened);
        through_a_grid(*opened);
    }
};

/// `gliftinfo convert` to .nvdb: the elements of resident pages are active voxels, and no others.
class Converted : public OpenVdb {
protected:
    const Device& host() { return files_test::device("host"); }

    openvdb::FloatGrid::Ptr convert(const std::string& from) {
        const std::string to = path("converted.nvdb");
        const std::string call = std::string(GLIFT_INFO) + " convert " + path() + " " + from + " " + to;
        EXPECT_EQ(std::system(call.c_str()), 0);
        auto handle = nanovdb::io::readGrid(to);
        return openvdb::gridPtrCast<openvdb::FloatGrid>(nanovdb::nanoToOpenVDB(handle));
    }

    /// Some pages, also at the end of a domain of 60 x 50 x 40, which the last ones exceed.
    static std::vector<uint3> places() {
        return {uint3(0, 0, 0), uint3(24, 8, 16), uint3(32, 8, 16), uint3(56, 48, 32), uint3(16, 40, 8)};
    }

    template <class S, class Fill> void expect_converted(S grid, uint3 page, const std::string& field, Fill fill) {
        volumes::Places list(host(), static_cast<uint>(places().size()));
        list.write(places());
        fill(host(), list, grid);
        EXPECT_EQ(grid.status(host()).resident, places().size());
        save(path(), "smoke", grid);
        const openvdb::FloatGrid::Ptr found = convert("smoke/" + field);
        EXPECT_EQ(found->background(), 2.5f);
        std::uint64_t voxels = 0;
        const auto at = found->getConstAccessor();
        for (const uint3& first : places())
            for (uint z = first.z; z < std::min(first.z + page.z, 40u); ++z)
                for (uint y = first.y; y < std::min(first.y + page.y, 50u); ++y)
                    for (uint x = first.x; x < std::min(first.x + page.x, 60u); ++x, ++voxels) {
                        const openvdb::Coord voxel(static_cast<int>(x), static_cast<int>(y), static_cast<int>(z));
                        ASSERT_TRUE(at.isValueOn(voxel)) << voxel;
                        ASSERT_EQ(at.getValue(voxel), static_cast<float>(x + 100 * y + 10000 * z)) << voxel;
                    }
        EXPECT_EQ(found->activeVoxelCount(), voxels);
    }
};

constexpr auto frames = "field/frames/data";

TEST_F(Converted, Sparse) {
    const volumes::Grid grid(host(), uint3(60, 50, 40), 9u, 2.5f);
    expect_converted(grid, uint3(8, 8, 8), frames, [](auto&... all) { volumes::fill_grid(all...); });
}
TEST_F(Converted, Bump) {
    const volumes::Bumped grid(host(), uint3(60, 50, 40), 9u, 2.5f);
    expect_converted(grid, uint3(4, 8, 2), frames, [](auto&... all) { volumes::fill_bumped(all...); });
}
TEST_F(Converted, TwoLevels) {
    const volumes::TwoLevel grid(host(), uint3(60, 50, 40), 9u, 2.5f);
    expect_converted(grid, uint3(8, 8, 8), frames, [](auto&... all) { volumes::fill_two_level(all...); });
}
TEST_F(Converted, FieldOfAStruct) {
    volumes::Smoke background;
    background.density = 2.5f;
    const volumes::Smokes grid(host(), uint3(60, 50, 40), 9u, background);
    expect_converted(grid, uint3(8, 8, 8), std::string(frames) + "/density",
                     [](auto&... all) { volumes::fill_smokes(all...); });
}

/// Has no end: the last pages are whole.
TEST_F(Converted, Hashed) {
    volumes::Hashed grid(host(), 9u, 2.5f);
    volumes::Places list(host(), static_cast<uint>(places().size()));
    list.write(places());
    volumes::fill_hashed(host(), list, grid);
    save(path(), "smoke", grid);
    const openvdb::FloatGrid::Ptr found = convert("smoke/frames/data");
    EXPECT_EQ(found->background(), 2.5f);
    EXPECT_EQ(found->activeVoxelCount(), 512 * places().size());
    for (auto it = found->beginValueOn(); it; ++it) {
        const openvdb::Coord at = it.getCoord();
        ASSERT_EQ(*it, static_cast<float>(at.x() + 100 * at.y() + 10000 * at.z())) << at;
    }
}

TEST_F(Converted, Dense) {
    volumes::Dense dense(host(), uint3(9, 8, 70));
    std::vector<float> values;
    for (int i = 0; i < 9 * 8 * 70; ++i) values.push_back(static_cast<float>(i));
    dense.write(values);
    save(path(), "ct", dense);
    expect_equal(*to_openvdb(dense, 0.0f), *convert("ct/data"));
}

TEST_F(Converted, OtherContentIsRefused) {
    const volumes::Smokes grid(host(), uint3(60, 50, 40), 9u);
    save(path(), "smoke", grid);
    for (const char* from : {"smoke/field/frames/data/heat", "smoke/pages/active/data"})
        EXPECT_NE(std::system((std::string(GLIFT_INFO) + " convert " + path() + " " + from + " " + path("x.nvdb") +
                               " 2>" + path("errors"))
                                  .c_str()),
                  0);
}

TEST_F(OpenVdb, LevelSet) {
    through_files(openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(20.0f, openvdb::Vec3f(0), 1.0f));
}

TEST_F(OpenVdb, Fog) {
    auto grid = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(20.0f, openvdb::Vec3f(0), 1.0f);
    openvdb::tools::sdfToFogVolume(*grid);
    through_files(grid);
}

TEST_F(OpenVdb, Dense) {
    const Device& host = files_test::device("host");
    volumes::Dense dense(host, uint3(9, 8, 70));
    std::vector<float> values;
    for (int i = 0; i < 9 * 8 * 70; ++i) values.push_back(static_cast<float>(i));
    dense.write(values);
    const auto grid = to_openvdb(dense, 0.0f);
    EXPECT_EQ(grid->activeVoxelCount(), values.size());
    volumes::Dense again(host, uint3(9, 8, 70));
    from_openvdb(again, *grid);
    EXPECT_EQ(again.read(), values);
}

}  // namespace
