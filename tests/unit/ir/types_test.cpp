#include "ir/types.h"

#include "ir/validate.h"

#include <gtest/gtest.h>

namespace gliftc {
namespace {

TEST(Types, EqualTypesHaveOneId) {
    ir::Types types;
    EXPECT_EQ(types.vector(types.float_, 3), types.vector(types.float_, 3));
    EXPECT_NE(types.vector(types.float_, 3), types.vector(types.uint, 3));
    EXPECT_EQ(types.vector(types.float_, 1), types.float_);
    EXPECT_EQ(types.with_scalar(types.vector(types.float_, 4), types.bool_), types.vector(types.bool_, 4));
    EXPECT_EQ(types.components(types.vector(types.int_, 2)), 2u);
    EXPECT_EQ(types.scalar_of(types.matrix(types.float_, 2, 3)), types.float_);
    EXPECT_TRUE(types.is_signed(types.int64));
    EXPECT_FALSE(types.is_number(types.bool_));
}

TEST(Types, KnowTheTypesOfACopy) {
    ir::Types types, copy = types;
    types.vector(types.uint, 2);  // from here on, different new types have equal ids in the two tables
    const ir::TypeId made = copy.optional(copy.vector(copy.float_, 3));
    EXPECT_EQ(types.same_as(copy, made), types.optional(types.vector(types.float_, 3)));
    EXPECT_EQ(types.same_as(copy, copy.bool_), types.bool_);
}

TEST(Validate, FindsALocalBeforeItsLet) {
    Names names;
    ir::Program program;
    program.names = &names;
    ir::Expr use;
    use.op = ir::Op::local;
    use.type = program.types.float_;
    use.local = program.locals.add({names.intern("x"), program.types.float_, {}, false, ir::Storage::value});
    ir::Stmt stmt;
    stmt.op = ir::StmtOp::evaluate;
    stmt.value = program.exprs.add(use);
    ir::Pass pass;
    pass.kernel = program.kernels.add({});
    pass.plain().body = {program.stmts.add(stmt)};
    std::vector<std::string> problems = ir::validate(program, pass);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0], "a local before its let: x");
}

}  // namespace
}  // namespace gliftc
