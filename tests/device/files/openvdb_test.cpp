// Grids of OpenVDB and NanoVDB, a fog and a level set: into sparse and dense structures, out of them, and through .vdb
// and .nvdb files. Values and active voxels are equal.
#include "folder.h"

#include "volumes.glift.hpp"

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
