#include "sema/bodies/free_names.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

class Finder {
public:
    explicit Finder(const Context& context) : c(context) {}

    void closure(const ast::Expr& expr) {
        const auto& function = std::get<ast::Function>(c[expr.decl].body);
        const std::size_t outer = bound_.size();
        for (const ast::Param& param : function.params) {
            expression(param.type);
            bound_.push_back(param.name.name);
        }
        statements(function.body);
        bound_.resize(outer);
    }

    std::vector<ast::ExprId> found;

private:
    void expression(ast::ExprId id) {
        if (!id) return;
        const ast::Expr& expr = c[id];
        if (expr.kind == ast::ExprKind::closure) return closure(expr);
        if (expr.kind == ast::ExprKind::name && is_new(expr.name)) found.push_back(id);
        for (ast::ExprId operand : expr.operands) expression(operand);
    }

    bool is_new(Name name) const {
        const auto is_it = [&](ast::ExprId other) { return c[other].name == name; };
        return std::ranges::find(bound_, name) == bound_.end() && std::ranges::none_of(found, is_it);
    }

    void statements(const std::vector<ast::StmtId>& body) {
        const std::size_t outer = bound_.size();
        for (ast::StmtId id : body) statement(c[id]);
        bound_.resize(outer);
    }

    /// The name that a statement declares is bound in its body and in the statements that follow it; after `for` and
    /// `if let` in the body alone.
    void statement(const ast::Stmt& stmt) {
        expression(stmt.type);
        expression(stmt.target);
        expression(stmt.value);
        const std::size_t outer = bound_.size();
        if (stmt.name.name) bound_.push_back(stmt.name.name);
        expression(stmt.condition);
        statements(stmt.body);
        const bool stays =
            stmt.kind == ast::StmtKind::let || stmt.kind == ast::StmtKind::shared || stmt.kind == ast::StmtKind::temp;
        if (!stays) bound_.resize(outer);
        statements(stmt.otherwise);
    }

    const Context& c;
    std::vector<Name> bound_;
};

}  // namespace

std::vector<ast::ExprId> free_names(const Context& context, ast::ExprId closure) {
    Finder finder(context);
    finder.closure(context[closure]);
    return std::move(finder.found);
}

}  // namespace gliftc::sema
