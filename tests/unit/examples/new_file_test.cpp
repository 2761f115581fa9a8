#include "examples/common/new_file.h"
#include "support/process.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <stdexcept>

namespace {

using glift::test::read_file;
using glift::test::write_file;

struct NewFiles : testing::Test {
    glift::test::TemporaryFolder folder;
    std::string path = folder.path() / "a";
    std::size_t files() const { return glift::test::files_under(folder.path(), "").size(); }
};

TEST_F(NewFiles, ReplaceOldOnesWhenTheyAreWhole) {
    write_file(path, "old");
    {
        NewFile file(path);
        file.write("new, ");
        EXPECT_EQ(read_file(path), "old");
        file.write("whole");
        file.take_name();
    }
    EXPECT_EQ(read_file(path), "new, whole");
    EXPECT_EQ(files(), 1u);
    {
        NewFile file(path);
        file.write("it ends in the middle");
    }
    EXPECT_EQ(read_file(path), "new, whole");
    EXPECT_EQ(files(), 1u);
}

TEST_F(NewFiles, TouchNoOtherFile) {
    write_file(path + ".new", "a user's");
    NewFile one(path), other(path);
    one.write("one");
    other.write("other");
    one.take_name();
    EXPECT_EQ(read_file(path), "one");
    other.take_name();
    EXPECT_EQ(read_file(path), "other");
    EXPECT_EQ(read_file(path + ".new"), "a user's");
}

TEST_F(NewFiles, AreWhereLinksLead) {
    write_file(path, "old");
    const std::string link = folder.path() / "link";
    std::filesystem::create_symlink(path, link);
    NewFile file(link);
    file.write("new");
    file.take_name();
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(read_file(path), "new");
}

TEST_F(NewFiles, TakeNoPlaceOfFoldersAndDevices) {
    for (const std::string& bad : {folder.path().string(), std::string("/dev/null"), path + "/b"})
        EXPECT_THROW(NewFile{bad}, std::runtime_error) << bad;
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

}  // namespace
