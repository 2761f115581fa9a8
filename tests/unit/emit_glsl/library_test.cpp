// The generated functions of a structure that a user's own shader includes.
#include "driver/compile.h"
#include "emit/glsl/library.h"
#include "emit/spirv/emit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gliftc::test {
namespace {

using testing::HasSubstr;

/// The function libraries of the public structures and views of a module `own` with this text.
std::vector<std::string> libraries(const std::string& text) {
    FileSystem files = disk();
    auto read = files.read;
    files.read = [=](const std::string& path) { return path == "own.glift" ? ReadResult{text, ""} : read(path); };
    auto exists = files.exists;
    files.exists = [=](const std::string& path) { return path == "own.glift" || exists(path); };
    auto identity = files.identity;
    files.identity = [=](const std::string& path) { return path == "own.glift" ? path : identity(path); };
    Options options;
    options.files = {"own.glift"};
    options.library_folder = std::string(GLIFT_SOURCE_DIR) + "/stdlib";
    options.stop_after = Stage::layout;
    Compilation c;
    compile(options, files, c);
    for (const Diagnostic& diagnostic : c.diagnostics.all()) ADD_FAILURE() << diagnostic.text;
    std::vector<std::string> texts;
    if (c.diagnostics.has_errors()) return texts;
    for (const ir::Library& library : c.lowered.libraries)
        texts.push_back(glsl::library_of(c.program, c.sources, library));
    return texts;
}

/// The library of a module's only public structure.
std::string library(const std::string& text) {
    const std::vector<std::string> texts = libraries(text);
    EXPECT_EQ(texts.size(), 1u);
    return texts.empty() ? "" : texts[0];
}

std::string error_of(const std::string& declarations) {
    return spirv::spirv_of("#version 460\n#extension GL_EXT_scalar_block_layout : require\n" + declarations +
                           "void main() {}\n")
        .error;
}

void prove(const std::string& library, const std::string& before, const std::string& after) {
    std::string shader =
        "#version 460\n#extension GL_EXT_scalar_block_layout : require\nlayout(local_size_x = 64) in;\n" + before +
        library + "void main() {\n    uvec3 id = gl_GlobalInvocationID;\n" + after + "}\n";
    EXPECT_EQ(spirv::spirv_of(shader).error, "") << shader;
}

TEST(Library, OfAnArray) {
    std::string text = library("module own;\nuse std.array;\npub structure Field = Array<3, float>;\n");
    EXPECT_THAT(text, HasSubstr("float Field_read(uvec3 address) {"));
    EXPECT_THAT(text, HasSubstr("void Field_write(uvec3 address, float value) {"));
    EXPECT_THAT(text, HasSubstr("uint Field_translate(uvec3 address) {"));
    prove(text, "#define FIELD_BINDING 0\n", "Field_write(id, Field_read(id + 1u) + float(Field_translate(id)));\n");
    prove(text,
          "#define FIELD_SET 2\n#define FIELD_BINDING 5\n#define FIELD_STATE\n#define FIELD_READONLY\n"
          "layout(push_constant, scalar) uniform Mine { uvec3 Field_extent; };\nlayout(binding = 0) buffer Out { float "
          "result; };\n",
          "result = Field_read(id);\n");
}

// The including program provides the state. Here it is the constructor's argument: what is computed from that is not in
// it.
TEST(Library, StateIsThatOfTheStructure) {
    std::string text = library("module own;\nuse std.tiled;\npub structure Plane = Tiled<2, float, uint2(8, 8)>;\n");
    EXPECT_THAT(text, HasSubstr("buffer Plane_state {\n    uvec2 Plane_extent;\n};"));
    prove(text, "#define PLANE_BINDING 0\n", "Plane_write(id.xy, Plane_read(id.yx));\n");
}

TEST(Library, OfAPartialMapping) {
    std::string text = library("module own;\nuse std.array;\nuse std.edge;\npub structure Field = Array<2, float2, "
                               "Boundary.repeat, Storage.image2d>;\n");
    EXPECT_THAT(text, HasSubstr("bool Field_is_mapped(uvec2 address) {"));
    prove(text, "#define FIELD_BINDING 0\n",
          "if (Field_is_mapped(id.xy)) Field_write(id.xy, Field_read(id.yx) + vec2(Field_translate(id.xy)));\n");
}

TEST(Library, OfMortonOrder) {
    std::string text = library("module own;\nuse std.tiled;\npub structure Cloud = MortonArray<3, uint>;\n");
    prove(text, "#define CLOUD_BINDING 0\n", "Cloud_write(id, Cloud_read(id.zyx));\n");
}

// Depths are read through a sampler, and only draws write them.
TEST(Library, OfDepths) {
    std::string text = library("module own;\nuse std.image;\npub structure Depth = Image<d32>;\n");
    EXPECT_THAT(text, Not(HasSubstr("Depth_write")));
    prove(text, "#define DEPTH_BINDING 0\nlayout(binding = 7) buffer Out { float result; };\n",
          "result = Depth_read(id.xy);\n");
}

TEST(Library, OfAViewThatFilters) {
    const std::vector<std::string> texts =
        libraries("module own;\nuse std.image;\nstructure Picture = Image<rgba8>;\n"
                  "pub structure Halved(of: Picture) : uint2 -> float4 {\n    domain() { return of.domain() / 2u; }\n"
                  "    at(p) { return of.sample(2.0 * float2(p) + 1.0); }\n}\n");
    ASSERT_EQ(texts.size(), 1u);
    prove(texts[0], "#define HALVED_BINDING 0\nlayout(binding = 7) buffer Out { vec4 result; };\n",
          "result = Halved_read(id.xy);\n");
}

TEST(Library, OfAViewOfIntegers) {
    const std::vector<std::string> texts =
        libraries("module own;\nuse std.image;\nstructure Counts = Image<uint>;\n"
                  "pub structure Doubled(of: Counts) : uint2 -> uint {\n    domain() { return of.domain(); }\n"
                  "    at(p) { return 2u * of[p]; }\n}\n");
    ASSERT_EQ(texts.size(), 1u);
    prove(texts[0], "#define DOUBLED_BINDING 0\n#define DOUBLED_READONLY\n", "if (Doubled_read(id.xy) > 1u) return;\n");
}

// The functions must not be printed as part of the program's first kernel: that is a draw here, whose parts declare
// only what they use.
TEST(Library, BesideADraw) {
    std::string text = library("module own;\nuse std.array;\nuse std.image;\npub structure Line = Array<1, float3>;\n"
                               "raster draw(c: in each<Line>, t: out target<Image<rgba8>>) {\n"
                               "    vertex { place(float4(c, 1.0)); }\n    fragment { t = float4(1.0); }\n}\n");
    prove(text, "#define LINE_BINDING 0\n", "Line_write(id.x, Line_read(id.y));\n");
}

// `translate` is not inlined, since it has a `while` loop: it is a separate function, declared before its callers.
TEST(Library, OfATranslatorWithALoop) {
    std::string text = library(
        "module own;\ntranslator Halved : uint -> uint {\n    n: uint;\n    domain() { return n; }\n"
        "    translate(va) {\n        var p = va;\n        while p > 100u {\n            p = p / 2u;\n        }\n"
        "        return p;\n    }\n}\npub structure Few(n: uint) {\n    memory data = buffer<float>[n];\n"
        "    via Halved(n);\n}\n");
    EXPECT_THAT(text, HasSubstr("uint Few_place = Few_Halved_translate(address);"));
    prove(text, "#define FEW_BINDING 0\n", "Few_write(id.x, Few_read(id.y));\n");
}

// Libraries in one shader: a struct that several use is shared, each has its own functions, and each contains the
// helper functions that it calls.
TEST(Library, SeveralInOneShader) {
    const std::vector<std::string> texts =
        libraries("module own;\nuse std.array;\nuse std.tiled;\nstruct Particle { x: float; v: float2; }\n"
                  "pub structure A = Array<1, Particle>;\npub structure B = Tiled<1, Particle, 4>;\n"
                  "pub structure C = Tiled<1, Particle, 8>;\n");
    ASSERT_EQ(texts.size(), 3u);
    prove(texts[0] + texts[1] + texts[2] + texts[0], "#define A_BINDING 0\n#define B_BINDING 2\n#define C_BINDING 4\n",
          "A_write(id.x, B_read(id.y));\nC_write(id.x, A_read(id.z));\n");
}

TEST(Library, SaysWhatMayNotMeet) {
    const std::string a =
        library("module own;\nuse std.array;\nstruct P { x: float; }\npub structure A = Array<1, P>;\n");
    const std::string b =
        library("module own;\nuse std.array;\nstruct P { y: float; }\npub structure B = Array<1, P>;\n");
    const std::string other = library("module own;\nuse std.array;\npub structure A = Array<2, float>;\n");
    const std::string bound = "#define A_BINDING 0\n#define B_BINDING 2\n";
    EXPECT_THAT(error_of(bound + a + b), HasSubstr("another struct is called P in a file included before"));
    EXPECT_THAT(error_of(bound + a + other),
                HasSubstr("the functions of another structure called A are included already"));
    EXPECT_THAT(error_of(a), HasSubstr("define A_BINDING before this file is included"));
}

}  // namespace
}  // namespace gliftc::test
