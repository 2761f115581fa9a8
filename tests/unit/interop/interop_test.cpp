// Import of C++ structs, and formatting, by the plugin, which is loaded with dlopen as gliftc does it.

#include "interop/interop.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace gliftc {
namespace {

const std::string headers = GLIFT_SOURCE_DIR "/tests/unit/interop/headers/";

class Interop : public testing::Test {
protected:
    static void SetUpTestSuite() { setenv("GLIFT_CLANG", GLIFT_CLANG_PLUGIN, 1); }
};

ImportResult import(const std::string& name, const std::string& file = "particle.hpp") {
    return import_struct({.header = headers + file, .include_dirs = {}, .name = name});
}

const ImportedField& field(const ImportedStruct& record, const std::string& name) {
    for (const ImportedField& candidate : record.fields) {
        if (candidate.name == name) return candidate;
    }
    throw std::runtime_error("no field " + name);
}

TEST_F(Interop, lays_a_struct_out_as_the_cpp_compiler_does) {
    const ImportResult result = import("Particle");
    ASSERT_EQ(result.error, "");
    ASSERT_EQ(result.structs.size(), 2u);
    const ImportedStruct& spin = result.structs[0];
    EXPECT_EQ(spin.name, "sim::Spin");
    EXPECT_EQ(spin.size, 24u);
    EXPECT_EQ(field(spin, "rate").offset, 16u);

    const ImportedStruct& particle = result.structs[1];
    EXPECT_EQ(particle.name, "sim::Particle");
    EXPECT_EQ(particle.size, 152u);
    EXPECT_EQ(particle.align, 8u);
    ASSERT_EQ(particle.fields.size(), 9u);
    EXPECT_EQ(field(particle, "mass").offset, 12u);
    EXPECT_EQ(field(particle, "neighbours").offset, 40u);
    EXPECT_EQ(field(particle, "id").offset, 64u);
    EXPECT_EQ(field(particle, "cell").offset, 144u);
}

TEST_F(Interop, reads_scalars_vectors_arrays_and_nested_structs) {
    const ImportResult result = import("sim::Particle");
    ASSERT_EQ(result.error, "");
    const ImportedStruct& particle = result.structs.back();
    EXPECT_EQ(field(particle, "position").type.scalar, ImportedScalar::Float);
    EXPECT_EQ(field(particle, "position").type.components, 3u);
    EXPECT_EQ(field(particle, "grid").type.array_extents, (std::vector<std::uint64_t>{2, 3}));
    EXPECT_EQ(field(particle, "neighbours").type.scalar, ImportedScalar::Int);
    EXPECT_EQ(field(particle, "kind").type.scalar, ImportedScalar::Uint);
    EXPECT_EQ(field(particle, "id").type.scalar, ImportedScalar::Uint64);
    EXPECT_EQ(field(particle, "history").type.scalar, ImportedScalar::Struct);
    EXPECT_EQ(field(particle, "history").type.record, 0u);
    EXPECT_EQ(field(particle, "history").type.array_extents, (std::vector<std::uint64_t>{2}));
    EXPECT_EQ(field(particle, "cell").type.scalar, ImportedScalar::Uint);
    EXPECT_EQ(field(particle, "cell").type.components, 2u);
    EXPECT_EQ(field(particle, "mass").line, 19u);
}

TEST_F(Interop, takes_the_first_type_of_a_vector_for_its_scalar) {
    const ImportResult result = import("tagged::Body");
    ASSERT_EQ(result.error, "");
    EXPECT_EQ(field(result.structs.front(), "position").type.scalar, ImportedScalar::Float);
    EXPECT_EQ(field(result.structs.front(), "position").type.components, 3u);
}

TEST_F(Interop, names_the_headers_it_read) {
    const ImportResult result = import("sim::Particle");
    ASSERT_EQ(result.read_files.size(), 2u);
    EXPECT_EQ(std::filesystem::path(result.read_files[0]).filename(), "particle.hpp");
    EXPECT_EQ(std::filesystem::path(result.read_files[1]).filename(), "vectors.hpp");
}

void expect_error(const ImportResult& result, const std::string& words, std::uint32_t line) {
    EXPECT_NE(result.error.find(words), std::string::npos) << result.error;
    EXPECT_EQ(result.error_line, line);
    EXPECT_TRUE(result.structs.empty());
}

TEST_F(Interop, says_where_a_struct_cannot_be_imported) {
    expect_error(import("WithPointer"), "'values' has the type 'float *', which has no counterpart", 31);
    expect_error(import("Derived"), "'sim::Derived' has a base class", 38);
    expect_error(import("WithBits"), "bit field", 43);
    expect_error(import("Base"), "may be 'sim::Base' or 'other::Base'", 49);
    expect_error(import("WithInstance"), "'sim::Pair' is an instance of a template", 56);
    expect_error(import("Missing"), "there is no struct 'Missing'", 0);
    expect_error(import("Broken", "broken.hpp"), "unknown type name 'flota'", 4);
    expect_error(import("Any", "absent.hpp"), "cannot read", 0);
}

TEST_F(Interop, knows_the_vectors_of_the_runtime) {
    const ImportResult result = import_struct({.header = headers + "with_runtime.hpp",
                                               .include_dirs = {GLIFT_SOURCE_DIR "/runtime/include"},
                                               .name = "Body"});
    ASSERT_EQ(result.error, "") << result.error_file << ':' << result.error_line;
    ASSERT_EQ(result.structs.size(), 1u);
    const ImportedStruct& body = result.structs.front();
    EXPECT_EQ(field(body, "position").type.scalar, ImportedScalar::Float);
    EXPECT_EQ(field(body, "position").type.components, 3u);
    EXPECT_EQ(field(body, "cells").type.scalar, ImportedScalar::Uint);
    EXPECT_EQ(field(body, "cells").type.components, 4u);
    EXPECT_EQ(field(body, "cells").type.array_extents, (std::vector<std::uint64_t>{2}));
    EXPECT_EQ(body.size, 48u);
}

TEST_F(Interop, formats_by_the_name_of_a_style) {
    const FormatResult result = format_code("int  f( int a ){return a;}\n", "LLVM");
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(result.text, "int f(int a) { return a; }\n");
}

TEST_F(Interop, formats_by_a_file) {
    const std::string path = testing::TempDir() + "glift_style";
    std::ofstream(path) << "BasedOnStyle: LLVM\nIndentWidth: 8\nAllowShortFunctionsOnASingleLine: None\n";
    const FormatResult result = format_code("int f(){return 1;}\n", path);
    std::filesystem::remove(path);
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(result.text, "int f() {\n        return 1;\n}\n");
}

TEST_F(Interop, an_unknown_style_is_an_error) {
    EXPECT_NE(format_code("int a;", "Baroque").error.find("'Baroque'"), std::string::npos);
}

}  // namespace
}  // namespace gliftc
