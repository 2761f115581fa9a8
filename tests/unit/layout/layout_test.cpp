#include "layout/layout.h"

#include <gtest/gtest.h>

namespace gliftc {
namespace {

TEST(Layout, ScalarLayoutOfTypes) {
    ir::Program program;
    ir::Types& types = program.types;
    EXPECT_EQ(layout::size_of(program, types.vector(types.float_, 3)).size, 12u);
    EXPECT_EQ(layout::size_of(program, types.vector(types.float_, 3)).align, 4u);
    EXPECT_EQ(layout::size_of(program, types.bool_).size, 4u);
    EXPECT_EQ(layout::size_of(program, types.matrix(types.float_, 4, 4)).size, 64u);
    EXPECT_EQ(layout::size_of(program, types.array(types.uint64, 3)).size, 24u);
    EXPECT_EQ(layout::size_of(program, types.optional(types.double_)).size, 16u);
    const ir::StructId made =
        program.structs.add({.fields = {{{}, types.float_, {}}, {{}, types.double_, {}}, {{}, types.half, {}}}});
    ir::TypeId type = types.of_struct(made);
    EXPECT_EQ(layout::offsets_of(program, program.structs[made]), (std::vector<std::uint32_t>{0, 8, 16}));
    EXPECT_EQ(layout::size_of(program, type).size, 24u);
    EXPECT_EQ(layout::size_of(program, type).align, 8u);
}

TEST(Layout, ParametersArePushConstantsWhereTheyFit) {
    ir::Program program;
    ir::Lowered lowered;
    ir::Lowered::Forms& forms = lowered.passes.emplace_back();
    auto add = [&](ir::Pass& pass, ir::TypeId type) {
        ir::PassParameter parameter;
        parameter.type = type;
        pass.parameters.push_back(parameter);
    };
    forms.general.form = ir::Form::general;
    add(forms.direct, program.types.uint);
    add(forms.direct, program.types.vector(program.types.uint, 4));
    add(forms.general, program.types.uint);
    add(forms.general, program.types.uint64);
    layout::lay_out(program, lowered);
    EXPECT_TRUE(forms.direct.push_constants);
    EXPECT_EQ(forms.direct.parameters[1].offset, 4u);
    EXPECT_EQ(forms.direct.parameter_bytes, 20u);
    EXPECT_EQ(forms.general.parameters[1].offset, 8u);
    EXPECT_FALSE(forms.general.push_constants);
    add(forms.direct, program.types.array(program.types.float_, 40));
    layout::lay_out(program, lowered);
    EXPECT_FALSE(forms.direct.push_constants);
}

}  // namespace
}  // namespace gliftc
