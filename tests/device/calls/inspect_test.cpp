// What glift::inspect says of structures, and that tools/inspect draws it.
#include "resident.glift.hpp"
#include "support/process.h"

#include <glift/inspect.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using glift::uint2;
using glift::uint3;
using testing::HasSubstr;
using testing::Not;

class Inspect : public testing::TestWithParam<const char*> {
protected:
    const glift::Device& device() const { return device_; }

    resident::Grid grid() const {
        resident::Grid made(device(), {18, 9, 7}, 20, -1.0f);
        resident::Places places(device(), 3);
        places.write(std::vector<uint3>{{1, 0, 2}, {4, 4, 3}, {0, 0, 0}});
        resident::ask(device(), places, made);
        return made;
    }

    /// Saves the inspection and runs tools/inspect on it. Expects a picture; returns the HTML page.
    std::string drawn(const glift::Inspection& inspection) const {
        const glift::test::TemporaryFolder folder;
        const std::string file = (folder.path() / "some.inspection").string();
        inspection.save(file);
        const auto result = glift::test::run_process({GLIFT_TOOLS "/inspect", file});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        const std::string png = glift::test::read_file(folder.path() / "some.png");
        EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
        EXPECT_GT(png.size(), 200u);
        return glift::test::read_file(folder.path() / "some.html");
    }

private:
    glift::Device device_ = glift::Device::open(GetParam());
};

TEST_P(Inspect, AnAdaptorAndItsParts) {
    const std::string text = glift::inspect(grid(), "grid").text();
    EXPECT_THAT(text, HasSubstr("\"name\": \"grid\""));
    EXPECT_THAT(text, HasSubstr("\"text\": \"requested 3, granted 3, refused 0, resident 3, capacity 20\""));
    EXPECT_THAT(text, HasSubstr("\"elements\": 34"));  // grid.field: of three pages' 48 elements, 34 are in the domain
    EXPECT_THAT(text, HasSubstr("\"domain\": [18, 9, 7]"));
    EXPECT_THAT(text, HasSubstr("\"bytes_of_elements\": 1280"));  // 20 frames of 16 floats
    EXPECT_THAT(text, HasSubstr("\"role\": \"memory\""));
    const std::string page = drawn(glift::inspect(grid(), "grid"));
    EXPECT_THAT(page, HasSubstr("grid.field.frames"));
    EXPECT_THAT(page, HasSubstr("34 of 1134 (3 %)"));
    EXPECT_THAT(page, HasSubstr("share of each cell that is there, layer by layer"));
    EXPECT_THAT(page, HasSubstr("data:image/png;base64,"));
    EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
}

TEST_P(Inspect, TablesOfTwoLevelsAndOfAHash) {
    resident::Places2 places(device(), 3);
    places.write(std::vector<uint2>{{24, 14}, {0, 0}, {7, 3}});
    resident::Two two(device(), {100, 60}, 12, 5u);
    resident::ask(device(), places, two);
    EXPECT_THAT(drawn(glift::inspect(two, "two")), HasSubstr("48 of 6000"));
    resident::Hashed hashed(device(), 8, 1.5f);
    resident::ask(device(), places, hashed);
    EXPECT_THAT(drawn(glift::inspect(hashed, "hashed")), HasSubstr("192 of 18446744065119617025"));
}

TEST_P(Inspect, StructsHolesAndPlainArrays) {
    resident::Map map(device(), 4);
    EXPECT_THAT(drawn(glift::inspect(map)), HasSubstr("structure.keys"));
    EXPECT_THAT(drawn(glift::inspect(resident::Holes(device(), 1000))), HasSubstr("334 of 1000"));
    EXPECT_THAT(drawn(glift::inspect(resident::Plane(device(), {40, 30}))),
                HasSubstr("values, 0 to 0: plane of axes x and y"));
    resident::Line table(device(), 6);
    const resident::Cells cells(device(), table, {11, 8}, 2, {-1.0f, 0, {}});
    const std::string text = glift::inspect(cells).text();  // no page has a frame
    EXPECT_THAT(text, HasSubstr("\"text\": \"weight -1, count 0, along {0, 0}\""));
    EXPECT_THAT(text, HasSubstr("\"elements\": 0"));
    EXPECT_THAT(drawn(glift::inspect(cells)), HasSubstr("0 of 88"));
}

TEST_P(Inspect, WhatIsTooLargeIsNotRead) {
    const resident::Line table(device(), 1);
    const resident::Field large(device(), table, {65535, 65535, 17}, 1, 0.0f);
    EXPECT_THAT(drawn(glift::inspect(large)), HasSubstr("std.paged.ListedPages"));
    EXPECT_THAT(glift::inspect(resident::Holes(device(), 99), "holes", {.most_elements = 8}).text(),
                testing::AllOf(HasSubstr("only planes"), HasSubstr("\"places\""), Not(HasSubstr("\"use\""))));
}

TEST_P(Inspect, Errors) {
    const resident::Line line(device(), 1);
    EXPECT_THROW(glift::inspect(line).save("/nowhere/some.inspection"), glift::Error);
    const glift::test::TemporaryFolder folder;
    const std::string other = (folder.path() / "other.json").string();
    glift::test::write_file(other, "{}");
    for (const std::string& file : {other, std::string("/nowhere/some.inspection")}) {
        const auto result = glift::test::run_process({GLIFT_TOOLS "/inspect", file});
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_THAT(result.err, HasSubstr("tools/inspect: " + file));
    }
}

INSTANTIATE_TEST_SUITE_P(, Inspect, testing::Values("host", "lavapipe"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
