// Files of strokes: what is written is read again, what is wrong is refused, and no error destroys an old file.
#include "paint_model.h"
#include "support/process.h"

#include <gmock/gmock.h>

#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <limits>

namespace {

using namespace paint_model;
using glift::test::read_file;
using glift::test::write_file;
using testing::HasSubstr;

struct StrokeFile : testing::Test {
    glift::test::TemporaryFolder folder;
    std::string file(const char* name) const { return folder.path() / name; }
    std::size_t files() const { return glift::test::files_under(folder.path(), "").size(); }
};

/// While this object exists, files cannot grow beyond `most_bytes`, as on a disk that is full.
class FullDisk {
public:
    explicit FullDisk(rlim_t most_bytes) : old_signal_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &old_);
        const rlimit limit{most_bytes, old_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, old_signal_);
    }
    FullDisk(const FullDisk&) = delete;

private:
    rlimit old_{};
    void (*old_signal_)(int);
};

TEST_F(StrokeFile, IsReadAsItWasWritten) {
    const std::vector<strokes::Stroke> all = random_strokes(5, 17);
    strokes::write(file("made.strokes"), all);
    const std::vector<strokes::Stroke> found = strokes::read(file("made.strokes"));
    ASSERT_EQ(found.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_TRUE(strokes::dabs_of(found[i]) == strokes::dabs_of(all[i]));
        EXPECT_TRUE(strokes::viewpoint_of(found[i].camera, found[i].size) ==
                    strokes::viewpoint_of(all[i].camera, all[i].size));
    }
}

TEST_F(StrokeFile, SaysWhatIsWrong) {
    const auto said = [&](const std::string& line) -> std::string {
        write_file(file("bad.strokes"), "{\"path\": [[1, 2]]}\n\n" + line + "\n");
        try {
            strokes::read(file("bad.strokes"));
            return {};
        } catch (const std::runtime_error& error) {
            return error.what();
        }
    };
    EXPECT_EQ(said("{\"path\": [[1, 2, 0.5], [3, 4]]}"), "");
    EXPECT_THAT(said("{\"path\": [[1, 2]"), HasSubstr("bad.strokes, line 3: "));
    EXPECT_THAT(said("{}"), HasSubstr("a stroke has to have a 'path'"));
    EXPECT_THAT(said("[1]"), HasSubstr("'stroke' has to be an object"));
    EXPECT_THAT(said("{\"path\": [[1]]}"), HasSubstr("'path' has to be a list of 2 numbers"));
    EXPECT_THAT(said("{\"path\": [[1, 2, 7]]}"), HasSubstr("'pressure' is 7, and has to be from"));
    EXPECT_THAT(said("{\"path\": [[1, 2]], \"brush\": {\"radius\": -1}}"), HasSubstr("'radius' is -1"));
    EXPECT_THAT(said("{\"path\": [[1, 2]], \"brush\": {\"size\": 1}}"), HasSubstr("'brush' has no member 'size'"));
    EXPECT_THAT(said("{\"path\": [[1, 2]], \"brush\": {\"blend\": \"mix\"}}"), HasSubstr("'blend' has to be"));
    EXPECT_THAT(said("{\"path\": [[0, 0], [1e6, 0]], \"brush\": {\"radius\": 1}}"), HasSubstr("is too long"));
    EXPECT_THAT(said("{\"path\": [[1, 2]], \"camera\": {\"eye\": [1, 2, \"3\"]}}"),
                HasSubstr("'eye' has to be a number"));
    EXPECT_THAT(said("{\"path\": [[1, 2]], \"size\": [800.5, 600]}"),
                HasSubstr("line 3: 'size' has to be whole numbers"));
    const auto said_of_up = [&](const std::string& up) {
        return said("{\"path\": [[1, 2]], \"camera\": {\"eye\": [0, 0, 2], \"target\": [0, 0, 0], \"up\": " + up +
                    "}}");
    };
    EXPECT_EQ(said_of_up("[0, 0.1, 5]"), "");
    EXPECT_THAT(said_of_up("[0, 0, 0]"), HasSubstr("line 3: 'up' has to be a direction"));
    EXPECT_THAT(said_of_up("[0, 1e-30, 0]"), HasSubstr("line 3: 'up' has to be a direction"));
    for (const char* up : {"[0, 0, 1]", "[0, 0, -7]", "[1e-6, 0, 1]"})
        EXPECT_THAT(said_of_up(up), HasSubstr("line 3: 'up' has to be another direction than that of the view"));
}

TEST_F(StrokeFile, IsTheOldOneWhereItCannotBeWritten) {
    std::vector<strokes::Stroke> all = random_strokes(5, 17);
    strokes::write(file("made.strokes"), all);
    const std::string old = read_file(file("made.strokes"));
    {
        const FullDisk disk(100);
        EXPECT_THROW(strokes::write(file("made.strokes"), random_strokes(6, 18)), std::runtime_error);
    }
    EXPECT_EQ(read_file(file("made.strokes")), old);
    all[3].brush.picture = "/br\xff.png";
    try {
        strokes::write(file("made.strokes"), all);
        ADD_FAILURE();
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("has a name that is not in UTF-8"));
    }
    EXPECT_EQ(read_file(file("made.strokes")), old);
    EXPECT_EQ(files(), 1u) << "no other file is left";
    EXPECT_THROW(strokes::write(folder.path(), all), std::runtime_error);
}

/// Whatever numbers a panel gives for a brush, strokes with the nearest allowed numbers can be written and read again.
TEST_F(StrokeFile, TakesTheNearestBrushThatIsAllowed) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    std::vector<strokes::Stroke> all = random_strokes(1, 19);
    const paint::Brush right = strokes::dabs_of(all[0])[0];
    for (const float bad : {-3.0f, 1e30f, nan, infinity, -infinity}) {
        strokes::Stroke stroke = all[0];
        strokes::Brush& brush = stroke.brush;
        brush.radius = brush.hardness = brush.grain = brush.opacity = brush.flow = brush.cells = bad;
        brush.colour = {bad, bad, bad};
        brush = strokes::allowed(brush);
        all.push_back(stroke);
    }
    all[0].brush = strokes::allowed(all[0].brush);
    strokes::write(file("made.strokes"), all);
    const std::vector<strokes::Stroke> found = strokes::read(file("made.strokes"));
    ASSERT_EQ(found.size(), all.size());
    EXPECT_TRUE(strokes::dabs_of(found[0])[0] == right) << "what is allowed stays as it is";
    EXPECT_EQ(found[1].brush.radius, 0.5f);
    EXPECT_EQ(found[2].brush.radius, 8192);
    EXPECT_EQ(found[3].brush.flow, 0);
    EXPECT_EQ(found[4].brush.colour.y, 1);
}

}  // namespace
