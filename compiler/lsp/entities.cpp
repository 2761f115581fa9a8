#include "lsp/entities.h"

#include <algorithm>

namespace gliftc::lsp {

namespace {

EntityKind kind_of(const ast::Decl& decl) {
    struct Kinds {
        EntityKind operator()(const std::monostate&) const { return EntityKind::alias; }
        EntityKind operator()(const ast::Function&) const { return EntityKind::function; }
        EntityKind operator()(const ast::Struct&) const { return EntityKind::struct_; }
        EntityKind operator()(const ast::Enum&) const { return EntityKind::enum_; }
        EntityKind operator()(const ast::Interface&) const { return EntityKind::interface; }
        EntityKind operator()(const ast::Const&) const { return EntityKind::constant; }
        EntityKind operator()(const ast::Alias&) const { return EntityKind::alias; }
        EntityKind operator()(const ast::Translator&) const { return EntityKind::translator; }
        EntityKind operator()(const ast::Structure&) const { return EntityKind::structure; }
        EntityKind operator()(const ast::Kernel& kernel) const {
            return kernel.raster ? EntityKind::raster : EntityKind::kernel;
        }
        EntityKind operator()(const ast::KernelInstances&) const { return EntityKind::kernel; }
        EntityKind operator()(const ast::Pipeline&) const { return EntityKind::pipeline; }
        EntityKind operator()(const ast::Test&) const { return EntityKind::test; }
    };
    return std::visit(Kinds{}, decl.body);
}

/// Visits a module's declarations in order, and adds an entity for each.
class Collector {
public:
    Collector(const ast::Tree& tree, std::vector<Entity>& entities) : tree_(tree), entities_(entities) {}

    void declaration(ast::DeclId id, Span scope, std::uint32_t parent) {
        const ast::Decl& decl = tree_.decls[id];
        Entity entity;
        entity.kind = kind_of(decl);
        entity.name = decl.name;
        entity.written = decl.span;
        entity.scope = scope;
        entity.parent = parent;
        entity.doc = decl.doc;
        entity.is_pub = decl.is_pub;
        if (const auto* test = std::get_if<ast::Test>(&decl.body)) entity.title = test->title;
        const std::uint32_t index = add(std::move(entity));
        for (const ast::GenericParam& generic : decl.named_generics())
            simple(EntityKind::generic, generic.name, span_of(generic), decl.span, index);
        std::visit([&](const auto& body) { parts(body, decl.span, index); }, decl.body);
    }

private:
    std::uint32_t add(Entity entity) {
        entities_.push_back(std::move(entity));
        return static_cast<std::uint32_t>(entities_.size() - 1);
    }

    void simple(EntityKind kind, ast::Identifier name, Span written, Span scope, std::uint32_t parent,
                const std::string& doc = {}) {
        if (!name.name) return;
        Entity entity;
        entity.kind = kind;
        entity.name = name;
        entity.written = join(name.span, written);
        entity.scope = scope;
        entity.parent = parent;
        entity.doc = doc;
        add(std::move(entity));
    }

    Span span_of(const ast::GenericParam& generic) const {
        return join(generic.name.span, join(span(generic.constraint), span(generic.default_value)));
    }
    Span span(ast::ExprId id) const { return id ? tree_.exprs[id].span : Span{}; }
    Span span(ast::StmtId id) const { return tree_.stmts[id].span; }

    // ---- parts of declarations
    void parts(const std::monostate&, Span, std::uint32_t) {}
    void parts(const ast::Alias& alias, Span, std::uint32_t of) { expression(alias.target, of); }
    void parts(const ast::KernelInstances&, Span, std::uint32_t) {}
    void parts(const ast::Const& constant, Span, std::uint32_t of) { expression(constant.value, of); }
    void parts(const ast::Function& function, Span whole, std::uint32_t of) {
        parameters(function.params, whole, of);
        block(function.body, whole.end, of);
    }
    void parts(const ast::Struct& record, Span, std::uint32_t of) { fields(record.fields, {}, of); }
    void parts(const ast::Enum& enumeration, Span, std::uint32_t of) {
        for (const ast::Enumerator& each : enumeration.enumerators)
            simple(EntityKind::enumerator, each.name, span(each.value), {}, of);
    }
    void parts(const ast::Interface& interface, Span, std::uint32_t of) {
        for (ast::DeclId member : interface.members) declaration(member, {}, of);
    }
    void parts(const ast::Translator& translator, Span whole, std::uint32_t of) {
        fields(translator.fields, whole, of);
        for (ast::DeclId method : translator.methods) declaration(method, whole, of);
    }
    void parts(const ast::Structure& structure, Span whole, std::uint32_t of) {
        parameters(structure.constructor, whole, of);
        items(structure.items, whole, of);
    }
    void parts(const ast::Kernel& kernel, Span whole, std::uint32_t of) {
        parameters(kernel.params, whole, of);
        if (kernel.raster)
            for (const ast::Varying& varying : kernel.raster->varyings)
                simple(EntityKind::field, varying.name, span(varying.type), whole, of);
        const bool has_fragment = kernel.raster && kernel.raster->fragment_span;
        block(kernel.body, has_fragment ? kernel.raster->fragment_span.begin : whole.end, of);
        if (kernel.raster) block(kernel.raster->fragment, whole.end, of);
    }
    void parts(const ast::Pipeline& pipeline, Span whole, std::uint32_t of) {
        parameters(pipeline.params, whole, of);
        block(pipeline.body, whole.end, of);
    }
    void parts(const ast::Test& test, Span whole, std::uint32_t of) { block(test.body, whole.end, of); }

    void fields(const std::vector<ast::Field>& fields, Span scope, std::uint32_t of) {
        for (const ast::Field& field : fields)
            simple(EntityKind::field, field.name, span(field.type), scope, of, field.doc);
    }

    void parameters(const std::vector<ast::Param>& params, Span scope, std::uint32_t of) {
        for (const ast::Param& param : params) {
            Span written = join(param.name.span, join(span(param.type), span(param.default_value)));
            for (ast::ExprId extra : param.extra) written = join(written, span(extra));
            simple(EntityKind::parameter, param.name, written, scope, of);
            expression(param.default_value, of);
        }
    }

    void items(const std::vector<ast::Item>& items, Span scope, std::uint32_t of) {
        for (const ast::Item& item : items) {
            switch (item.kind) {
            case ast::ItemKind::memory: simple(EntityKind::memory, item.name, item.span, scope, of, item.doc); break;
            case ast::ItemKind::member: simple(EntityKind::member, item.name, item.span, scope, of, item.doc); break;
            case ast::ItemKind::host: simple(EntityKind::host_state, item.name, item.span, scope, of, item.doc); break;
            case ast::ItemKind::function:
            case ast::ItemKind::pipeline:
                if (item.decl) declaration(item.decl, scope, of);
                break;
            case ast::ItemKind::condition:
                this->items(item.body, scope, of);
                this->items(item.alternative, scope, of);
                break;
            case ast::ItemKind::via:
            case ast::ItemKind::otherwise: break;
            }
        }
    }

    // ---- bodies
    /// The statements of a block whose names end at byte `end`.
    void block(const std::vector<ast::StmtId>& statements, std::uint32_t end, std::uint32_t of) {
        for (ast::StmtId statement : statements) this->statement(statement, end, of);
    }

    void variable(const ast::Stmt& stmt, std::uint32_t begin, std::uint32_t end, std::uint32_t of) {
        const Span scope{stmt.span.file, begin, std::max(begin, end)};
        simple(EntityKind::variable, stmt.name, stmt.name.span, scope, of);
    }

    void statement(ast::StmtId id, std::uint32_t end, std::uint32_t of) {
        const ast::Stmt& stmt = tree_.stmts[id];
        switch (stmt.kind) {
        case ast::StmtKind::let:
        case ast::StmtKind::shared:
        case ast::StmtKind::temp: variable(stmt, stmt.span.end, end, of); break;
        case ast::StmtKind::for_: variable(stmt, stmt.name.span.end, stmt.span.end, of); break;
        case ast::StmtKind::if_: variable(stmt, stmt.name.span.end, end_of_first_branch(stmt), of); break;
        case ast::StmtKind::error:
        case ast::StmtKind::assign:
        case ast::StmtKind::expression:
        case ast::StmtKind::while_:
        case ast::StmtKind::switch_:
        case ast::StmtKind::break_:
        case ast::StmtKind::continue_:
        case ast::StmtKind::return_:
        case ast::StmtKind::discard:
        case ast::StmtKind::block: break;
        }
        for (ast::ExprId part : {stmt.target, stmt.value, stmt.condition}) expression(part, of);
        block(stmt.body, end_of_first_branch(stmt), of);
        block(stmt.otherwise, stmt.span.end, of);
    }

    std::uint32_t end_of_first_branch(const ast::Stmt& stmt) const {
        return stmt.otherwise.empty() ? stmt.span.end : span(stmt.otherwise.front()).begin;
    }

    /// Adds what closures within the expression declare.
    void expression(ast::ExprId id, std::uint32_t of) {
        if (!id) return;
        const ast::Expr& expr = tree_.exprs[id];
        if (expr.kind == ast::ExprKind::closure && expr.decl) {
            const auto& function = std::get<ast::Function>(tree_.decls[expr.decl].body);
            parameters(function.params, expr.span, of);
            block(function.body, expr.span.end, of);
        }
        for (ast::ExprId operand : expr.operands) expression(operand, of);
    }

    const ast::Tree& tree_;
    std::vector<Entity>& entities_;
};

}  // namespace

std::vector<Entity> entities_of(const ast::Module& module, const ast::Tree& tree, std::size_t size) {
    std::vector<Entity> entities;
    Collector collector(tree, entities);
    const Span file{module.file, 0, static_cast<std::uint32_t>(size)};
    for (ast::DeclId decl : module.decls) collector.declaration(decl, file, Entity::none);
    return entities;
}

bool is_callable(EntityKind kind) {
    return kind == EntityKind::function || kind == EntityKind::kernel || kind == EntityKind::raster ||
           kind == EntityKind::pipeline || kind == EntityKind::structure || kind == EntityKind::struct_;
}

/// The text of the declaration with its body. A parameter's pattern, as `near<S, 1>`, ends behind its last argument.
static std::string_view whole_text(const Entity& entity, std::string_view file_text) {
    std::string_view text = file_text.substr(entity.written.begin, entity.written.end - entity.written.begin);
    const bool is_open = entity.kind == EntityKind::parameter && entity.written.end < file_text.size() &&
                         file_text[entity.written.end] == '>' &&
                         std::ranges::count(text, '<') > std::ranges::count(text, '>');
    return is_open ? file_text.substr(entity.written.begin, text.size() + 1) : text;
}

std::string header_of(const Entity& entity, std::string_view file_text) {
    std::string_view text = whole_text(entity, file_text);
    int depth = 0;
    std::size_t end = 0;
    for (; end < text.size(); ++end) {
        const char c = text[end];
        if (depth == 0 && (c == '{' || c == ';')) break;
        if (c == '(' || c == '[') ++depth;
        if (c == ')' || c == ']') --depth;
    }
    text = text.substr(0, end);
    while (text.ends_with(' ') || text.ends_with('\n')) text.remove_suffix(1);
    std::string line;  // line breaks and indentation become one space
    for (char c : text) {
        const bool is_space = c == ' ' || c == '\n' || c == '\t' || c == '\r';
        if (!is_space) line += c;
        else if (!line.empty() && line.back() != ' ') line += ' ';
    }
    return line;
}

}  // namespace gliftc::lsp
