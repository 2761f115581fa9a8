#include "sema/types/specificity.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace gliftc::sema {

namespace {

const std::vector<ast::Param>& params_of(const ast::Decl& decl) {
    if (const auto* kernel = std::get_if<ast::Kernel>(&decl.body)) return kernel->params;
    if (const auto* pipeline = std::get_if<ast::Pipeline>(&decl.body)) return pipeline->params;
    return std::get<ast::Function>(decl.body).params;
}

bool is_generic_of(const ast::Decl& decl, Name name) {
    return std::ranges::any_of(decl.generics,
                               [&](const ast::GenericParam& generic) { return generic.name.name == name; });
}

/// Whether the type expression depends on the declaration's generic parameters.
bool names_generic(const Context& c, const ast::Decl& decl, ast::ExprId type) {
    if (!type) return false;
    const ast::Expr& expr = c[type];
    if (expr.kind == ast::ExprKind::name && is_generic_of(decl, expr.name)) return true;
    return std::ranges::any_of(expr.operands, [&](ast::ExprId part) { return names_generic(c, decl, part); });
}

/// Whether two nodes are the same, apart from their operands. Literals other than integers are not compared.
bool is_same_node(const ast::Expr& a, const ast::Expr& b) {
    if (a.kind != b.kind || a.operands.size() != b.operands.size()) return false;
    switch (a.kind) {
    case ast::ExprKind::name:
    case ast::ExprKind::named:
    case ast::ExprKind::member: return a.name == b.name;
    case ast::ExprKind::int_literal: return a.value == b.value;
    case ast::ExprKind::unary: return a.unary == b.unary;
    case ast::ExprKind::binary: return a.binary == b.binary;
    default: return true;
    }
}

bool is_same(const Context& c, ast::ExprId a, ast::ExprId b) {
    if (!a || !b) return !a && !b;
    const ast::Expr &left = c[a], &right = c[b];
    if (!is_same_node(left, right)) return false;
    for (std::size_t i = 0; i < left.operands.size(); ++i)
        if (!is_same(c, left.operands[i], right.operands[i])) return false;
    return true;
}

/// One-sided unification: matches the parameter types of one declaration, whose generics are variables, against those
/// of another, whose generics are constants.
struct Matcher {
    const Context& c;
    const ast::Decl& taking;
    const ast::Decl& taken;
    std::vector<std::pair<Name, ast::ExprId>> bound;

    bool takes(ast::ExprId pattern, ast::ExprId type) {
        if (!pattern || !type) return !pattern && !type;
        const ast::Expr &wanted = c[pattern], &given = c[type];
        if (wanted.kind == ast::ExprKind::name && is_generic_of(taking, wanted.name)) {
            for (const auto& [name, what] : bound)
                if (name == wanted.name) return is_same(c, what, type);
            bound.emplace_back(wanted.name, type);
            return true;
        }
        if (!is_same_node(wanted, given)) return false;
        if (given.kind == ast::ExprKind::name && is_generic_of(taken, given.name)) return false;
        for (std::size_t i = 0; i < wanted.operands.size(); ++i)
            if (!takes(wanted.operands[i], given.operands[i])) return false;
        return true;
    }

    bool takes_all() {
        const auto& patterns = params_of(taking);
        const auto& types = params_of(taken);
        for (std::size_t i = 0; i < patterns.size() && i < types.size(); ++i) {
            // Both overloads accept the arguments, so that a type without generics is an instance of the other's type.
            if (!names_generic(c, taken, types[i].type)) continue;
            if (!names_generic(c, taking, patterns[i].type) || !takes(patterns[i].type, types[i].type)) return false;
        }
        return true;
    }
};

bool takes_all_of(const Context& c, const ast::Decl& taking, const ast::Decl& taken) {
    return Matcher{c, taking, taken, {}}.takes_all();
}

}  // namespace

bool is_more_special(const Context& c, const ast::Decl& a, const ast::Decl& b) {
    return takes_all_of(c, b, a) && !takes_all_of(c, a, b);
}

}  // namespace gliftc::sema
