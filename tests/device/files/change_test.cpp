// Files whose structures are declared otherwise than the program's: loaded field by field or by address, or refused
// with an error that names both.
#include "folder.h"
#include "snapshot.h"

#include "after.glift.hpp"
#include "before.glift.hpp"

#include <glift/files.h>

#include <gmock/gmock.h>

namespace {

using namespace glift;

class Change : public files_test::InFolder {
protected:
    const Device& host() { return files_test::device("host"); }

    before::Cell cell(uint i) {
        before::Cell made;
        made.density = static_cast<float>(i);
        made.velocity = float3(1.0f, 2.0f, static_cast<float>(i));
        made.old_name = static_cast<int>(7 * i);
        return made;
    }
    std::vector<before::Cell> cells(uint count) {
        std::vector<before::Cell> all;
        for (uint i = 0; i < count; ++i) all.push_back(cell(i));
        return all;
    }
    void save_cells() {
        before::Cells saved(host(), uint2(6, 5));
        saved.write(cells(30));
        save(path(), "it", saved);
    }
    /// A grid of 16 x 16 with its first pages resident.
    before::Grid save_grid() {
        before::Grid saved(host(), uint2(16, 16), 9u);
        saved.request_box(host(), uint2(0, 0), uint2(9, 5));
        saved.allocate(host());
        saved.write(uint2(0, 0), uint2(8, 4), cells(32));
        save(path(), "it", saved);
        return saved;
    }
    void save_plane() {
        before::Plane saved(host(), uint2(16, 8));
        saved.write(numbers(128));
        save(path(), "it", saved);
    }
    static std::vector<float> numbers(uint count) {
        std::vector<float> all;
        for (uint i = 0; i < count; ++i) all.push_back(static_cast<float>(i));
        return all;
    }
    /// Loads, which must fail without a change, and returns the error's text.
    template <class S> std::string refusal(S structure) {
        const snapshot::Snapshot before = snapshot::of(structure);
        try {
            load(path(), "it", structure);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::wrong_argument);
            EXPECT_EQ(snapshot::difference(before, snapshot::of(structure)), "");
            return error.what();
        }
        return "loaded";
    }
};

using testing::HasSubstr;

TEST_F(Change, FieldsAddedRemovedAndRenamed) {
    save_cells();
    after::Cells loaded(host(), uint2(6, 5));
    snapshot::fill_at_random(loaded, 1);
    const LoadReport report = load(path(), "it", loaded);
    EXPECT_EQ(report.added, (std::vector<std::string>{"it.added"}));
    EXPECT_EQ(report.removed, (std::vector<std::string>{"it.velocity"}));
    const std::vector<after::Cell> values = loaded.read();
    for (uint i = 0; i < 30; ++i) {
        EXPECT_EQ(values[i].density, static_cast<float>(i));
        EXPECT_EQ(values[i].new_name, static_cast<int>(7 * i));
        EXPECT_EQ(values[i].added, float2(0.0f, 0.0f));
    }
}

TEST_F(Change, FieldsOfASparseGrid) {
    const before::Grid saved = save_grid();
    after::Grid loaded(host(), uint2(16, 16), 9u);
    const LoadReport report = load(path(), "it", loaded);
    EXPECT_EQ(report.added, (std::vector<std::string>{"it.field.frames.data.added"}));
    EXPECT_EQ(report.removed, (std::vector<std::string>{"it.field.frames.data.velocity"}));
    EXPECT_EQ(loaded.status(host()).resident, saved.status(host()).resident);
    const std::vector<before::Cell> was = saved.read();
    const std::vector<after::Cell> is = loaded.read();
    for (std::size_t i = 0; i < was.size(); ++i) {
        EXPECT_EQ(is[i].density, was[i].density);
        EXPECT_EQ(is[i].new_name, was[i].old_name);
    }
}

TEST_F(Change, FieldRetyped) {
    save_cells();
    const std::string text = refusal(after::RetypedCells(host(), uint2(6, 5)));
    EXPECT_THAT(text, HasSubstr("a field has another type in the file"));
    EXPECT_THAT(text, HasSubstr("the file has float32, the program float64"));
}

TEST_F(Change, Extent) {
    save_plane();
    after::Plane loaded(host(), uint2(20, 5));
    EXPECT_TRUE(load(path(), "it", loaded).is_by_address);
    const std::vector<float> values = loaded.read();
    for (uint y = 0; y < 5; ++y)
        for (uint x = 0; x < 20; ++x)
            EXPECT_EQ(values[y * 20 + x], x < 16 ? static_cast<float>(y * 16 + x) : 0.0f) << x << ", " << y;
}

TEST_F(Change, OrderOfElements) {
    save_plane();
    after::OtherOrder morton(host(), uint2(16, 8));
    EXPECT_TRUE(load(path(), "it", morton).is_by_address);
    EXPECT_EQ(morton.read(), numbers(128));
    save(path("morton.h5"), "it", morton);
    after::OtherTiles tiles(host(), uint2(16, 8));
    load(path("morton.h5"), "it", tiles);
    EXPECT_EQ(tiles.read(), numbers(128));
}

TEST_F(Change, LayoutOfAnArray) {
    save_cells();
    after::OtherLayoutCells loaded(host(), uint2(6, 5));
    load(path(), "it", loaded);
    const std::vector<after::Same> values = loaded.read();
    for (uint i = 0; i < 30; ++i) EXPECT_EQ(values[i].velocity, cell(i).velocity);
}

TEST_F(Change, LayoutOfASparseGrid) {
    const before::Grid saved = save_grid();
    after::OtherLayout loaded(host(), uint2(16, 16), 9u);
    load(path(), "it", loaded);
    EXPECT_EQ(loaded.status(host()).resident, saved.status(host()).resident);
    const std::vector<before::Cell> was = saved.read();
    const std::vector<after::Same> is = loaded.read();
    for (std::size_t i = 0; i < was.size(); ++i) {
        EXPECT_EQ(is[i].density, was[i].density);
        EXPECT_EQ(is[i].velocity, was[i].velocity);
        EXPECT_EQ(is[i].old_name, was[i].old_name);
    }
    // A later change does what it does to the saved one.
    before::Grid old = saved;
    old.request_box(host(), uint2(8, 8), uint2(16, 10));
    old.allocate(host());
    loaded.request_box(host(), uint2(8, 8), uint2(16, 10));
    loaded.allocate(host());
    EXPECT_EQ(loaded.pages().active().read(), old.pages().active().read());
    EXPECT_EQ(loaded.pages().owners().read(), old.pages().owners().read());
}

TEST_F(Change, ParameterOfAContainer) {
    const before::Grid saved = save_grid();
    after::OtherPolicy loaded(host(), uint2(16, 16), 9u);
    load(path(), "it", loaded);
    EXPECT_EQ(snapshot::difference(snapshot::of(saved), snapshot::of(loaded)), "");
}

TEST_F(Change, PageSize) {
    save_grid();
    const std::string text = refusal(after::OtherPage(host(), uint2(16, 16), 9u));
    EXPECT_THAT(text, HasSubstr("the file has Sparse<2, Cell, uint2(4, 2)>(extent {16, 16}, capacity 9"));
    EXPECT_THAT(text, HasSubstr("the program Sparse<2, Same, uint2(2, 4)>(extent {16, 16}, capacity 9"));
    EXPECT_THAT(text, HasSubstr("by a pipeline"));
}

TEST_F(Change, TableKind) {
    save_grid();
    EXPECT_THAT(refusal(after::OtherTable(host(), uint2(16, 16), 9u)), HasSubstr("TwoLevels<16>"));
}

TEST_F(Change, ExtentOfASparseGrid) {
    save_grid();
    const std::string text = refusal(after::Grid(host(), uint2(32, 16), 9u));
    EXPECT_THAT(text, HasSubstr("the structure was saved with other arguments"));
    EXPECT_THAT(text, HasSubstr("extent {16, 16}"));
    EXPECT_THAT(text, HasSubstr("extent {32, 16}"));
}

TEST_F(Change, OtherName) {
    save_plane();
    after::Plane plane(host(), uint2(16, 8));
    try {
        load(path(), "other", plane);
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("it has: it"));
    }
}

}  // namespace
