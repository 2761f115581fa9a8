// The program paint without a window: exported samples, what it undoes, and command lines that it refuses.
#include "paint_model.h"
#include "support/process.h"

#include "examples/common/png.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace {

using namespace paint_model;
using glift::float2;
using strokes::Stroke;
using testing::HasSubstr;

struct PaintProgram : testing::Test {
    glift::test::TemporaryFolder folder;

    PaintProgram() {
        glift::test::write_file(file("sheet.obj"), "v 0 0 0.2\nv 1 0 0.2\nv 1 1 0.2\nv 0 1 0.3\nf 1 2 3 4\n");
    }
    std::string file(const char* name) const { return folder.path() / name; }
    glift::test::ProcessResult run(const std::vector<std::string>& options) const {
        std::vector<std::string> words = {"env", "GLIFT_DEVICE=host", GLIFT_PAINT, file("sheet.obj"), "--resolution",
                                          "128", "--pages",           "300"};
        words.insert(words.end(), options.begin(), options.end());
        return glift::test::run_process(words);
    }
    /// The picture that the program writes.
    png::Picture painted(std::vector<std::string> options) const {
        options.insert(options.end(), {"--size", "32", "24", "--out", file("out.png")});
        const auto done = run(options);
        EXPECT_EQ(done.exit_code, 0) << done.err;
        return png::read(file("out.png"));
    }
    /// The error message for a command line, which the program must refuse before it paints any strokes.
    std::string refused(const std::vector<std::string>& options) const {
        const auto done = run(options);
        EXPECT_NE(done.exit_code, 0) << done.out;
        EXPECT_THAT(done.out, testing::Not(HasSubstr("dabs"))) << "it is refused before strokes are painted";
        return done.err;
    }
};

TEST_F(PaintProgram, ExportsSamples) {
    const Stroke stroke = paint_model::one_dab();
    strokes::write(file("one.strokes"), {stroke});
    painted({"--strokes", file("one.strokes"), "--npy", file("out.npy"), "--npy-side", "9"});
    // The header is that of NumPy's format, version 1.
    const std::string bytes = glift::test::read_file(file("out.npy"));
    EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    EXPECT_THAT(bytes.substr(0, 128), HasSubstr("'descr': '<f4'"));
    EXPECT_THAT(bytes.substr(0, 128), HasSubstr("'shape': (9, 9, 9, 4)"));
    const npy::Array array = npy::read(file("out.npy"));
    EXPECT_EQ(array.extent, (std::vector<std::uint32_t>{4, 9, 9, 9}));
    Canvas canvas(glift::Device::open("host"), model_of(file("sheet.obj")), small(300));
    canvas.paint(stroke);
    EXPECT_EQ(array.values, canvas.samples(9).values);
    EXPECT_GT(*std::ranges::max_element(array.values), 0.85f) << "painted red, of 0.75";
}

/// Models that are made by name; an unknown name is refused.
TEST(PaintedModel, IsMadeByName) {
    const mesh::Box box = mesh::bounds_of(model_of("knot"));
    EXPECT_NEAR(box.high.x - box.low.x, 1, 0.2);
    EXPECT_GT(model_of("robot").triangles(), 1000u);
    EXPECT_THROW(model_of("no such model"), std::runtime_error);
}

TEST_F(PaintProgram, UndoesTheLastStrokeAlsoIfItMissed) {
    Stroke beside = paint_model::one_dab();
    beside.path = {{float2(-500, 100), 1}};
    strokes::write(file("hit.strokes"), {paint_model::one_dab()});
    strokes::write(file("both.strokes"), {paint_model::one_dab(), beside});
    const std::vector<float> blank = painted({}).values, hit = painted({"--strokes", file("hit.strokes")}).values;
    EXPECT_NE(hit, blank);
    EXPECT_EQ(painted({"--strokes", file("both.strokes"), "--undo", "1"}).values, hit);
    EXPECT_EQ(painted({"--strokes", file("both.strokes"), "--undo", "2"}).values, blank);
    EXPECT_EQ(painted({"--strokes", file("both.strokes"), "--undo", "2", "--redo", "1"}).values, hit);
}

TEST_F(PaintProgram, TakesASizeInOneWord) {
    const auto done = run({"--size", "17x9", "--out", file("out.png")});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const png::Picture made = png::read(file("out.png"));
    EXPECT_EQ(made.width, 17u);
    EXPECT_EQ(made.height, 9u);
}

TEST_F(PaintProgram, RefusesWhatItWouldIgnore) {
    strokes::write(file("one.strokes"), {paint_model::one_dab()});
    const std::string one = file("one.strokes");
    EXPECT_THAT(refused({"--window", "--bend", "1"}), HasSubstr("--window excludes --bend"));
    EXPECT_THAT(refused({"--window", "--strokes", one, "--undo", "1"}), HasSubstr("--window excludes --undo"));
    EXPECT_THAT(refused({"--window", "--redo", "1"}), HasSubstr("--redo requires --undo"));
    EXPECT_THAT(refused({"--strokes", one, "--record", file("a.strokes")}), HasSubstr("--record requires --window"));
    glift::test::write_file(file("brush.png"), "");
    EXPECT_THAT(refused({"--brush", file("brush.png")}), HasSubstr("--brush requires --strokes or --window"));
    EXPECT_THAT(refused({"--npy-side", "9"}), HasSubstr("--npy-side requires --npy"));
}

TEST_F(PaintProgram, RefusesBeforeItPaints) {
    strokes::write(file("one.strokes"), {paint_model::one_dab()});
    glift::test::write_file(file("no.png"), "no picture");
    const auto said = [&](std::vector<std::string> options) {
        options.insert(options.end(), {"--strokes", file("one.strokes")});
        return refused(options);
    };
    EXPECT_THAT(said({"--out", file("a.jpg")}), HasSubstr("a.jpg: pictures are .png or .exr files"));
    EXPECT_THAT(said({"--out", file("no/a.png")}), HasSubstr("no/a.png: there is no such folder"));
    EXPECT_THAT(said({"--save", file("no/a.paint")}), HasSubstr("no/a.paint: there is no such folder"));
    EXPECT_THAT(said({"--save", folder.path()}), HasSubstr(": is a folder"));
    EXPECT_THAT(said({"--load", folder.path()}), HasSubstr("--load: "));
    EXPECT_THAT(said({"--brush", file("no.png")}), HasSubstr("no.png: cannot be read as a PNG"));
    for (const char* option : {"--turn", "--upwards", "--closer", "--bend"})
        for (const char* number : {"nan", "inf"}) EXPECT_NE(said({option, number}), "") << option << " " << number;
    EXPECT_NE(said({"--target", "0", "nan", "0"}), "");
    EXPECT_THAT(said({"--closer", "101"}), HasSubstr("--closer: Value 101 not in range"));
}

}  // namespace
