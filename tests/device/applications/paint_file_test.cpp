// Files of paint and of strokes: what is written is read again, what is damaged is refused, and a crash loses nothing.
#include "paint_model.h"
#include "support/process.h"

#include "examples/paint/paint_file.h"

#include <gmock/gmock.h>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>

namespace {

using namespace paint_model;
using glift::test::read_file;
using glift::test::write_file;
using testing::HasSubstr;

struct PaintFile : testing::Test {
    glift::test::TemporaryFolder folder;
    glift::Device device = glift::Device::open("host");

    std::string file(const char* name) const { return folder.path() / name; }

    /// Loads a file of these bytes. The text of the error that this throws; empty if it throws none.
    std::string refused(Canvas& canvas, const std::string& bytes) const {
        write_file(file("altered.paint"), bytes);
        try {
            canvas.load(file("altered.paint"));
            return {};
        } catch (const std::runtime_error& error) {
            return error.what();
        }
    }
};

TEST_F(PaintFile, IsTheSameWhenItIsSavedAgain) {
    Canvas canvas(device, model(), small());
    for (const strokes::Stroke& stroke : random_strokes(3, 11)) canvas.paint(stroke);
    canvas.save(file("first.paint"));
    const State state = state_of(canvas);
    const char* name = std::getenv("GLIFT_TEST_DEVICE");
    for (const std::string& other : {std::string("host"), std::string(name ? name : "lavapipe")}) {
        Canvas loaded(glift::Device::open(other), model(), small(900));
        loaded.paint(random_strokes(1, 12)[0]);  // loading removes it
        loaded.load(file("first.paint"));
        EXPECT_FALSE(loaded.undo());
        const State found = state_of(loaded);
        EXPECT_EQ(found.pages, state.pages);
        EXPECT_TRUE(found.texels == state.texels);
        loaded.save(file("second.paint"));
        EXPECT_TRUE(read_file(file("second.paint")) == read_file(file("first.paint")));
    }
    EXPECT_FALSE(std::filesystem::exists(file("first.paint.new")));
}

/// A file in memory, to be altered and checked without a device.
struct Held {
    std::vector<glift::uint> words;

    explicit Held(const std::string& bytes) : words(bytes.size() / 4) {
        std::memcpy(words.data(), bytes.data(), 4 * words.size());
    }
    std::size_t bytes() const { return 4 * words.size(); }
    /// Checks the first `size` bytes. The text of the error that this throws; empty if it throws none.
    std::string refused(std::size_t size) const {
        try {
            paint_file::check("held.paint", {words.data(), size / 4}, size);
            return {};
        } catch (const std::runtime_error& error) {
            return error.what();
        }
    }
    std::string refused_altered(std::size_t at, unsigned char by) {
        unsigned char& byte = reinterpret_cast<unsigned char*>(words.data())[at];
        byte ^= by;
        std::string said = refused(bytes());
        byte ^= by;
        return said;
    }
};

/// Alters every byte of the header and every 1000th of the rest, and cuts the file at every multiple of 4096 bytes and
/// at four other sizes.
void expect_damage_is_refused(Held& file) {
    ASSERT_EQ(file.refused(file.bytes()), "");
    for (std::size_t at = 0; at < 64; ++at)
        for (unsigned by = 1; by < 256; by = 2 * by + 1)
            EXPECT_NE(file.refused_altered(at, static_cast<unsigned char>(by)), "") << "byte " << at << " by " << by;
    for (std::size_t at = 64; at < file.bytes(); at += 1000)
        EXPECT_THAT(file.refused_altered(at, 4), HasSubstr("is damaged")) << "byte " << at;
    for (std::size_t size = 0; size < file.bytes(); size += 4096)
        EXPECT_THAT(file.refused(size), HasSubstr("is truncated")) << size;
    for (const std::size_t size : {file.bytes() - 1, file.bytes() - 4, std::size_t{63}, std::size_t{65}})
        EXPECT_THAT(file.refused(size), HasSubstr("is truncated")) << size;
    EXPECT_EQ(file.refused(file.bytes()), "");
}

/// Damages a small file, and a large one if GLIFT_PAINT_FILE names it.
TEST_F(PaintFile, IsRefusedWhereItIsDamaged) {
    Canvas canvas(device, model(), small());
    canvas.paint(random_strokes(1, 13)[0]);
    canvas.save(file("whole.paint"));
    Held whole(read_file(file("whole.paint")));
    expect_damage_is_refused(whole);
    if (const char* name = std::getenv("GLIFT_PAINT_FILE")) {
        Held large(read_file(name));
        expect_damage_is_refused(large);
    }
}

TEST_F(PaintFile, ChangesNothingWhereItIsRefused) {
    Canvas canvas(device, model(), small());
    canvas.paint(random_strokes(1, 14)[0]);
    canvas.save(file("whole.paint"));
    const std::string whole = read_file(file("whole.paint"));
    const State state = state_of(canvas);
    EXPECT_EQ(refused(canvas, whole), "");
    for (const std::size_t at :
         {std::size_t{0}, std::size_t{20}, std::size_t{70}, whole.size() / 2, whole.size() - 1}) {
        std::string altered = whole;
        altered[at] = static_cast<char>(altered[at] ^ 4);
        EXPECT_THAT(refused(canvas, altered), HasSubstr("altered.paint: ")) << "byte " << at;
        EXPECT_THAT(refused(canvas, whole.substr(0, at)), HasSubstr("is truncated")) << at;
    }
    EXPECT_THAT(refused(canvas, whole + "four"), HasSubstr("has bytes too many"));
    EXPECT_THAT(refused(canvas, whole + "5"), HasSubstr("is truncated: its length is no number of words"));
    EXPECT_THAT(refused(canvas, "{\"this\": \"is a text, of more than 64 characters, and no file of paint at all\"}  "),
                HasSubstr("is no file of 3-D paint"));
    EXPECT_TRUE(state_of(canvas) == state);
}

TEST_F(PaintFile, SaysWhatDoesNotFit) {
    Canvas canvas(device, model(), small());
    canvas.paint(random_strokes(1, 15)[0]);
    canvas.save(file("whole.paint"));
    const std::string whole = read_file(file("whole.paint"));
    Canvas few(device, model(), small(5));
    EXPECT_THAT(refused(few, whole), HasSubstr("pages, and there may be 5: give more of them by --pages"));
    OctreeSize coarse = small();
    coarse.resolution = 64;
    Canvas other(device, model(), coarse);
    EXPECT_THAT(refused(other, whole), HasSubstr("is paint of 128^3, and the octree has 64^3"));
    EXPECT_THROW(canvas.load(file("missing.paint")), std::runtime_error);
    EXPECT_THROW(canvas.save("/dev/null/no.paint"), std::runtime_error);
}

/// Runs a program that saves, and kills it when the new file is there. Whether it was killed and the new file is left.
bool killed_while_saving(const std::vector<std::string>& words, const std::string& new_file) {
    const pid_t process = fork();
    if (process == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        std::vector<char*> arguments;
        for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        if (!std::freopen("/dev/null", "w", stdout)) _exit(126);
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    int status = 0;
    while (waitpid(process, &status, WNOHANG) == 0)
        if (access(new_file.c_str(), F_OK) == 0) {
            kill(process, SIGKILL);
            waitpid(process, &status, 0);
            break;
        }
    return WIFSIGNALED(status) && access(new_file.c_str(), F_OK) == 0;
}

TEST_F(PaintFile, IsTheOldOneWhereSavingIsKilled) {
    Canvas canvas(device, model(), small());
    for (const strokes::Stroke& stroke : random_strokes(4, 16)) canvas.paint(stroke);
    canvas.save(file("old.paint"));
    const std::string old = read_file(file("old.paint"));
    write_file(file("model.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    bool was_killed = false;
    for (unsigned attempt = 0; attempt < 20 && !was_killed; ++attempt) {
        was_killed = killed_while_saving({"env", "GLIFT_DEVICE=host", GLIFT_PAINT, file("model.obj"), "--resolution",
                                          "128", "--pages", "1500", "--load", file("old.paint"), "--save",
                                          file("old.paint"), "--size", "8", "8", "--out", file("picture.png")},
                                         file("old.paint.new"));
        EXPECT_TRUE(read_file(file("old.paint")) == old);
    }
    EXPECT_TRUE(was_killed) << "no attempt met the moment";
    canvas.load(file("old.paint"));
    canvas.save(file("old.paint"));  // over old.paint.new, which was left behind
    EXPECT_TRUE(read_file(file("old.paint")) == old);
    EXPECT_FALSE(std::filesystem::exists(file("old.paint.new")));
}

TEST_F(PaintFile, OfStrokesIsReadAsItWasWritten) {
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

TEST_F(PaintFile, OfStrokesSaysWhatIsWrong) {
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
}

}  // namespace
