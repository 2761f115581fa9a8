#include "sema/warnings.h"

#include "sema/types/meta.h"

#include <algorithm>
#include <unordered_set>

namespace gliftc::sema {

namespace {

/// The names that a body mentions.
class Mentions {
public:
    Mentions(const Context& context, const std::vector<ast::StmtId>& body) : c(context) { statements(body); }

    bool is_named(Name name) const { return named_.contains(name.index); }
    /// Whether the name occurs in the target of an assignment, or in a call, which may write it.
    bool may_be_written(Name name) const { return written_.contains(name.index); }

private:
    void statements(const std::vector<ast::StmtId>& body) {
        for (ast::StmtId id : body) {
            const ast::Stmt& stmt = c[id];
            for (ast::ExprId part : {stmt.type, stmt.target, stmt.value, stmt.condition})
                if (part) expression(part, part == stmt.target);
            statements(stmt.body);
            statements(stmt.otherwise);
        }
    }

    void expression(ast::ExprId id, bool is_written) {
        const ast::Expr& expr = c[id];
        if (expr.kind == ast::ExprKind::name) {
            named_.insert(expr.name.index);
            if (is_written) written_.insert(expr.name.index);
        }
        if (expr.kind == ast::ExprKind::closure) statements(std::get<ast::Function>(c[expr.decl].body).body);
        for (ast::ExprId operand : expr.operands) expression(operand, is_written || expr.kind == ast::ExprKind::call);
    }

    const Context& c;
    std::unordered_set<std::uint32_t> named_, written_;
};

/// Whether the parameter's range is iterated over: it is needed even if the body uses no element of it.
bool is_visited(ast::Pattern pattern) {
    return pattern == ast::Pattern::each || pattern == ast::Pattern::at || pattern == ast::Pattern::instance;
}

void check_param(Context& c, const ast::Param& param, const Mentions& mentions) {
    const std::string& name = c.text(param.name.name);
    if (name.starts_with('_')) return;
    if (param.direction == ast::Direction::out && !mentions.may_be_written(param.name.name)) {
        c.diagnostics.report(Diag::never_written, param.name.span, {name});
        return;
    }
    if (is_visited(param.pattern) || mentions.is_named(param.name.name)) return;
    note(c.diagnostics.report(Diag::unused_variable, param.name.span, {name}), param.name.span,
         "a name that begins with '_' may stay unused");
}

/// Whether the parameter is a struct: its type selects among overloads and functions of interfaces, so that it may be
/// unused.
bool chooses_function(Context& c, const Env& env, const ast::Param& param) {
    return param.pattern == ast::Pattern::none && c.types().kind(type_of(c, env, param.type)) == ir::TypeKind::struct_;
}

bool always_leaves(const Context& c, const std::vector<ast::StmtId>& body);

bool always_leaves(const Context& c, const ast::Stmt& stmt) {
    switch (stmt.kind) {
    case ast::StmtKind::return_:
    case ast::StmtKind::break_:
    case ast::StmtKind::continue_:
    case ast::StmtKind::discard: return true;
    case ast::StmtKind::switch_:
    case ast::StmtKind::block: return always_leaves(c, stmt.body);
    case ast::StmtKind::if_: return stmt.has_else && always_leaves(c, stmt.body) && always_leaves(c, stmt.otherwise);
    case ast::StmtKind::error:
    case ast::StmtKind::let:
    case ast::StmtKind::shared:
    case ast::StmtKind::temp:
    case ast::StmtKind::assign:
    case ast::StmtKind::expression:
    case ast::StmtKind::for_:
    case ast::StmtKind::while_: return false;
    }
    return false;
}

bool always_leaves(const Context& c, const std::vector<ast::StmtId>& body) {
    return std::ranges::any_of(body, [&](ast::StmtId id) { return always_leaves(c, c[id]); });
}

/// Warns, in each block, about the first statement after one that always jumps away.
void check_reached(Context& c, const std::vector<ast::StmtId>& body) {
    for (std::size_t i = 0; i < body.size(); ++i) {
        const ast::Stmt& stmt = c[body[i]];
        check_reached(c, stmt.body);
        check_reached(c, stmt.otherwise);
        if (i + 1 == body.size() || !always_leaves(c, stmt)) continue;
        note(c.diagnostics.report(Diag::unreachable, c[body[i + 1]].span), stmt.span,
             "what stands before always leaves");
        return;
    }
}

/// Warns about `x = x;`.
void check_self_assignments(Context& c, const std::vector<ast::StmtId>& body) {
    for (ast::StmtId id : body) {
        const ast::Stmt& stmt = c[id];
        check_self_assignments(c, stmt.body);
        check_self_assignments(c, stmt.otherwise);
        if (stmt.kind != ast::StmtKind::assign || stmt.op) continue;
        const ast::Expr &target = c[stmt.target], &value = c[stmt.value];
        const bool are_names = target.kind == ast::ExprKind::name && value.kind == ast::ExprKind::name;
        if (are_names && target.name.index == value.name.index)
            c.diagnostics.report(Diag::self_assignment, stmt.span, {c.text(target.name)});
    }
}

/// Checks a pipeline, or a kernel that does not draw.
void check_pass(Context& c, const std::vector<ast::Param>& params, const std::vector<ast::StmtId>& body) {
    check_reached(c, body);
    check_self_assignments(c, body);
    const Mentions mentions(c, body);
    for (const ast::Param& param : params) check_param(c, param, mentions);
}

/// Checks both parts of a draw.
void check_raster(Context& c, const ast::Kernel& raster) {
    check_reached(c, raster.body);
    check_reached(c, raster.raster->fragment);
    std::vector<ast::StmtId> all = raster.body;
    all.insert(all.end(), raster.raster->fragment.begin(), raster.raster->fragment.end());
    const Mentions mentions(c, all);
    for (const ast::Param& param : raster.params)
        if (param.pattern != ast::Pattern::target || param.direction == ast::Direction::out)
            check_param(c, param, mentions);
}

/// Whether the kernel has an instance, or may get one where generic code that mentions it is instantiated.
bool is_checked(const Context& c, ast::DeclId id) {
    const ast::Decl& decl = c[id];
    const auto is_instance = [&](const ir::Kernel& made) {
        return made.name == decl.name.name && made.module == c.module_of.at(id);
    };
    const auto mentions_it = [&](const ast::Expr& expr) {
        return expr.kind == ast::ExprKind::name && expr.name == decl.name.name && expr.span.file == decl.name.span.file;
    };
    return decl.is_pub || std::ranges::any_of(c.program.kernels, is_instance) ||
           std::any_of(c.tree.exprs.begin(), c.tree.exprs.end(), mentions_it);
}

void check_kernel(Context& c, ast::DeclId id, const ast::Kernel& kernel) {
    if (!is_checked(c, id))
        note(c.diagnostics.report(Diag::unchecked_kernel, c[id].name.span, {c.text(c[id].name.name)}), c[id].name.span,
             "call it in a pipeline or a test, or list instances: 'kernel k = k<S>;'");
    else if (kernel.raster) check_raster(c, kernel);
    else check_pass(c, kernel.params, kernel.body);
}

void check_function(Context& c, ast::DeclId id, const ast::Function& function) {
    if (!function.has_body) return;
    check_reached(c, function.body);
    check_self_assignments(c, function.body);
    if (!c[id].generics.empty()) return;  // the types of its parameters are not known
    const Mentions mentions(c, function.body);
    const Env& env = c.new_env(c.module_of.at(id));
    for (const ast::Param& param : function.params)
        if (!chooses_function(c, env, param)) check_param(c, param, mentions);
}

}  // namespace

void warn(Context& c, const std::vector<ast::DeclId>& declarations) {
    for (ast::DeclId id : declarations) {
        const auto& body = c[id].body;
        if (const auto* test = std::get_if<ast::Test>(&body)) check_reached(c, test->body);
        if (const auto* function = std::get_if<ast::Function>(&body)) check_function(c, id, *function);
        if (const auto* kernel = std::get_if<ast::Kernel>(&body)) check_kernel(c, id, *kernel);
        if (const auto* pipeline = std::get_if<ast::Pipeline>(&body)) check_pass(c, pipeline->params, pipeline->body);
    }
}

}  // namespace gliftc::sema
