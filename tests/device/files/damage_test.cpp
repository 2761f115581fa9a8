// Files that were altered, cut off, or whose save was killed: refused or whole, never a crash, never wrong elements.
#include "folder.h"

#include "damage.glift.hpp"

#include <glift/files.h>

#include <chrono>
#include <fcntl.h>
#include <fstream>
#include <random>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

extern char** environ;

namespace {

using namespace glift;

std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A file that is open for changes of single bytes.
class Altered {
public:
    explicit Altered(const std::string& path) : file_(::open(path.c_str(), O_RDWR)) {}
    ~Altered() { ::close(file_); }
    void put(std::size_t at, char byte) { ASSERT_EQ(::pwrite(file_, &byte, 1, static_cast<off_t>(at)), 1); }
    void cut(std::size_t bytes) { ASSERT_EQ(::ftruncate(file_, static_cast<off_t>(bytes)), 0); }

private:
    int file_;
};

class Damage : public files_test::InFolder {
protected:
    const Device& host() { return files_test::device("host"); }

    /// Loads all of the file; the code of the error, if there is one.
    template <class S> std::optional<ErrorCode> error_of_load(const std::string& name) {
        try {
            load<S>(path(), name, host());
            return std::nullopt;
        } catch (const Error& error) {
            return error.code();
        }
    }
    /// Inverts bytes one at a time; each change must be noticed.
    template <class S> void alter(const std::string& name, std::size_t begin, std::size_t step) {
        const std::string whole = contents(path());
        Altered file(path());
        for (std::size_t at = begin; at < whole.size(); at += step) {
            file.put(at, static_cast<char>(~whole[at]));
            ASSERT_EQ(error_of_load<S>(name), ErrorCode::bad_file) << "byte " << at;
            file.put(at, whole[at]);
        }
        ASSERT_EQ(error_of_load<S>(name), std::nullopt);
    }
};

/// A file this small is all metadata: each byte.
TEST_F(Damage, EveryByteOfTheMetadata) {
    damage::Grid grid(host(), uint2(16, 16), 4u, 1.0f);
    save(path(), "grid", grid);
    alter<damage::Grid>("grid", 0, 1);
}

TEST_F(Damage, EachThousandthByteOfElements) {
    std::vector<uint> values(1u << 20);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<uint>(i * 2654435761u);
    damage::Line line(host(), static_cast<uint>(values.size()));
    line.write(values);
    save(path(), "line", line);
    alter<damage::Line>("line", 7, 1000);
}

/// Of many blocks: elements are read ahead, past the page cache, and written so.
class LargeFile : public Damage {
protected:
    static constexpr uint elements = 11'000'003;  // 42 MiB, and no whole number of anything

    LargeFile() : values_(elements) {
        for (uint i = 0; i < elements; ++i) values_[i] = i * 2654435761u;
        damage::Line line(host(), elements);
        line.write(values_);
        save(path(), "line", line);
    }
    std::vector<uint> values_;
};

TEST_F(LargeFile, IsLoaded) {
    EXPECT_EQ(load<damage::Line>(path(), "line", host()).read(), values_);  // mostly from the cache, or not
    const int file = ::open(path().c_str(), O_RDONLY);
    ::posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
    ::close(file);
    EXPECT_EQ(load<damage::Line>(path(), "line", host()).read(), values_);
    contents(path());  // now the cache has it
    EXPECT_EQ(load<damage::Line>(path(), "line", host()).read(), values_);
}

TEST_F(LargeFile, Damaged) {
    const std::string whole = contents(path());
    Altered file(path());
    for (std::size_t at :
         {std::size_t{3'000'000}, std::size_t{17'000'000}, whole.size() / 2, std::size_t{43'000'000}}) {
        file.put(at, static_cast<char>(~whole[at]));
        EXPECT_EQ(error_of_load<damage::Line>("line"), ErrorCode::bad_file) << "byte " << at;
        file.put(at, whole[at]);
    }
    EXPECT_EQ(error_of_load<damage::Line>("line"), std::nullopt);
}

/// A file that becomes shorter while it is open.
TEST_F(LargeFile, CutOffWhileOpen) {
    File file(path());
    Altered(path()).cut(20 << 20);
    damage::Line line(host(), elements);
    EXPECT_THROW(file.load("line", line), Error);
}

/// The disk is full, or the file may not be so large.
TEST_F(LargeFile, ThatCannotBeWritten) {
    damage::Line line(host(), elements);
    line.write(values_);
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    ::signal(SIGXFSZ, SIG_IGN);
    for (rlim_t most : {rlim_t{0}, rlim_t{1000}, rlim_t{5} << 20, rlim_t{40} << 20}) {
        const rlimit limited{most, before.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limited);
        EXPECT_THROW(save(path("other.h5"), "line", line), Error) << most;
        ::setrlimit(RLIMIT_FSIZE, &before);
        EXPECT_FALSE(std::filesystem::exists(path("other.h5")) || std::filesystem::exists(path("other.h5.saving")));
    }
    save(path("other.h5"), "line", line);
    EXPECT_EQ(load<damage::Line>(path("other.h5"), "line", host()).read(), values_);
}

/// Zeros are not written: chunks with elements lie between them.
TEST_F(LargeFile, WithZeros) {
    for (uint i = 0; i < elements; ++i)
        if (i / 3'000'000 % 2 == 1) values_[i] = 0;
    damage::Line line(host(), elements);
    line.write(values_);
    save(path(), "line", line);
    EXPECT_LT(std::filesystem::file_size(path()), elements * 4 * 3 / 4);
    EXPECT_EQ(load<damage::Line>(path(), "line", host()).read(), values_);
}

TEST_F(Damage, CutOffAtEvery4096Bytes) {
    damage::Line line(host(), 1u << 20);
    line.fill(3);
    save(path(), "line", line);
    const std::string whole = contents(path());
    for (std::size_t bytes = whole.size() / 4096 * 4096;; bytes -= 4096) {
        Altered(path()).cut(bytes);
        ASSERT_EQ(error_of_load<damage::Line>("line"), ErrorCode::bad_file) << bytes;
        if (bytes == 0) break;
    }
}

TEST_F(Damage, MoreBytesAtTheEnd) {
    damage::Line line(host(), 100u);
    save(path(), "line", line);
    std::ofstream(path(), std::ios::app | std::ios::binary) << "x";
    EXPECT_EQ(error_of_load<damage::Line>("line"), ErrorCode::bad_file);
}

TEST_F(Damage, OtherFiles) {
    std::ofstream(path()) << std::string(10000, 'x');
    EXPECT_EQ(error_of_load<damage::Line>("line"), ErrorCode::bad_file);
    std::filesystem::remove(path());
    EXPECT_EQ(error_of_load<damage::Line>("line"), ErrorCode::wrong_argument);
}

/// A save is killed at 50 moments: afterwards there is a whole file, the one of this save or one of an earlier one.
TEST_F(Damage, KilledWhileSaving) {
    constexpr uint elements = 1u << 20;
    damage::Line line(host(), elements);
    save(path(), "line", line);
    std::mt19937 random(5);
    uint files = 0;
    for (int time = 0; time < 50; ++time) {
        std::string program = GLIFT_SAVER, file = path(), count = std::to_string(elements);
        char* const arguments[] = {program.data(), file.data(), count.data(), nullptr};
        pid_t child = 0;
        ASSERT_EQ(::posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments, environ), 0);
        std::this_thread::sleep_for(std::chrono::milliseconds(20 + random() % 150));
        ::kill(child, SIGKILL);
        int status = 0;
        ::waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << "the saver ended by itself";
        const std::vector<uint> values = load<damage::Line>(path(), "line", host()).read();
        ASSERT_EQ(values.size(), elements);
        for (uint value : values) ASSERT_EQ(value, values[0]);
        files += values[0] != 0;
    }
    EXPECT_GT(files, 0u);
    // What the killed one left is replaced.
    save(path(), "line", line);
    EXPECT_FALSE(std::filesystem::exists(path() + ".saving"));
}

TEST_F(Damage, DiscardedWithoutCommit) {
    damage::Line line(host(), 10u);
    line.fill(1);
    save(path(), "line", line);
    {
        NewFile file(path());
        line.fill(2);
        file.save("line", line);
        EXPECT_THROW(NewFile second(path()), Error) << "two at once";
    }
    EXPECT_EQ(load<damage::Line>(path(), "line", host()).read(), std::vector<uint>(10, 1u));
    EXPECT_FALSE(std::filesystem::exists(path() + ".saving"));
}

TEST_F(Damage, NamesThatCannotBe) {
    damage::Line line(host(), 10u);
    NewFile file(path());
    for (const char* name : {"", ".", "a/b"}) EXPECT_THROW(file.save(name, line), Error);
    file.save("line", line);
    EXPECT_THROW(file.save("line", line), Error);
    file.commit();
    EXPECT_THROW(file.save("other", line), Error);
    EXPECT_THROW(file.commit(), Error);
}

TEST_F(Damage, NotInARecording) {
    damage::Line line(host(), 10u);
    save(path(), "line", line);
    EXPECT_THROW(host().record([&](const Commands&) { save(path("other.h5"), "line", line); }), Error);
    EXPECT_THROW(host().record([&](const Commands&) { load(path(), "line", line); }), Error);
}

}  // namespace
