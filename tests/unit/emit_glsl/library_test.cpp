// The functions of a structure in a shader of one's own.
#include "driver/compile.h"
#include "emit/glsl/library.h"
#include "emit/spirv/emit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gliftc::test {
namespace {

using testing::HasSubstr;

/// The library of the only public structure of the text.
std::string library(const std::string& text) {
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
    if (c.diagnostics.has_errors()) return "";
    EXPECT_EQ(c.lowered.libraries.size(), 1u);
    return c.lowered.libraries.empty() ? "" : glsl::library_of(c.program, c.sources, c.lowered.libraries[0]);
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
    prove(text, "", "Field_write(id, Field_read(id + 1u) + float(Field_translate(id)));\n");
    prove(text,
          "#define FIELD_SET 2\n#define FIELD_BINDING 5\n#define FIELD_STATE\n#define FIELD_READONLY\n"
          "layout(push_constant, scalar) uniform Mine { uvec3 Field_extent; };\nlayout(binding = 0) buffer Out { float "
          "result; };\n",
          "result = Field_read(id);\n");
}

// Who includes the functions fills in the state: it is what the structure was made with, nothing computed from it.
TEST(Library, StateIsThatOfTheStructure) {
    std::string text = library("module own;\nuse std.tiled;\npub structure Plane = Tiled<2, float, uint2(8, 8)>;\n");
    EXPECT_THAT(text, HasSubstr("buffer Plane_state {\n    uvec2 Plane_extent;\n};"));
    prove(text, "", "Plane_write(id.xy, Plane_read(id.yx));\n");
}

TEST(Library, OfAPartialMapping) {
    std::string text = library("module own;\nuse std.array;\nuse std.edge;\npub structure Field = Array<2, float2, "
                               "Boundary.repeat, Storage.image2d>;\n");
    EXPECT_THAT(text, HasSubstr("bool Field_is_mapped(uvec2 address) {"));
    prove(text, "",
          "if (Field_is_mapped(id.xy)) Field_write(id.xy, Field_read(id.yx) + vec2(Field_translate(id.xy)));\n");
}

TEST(Library, OfMortonOrder) {
    std::string text = library("module own;\nuse std.tiled;\npub structure Cloud = MortonArray<3, uint>;\n");
    prove(text, "", "Cloud_write(id, Cloud_read(id.zyx));\n");
}

// A translator with a loop is a function of its own: it is named before what calls it is printed.
TEST(Library, OfATranslatorWithALoop) {
    std::string text = library(
        "module own;\ntranslator Halved : uint -> uint {\n    n: uint;\n    domain() { return n; }\n"
        "    translate(va) {\n        var p = va;\n        while p > 100u {\n            p = p / 2u;\n        }\n"
        "        return p;\n    }\n}\npub structure Few(n: uint) {\n    memory data = buffer<float>[n];\n"
        "    via Halved(n);\n}\n");
    EXPECT_THAT(text, HasSubstr("return Halved_translate(address);"));
    prove(text, "", "Few_write(id.x, Few_read(id.y));\n");
}

}  // namespace
}  // namespace gliftc::test
