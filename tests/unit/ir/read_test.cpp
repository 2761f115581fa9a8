// The text of a pass is complete: when it is parsed, it prints to the same text again.
#include "ir/print.h"
#include "ir/read.h"
#include "ir/validate.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace gliftc::ir {
namespace {

std::string read_file(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

struct Reading {
    Names names;
    Program program;
    std::vector<ReadPass> passes;

    explicit Reading(std::string_view text) {
        program.names = &names;
        passes = read_passes(program, text);
    }
    std::string printed() const {
        std::string text;
        for (const ReadPass& read : passes) text += print(program, read.pass) + "\n";
        return text;
    }
};

std::string error_of(std::string_view text) {
    try {
        Reading reading(text);
    } catch (const ReadError& error) {
        return error.what();
    }
    return "";
}

/// The file with the text of a golden test's passes, next to the test's source.
std::filesystem::path text_of(std::filesystem::path source) { return source.replace_extension(".expected.ir"); }

TEST(Read, GivesWhatWasPrintedForEveryGolden) {
    std::size_t passes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(GLIFT_SOURCE_DIR "/tests/golden")) {
        if (entry.path().extension() == ".glift" && entry.path().parent_path().filename() != "support") {
            EXPECT_TRUE(std::filesystem::exists(text_of(entry.path()))) << entry.path();
        }
        if (entry.path().extension() != ".ir") continue;
        SCOPED_TRACE(entry.path().filename().string());
        const std::string text = read_file(entry.path());
        try {
            const Reading reading(text);
            EXPECT_EQ(reading.printed(), text);
            for (const ReadPass& read : reading.passes)
                for (const std::string& problem : validate(reading.program, read.pass)) ADD_FAILURE() << problem;
            passes += reading.passes.size();
        } catch (const ReadError& error) {
            ADD_FAILURE() << error.what();
        }
    }
    EXPECT_GT(passes, 100u);
}

TEST(Read, KnowsWhatNoGoldenHas) {
    const std::string text = R"(pass all direct {
    group 64 1 1, rank 1
    struct Pair<uint, vec<2, int64>> { first: uint, second: vec<2, int64> }
    enum Mode { one = 1, two = 2 }
    value scale: half
    structure f
    binding f_data: buffer<Pair<uint, vec<2, int64>>> read_write coherent of f.table 1
    parameter size: uint = size
    fn @translate(va: uint3) -> uint {
        return va[1u] + ((state0: uint3)[0u] * (state1: uint));
    }
    body
        let a: half = 1.5h * scale;
        let b: double = 2.25d;
        let c: int64 = -3l + 4l;
        let d: float = -inf;
        let e: double = (-inf: double);
        let m: Mode = Mode.two;
        let o: uint? = (none: uint?);
        let p: uint? = some(3u);
        let x: uint = has_value(p) ? value(p) : 0u;
        let y: float = -(-1.0);
        f_data[x] = Pair<uint, vec<2, int64>>(x, vec<2, int64>(5l, c));
}

)";
    EXPECT_EQ(Reading(text).printed(), text);
}

TEST(Read, SaysTheLineAndWhatIsMissing) {
    EXPECT_EQ(error_of("pass k direct {\n    group 64 1 1, rank 1\n    body\n        let x: uint = y;\n}\n"),
              "line 4: 'y' is not declared before this, found ';'");
    EXPECT_EQ(error_of("pass k sideways {"), "line 1: expected a form before this, found ' {'");
}

}  // namespace
}  // namespace gliftc::ir
