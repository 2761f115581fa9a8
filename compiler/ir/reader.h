// The class that reads expressions, statements and passes, for the files read_*.cpp.
#pragma once

#include "base/concat.h"
#include "ir/read.h"

#include <map>
#include <string>
#include <unordered_map>

namespace gliftc::ir {

class Reader {
public:
    Reader(Program& program, std::string_view text) : p(program), text_(text) {}

    bool at_end();
    ReadPass pass();

private:
    // read_tokens.cpp
    void skip_space();
    bool at(std::string_view token);  ///< punctuation, or a whole word
    bool accept(std::string_view token);
    void expect(std::string_view token);
    bool at_name();
    std::string name();  ///< a local, function, binding or parameter, with the suffix that makes it unique: sum.2
    std::string word();  ///< a field or keyword: no suffix
    std::uint64_t number();
    [[noreturn]] void fail(std::string_view what);

    // read_types.cpp
    bool at_type();
    TypeId type();
    std::optional<TypeId> accept_base_type();
    std::optional<TypeId> accept_builtin_type();
    void declare_struct();
    void declare_enum();

    // read_expressions.cpp
    ExprId expr();
    ExprId operand();
    TypeId type_of(Builtin builtin);
    ExprId primary();
    ExprId postfix(ExprId whole);
    ExprId after_dot(ExprId whole);
    ExprId literal();
    ExprId parenthesized();
    ExprId made_of_type();
    ExprId intrinsic(const std::string& called);
    ExprId call();
    ExprId parameter();
    ExprId of_place();
    ExprId of_local(const std::string& called);
    ExprId of_binding(Op op);
    Operands list();
    Place place();
    void grow(StructureId structure, const Expr& property);
    std::uint32_t member_of(StructureId structure, const std::string& called);
    ExprId add(Expr node);
    ExprId implied(Expr node);
    TypeId type_of(ExprId id) const { return p.exprs[id].type; }

    // read_statements.cpp
    LocalId declared(const std::string& called, Local local);
    std::vector<StmtId> block();
    std::vector<StmtId> statements();
    Stmt statement();
    Stmt let(bool is_mutable, bool is_temporary);
    Stmt conditional();
    Stmt counted_loop();
    Stmt move_of_rows(StmtOp op);
    Stmt copy_of_row();
    Stmt cut();
    Stmt print();
    Stmt keep();
    Stmt memory_statement(StmtOp op, Combine combine);
    std::vector<std::uint32_t> path_of(ExprId member);
    Stmt assignment();
    Stmt simple(StmtOp op);

    // read_pass.cpp
    bool header();
    void dispatch();
    void kernel_parameter(bool is_value);
    void binding();
    Compare compare();
    void pass_parameter();
    void function();
    bool section();
    void given();
    Variant variant(Part part);
    Interior interior();
    Bounds bounds();
    StructureId new_structure(const std::string& called);
    std::uint32_t parameter_slot();
    std::uint32_t kernel_parameter_index();
    std::uint32_t earlier_binding();
    std::array<std::uint32_t, 3> three();
    Pass& current() { return read_.pass; }
    Kernel& kernel() { return p.kernels[read_.pass.kernel]; }

    Program& p;
    std::string_view text_;
    std::size_t at_ = 0;
    ReadPass read_;
    std::unordered_map<std::string, LocalId> locals_;
    std::unordered_map<std::string, FunctionId> functions_;
    std::unordered_map<std::string, std::uint32_t> bindings_, parameters_, roots_;
    std::map<std::string, TypeId, std::greater<>>
        types_;  ///< structs and enums by name; in descending order, so that a name is tried before its prefixes
};

}  // namespace gliftc::ir
