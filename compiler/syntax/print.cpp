#include "syntax/print.h"

#include <charconv>

namespace gliftc {

using namespace ast;

namespace {

std::string_view word_of(BinaryOp op) {
    switch (op) {
    case BinaryOp::multiply: return "*";
    case BinaryOp::divide: return "/";
    case BinaryOp::remainder: return "%";
    case BinaryOp::add: return "+";
    case BinaryOp::subtract: return "-";
    case BinaryOp::shift_left: return "<<";
    case BinaryOp::shift_right: return ">>";
    case BinaryOp::less: return "<";
    case BinaryOp::less_equal: return "<=";
    case BinaryOp::greater: return ">";
    case BinaryOp::greater_equal: return ">=";
    case BinaryOp::equal: return "==";
    case BinaryOp::not_equal: return "!=";
    case BinaryOp::bit_and: return "&";
    case BinaryOp::bit_xor: return "^";
    case BinaryOp::bit_or: return "|";
    case BinaryOp::logical_and: return "&&";
    case BinaryOp::logical_or: return "||";
    case BinaryOp::otherwise: return "??";
    case BinaryOp::then: return "then";
    }
    return "";
}

std::string_view word_of(UnaryOp op) {
    switch (op) {
    case UnaryOp::plus: return "+";
    case UnaryOp::minus: return "-";
    case UnaryOp::logical_not: return "!";
    case UnaryOp::bit_not: return "~";
    }
    return "";
}

std::string_view word_of(Direction direction) {
    switch (direction) {
    case Direction::none: return "";
    case Direction::in: return "in";
    case Direction::out: return "out";
    case Direction::inout: return "inout";
    }
    return "";
}

std::string_view word_of(Pattern pattern) {
    switch (pattern) {
    case Pattern::none: return "";
    case Pattern::each: return "each";
    case Pattern::near: return "near";
    case Pattern::any: return "any";
    case Pattern::at: return "at";
    case Pattern::scatter: return "scatter";
    case Pattern::coherent: return "coherent";
    case Pattern::target: return "target";
    case Pattern::instance: return "instance";
    case Pattern::calls: return "calls";
    case Pattern::range: return "range";
    }
    return "";
}

std::string_view word_of(Word interpolation) {
    return interpolation == Word::smooth ? "smooth" : interpolation == Word::linear ? "linear" : "flat";
}

class Printer {
public:
    Printer(const Tree& tree, const Names& names) : tree_(tree), names_(names) {}

    std::string expr(ExprId id) const {
        if (!id) return "-";
        const Expr& e = tree_.exprs[id];
        switch (e.kind) {
        case ExprKind::error: return "<error>";
        case ExprKind::int_literal: return std::to_string(e.value) + e.suffix;
        case ExprKind::float_literal: return number(e.number) + e.suffix;
        case ExprKind::bool_literal: return e.value ? "true" : "false";
        case ExprKind::string_literal: return "\"" + names_[e.name] + "\"";
        case ExprKind::none_literal: return "none";
        case ExprKind::name: return names_[e.name];
        case ExprKind::generic: return list("generic", e);
        case ExprKind::named: return names_[e.name] + ":" + expr(e.operands[0]);
        case ExprKind::member: return "(. " + expr(e.operands[0]) + " " + names_[e.name] + ")";
        case ExprKind::index: return list("index", e);
        case ExprKind::call: return list("call", e);
        case ExprKind::unary: return list(word_of(e.unary), e);
        case ExprKind::binary: return list(word_of(e.binary), e);
        case ExprKind::conditional: return list("?:", e);
        case ExprKind::range: return list("..", e);
        case ExprKind::optional: return list("optional", e);
        case ExprKind::await: return list("await", e);
        case ExprKind::tuple: return list("tuple", e);
        case ExprKind::closure: return closure(e);
        case ExprKind::known_type: return "<type " + std::to_string(e.value) + ">";
        }
        return "";
    }

    void module(const Module& module) {
        line("(module " + names_[module.name.name] + doc(module.doc));
        ++depth_;
        for (const Use& use : module.uses) line("(use " + use.path + ")");
        for (DeclId id : module.decls) decl(id);
        close();
    }

    std::string take() { return std::move(out_); }

private:
    static std::string number(double value) {
        char text[40];
        auto end = std::to_chars(text, text + sizeof text, value).ptr;
        return std::string(text, end);
    }

    std::string list(std::string_view head, const Expr& e) const {
        std::string text = "(" + std::string(head);
        std::size_t unlabelled = e.operands.size() - e.labels.size();
        for (std::size_t i = 0; i < e.operands.size(); ++i) {
            bool labelled = !e.labels.empty() && i >= unlabelled && e.labels[i - unlabelled].name;
            text += " ";
            if (labelled) text += names_[e.labels[i - unlabelled].name] + ":";
            text += expr(e.operands[i]);
        }
        return text + ")";
    }

    std::string closure(const Expr& e) const {
        const auto& function = std::get<Function>(tree_.decls[e.decl].body);
        const std::string head = "(closure" + params(function.params);
        if (!e.operands.empty()) return head + " " + expr(e.operands[0]) + ")";
        Printer inner(tree_, names_);
        inner.block(function.body);
        return head + " {\n" + inner.take() + "})";
    }

    void line(const std::string& text) {
        if (!out_.empty()) out_ += '\n';
        out_.append(2 * depth_, ' ');
        out_ += text;
    }
    void close() {
        --depth_;
        out_ += ")";
        if (depth_ == 0) out_ += '\n';
    }

    static std::string doc(const std::string& text) {
        if (text.empty()) return "";
        std::string shown = " doc \"";
        for (char c : text) shown += c == '\n' ? std::string("\\n") : std::string(1, c);
        return shown + "\"";
    }

    std::string typed(const Identifier& name, ExprId type) const {
        return names_[name.name] + (type ? ":" + expr(type) : "");
    }

    std::string param(const Param& p) const {
        std::string text = "(" + names_[p.name.name];
        if (p.direction != Direction::none) text += " " + std::string(word_of(p.direction));
        if (p.pattern != Pattern::none) text += " " + std::string(word_of(p.pattern));
        if (p.type) text += " " + expr(p.type);
        for (ExprId extra : p.extra) text += " " + expr(extra);
        if (p.default_value) text += " = " + expr(p.default_value);
        return text + ")";
    }
    std::string params(const std::vector<Param>& list) const {
        std::string text = " (";
        for (const Param& p : list) text += (text.size() > 2 ? " " : "") + param(p);
        return text + ")";
    }

    void block(const std::vector<StmtId>& body) {
        ++depth_;
        for (StmtId id : body) stmt(id);
        --depth_;
    }

    void stmt(StmtId id) {
        const Stmt& s = tree_.stmts[id];
        switch (s.kind) {
        case StmtKind::error: return line("<error>");
        case StmtKind::let: {
            const char* word = s.binding == Binding::let ? "let" : s.binding == Binding::var ? "var" : "const";
            return line(std::string("(") + word + " " + typed(s.name, s.type) + " " + expr(s.value) + ")");
        }
        case StmtKind::shared: return line("(shared " + typed(s.name, s.type) + ")");
        case StmtKind::temp:
            return line((s.is_uninitialized ? "(uninitialized-temp " : "(temp ") + typed(s.name, s.type) + " " +
                        expr(s.value) + ")");
        case StmtKind::assign:
            return line("(" + (s.op ? std::string(word_of(*s.op)) : "") + "= " + expr(s.target) + " " + expr(s.value) +
                        ")");
        case StmtKind::expression: return line("(do " + expr(s.value) + ")");
        case StmtKind::if_:
            line("(if " + (s.name.name ? "let " + names_[s.name.name] + " " : "") + expr(s.value));
            block(s.body);
            if (s.has_else) {
                line("else");
                block(s.otherwise);
            }
            out_ += ")";
            return;
        case StmtKind::for_:
            line("(for " + names_[s.name.name] + " " + expr(s.value) +
                 (s.condition ? " while " + expr(s.condition) : ""));
            break;
        case StmtKind::while_: line("(while " + expr(s.value)); break;
        case StmtKind::break_: return line("(break)");
        case StmtKind::continue_: return line("(continue)");
        case StmtKind::discard: return line("(discard)");
        case StmtKind::return_: return line("(return" + (s.value ? " " + expr(s.value) : "") + ")");
        case StmtKind::switch_: line("(switch " + expr(s.value)); break;
        case StmtKind::block: line("(block"); break;
        }
        block(s.body);
        out_ += ")";
    }

    std::string attributes(const std::vector<Attribute>& list) {
        std::string text;
        for (const Attribute& attribute : list) {
            text += "@" + names_[attribute.name.name];
            for (ExprId argument : attribute.arguments) text += " " + expr(argument);
            text += " ";
        }
        return text;
    }
    void field(const Field& f) {
        line("(field " + attributes(f.attributes) + typed(f.name, f.type) + doc(f.doc) + ")");
    }

    void item(const Item& i) {
        switch (i.kind) {
        case ItemKind::memory: {
            std::string text = "(memory " + names_[i.name.name] + " " + expr(i.value);
            if (i.mips) text += " mips " + expr(i.mips);
            if (i.filter) text += " filter " + names_[i.filter];
            if (i.compare) text += " compare " + names_[i.compare];
            if (i.apart) text += " apart " + expr(i.apart);
            return line(text + doc(i.doc) + ")");
        }
        case ItemKind::member: return line("(member " + names_[i.name.name] + " " + expr(i.value) + doc(i.doc) + ")");
        case ItemKind::via: return line("(via " + expr(i.value) + ")");
        case ItemKind::otherwise: return line("(otherwise " + expr(i.value) + ")");
        case ItemKind::host: return line("(host " + typed(i.name, i.type) + " " + expr(i.value) + ")");
        case ItemKind::condition:
            line("(if " + expr(i.value));
            items(i.body);
            if (!i.alternative.empty()) line("else");
            items(i.alternative);
            out_ += ")";
            return;
        case ItemKind::function:
        case ItemKind::pipeline:
            if (i.decl) decl(i.decl);
            return;
        }
    }
    void items(const std::vector<Item>& list) {
        ++depth_;
        for (const Item& i : list) item(i);
        --depth_;
    }

    void decl(DeclId id) {
        const Decl& d = tree_.decls[id];
        std::string head = attributes(d.attributes);
        if (d.is_pub) head += "pub ";
        if (d.is_extern) head += "extern ";
        std::string name = names_[d.name.name];
        for (const GenericParam& g : d.generics)
            name += " <" + typed(g.name, g.constraint) + (g.default_value ? " = " + expr(g.default_value) : "") + ">";
        name += doc(d.doc);
        std::visit([&](const auto& body) { print_body(head, name, body); }, d.body);
        out_ += ")";
    }

    void print_body(const std::string& head, const std::string& name, const std::monostate&) {
        line("(" + head + name);
    }
    std::string with(const std::vector<MemberPattern>& patterns) {
        std::string text;
        for (const MemberPattern& pattern : patterns) {
            text += (text.empty() ? " with " : ", ") + std::string(word_of(pattern.pattern)) + "<" +
                    names_[pattern.member.name];
            for (ExprId extra : pattern.extra) text += ", " + expr(extra);
            text += ">";
        }
        return text;
    }
    std::string group(const std::vector<ExprId>& extents) {
        std::string text = extents.empty() ? "" : " group";
        for (ExprId extent : extents) text += " " + expr(extent);
        return text;
    }
    void print_body(const std::string& head, const std::string& name, const Function& f) {
        line("(" + head + "fn " + name + params(f.params) + group(f.group) + with(f.with) +
             (f.result ? " -> " + expr(f.result) : ""));
        block(f.body);
    }
    void print_body(const std::string& head, const std::string& name, const Struct& s) {
        line("(" + head + "struct " + name + (s.extern_header.empty() ? "" : " from \"" + s.extern_header + "\""));
        ++depth_;
        for (const Field& f : s.fields) field(f);
        --depth_;
    }
    void print_body(const std::string& head, const std::string& name, const Enum& e) {
        std::string text = "(" + head + "enum " + name;
        for (const Enumerator& one : e.enumerators)
            text += " " + names_[one.name.name] + (one.value ? "=" + expr(one.value) : "");
        line(text);
    }
    void print_body(const std::string& head, const std::string& name, const Interface& i) {
        line("(" + head + "interface " + name);
        ++depth_;
        for (DeclId member : i.members) decl(member);
        --depth_;
    }
    void print_body(const std::string& head, const std::string& name, const Const& c) {
        line("(" + head + "const " + name + (c.type ? ":" + expr(c.type) : "") + " " + expr(c.value));
    }
    void print_body(const std::string& head, const std::string& name, const Alias& a) {
        line("(" + head + "alias " + name + " " + expr(a.target));
    }
    void print_body(const std::string& head, const std::string& name, const Translator& t) {
        line("(" + head + "translator " + name + " " + expr(t.virtual_type) + " -> " + expr(t.physical_type));
        ++depth_;
        for (const Field& f : t.fields) field(f);
        for (DeclId method : t.methods) decl(method);
        --depth_;
    }
    void print_body(const std::string& head, const std::string& name, const Structure& s) {
        const std::string types =
            s.virtual_type ? " " + expr(s.virtual_type) + " -> " + expr(s.element_type) : std::string();
        line("(" + head + "structure " + name + params(s.constructor) + types);
        items(s.items);
    }
    void print_body(const std::string& head, const std::string& name, const Kernel& k) {
        line("(" + head + (k.raster ? "raster " : "kernel ") + name + params(k.params) + group(k.group));
        if (k.raster) return raster(k);
        block(k.body);
    }
    void print_body(const std::string& head, const std::string& name, const KernelInstances& k) {
        std::string targets;
        for (ExprId target : k.targets) targets += " " + expr(target);
        line("(" + head + "kernel " + name + targets);
    }
    void raster(const Kernel& k) {
        ++depth_;
        for (const RasterState& state : k.raster->states)
            line("(" + std::string(state.word == Word::cull ? "cull" : "draw") + " " + names_[state.value.name] + ")");
        for (const Varying& varying : k.raster->varyings)
            line("(" + std::string(word_of(varying.interpolation)) + " " + typed(varying.name, varying.type) + ")");
        line("(vertex");
        block(k.body);
        out_ += ")";
        if (k.raster->fragment_span) {
            line("(fragment");
            block(k.raster->fragment);
            out_ += ")";
        }
        --depth_;
    }
    void print_body(const std::string& head, const std::string& name, const Pipeline& p) {
        std::string result = p.result ? " -> " : "";
        if (p.result_pattern != Pattern::none) result += std::string(word_of(p.result_pattern)) + " ";
        if (p.result) result += expr(p.result);
        if (p.result_extra) result += " " + expr(p.result_extra);
        line("(" + head + "pipeline " + name + params(p.params) + result);
        block(p.body);
    }
    void print_body(const std::string& head, const std::string& name, const Test& t) {
        line("(" + head + "test \"" + t.title + "\"" + name);
        block(t.body);
    }

    const Tree& tree_;
    const Names& names_;
    std::string out_;
    std::size_t depth_ = 0;
};

}  // namespace

std::string print(ExprId expr, const Tree& tree, const Names& names) { return Printer(tree, names).expr(expr); }

std::string print(const Module& module, const Tree& tree, const Names& names) {
    Printer printer(tree, names);
    printer.module(module);
    return printer.take();
}

}  // namespace gliftc
