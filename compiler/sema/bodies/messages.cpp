#include "sema/bodies/messages.h"

#include "ir/walk.h"
#include "sema/bodies/message_values.h"
#include "sema/bodies/order.h"
#include "sema/names/lookup.h"

#include <algorithm>
#include <utility>

namespace gliftc::sema {

namespace {

/// A message of more words would not be read, and takes its part of a bounded buffer.
constexpr std::uint64_t most_words = 128;

/// The text, with braces that are not placeholders doubled.
std::string escaped(std::string_view text) {
    std::string result;
    for (char c : text) {
        result += c;
        if (c == '{' || c == '}') result += c;
    }
    return result;
}

/// The expression as it is written, in one line.
std::string written(const Context& c, ast::ExprId id) {
    std::string text;
    for (char letter : c.settings.source_text(c[id].span)) {
        const bool is_space = letter == ' ' || letter == '\n' || letter == '\t' || letter == '\r';
        if (!is_space) text += letter;
        else if (!text.empty() && text.back() != ' ') text += ' ';
    }
    return text;
}

/// Whether a statement does more than to compute values that a message prints.
bool has_effect(const ir::Program& p, const ir::Stmt& stmt) {
    switch (stmt.op) {
    case ir::StmtOp::let:
    case ir::StmtOp::assign:
    case ir::StmtOp::if_:
    case ir::StmtOp::block: break;
    default: return true;
    }
    bool found = false;
    ir::for_each_root(stmt, [&](ir::ExprId root) {
        ir::for_each_node(p, root, [&](ir::ExprId id) {
            const ir::Expr& node = p.exprs[id];
            const bool is_atomic = node.op == ir::Op::intrinsic && ir::signature_of(node.intrinsic).starts_with('@');
            const bool is_call = node.op == ir::Op::call;
            found = found || is_atomic ||
                    (is_call && (p.functions[node.function].is_statements() || p.functions[node.function].prints));
        });
    });
    return found;
}

/// Whether a value, or the steps that compute it, have an effect, which a build without messages would lose.
bool has_effect(const ir::Program& p, const Alternative& operand) {
    if (std::ranges::any_of(operand.steps.pending, &Pending::has_effect)) return true;
    bool found = false;
    ir::for_each_statement(p, operand.steps.statements,
                           [&](const ir::Stmt& stmt) { found = found || has_effect(p, stmt); });
    ir::Stmt value;
    value.op = ir::StmtOp::let;
    value.value = operand.value;
    return found || has_effect(p, value);
}

/// One `print` or `assert` that is being checked.
class MessageCheck {
public:
    MessageCheck(Body& body, const ast::Stmt& stmt)
        : body_(body), c(body.context), p(body.program()), call_(c[stmt.value]), span_(stmt.span),
          name_(c.text(c[call_.operands[0]].name)), arguments_(call_.operands.begin() + 1, call_.operands.end()) {}

    void print() {
        if (!is_possible() || !has_arguments()) return;
        add_arguments(arguments_);
        emit_message(false);
    }

    void assert_() {
        if (!is_possible() || !has_arguments()) return;
        Alternative condition = recorded(body_, [&] { return check_value(body_, arguments_[0], body_.types().bool_); });
        is_good_ = is_without_effect(condition, arguments_[0]);
        text_ = escaped(written(c, arguments_[0]));
        ir::ExprId holds = condition.value;
        if (is_good_ && c.settings.messages) {
            append(body_, std::move(condition.steps));
            settle(body_);
            holds = with_named_sides(holds);
        }
        std::vector<ir::StmtId> failed;
        auto* outer = std::exchange(body_.block, &failed);
        const std::vector<ast::ExprId> more(arguments_.begin() + 1, arguments_.end());
        if (!more.empty()) {
            text_ += ": ";
            add_arguments(more);
        }
        emit_message(true);
        body_.block = outer;
        if (failed.empty()) return;
        const ir::ExprId fails = add(p, ir::Op::unary, p.types.bool_, span_, {holds});
        p.exprs[fails].unary = ir::UnaryOp::logical_not;
        const ir::StmtId branch = add(p, ir::StmtOp::if_, span_);
        p.stmts[branch].value = fails;
        p.stmts[branch].body = std::move(failed);
        emit(body_, branch);
    }

private:
    /// Notes that the body prints; reports it where nothing may print.
    bool is_possible() {
        if (body_.prints != nullptr) {
            if (!*body_.prints) *body_.prints = span_;
            return is_unlabelled();
        }
        Diagnostic& diagnostic = c.error(Diag::message_place, span_, {name_});
        if (body_.part != ir::Part::whole)
            note(diagnostic, span_, "fragments have no order: write what you want to see into a target");
        else if (body_.kind == BodyKind::pipeline)
            note(diagnostic, span_,
                 body_.in_test ? "tests ask by 'expect(…)'; to print, call a kernel that does"
                               : "call a kernel that prints");
        return false;
    }

    bool has_arguments() {
        if (arguments_.empty()) c.error(Diag::argument_count, call_.span, {name_, "1 or more", "0"});
        return !arguments_.empty();
    }

    bool is_unlabelled() {
        for (const ast::Identifier& label : call_.labels) {
            if (!label.name) continue;
            note(c.error(Diag::named_argument, label.span, {c.text(label.name)}), call_.span,
                 "only the fields of a struct are named where it is made");
            return false;
        }
        return true;
    }

    bool is_without_effect(const Alternative& operand, ast::ExprId written) {
        if (is_error(body_, operand.value)) return false;
        if (!has_effect(p, operand)) return true;
        note(c.error(Diag::message_effect, c[written].span, {name_}), c[written].span,
             "what is compiled without messages (--no-print) leaves it out: give the value a name by 'let' before");
        return false;
    }

    /// Adds the values of the arguments: into the text that the first of them gives, or with their names.
    void add_arguments(const std::vector<ast::ExprId>& arguments) {
        const bool has_text = c[arguments[0]].kind == ast::ExprKind::string_literal;
        const std::vector<ast::ExprId> values(arguments.begin() + (has_text ? 1 : 0), arguments.end());
        std::vector<std::string> shown;
        for (ast::ExprId value : values) shown.push_back(add_value(value));
        if (has_text) return add_text(c[arguments[0]], shown);
        for (std::size_t i = 0; i < values.size(); ++i)
            text_ += (i ? ", " : "") + escaped(written(c, values[i])) + " = " + shown[i];
    }

    /// Adds the words of a value; returns its text.
    std::string add_value(ast::ExprId id) {
        Alternative operand = recorded(body_, [&] { return check_value(body_, id); });
        if (!is_without_effect(operand, id)) {
            is_good_ = false;
            return "";
        }
        const ir::TypeId type = p.exprs[operand.value].type;
        const std::optional<std::string> text = message_text(p, type);
        if (!text) {
            is_good_ = false;
            Diagnostic& diagnostic = c.error(Diag::not_printable, c[id].span, {c.text(type)});
            if (p.types.kind(type) == ir::TypeKind::optional)
                note(diagnostic, c[id].span,
                     "print it where it has a value: 'if let x = … { print(x); }', or 'x ?? y'");
            else
                note(diagnostic, c[id].span,
                     "printed are numbers, bools, enums, and vectors, arrays and structs of them");
            return "";
        }
        words_count_ += message_words(p, type);
        if (c.settings.messages && words_count_ <= most_words) {
            append(body_, std::move(operand.steps));
            add_named_words(operand.value);
        }
        return *text;
    }

    void add_named_words(ir::ExprId value) {
        const ir::Expr& node = p.exprs[value];
        const bool is_short =
            node.op == ir::Op::local || node.op == ir::Op::constant || message_words(p, node.type) == 1;
        if (!is_short) value = make_local(p, emit_temporary(body_, "printed", value, node.span), span_);
        add_words(p, value, words_);
    }

    /// Puts the texts of values in place of the `{}` of a string.
    void add_text(const ast::Expr& literal, const std::vector<std::string>& values) {
        const std::string& text = c.text(literal.name);
        std::size_t holes = 0;
        for (std::size_t i = 0; i < text.size(); ++i) {
            const char letter = text[i], next = i + 1 < text.size() ? text[i + 1] : '\0';
            const bool is_brace = letter == '{' || letter == '}';
            if (!is_brace) {
                text_ += letter;
            } else if (next == letter) {
                text_ += {letter, letter};
                ++i;
            } else if (letter == '{' && next == '}') {
                if (holes < values.size()) text_ += values[holes];
                ++holes;
                ++i;
            } else {
                note(c.error(Diag::message_brace, literal.span, {std::string(1, letter)}), literal.span,
                     std::string("'{}' stands for a value, '") + letter + letter + "' for the brace");
                is_good_ = false;
                return;
            }
        }
        if (holes == values.size()) return;
        note(c.error(Diag::message_count, literal.span, {std::to_string(holes), std::to_string(values.size())}),
             call_.span, "write '{}' in the text for each value");
        is_good_ = false;
    }

    /// Where a condition compares two scalars, adds their values to the message: `n < 4 (n = 7)`. Returns the condition
    /// over locals, so that each side is evaluated once.
    ir::ExprId with_named_sides(ir::ExprId condition) {
        const ast::Expr& written_condition = c[arguments_[0]];
        const ir::Expr node = p.exprs[condition];
        const bool compares =
            node.op == ir::Op::binary && node.binary >= ir::BinaryOp::less && node.binary <= ir::BinaryOp::not_equal;
        if (!compares || written_condition.kind != ast::ExprKind::binary) return condition;
        ir::Operands sides = node.operands;
        std::string text;
        for (std::size_t i = 0; i < 2; ++i) {
            const ir::Expr side = p.exprs[sides[i]];
            if (side.op == ir::Op::constant ||
                !(p.types.is_scalar(side.type) || p.types.kind(side.type) == ir::TypeKind::enum_))
                continue;
            if (side.op != ir::Op::local)
                sides[i] = make_local(p, emit_temporary(body_, i == 0 ? "left" : "right", sides[i], span_), span_);
            text += (text.empty() ? "" : ", ") + escaped(written(c, written_condition.operands[i])) + " = " +
                    *message_text(p, side.type);
            words_count_ += message_words(p, side.type);
            add_words(p, sides[i], words_);
        }
        if (!text.empty()) text_ += " (" + text + ")";
        return make_binary(p, node.binary, p.types.bool_, sides[0], sides[1], node.span);
    }

    void emit_message(bool is_assertion) {
        if (words_count_ > most_words) {
            note(
                c.error(Diag::message_too_long, call_.span, {std::to_string(words_count_), std::to_string(most_words)}),
                call_.span, "print parts of it");
            is_good_ = false;
        }
        if (!is_good_ || !c.settings.messages) return;
        const ir::StmtId print = add(p, ir::StmtOp::print, span_);
        p.stmts[print].slot = static_cast<std::uint32_t>(p.messages.size());
        if (!words_.empty()) {
            const ir::TypeId type = p.types.array(p.types.uint, static_cast<std::uint32_t>(words_.size()));
            const ir::ExprId words = add(p, ir::Op::construct, type, span_, std::move(words_));
            p.stmts[print].value = words;
        }
        p.messages.push_back({std::move(text_), is_assertion, span_});
        emit(body_, print);
    }

    Body& body_;
    Context& c;
    ir::Program& p;
    const ast::Expr& call_;
    const Span span_;
    const std::string name_;
    const std::vector<ast::ExprId> arguments_;
    std::string text_;
    ir::Operands words_;
    std::uint64_t words_count_ = 0;
    bool is_good_ = true;
};

}  // namespace

bool is_message(Body& body, const ast::Expr& expr) {
    Context& c = body.context;
    if (expr.kind != ast::ExprKind::call) return false;
    const ast::Expr& callee = c[expr.operands[0]];
    if (callee.kind != ast::ExprKind::name) return false;
    const std::string& name = c.text(callee.name);
    if ((name != "print" && name != "assert") || find_symbol(body, callee.name)) return false;
    return look_up(c, body.env.module, {callee.name, callee.span}).found.empty();
}

bool check_message(Body& body, const ast::Stmt& stmt) {
    Context& c = body.context;
    if (!is_message(body, c[stmt.value])) return false;
    MessageCheck check(body, stmt);
    if (c.text(c[c[stmt.value].operands[0]].name) == "print") check.print();
    else check.assert_();
    return true;
}

bool add_messages(Body& body, ir::FunctionId id, Span call) {
    Context& c = body.context;
    const ir::Function& called = c.program.functions[id];
    if (!called.prints) return true;
    if (body.prints != nullptr) {
        if (!*body.prints) *body.prints = call;
        return true;
    }
    note(c.error(Diag::prints_here, call, {c.text(called.name)}), called.prints, "it prints here");
    return false;
}

}  // namespace gliftc::sema
