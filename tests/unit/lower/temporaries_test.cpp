#include "lower/transform/temporaries.h"

#include "ir/print.h"

#include <gtest/gtest.h>

namespace gliftc {
namespace {

/// Builds a pipeline of temporaries and of statements that use them, by hand.
struct Steps {
    Names names;
    ir::Program program;

    Steps() {
        program.names = &names;
        program.pipelines.emplace_back();
        program.structures.emplace_back().display = "Line";
    }
    ir::LocalId local(const char* name) {
        const ir::TypeId type = program.types.of_structure({0});
        return program.locals.add({names.intern(name), type, {}, false, ir::Storage::value});
    }
    ir::StmtId temp(ir::LocalId id) {
        ir::Stmt stmt;
        stmt.op = ir::StmtOp::temp;
        stmt.local = id;
        return program.stmts.add(stmt);
    }
    ir::StmtId use(ir::LocalId id, ir::StmtOp op = ir::StmtOp::evaluate) {
        ir::Expr expr;
        expr.op = ir::Op::local;
        expr.type = program.types.float_;
        expr.local = id;
        ir::Stmt stmt;
        stmt.op = op;
        stmt.value = program.exprs.add(expr);
        return program.stmts.add(stmt);
    }
    std::string released(std::vector<ir::StmtId> body) {
        program.pipelines.front().body = std::move(body);
        lower::release_temporaries(program);
        return ir::print(program, program.pipelines.front().body);
    }
};

TEST(Temporaries, DieAfterTheirLastUse) {
    Steps steps;
    ir::LocalId a = steps.local("a"), b = steps.local("b");
    EXPECT_EQ(steps.released({steps.temp(a), steps.temp(b), steps.use(a), steps.use(b)}),
              "    temp a = Line();\n    temp b = Line();\n    a;\n    release a;\n    b;\n    release b;\n");
}

TEST(Temporaries, UsedInALoopLiveUntilItsEnd) {
    Steps steps;
    ir::LocalId a = steps.local("a"), b = steps.local("b"), i = steps.local("i");
    ir::Stmt loop;
    loop.op = ir::StmtOp::while_;
    loop.value = steps.program.stmts[steps.use(i)].value;
    loop.body = {steps.use(a), steps.temp(b), steps.use(b), steps.use(i)};
    EXPECT_EQ(steps.released({steps.temp(a), steps.program.stmts.add(loop), steps.use(i)}),
              "    temp a = Line();\n    while i {\n        a;\n        temp b = Line();\n        b;\n        "
              "release b;\n        i;\n"
              "    }\n    release a;\n    i;\n");
}

TEST(Temporaries, ReturnedOnesStay) {
    Steps steps;
    ir::LocalId a = steps.local("a");
    EXPECT_EQ(steps.released({steps.temp(a), steps.use(a, ir::StmtOp::return_)}),
              "    temp a = Line();\n    return a;\n");
}

}  // namespace
}  // namespace gliftc
