// Reads and writes .npy files: every supported type and order, and errors for other files.
#include "examples/common/npy.h"
#include "support/process.h"

#include <gmock/gmock.h>

#include <cstring>

namespace {

using namespace std::string_literals;
using testing::ElementsAre;
using testing::HasSubstr;

std::string with_header(const std::string& header, const std::string& data, char version = 1) {
    std::string bytes = "\x93NUMPY"s + version + '\0';
    const auto length = static_cast<std::uint32_t>(header.size());
    for (int i = 0; i < (version == 1 ? 2 : 4); ++i) bytes += static_cast<char>(length >> (8 * i) & 0xff);
    return bytes + header + data;
}

std::string header_of(const std::string& type, const std::string& shape, bool fortran = false) {
    return "{'descr': '" + type + "', 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': " + shape +
           ", }\n";
}

template <class T> std::string bytes_of(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

struct Npy : testing::Test {
    npy::Array read(const std::string& bytes) {
        glift::test::write_file(path, bytes);
        return npy::read(path);
    }
    std::string problem(const std::string& bytes) {
        try {
            read(bytes);
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), HasSubstr(path));
            return error.what();
        }
        return "";
    }

    glift::test::TemporaryFolder folder;
    const std::string path = folder.path() / "a.npy";
};

TEST_F(Npy, TheLastAxisOfTheFileIsTheFirst) {
    const auto array = read(with_header(header_of("<f4", "(2, 3)"), bytes_of<float>({1, 2, 3, 4, 5, 6})));
    EXPECT_THAT(array.extent, ElementsAre(3, 2));
    EXPECT_THAT(array.values, ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST_F(Npy, FortranOrderIsTheSameArray) {
    const auto array = read(with_header(header_of("<f4", "(2, 3)", true), bytes_of<float>({1, 4, 2, 5, 3, 6})));
    EXPECT_THAT(array.extent, ElementsAre(3, 2));
    EXPECT_THAT(array.values, ElementsAre(1, 2, 3, 4, 5, 6));
    const auto cube = read(with_header(header_of("|u1", "(2, 2, 2)", true), "\0\4\2\6\1\5\3\7"s));
    EXPECT_THAT(cube.values, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
}

TEST_F(Npy, ReadsEveryNumber) {
    const auto value = [&](const std::string& type, const std::string& data) {
        return read(with_header(header_of(type, "(1,)"), data)).values.at(0);
    };
    EXPECT_EQ(value("<f8", bytes_of<double>({-2.5})), -2.5f);
    EXPECT_EQ(value("|i1", "\x80"), -128.0f);
    EXPECT_EQ(value("|u1", "\x80"), 128.0f);
    EXPECT_EQ(value("|b1", "\1"), 1.0f);
    EXPECT_EQ(value("<i2", bytes_of<std::int16_t>({-1024})), -1024.0f);
    EXPECT_EQ(value("<u2", bytes_of<std::uint16_t>({65535})), 65535.0f);
    EXPECT_EQ(value("<i4", bytes_of<std::int32_t>({-70000})), -70000.0f);
    EXPECT_EQ(value("<u4", bytes_of<std::uint32_t>({1u << 31})), 2147483648.0f);
    EXPECT_EQ(value("<i8", bytes_of<std::int64_t>({-5})), -5.0f);
    EXPECT_EQ(value("<u8", bytes_of<std::uint64_t>({7})), 7.0f);
    EXPECT_EQ(value(">i2", "\x01\x02"), 258.0f);
    EXPECT_EQ(value("<f2", bytes_of<std::uint16_t>({0x3e00})), 1.5f);
    EXPECT_EQ(value(">f2", "\xbc\x01"), -(1.0f + 1.0f / 1024));
    EXPECT_EQ(value("<f2", bytes_of<std::uint16_t>({1})), 5.9604644775390625e-8f);
}

TEST_F(Npy, WhatIsWrittenIsReadAgain) {
    const npy::Array array{{3, 1, 2, 1}, {1, 2, 3, 4, 5, 0.1f}};
    npy::write(path, array);
    const auto again = npy::read(path);
    EXPECT_EQ(again.extent, array.extent);
    EXPECT_EQ(again.values, array.values);
    const std::string bytes = glift::test::read_file(path);
    EXPECT_EQ((bytes.size() - 6 * sizeof(float)) % 64, 0u);
    EXPECT_THAT(bytes, HasSubstr("'shape': (1, 2, 1, 3), }"));
}

TEST_F(Npy, LongHeadersAndEmptyArrays) {
    EXPECT_THAT(read(with_header(header_of("<f4", "(1,)"), bytes_of<float>({8}), 2)).values, ElementsAre(8));
    EXPECT_TRUE(read(with_header(header_of("<f4", "(4, 0, 2)"), "")).values.empty());
    EXPECT_THAT(read(with_header(header_of("<f4", "()"), bytes_of<float>({8}))).values, ElementsAre(8));
}

TEST_F(Npy, SaysWhatIsWrong) {
    EXPECT_THAT(problem("hello"), HasSubstr("not a .npy file"));
    EXPECT_THAT(problem(with_header(header_of("<f4", "(2,)"), "123")),
                HasSubstr("cut short: 2 elements need 2, it holds 0"));
    EXPECT_THAT(problem(with_header(header_of("<c8", "(1,)"), "12345678")), HasSubstr("'<c8'"));
    EXPECT_THAT(problem(with_header("{'descr': [('a', '<f4')], }", "")), HasSubstr("records"));
    EXPECT_THAT(problem(with_header("{'descr': '<f4', ", "")), HasSubstr("header is damaged"));
    EXPECT_THAT(problem(with_header("{'descr': '<f4', }", "")), HasSubstr("header is damaged"));
    EXPECT_THAT(problem("\x93NUMPY\x01\x00\x80\x00{"s), HasSubstr("ends in its header"));
    EXPECT_THAT(problem(with_header(header_of("<f4", "(1,)"), "1234", 9)), HasSubstr("version 9"));
    EXPECT_THAT(problem(with_header(header_of("<f4", "(4000000000, 4000000000, 4000000000)"), "")),
                HasSubstr("too large"));
    EXPECT_THAT(problem(with_header(header_of("<f4", "(99999999999,)"), "")), HasSubstr("longer than"));
    std::filesystem::remove(path);
    EXPECT_THROW(npy::read(path), std::runtime_error);
    std::filesystem::create_directory(path);
    EXPECT_THROW(npy::read(path), std::runtime_error);
}

// A file that is cut off anywhere is refused with an error.
TEST_F(Npy, EveryPrefixIsRefused) {
    const std::string whole = with_header(header_of("<f4", "(1, 1)"), "1234");
    for (std::size_t length = 0; length < whole.size(); ++length)
        EXPECT_NE(problem(whole.substr(0, length)), "") << length;
}

}  // namespace
