// `switch`: the parser has made a chain of ifs over a variable with its value; here its cases are checked, and the
// variable is declared.
#include "sema/bodies/body.h"
#include "sema/pipelines/predication.h"
#include "sema/pipelines/values.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

/// The values first to last, both included, of one branch.
struct Case {
    std::int64_t first, last;
    const ast::Stmt* branch;
};

class Cases {
public:
    Cases(Body& body, ir::TypeId type) : body_(body), type_(type) {}

    std::vector<Case> all;
    bool is_wrong = false;  ///< an error is reported

    /// Adds the cases of a branch's condition, which the parser has made: `x == a`, `x >= a && x < b`, or several of
    /// these joined by `||`.
    void add(const ast::Expr& condition, const ast::Stmt& branch) {
        const Context& c = body_.context;
        switch (condition.binary) {
        case ast::BinaryOp::logical_or:
            for (ast::ExprId side : condition.operands) add(c[side], branch);
            return;
        case ast::BinaryOp::equal: {
            const auto value = value_of(condition.operands[1]);
            if (value) add({*value, *value, &branch}, c[condition.operands[1]].span);
            return;
        }
        default: {
            const auto low = value_of(c[condition.operands[0]].operands[1]);
            const auto high = value_of(c[condition.operands[1]].operands[1]);
            if (low && high && *low < *high) add({*low, *high - 1, &branch}, condition.span);
            return;
        }
        }
    }

private:
    void add(Case added, Span span) {
        const auto meets = [&](const Case& other) { return added.first <= other.last && other.first <= added.last; };
        if (std::ranges::any_of(all, meets)) body_.context.error(Diag::switch_case, span), is_wrong = true;
        all.push_back(added);
    }

    std::optional<std::int64_t> value_of(ast::ExprId id) {
        const ir::ExprId value = check_value(body_, id, type_);
        const auto known = is_error(body_, value) ? std::nullopt : known_value(body_, value);
        if (!known && !is_error(body_, value)) body_.context.error(Diag::not_constant, body_.context[id].span);
        if (known) return static_cast<std::int64_t>(known->bits());
        is_wrong = true;
        return std::nullopt;
    }

    Body& body_;
    ir::TypeId type_;
};

/// The enumerators without a case, as "'solid' and 'gas'".
std::string missing(const Context& c, const ir::Enum& declared, const std::vector<Case>& cases) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < declared.values.size(); ++i) {
        const auto has = [&](const Case& other) { return declared.values[i] == other.first; };
        if (std::ranges::none_of(cases, has)) names.push_back("'" + c.text(declared.enumerators[i]) + "'");
    }
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
    return text;
}

/// Makes the last branch of a chain of ifs its `else`.
void drop_last_condition(ir::Program& program, ir::StmtId id) {
    ir::Stmt& branch = program.stmts[id];
    if (!branch.otherwise.empty()) return drop_last_condition(program, branch.otherwise.back());
    branch.op = ir::StmtOp::block;
    branch.value = {};
}

/// The statements that run for a known value; `otherwise`: those for values without a case.
const std::vector<ast::StmtId>& selected(const std::vector<Case>& cases, const ir::Value& known,
                                         const std::vector<ast::StmtId>& otherwise) {
    const auto value = static_cast<std::int64_t>(known.bits());
    const auto has = [&](const Case& one) { return one.first <= value && value <= one.last; };
    const auto found = std::ranges::find_if(cases, has);
    return found == cases.end() ? otherwise : found->branch->body;
}

}  // namespace

void check_switch(Body& body, const ast::Stmt& stmt) {
    Context& c = body.context;
    ir::ExprId value = to_value(body, check(body, stmt.value));
    if (is_error(body, value)) return;
    value = as_declared(body, value, stmt.name.span);
    const ir::TypeId whole = body.program().exprs[value].type;
    const ir::TypeId type = is_on_device(body, value) ? body.types()[whole].element : whole;
    const bool is_enum = body.types().kind(type) == ir::TypeKind::enum_;
    if (!is_enum && !(body.types().is_scalar(type) && body.types().is_integer(type))) {
        c.error(Diag::switch_type, c[stmt.value].span, {c.text(whole)});
        return;
    }
    Cases cases(body, type);
    const std::vector<ast::StmtId>* chain = &stmt.body;
    for (std::size_t left = stmt.branches; left > 0; --left) {
        const ast::Stmt& branch = c[chain->front()];
        cases.add(c[branch.value], branch);
        chain = &branch.otherwise;
    }
    if (cases.is_wrong) return;
    if (is_enum && !stmt.has_else) {
        const std::string text = missing(c, c.program.enums[body.types()[type].enum_], cases.all);
        if (!text.empty()) {
            note(c.error(Diag::switch_incomplete, c[stmt.value].span, {text}), c[stmt.value].span,
                 "write a case, or 'else: { … }' for all that have none");
            return;
        }
    }
    const auto known = known_value(body, value);
    if (known && !body.env.bindings.empty()) {  // in an instance nothing is instantiated for the other branches
        for (ir::StmtId id : check_nested(body, selected(cases.all, *known, *chain))) emit(body, id);
        return;
    }
    Symbol symbol;
    symbol.kind = SymbolKind::local;
    symbol.type = whole;
    symbol.local = emit_temporary(body, "selected", value, stmt.name.span);
    body.lets[symbol.local] = value;
    open_scope(body);
    declare(body, stmt.name, symbol);
    std::vector<ir::StmtId> inner = check_nested(body, stmt.body);
    close_scope(body);
    if (is_enum && !stmt.has_else && !known && type == whole && !inner.empty())
        drop_last_condition(body.program(), inner.back());
    for (ir::StmtId id : inner) emit(body, id);
}

}  // namespace gliftc::sema
