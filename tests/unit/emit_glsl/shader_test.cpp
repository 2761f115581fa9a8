// Whole shaders: their text, and that glslang and the SPIR-V validator accept them.
#include "builder.h"

#include "emit/glsl/emit.h"
#include "emit/spirv/emit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gliftc::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The readable text of a shader. Validates it, and the same shader with line directives.
std::string proved(Builder& b) {
    std::string text = glsl::glsl_of(b.program, b.sources, b.pass);
    auto plain = spirv::spirv_of(text);
    EXPECT_EQ(plain.error, "") << text;
    std::string marked = glsl::glsl_of(b.program, b.sources, b.pass, {.lines = glsl::LineMarks::directives});
    auto debug = spirv::spirv_of(marked);
    EXPECT_EQ(debug.error, "") << marked;
    return text;
}

TEST(Shader, IsReadable) {
    Builder b;
    ExprId address = b.one_axis();
    auto in = b.buffer("f_data", b.types().float_, Access::read);
    auto out = b.buffer("g_data", b.types().float_, Access::write);
    b.here = b.line(4);
    LocalId sum = b.local("sum", b.types().float_);
    b.pass.plain().body = {b.let(sum, b.times(b.f(-8.0), b.load(in, address))),
                           b.assign(b.use(sum), b.plus(b.use(sum), b.load(in, b.plus(address, b.u(1)))))};
    b.here = b.line(5);
    b.pass.plain().body.push_back(b.store(out, address, b.use(sum)));
    EXPECT_EQ(proved(b), R"(#version 460
// sample, sample.glift:3: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(push_constant, scalar) uniform Parameters {
    uint size;
};

layout(scalar, set = 0, binding = 1) readonly buffer F_data { float f_data[]; };
layout(scalar, set = 0, binding = 2) writeonly buffer G_data { float g_data[]; };

void main() {
    uint address = gl_GlobalInvocationID.x;
    if (address >= size) return;
    // sample.glift:4
    float sum = -8.0 * f_data[address];
    sum += f_data[address + 1u];
    // sample.glift:5
    g_data[address] = sum;
}
)");
}

TEST(Shader, HasParametersInABufferWhereTheyAreNotPushed) {
    Builder b;
    ExprId address = b.one_axis();
    b.pass.push_constants = false;
    ExprId dt = b.parameter("dt", b.types().float_);
    ExprId flag = b.parameter("flag", b.types().bool_);
    auto out = b.buffer("g_data", b.types().float_, Access::write);
    b.pass.plain().body = {b.branch(flag, {b.store(out, address, dt)})};
    const std::string text = proved(b);
    EXPECT_THAT(text, HasSubstr("layout(scalar, set = 0, binding = 0) readonly buffer Parameters {\n    uint "
                                "size;\n    float dt;\n    bool flag;\n} parameters;"));
    EXPECT_THAT(text, HasSubstr("if (copies_parameters) {\n        size = parameters.size;\n"));
    EXPECT_THAT(text, HasSubstr("if (parameter(flag))"));
}

TEST(Shader, ReachesBuffersByAddressInTheGeneralForm) {
    Builder b;
    b.pass.form = Form::general;
    b.pass.push_constants = false;
    ExprId address = b.one_axis();
    auto in = b.buffer("f_data", b.types().vector(b.types().float_, 3), Access::read);
    auto out = b.buffer("g_data", b.types().vector(b.types().float_, 3), Access::write);
    for (auto binding : {in, out}) {
        b.parameter(b.pass.bindings[binding].name + "_address", b.types().uint64, ParameterSource::address);
        b.pass.parameters.back().param = binding;
        b.pass.bindings[binding].address_parameter = static_cast<std::uint32_t>(b.pass.parameters.size() - 1);
    }
    b.pass.plain().body = {b.store(out, address, b.load(in, address))};
    std::string text = proved(b);
    EXPECT_THAT(
        text,
        HasSubstr("layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer F_data { vec3 at; };"));
    EXPECT_THAT(text, HasSubstr("    uint64_t g_data;\n"));
    EXPECT_THAT(text, HasSubstr("G_data(parameters.g_data + uint64_t(address) * 12ul).at = "
                                "F_data(parameters.f_data + uint64_t(address)\n        * 12ul).at;"));
}

TEST(Shader, ReadsAndWritesImages) {
    Builder b;
    ExprId address = b.one_axis();
    auto in = b.image("f_data", MemoryShape::image2d, b.types().float_, Format::r32f, Access::read);
    auto sampled =
        b.image("s_data", MemoryShape::image3d, b.types().vector(b.types().float_, 2), Format::rg32f, Access::read);
    b.pass.bindings[sampled].sampled = true;
    auto out =
        b.image("g_data", MemoryShape::image1d, b.types().vector(b.types().uint, 2), Format::rg32ui, Access::write);
    TypeId int2 = b.types().vector(b.types().int_, 2), float3 = b.types().vector(b.types().float_, 3),
           float2 = b.types().vector(b.types().float_, 2);
    TypeId int3 = b.types().vector(b.types().int_, 3);
    ExprId at = b.make(Op::convert, b.types().int_, {address});
    ExprId texel = b.with(Op::image_load, b.types().float_, {b.make(Op::construct, int2, {at, b.i(0)})}, in);
    ExprId fetch = b.with(Op::image_load, float2, {b.make(Op::construct, int3, {b.i(0)}), b.i(1)}, sampled);
    ExprId sample = b.with(Op::image_sample, float2, {b.make(Op::construct, float3, {texel})}, sampled);
    LocalId v = b.local("v", float2);
    ExprId bits = b.intrinsic(Intrinsic::floatBitsToUint, b.types().vector(b.types().uint, 2), {b.use(v)});
    b.pass.plain().body = {b.let(v, b.plus(sample, fetch)), b.store(out, at, bits, StmtOp::image_store)};
    std::string text = proved(b);
    EXPECT_THAT(text, HasSubstr("layout(set = 0, binding = 1, r32f) uniform readonly image2D f_data;"));
    EXPECT_THAT(text, HasSubstr("layout(set = 0, binding = 2) uniform sampler3D s_data;"));
    EXPECT_THAT(text, HasSubstr("layout(set = 0, binding = 3, rg32ui) uniform writeonly uimage1D g_data;"));
    EXPECT_THAT(text, HasSubstr("textureLod(s_data, vec3(imageLoad(f_data, ivec2(int(address), 0)).x), 0.0).xy\n       "
                                " + texelFetch(s_data, ivec3(0), 1).xy"));
    EXPECT_THAT(text, HasSubstr("imageStore(g_data, int(address), uvec4(floatBitsToUint(v), 0, 0));"));
}

TEST(Shader, MakesNamesUniqueAndNeverWordsOfGlsl) {
    Builder b;
    ExprId address = b.one_axis();
    auto out = b.buffer("output", b.types().float_, Access::write);
    LocalId first = b.local("sample", b.types().float_), second = b.local("sample", b.types().float_),
            third = b.local("size", b.types().float_), fourth = b.local("gl_x__y", b.types().float_);
    b.pass.plain().body = {
        b.let(first, b.f(1)), b.let(third, b.f(3)), b.let(fourth, b.f(4)),
        b.branch(b.less(address, b.u(3)), {b.let(second, b.plus(b.use(first), b.plus(b.use(third), b.use(fourth)))),
                                           b.store(out, address, b.use(second))})};
    std::string text = proved(b);
    EXPECT_THAT(text, HasSubstr("float sample_1 = 1.0;"));
    EXPECT_THAT(text, HasSubstr("float size_1 = 3.0;"));
    EXPECT_THAT(text, HasSubstr("float sample_2 = sample_1 + (size_1 + the_gl_x_y);"));
    EXPECT_THAT(text, HasSubstr("output_1[address] = sample_2;"));
}

TEST(Shader, PrintsStructsOptionalsAndFunctions) {
    Builder b;
    ExprId address = b.one_axis();
    TypeId uint2 = b.types().vector(b.types().uint, 2);
    Struct entry;
    entry.name = b.names.intern("Entry");
    entry.display = "Entry";
    entry.fields = {{b.names.intern("frame"), uint2, ""}, {b.names.intern("resident"), b.types().bool_, ""}};
    TypeId entry_type = b.types().of_struct(b.program.structs.add(entry)), maybe = b.types().optional(uint2);
    auto table = b.buffer("table", entry_type, Access::read);
    auto out = b.buffer("g_data", b.types().uint, Access::write);

    Function function;
    function.name = b.names.intern("find");
    function.display = "find<2>";
    LocalId at = b.local("at", b.types().uint, false), e = b.local("e", entry_type, false);
    function.params = {at};
    function.result = maybe;
    Stmt none = b.statement(StmtOp::return_), some = b.statement(StmtOp::return_);
    none.value = b.make(Op::none, maybe);
    some.value = b.make(Op::some, maybe, {b.with(Op::field, uint2, {b.use(e)}, 0)});
    ExprId missing = b.unary(UnaryOp::logical_not, b.with(Op::field, b.types().bool_, {b.use(e)}, 1));
    function.body = {b.let(e, b.load(table, b.use(at))), b.branch(missing, {b.add(none)}), b.add(some)};
    FunctionId id = b.program.functions.add(function);
    b.pass.functions = {id};

    LocalId found = b.local("found", maybe, false);
    ExprId call = b.make(Op::call, maybe, {address});
    b.program.exprs[call].function = id;
    ExprId has = b.make(Op::has_value, b.types().bool_, {b.use(found)}),
           value = b.make(Op::value, uint2, {b.use(found)});
    b.pass.plain().body = {b.let(found, call), b.branch(has, {b.store(out, address, b.lanes(value, {1}))},
                                                        {b.store(out, address, b.u(7))})};
    std::string text = proved(b);
    EXPECT_THAT(text, HasSubstr("struct optional_uvec2 {\n    bool has;\n    uvec2 value;\n};"));
    EXPECT_THAT(text, HasSubstr("// find<2>\n"));
    EXPECT_THAT(text, HasSubstr("optional_uvec2 find(uint at) {"));
    EXPECT_THAT(text, HasSubstr("if (!e.resident) {\n        return optional_uvec2(false, uvec2(0u));\n    }\n    "
                                "return optional_uvec2(true, e.frame);"));
    EXPECT_THAT(text, HasSubstr("g_data[address] = found.value.y;\n    } else {\n"));
}

TEST(Shader, BreaksLongLines) {
    Builder b;
    ExprId address = b.one_axis();
    auto in = b.buffer("a_rather_long_name", b.types().float_, Access::read);
    auto out = b.buffer("g_data", b.types().float_, Access::write);
    ExprId sum = b.load(in, address);
    for (std::uint64_t n = 1; n < 10; ++n) sum = b.plus(sum, b.load(in, b.plus(address, b.u(n))));
    b.pass.plain().body = {b.store(out, address, sum)};
    std::string text = proved(b);
    std::size_t longest = 0;
    for (std::size_t from = 0; from < text.size();) {
        std::size_t end = text.find('\n', from);
        longest = std::max(longest, end - from);
        from = end + 1;
    }
    EXPECT_LE(longest, 110u) << text;
}

}  // namespace
}  // namespace gliftc::test
