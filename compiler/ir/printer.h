// The class that prints expressions, statements and passes, for the files print*.cpp.
#pragma once

#include "ir/pass.h"

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace gliftc::ir {

class Printer {
public:
    Printer(const Program& program, const Pass* pass, const Kernel* kernel = nullptr);

    // print_expressions.cpp
    std::string expr(ExprId id);
    // print_statements.cpp
    void body(const std::vector<StmtId>& body);
    void function(FunctionId id);
    // print_pass.cpp
    void pass(const std::vector<ExprId>& facts);
    // print.cpp
    void kernel();

    void line(const std::string& text) { text_ += std::string(indent_ * 4, ' ') + text + "\n"; }
    std::string take() { return std::move(text_); }

private:
    std::string bare(ExprId id);
    std::string constant(const Expr& node);
    std::string call(const Expr& node);
    std::string memory(const Expr& node);
    std::string host(const Expr& node);
    std::string operand(ExprId id);
    std::string list(const Operands& operands, std::size_t from = 0);
    std::string place(const Place& place);
    std::string local(LocalId id);
    std::string type(TypeId id);
    std::string unique(std::string text);
    std::string function_name(FunctionId id);
    std::string binding(std::uint32_t slot);
    std::string name(Name name) const { return (*p.names)[name]; }
    bool needs_type(const Expr& node);

    void stmt(const Stmt& stmt);
    void nested(const std::string& head, const std::vector<StmtId>& body);
    void let(const Stmt& stmt);
    void host_stmt(const Stmt& stmt);
    std::string member(const Stmt& stmt) const;
    std::string field(const Stmt& stmt) const;
    void cpu_stmt(const Stmt& stmt);
    std::string declaration(LocalId local);

    void declare_types(TypeId type);
    void declare_struct(StructId id);
    void declare_enum(EnumId id);
    void declare_used_types();
    void dispatch_lines();
    void kernel_parameters();
    void bindings();
    void parameters();
    std::string title(const Variant& variant);

    const Program& p;
    const Pass* pass_;
    const Kernel* kernel_;
    unsigned indent_ = 0;
    std::string text_;
    std::unordered_map<LocalId, std::string> locals_;
    std::unordered_map<FunctionId, std::string> functions_;
    std::unordered_map<StructId, std::string> structs_;
    std::unordered_map<EnumId, std::string> enums_;
    std::unordered_map<std::string, unsigned> taken_;  ///< how many things have each name so far
    std::unordered_set<TypeId> declared_;              ///< the types whose structs and enums have been printed
};

}  // namespace gliftc::ir
