// NumPy's .npy files into dense structures and out of them: every type, both orders, all versions; files that were
// altered or cut off are refused. python_test.py does the same with NumPy itself.
#include "folder.h"

#include "arrays.glift.hpp"

#include <glift/files.h>
#include <glift/files/npy.h>

#include <cstring>
#include <fstream>
#include <random>

namespace {

using namespace glift;
using files_test::device;
using files_test::devices;

std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string header_of(const std::string& type, const std::string& shape, bool is_fortran = false) {
    return "{'descr': '" + type + "', 'fortran_order': " + (is_fortran ? "True" : "False") + ", 'shape': " + shape +
           ", }\n";
}

template <class T> std::string bytes_of(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

class Npy : public files_test::InFolder {
protected:
    const Device& host() { return device("host"); }
    std::string file() { return path("array.npy"); }

    void write(const std::string& bytes) { std::ofstream(file(), std::ios::binary) << bytes; }
    void write(const std::string& header, const std::string& data, char version = 1) {
        std::string bytes = std::string("\x93NUMPY") + version + '\0';
        for (int i = 0; i < (version == 1 ? 2 : 4); ++i) bytes += static_cast<char>(header.size() >> (8 * i) & 0xff);
        write(bytes + header + data);
    }

    /// Random elements, saved from one device and loaded on another one, into a new structure and into one that exists.
    template <class S, class A> void round_trip(const A& extent) {
        using T = typename S::Element;
        std::mt19937 random(7);
        for (const std::string& from : devices()) {
            S saved(device(from), extent);
            std::vector<T> values = saved.read();
            std::string bytes(values.size() * sizeof(T), '\0');
            // No exponent is that of a NaN, whose bits may change in a register; bools are 0 or 1.
            for (char& byte : bytes) byte = static_cast<char>(random() & (std::is_same_v<T, Bool> ? 0 : 0x3b));
            if constexpr (std::is_same_v<T, Bool>)
                for (std::size_t i = 0; i < bytes.size(); i += 4) bytes[i] = static_cast<char>(random() & 1);
            if (!bytes.empty()) std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
            saved.write(values);
            const std::string before = bytes_of(saved.read());
            save_npy(file(), saved);
            for (const std::string& to : devices()) {
                EXPECT_EQ(bytes_of(load_npy<S>(file(), device(to)).read()), before) << from << " to " << to;
                S existing(device(to), extent);
                load_npy(file(), existing);
                EXPECT_EQ(bytes_of(existing.read()), before) << from << " to " << to;
            }
        }
    }

    template <class S> std::optional<Error> error_of_load() {
        try {
            load_npy<S>(file(), host());
            return std::nullopt;
        } catch (const Error& error) {
            return error;
        }
    }
    template <class S> void expect_refused(ErrorCode code, const std::string& text) {
        const std::optional<Error> error = error_of_load<S>();
        ASSERT_TRUE(error) << "no error: " << text;
        EXPECT_EQ(error->code(), code) << error->what();
        EXPECT_NE(std::string(error->what()).find(text), std::string::npos) << error->what();
    }
};

TEST_F(Npy, OneAxis) { round_trip<arrays::Floats1>(101u); }
TEST_F(Npy, TwoAxes) { round_trip<arrays::Floats2>(uint2(17, 9)); }
TEST_F(Npy, ThreeAxes) { round_trip<arrays::Floats3>(uint3(7, 5, 3)); }
TEST_F(Npy, FourAxes) { round_trip<arrays::Floats4>(uint4(4, 3, 2, 5)); }
TEST_F(Npy, NoElements) { round_trip<arrays::Floats2>(uint2(0, 9)); }
TEST_F(Npy, SeveralBoxes) { round_trip<arrays::Floats2>(uint2(1000, 1500)); }
TEST_F(Npy, Vectors) { round_trip<arrays::Vectors>(uint2(17, 9)); }
TEST_F(Npy, Pairs) { round_trip<arrays::Pairs>(uint3(7, 5, 3)); }
TEST_F(Npy, Matrices) { round_trip<arrays::Turns>(13u); }
TEST_F(Npy, Arrays) { round_trip<arrays::Rows>(13u); }
TEST_F(Npy, Bools) { round_trip<arrays::Bools>(uint2(17, 9)); }
TEST_F(Npy, Halves) { round_trip<arrays::Halves>(101u); }
TEST_F(Npy, Ints) { round_trip<arrays::Ints>(101u); }
TEST_F(Npy, Uints) { round_trip<arrays::Uints>(101u); }
TEST_F(Npy, Doubles) { round_trip<arrays::Doubles>(101u); }
TEST_F(Npy, Longs) { round_trip<arrays::Longs>(101u); }
TEST_F(Npy, Tiled) { round_trip<arrays::Tiles>(uint2(32, 12)); }
TEST_F(Npy, Morton) { round_trip<arrays::Morton>(uint2(16, 16)); }
TEST_F(Npy, InImage) { round_trip<arrays::Picture>(uint2(17, 9)); }

TEST_F(Npy, VectorsOfBools) {
    arrays::Flags flags(host(), 3u);
    using Flag = arrays::Flags::Element;
    const std::vector<Flag> values = {Flag(true, false, false), Flag(false, true, true), Flag(true, true, true)};
    flags.write(values);
    save_npy(file(), flags);
    const std::string bytes = contents(file());
    EXPECT_EQ(bytes.substr(bytes.size() - 9), std::string("\1\0\0\0\1\1\1\1\1", 9));
    EXPECT_EQ(bytes_of(load_npy<arrays::Flags>(file(), host()).read()), bytes_of(values));
}

TEST_F(Npy, TheLastAxisOfTheArrayIsTheFirst) {
    write(header_of("<f4", "(2, 3)"), bytes_of<float>({1, 2, 3, 4, 5, 6}));
    const auto array = load_npy<arrays::Floats2>(file(), host());
    EXPECT_EQ(array.domain(), uint2(3, 2));
    EXPECT_EQ(array.read(), (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TEST_F(Npy, FortranOrderIsTheSameArray) {
    write(header_of("<f4", "(2, 3)", true), bytes_of<float>({1, 4, 2, 5, 3, 6}));
    EXPECT_EQ(load_npy<arrays::Floats2>(file(), host()).read(), (std::vector<float>{1, 2, 3, 4, 5, 6}));
    // Shape (2, 1, 3): number (y, x, component) lies at y + 2 x + 2 component.
    write(header_of("<f4", "(2, 1, 3)", true), bytes_of<float>({1, 4, 2, 5, 3, 6}));
    EXPECT_EQ(load_npy<arrays::Vectors>(file(), host()).read(),
              (std::vector<float3>{float3(1, 2, 3), float3(4, 5, 6)}));
}

/// Of more than one box.
TEST_F(Npy, LongArrayInFortranOrder) {
    constexpr uint width = 1500, height = 1000;
    std::vector<float> values(width * height);
    for (uint i = 0; i < width * height; ++i) values[i] = static_cast<float>(i);
    write(header_of("<f4", "(1000, 1500)", true), bytes_of(values));
    const std::vector<float> read = load_npy<arrays::Floats2>(file(), host()).read();
    for (uint y = 0; y < height; y += 7)
        for (uint x = 0; x < width; ++x)
            ASSERT_EQ(read[y * width + x], static_cast<float>(y + x * height)) << x << ", " << y;
}

TEST_F(Npy, VersionsWithLongHeaders) {
    for (char version = 1; version <= 3; ++version) {
        write(header_of("<f4", "(1,)"), bytes_of<float>({8}), version);
        EXPECT_EQ(load_npy<arrays::Floats1>(file(), host()).read(), std::vector<float>{8});
    }
}

TEST_F(Npy, SaysWhatIsWrong) {
    const auto refused = [&](const std::string& header, const std::string& data, ErrorCode code,
                             const std::string& text) {
        write(header, data);
        expect_refused<arrays::Floats1>(code, text);
    };
    const std::string one(4, 'x');
    refused(header_of(">f4", "(1,)"), one, ErrorCode::bad_file, "newbyteorder('<')");
    refused(header_of("<c8", "(1,)"), one + one, ErrorCode::bad_file, "'<c8'");
    refused("{'descr': [('a', '<f4')], 'fortran_order': False, 'shape': (1,), }\n", one, ErrorCode::bad_file,
            "records");
    refused(header_of("<f4", "(99999999999,)"), one, ErrorCode::bad_file, "longer than 2^32 - 1");
    refused(header_of("<f4", "(4000000000, 4000000000, 4000000000)"), one, ErrorCode::bad_file, "more than 2^64");
    refused(header_of("<f4", "(2,)"), one, ErrorCode::bad_file, "needs 8 bytes, and it has 4");
    refused(header_of("<f4", "(1,)"), one + "x", ErrorCode::bad_file, "was appended to");
    refused(header_of("<f8", "(1,)"), one + one, ErrorCode::wrong_argument, "astype(numpy.float32)");
    refused(header_of("<f4", "(1, 1)"), one, ErrorCode::wrong_argument, "the file has (1, 1), the structure 1 axis");
    for (const char* header : {"", "{", "{}\n", "{'descr': '<f4', }\n", "{'shape': (1 1), }\n", "{'shape': (1,}\n",
                               "{'descr': '<f4', 'fortran_order': False, 'shape': (1,), 'shape': (1,), }\n",
                               "{'descr': '<f4', 'fortran_order': False, 'shape': (1,), }\n\n", "{'descr\n"})
        refused(header, one, ErrorCode::bad_file, "damaged");
    write("hello, this is a text");
    expect_refused<arrays::Floats1>(ErrorCode::bad_file, "does not begin as .npy files do");
    write(header_of("<f4", "(1,)"), one, 4);
    expect_refused<arrays::Floats1>(ErrorCode::bad_file, "version 4.0");
    std::filesystem::remove(file());
    expect_refused<arrays::Floats1>(ErrorCode::wrong_argument, "open");
    write(header_of("<f4", "(2, 2)"), std::string(16, 'x'));
    arrays::Floats2 other(host(), uint2(3, 2));
    EXPECT_THROW(load_npy(file(), other), Error);
}

/// A vector's axis must be there: an array of numbers is no array of vectors.
TEST_F(Npy, ElementsOfAnotherShape) {
    write(header_of("<f4", "(2, 3)"), std::string(24, 'x'));
    expect_refused<arrays::Vectors>(ErrorCode::wrong_argument, "then those of an element, (3,)");
    write(header_of("<f4", "(2, 1, 4)"), std::string(32, 'x'));
    expect_refused<arrays::Vectors>(ErrorCode::wrong_argument, "the file has (2, 1, 4)");
}

/// Each byte of the header becomes each other byte: refused, or a header that means the same.
TEST_F(Npy, EveryByteOfTheHeader) {
    arrays::Floats2 array(host(), uint2(3, 2));
    const std::vector<float> values = {1, 2, 3, 4, 5, 6};
    array.write(values);
    save_npy(file(), array);
    const std::string whole = contents(file());
    for (std::size_t at = 0; at < whole.size() - 24; ++at) {
        for (int byte = 0; byte < 256; ++byte) {
            std::string altered = whole;
            altered[at] = static_cast<char>(byte);
            write(altered);
            arrays::Floats2 loaded(host(), uint2(3, 2));
            try {
                load_npy(file(), loaded);
                EXPECT_EQ(loaded.read(), values) << "byte " << at << " as " << byte;
            } catch (const Error&) {}
        }
    }
}

TEST_F(Npy, CutOffAnywhere) {
    arrays::Floats2 array(host(), uint2(3, 2));
    save_npy(file(), array);
    const std::string whole = contents(file());
    for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
        write(whole.substr(0, bytes));
        expect_refused<arrays::Floats2>(ErrorCode::bad_file, "");
    }
}

/// gliftinfo makes a file of an array, which is loaded as any saved structure.
TEST_F(Npy, ThroughGliftinfo) {
    arrays::Vectors vectors(host(), uint2(5, 3));
    std::vector<float3> values;
    for (int i = 0; i < 15; ++i) values.emplace_back(static_cast<float>(i), 0.5f, -1.0f);
    vectors.write(values);
    save_npy(file(), vectors);
    const std::string call = std::string(GLIFT_INFO) + " convert --element-axes 1 " + file() + " it " + path();
    ASSERT_EQ(std::system(call.c_str()), 0);
    EXPECT_EQ(load<arrays::Vectors>(path(), "it", host()).read(), values);
    arrays::Vectors existing(host(), uint2(5, 3));
    EXPECT_FALSE(load(path(), "it", existing).is_by_address);
    EXPECT_EQ(existing.read(), values);
}

TEST_F(Npy, AFileThatCannotBeWritten) {
    const arrays::Floats1 array(host(), 5u);
    EXPECT_THROW(save_npy(path("nowhere/array.npy"), array), Error);
    save_npy(file(), array);
    EXPECT_FALSE(std::filesystem::exists(file() + ".saving"));
}

TEST_F(Npy, NotInARecording) {
    arrays::Floats1 array(host(), 5u);
    save_npy(file(), array);
    EXPECT_THROW(host().record([&](const Commands&) { save_npy(path("other.npy"), array); }), Error);
    EXPECT_THROW(host().record([&](const Commands&) { load_npy(file(), array); }), Error);
}

}  // namespace
