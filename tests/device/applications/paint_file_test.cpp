// Files of paint: what is written is read again, what is damaged or altered is refused, and a crash loses nothing.
#include "paint_model.h"
#include "support/process.h"

#include "examples/paint/paint_file.h"

#include <gmock/gmock.h>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <set>
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
    EXPECT_EQ(glift::test::files_under(folder.path(), "").size(), 2u) << "none is left beside them";
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

constexpr std::size_t header_words = 16, texels_of_page = 17 * 17 * 17, page_words = texels_of_page + 1;

/// A file whose checksums can be made to match again after an alteration. So it looks like a file that a program has
/// altered, not like one that a failing disk has damaged.
struct Forged : Held {
    using Held::Held;

    Word pages() const { return words[5]; }
    Word* page(std::size_t i) { return words.data() + header_words + pages() + 1 + i * page_words; }
    std::string refused_header(std::size_t word, Word value) {
        Forged other = *this;
        other.words[word] = value;
        other.sign(other.words.data(), header_words - 1);
        return other.refused(other.bytes());
    }
    /// Writes the checksum of `count` words into the word after them.
    void sign(Word* first, std::size_t count) const {
        first[count] = static_cast<Word>(crc32_z(0, reinterpret_cast<const Bytef*>(first), 4 * count));
    }
};

TEST_F(PaintFile, IsRefusedWhereItIsAlteredWithItsChecksums) {
    Canvas canvas(device, model(), small());
    canvas.paint(random_strokes(1, 13)[0]);
    canvas.save(file("whole.paint"));
    Forged whole(read_file(file("whole.paint")));
    ASSERT_EQ(whole.refused(whole.bytes()), "");
    ASSERT_GT(whole.pages(), 9u);
    Forged swapped = whole;
    std::swap_ranges(swapped.page(7), swapped.page(8), swapped.page(8));
    EXPECT_THAT(swapped.refused(swapped.bytes()), HasSubstr("is damaged: the checksum of page"));
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -0.1f, 1.5f})
        for (const std::size_t word : {6u, 7u, 8u})
            EXPECT_THAT(whole.refused_header(word, std::bit_cast<Word>(bad)),
                        HasSubstr("has a ground that is no colour"));
    EXPECT_EQ(whole.refused_header(6, std::bit_cast<Word>(1.0f)), "");
    for (std::size_t word = 9; word < 15; ++word)
        EXPECT_THAT(whole.refused_header(word, 77),
                    HasSubstr("has words in its header that this program does not know"));
    for (const Word other : {1u, 3u})
        EXPECT_THAT(whole.refused_header(2, other),
                    HasSubstr("is of version " + std::to_string(other) + ", and this program reads version 2"));
}

/// The page of the next coarser level that a page lies in.
Word parent_of(Word page) {
    Word along = 1, first = 0;
    for (; page >= along * along * along; along *= 2) {
        page -= along * along * along;
        first += along * along * along;
    }
    const Word half = along / 2;
    return first - half * half * half + page % along / 2 +
           half * (page / along % along / 2 + half * (page / along / along / 2));
}

/// A page can be left out, with all checksums right, if no finer one lies in it.
TEST_F(PaintFile, IsRefusedWhereAParentIsMissing) {
    Canvas canvas(device, model(), small());
    canvas.paint(random_strokes(1, 13)[0]);
    canvas.save(file("whole.paint"));
    const Forged whole(read_file(file("whole.paint")));
    std::set<Word> parents{0};
    for (Word i = 1; i < whole.pages(); ++i) parents.insert(parent_of(whole.words[header_words + i]));
    EXPECT_GT(parents.size(), 5u);
    for (Word gone = 0; gone < whole.pages(); gone += gone < 20 ? 1 : 9) {
        Forged less = whole;
        const auto page = less.words.begin() + (less.page(gone) - less.words.data());
        less.words.erase(page, page + page_words);
        less.words.erase(less.words.begin() + header_words + gone);
        --less.words[5];
        less.sign(less.words.data(), header_words - 1);
        less.sign(less.words.data() + header_words, less.pages());
        const bool has_finer = parents.contains(whole.words[header_words + gone]);
        EXPECT_EQ(less.refused(less.bytes()), has_finer ? "held.paint: has a page table that no octree has" : "")
            << gone;
    }
}

/// The file of a pool that was too small for all pages is accepted: of each page that has a frame, all coarser pages
/// that the page lies in have frames, too.
TEST_F(PaintFile, OfAFullPoolIsLoaded) {
    Canvas canvas(device, model(), small(40));
    Word lost = 0;
    for (const strokes::Stroke& stroke : random_strokes(3, 10)) lost += canvas.paint(stroke);
    ASSERT_GT(lost, 0u);
    canvas.save(file("full.paint"));
    const State state = state_of(canvas);
    canvas.load(file("full.paint"));
    EXPECT_TRUE(state_of(canvas).texels == state.texels);
}

TEST_F(PaintFile, IsNoFolder) {
    Canvas canvas(device, model(), small());
    try {
        canvas.load(folder.path());
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_EQ(error.what(), folder.path().string() + ": is a folder");
    }
}

/// A program that loads one file of paint and saves it over another.
struct Saving : PaintFile {
    std::string old_bytes, new_bytes;

    Saving() {
        Canvas canvas(device, model(), small());
        const std::vector<strokes::Stroke> all = random_strokes(4, 16);
        canvas.paint(all[0]);
        canvas.save(file("old.paint"));
        for (const strokes::Stroke& stroke : all) canvas.paint(stroke);
        canvas.save(file("new.paint"));
        old_bytes = read_file(file("old.paint"));
        new_bytes = read_file(file("new.paint"));
        write_file(file("model.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        std::filesystem::create_directory(file("saved"));
    }

    /// Writes the old contents to saved/a.paint, and starts the program. A signal ends the program when it writes to a
    /// file beyond `most_bytes`.
    pid_t started(rlim_t most_bytes = RLIM_INFINITY) const {
        write_file(file("saved/a.paint"), old_bytes);
        const pid_t process = fork();
        if (process < 0) throw std::runtime_error("no process can be started");
        if (process != 0) return process;
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        const rlimit no_core{0, 0}, size{most_bytes, most_bytes};
        setrlimit(RLIMIT_CORE, &no_core);
        setrlimit(RLIMIT_FSIZE, &size);
        setenv("GLIFT_DEVICE", "host", 1);
        const std::vector<std::string> words = {
            GLIFT_PAINT,        file("model.obj"), "--resolution",        "128",    "--pages", "1500", "--load",
            file("new.paint"),  "--save",          file("saved/a.paint"), "--size", "8",       "8",    "--out",
            file("picture.png")};
        std::vector<char*> arguments;
        for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        if (!std::freopen("/dev/null", "w", stdout)) _exit(126);
        execv(arguments[0], arguments.data());
        _exit(127);
    }
    /// Bytes of the file that is being written beside the old one; none if there is no such file.
    std::optional<std::uintmax_t> bytes_of_new() const {
        std::error_code error;
        for (const auto& entry : std::filesystem::directory_iterator(file("saved"), error))
            if (entry.path().filename() != "a.paint") {
                const std::uintmax_t bytes = std::filesystem::file_size(entry.path(), error);
                if (!error) return bytes;
            }
        return std::nullopt;
    }
    std::string saved() const { return read_file(file("saved/a.paint")); }
    void tidy() const {
        std::filesystem::remove_all(file("saved"));
        std::filesystem::create_directory(file("saved"));
    }
};

/// A signal ends the program when the new file has one of several sizes: before it has bytes, in its header, its page
/// table and its pages, and when only the last byte is missing.
TEST_F(Saving, LeavesTheOldFileWhereItEndsInTheMiddle) {
    const std::size_t whole = new_bytes.size();
    ASSERT_NE(old_bytes, new_bytes);
    for (const std::size_t at : {std::size_t{0}, std::size_t{10}, std::size_t{64}, std::size_t{100}, whole / 3,
                                 whole / 2, whole - 1000, whole - 1}) {
        int status = 0;
        waitpid(started(at), &status, 0);
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ) << at;
        EXPECT_EQ(bytes_of_new(), at) << "it was met while it was writing";
        EXPECT_TRUE(saved() == old_bytes) << at;
        tidy();
    }
    int status = 0;
    waitpid(started(), &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(saved() == new_bytes);
}

/// Kills the program (SIGKILL) at moments from when the new file exists until after it has its final name.
TEST_F(Saving, LeavesTheOldOrTheNewFileWhereItIsKilled) {
    unsigned with_old = 0;
    for (const int microseconds : {20000, 12000, 8000, 5000, 3000, 2000, 1000, 300, 100, 0, 0}) {
        tidy();
        const pid_t process = started();
        int status = 0;
        bool has_ended = false;
        while (!has_ended && !bytes_of_new()) has_ended = waitpid(process, &status, WNOHANG) == process;
        std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
        if (!has_ended) {
            kill(process, SIGKILL);
            waitpid(process, &status, 0);
        }
        const std::string found = saved();
        EXPECT_TRUE(found == old_bytes || found == new_bytes) << microseconds << ": " << found.size() << " bytes";
        with_old += WIFSIGNALED(status) && found == old_bytes;
    }
    EXPECT_GT(with_old, 0u) << "no attempt met the moment";
    int status = 0;
    waitpid(started(), &status, 0);  // beside the files that killed programs left
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(saved() == new_bytes);
}

}  // namespace
