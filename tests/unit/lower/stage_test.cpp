#include "lowered.h"

#include "ir/validate.h"
#include "ir/walk.h"

#include <gmock/gmock.h>

#include <array>

namespace gliftc {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::string structures = R"(
translator Along : uint -> uint {
    extent: uint;
    domain() { return extent; }
    translate(va) { return va; }
}
translator Across : uint2 -> uint {
    extent: uint2;
    domain() { return extent; }
    translate(va) { return va.y * extent.x + va.x; }
}
structure Line(extent: uint) { memory data = buffer<uint>[extent]; via Along(extent); }
structure Points(extent: uint) { memory data = buffer<float4>[extent]; via Along(extent); }
structure Matrices(extent: uint) { memory data = buffer<float2x2>[extent]; via Along(extent); }
structure Matrix(extent: uint2) { memory data = buffer<float>[extent.x * extent.y]; via Across(extent); }
)";

struct Body {
    std::string text;
    std::array<std::uint32_t, 3> elements;
    std::vector<ir::PassStaged> staged;
};

/// What shaders run of a kernel k.
Body body_of(const std::string& kernel) {
    const Lowering lowering(structures + "kernel k(" + kernel);
    const ir::Pass &pass = lowering.forms("k").direct, &general = lowering.forms("k").general;
    const ir::Variant& variant = variant_for(pass, ir::Devices::shaders);
    EXPECT_EQ(variant_for(general, ir::Devices::shaders).assumes.elements, variant.assumes.elements);
    EXPECT_THAT(validate(lowering.program, pass), IsEmpty());
    EXPECT_THAT(validate(lowering.program, general), IsEmpty());
    EXPECT_EQ(has_any_barrier(lowering.program, variant.body), !pass.staged.empty());
    return {ir::print(lowering.program, variant.body, &pass), variant.assumes.elements, pass.staged};
}

std::vector<ir::PassStaged> staged_in(const std::string& kernel) { return body_of(kernel).staged; }

constexpr std::array one{1u, 1u, 1u}, four_along_y{1u, 4u, 1u};

TEST(Stage, ElementsThatAllInvocationsLoad) {
    const Body body = body_of("p: in each<Line>, all: in any<Line>, to: out each<Line>) "
                              "{ var sum = 0u; for i in 0..all.domain() { sum += all[i] ^ p; } to = sum; }");
    ASSERT_THAT(body.staged, SizeIs(1));
    EXPECT_EQ(body.staged[0].rounds, 256u);
    EXPECT_EQ(body.staged[0].entries, 256u);
    EXPECT_EQ(body.elements, one);
    EXPECT_EQ(count(body.text, "barrier()"), 2u) << body.text;
}

TEST(Stage, RowsAndColumnsOfMatricesForFourElements) {
    const Body body =
        body_of("c: out each<Matrix>, p: at<Matrix>, a: in any<Matrix>, b: in any<Matrix>) { var sum = 0.0; "
                "for k in 0..a.domain().x { sum += a[uint2(k, p.y)] * b[uint2(p.x, k)]; } c = sum; }");
    ASSERT_THAT(body.staged, SizeIs(2));
    EXPECT_EQ(body.staged[0].entries, 1024u);
    EXPECT_EQ(body.staged[1].entries, 1024u);
    EXPECT_EQ(body.elements, four_along_y);
    EXPECT_EQ(count(body.text, " c_data["), 4u) << body.text;
}

/// Invocations of a workgroup that load entries of consecutive rounds write to different banks.
TEST(Stage, RowsAreLongerWhereLanesLoadAlongRounds) {
    const Body body = body_of("c: out each<Matrix>, p: at<Matrix>, b: in any<Matrix>) { var sum = 0.0; "
                              "for k in 0..b.domain().x { sum += b[uint2(k, p.x)]; } c = sum; }");
    ASSERT_THAT(body.staged, SizeIs(1));
    EXPECT_THAT(body.text, HasSubstr("* 33u")) << body.text;
}

TEST(Stage, EqualLoadsShareATile) {
    EXPECT_THAT(staged_in("p: in each<Points>, all: in any<Points>, to: out each<Points>) { var sum = p; "
                          "for i in 0..all.domain() { sum += all[i].wzyx; sum *= all[i]; } to = sum; }"),
                SizeIs(1));
}

TEST(Stage, LeavesAloneWhatInvocationsDoNotShare) {
    const std::string begin = "p: in each<Line>, a: at<Line>, all: in any<Line>, to: out each<Line>) { var sum = 0u; ";
    // Of their own, and of data.
    EXPECT_THAT(staged_in(begin + "for i in 0..100u { sum += all[a + i]; } to = sum; }"), IsEmpty());
    EXPECT_THAT(staged_in(begin + "for i in 0..100u { sum += all[p + i]; } to = sum; }"), IsEmpty());
    EXPECT_THAT(staged_in(begin + "for i in 0..100u { sum += all[all[i] % 7u + p]; } to = sum; }"), SizeIs(1));
    // Not in every round, and in no round.
    EXPECT_THAT(staged_in(begin + "for i in 0..100u { if sum > 3u { sum += all[i]; } } to = sum; }"), IsEmpty());
    EXPECT_THAT(staged_in(begin + "for i in 0..100u { sum += all[3u]; } to = sum; }"), IsEmpty());
    // As many rounds as data say, and few rounds.
    EXPECT_THAT(staged_in(begin + "for i in 0..p { sum += all[i]; } to = sum; }"), IsEmpty());
    EXPECT_THAT(staged_in(begin + "for i in 0..8u { sum += all[i]; } to = sum; }"), IsEmpty());
}

TEST(Stage, LeavesAloneLoopsThatInvocationsMayLeave) {
    const std::string begin = "p: in each<Line>, all: in any<Line>, to: out each<Line>) { var sum = 0u; ";
    EXPECT_THAT(staged_in(begin + "for i in 0..100u { if sum > p { break; } sum += all[i]; } to = sum; }"), IsEmpty());
    EXPECT_THAT(staged_in(begin + "if p == 0u { return; } for i in 0..100u { sum += all[i]; } to = sum; }"), IsEmpty());
    EXPECT_THAT(staged_in(begin + "for i in 0..100u { for j in 0..p { sum += all[i]; } } to = sum; }"), IsEmpty());
    EXPECT_THAT(staged_in(begin + "if p > 5u { for i in 0..100u { sum += all[i]; } } to = sum; }"), IsEmpty());
}

TEST(Stage, LeavesAloneMemoryThatIsWritten) {
    EXPECT_THAT(staged_in("p: in each<Line>, all: inout coherent<Line>) "
                          "{ var sum = p; for i in 0..100u { sum += all[i]; } all[p] = sum; }"),
                IsEmpty());
}

TEST(Stage, LeavesAloneElementsThatAreNoVectors) {
    EXPECT_THAT(staged_in("p: in each<Line>, all: in any<Matrices>, to: out each<Line>) "
                          "{ var sum = p; for i in 0..100u { sum += uint(all[i][0].x); } to = sum; }"),
                IsEmpty());
}

}  // namespace
}  // namespace gliftc
