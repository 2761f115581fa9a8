#include "sema/structures/properties.h"

#include "ir/chain.h"

#include <set>

namespace gliftc::sema {

namespace {

constexpr const char *constant = "O(1)", *not_known = "not known";

/// Properties of the control flow of `translate`, or of a view's `at`, and of the functions that it calls.
struct Flow {
    bool has_branch = false;     ///< an `if` other than `if … { return none; }`, on a condition that is not constant
    bool has_open_loop = false;  ///< a `while`, or a `for` whose bounds are not constant
};

/// Whether the body is empty, or only `return none;`: an early exit.
bool only_gives_up(const ir::Program& program, const std::vector<ir::StmtId>& body) {
    if (body.empty()) return true;
    const ir::Stmt& stmt = program.stmts[body[0]];
    return body.size() == 1 && stmt.op == ir::StmtOp::return_ && stmt.value &&
           program.exprs[stmt.value].op == ir::Op::none;
}

void look(const ir::Program& program, ir::FunctionId id, Flow& flow);

void look(const ir::Program& program, ir::ExprId id, Flow& flow) {
    if (!id) return;
    const ir::Expr& expr = program.exprs[id];
    if (expr.op == ir::Op::call) look(program, expr.function, flow);
    for (ir::ExprId operand : expr.operands) look(program, operand, flow);
}

void look(const ir::Program& program, const std::vector<ir::StmtId>& body, Flow& flow) {
    for (ir::StmtId id : body) {
        const ir::Stmt& stmt = program.stmts[id];
        look(program, stmt.value, flow);
        look(program, stmt.target, flow);
        if (stmt.op == ir::StmtOp::if_ && !ir::evaluate(program, stmt.value))
            flow.has_branch |= !only_gives_up(program, stmt.body) || !only_gives_up(program, stmt.otherwise);
        if (stmt.op == ir::StmtOp::while_) flow.has_open_loop = true;
        if (stmt.op == ir::StmtOp::for_) {
            flow.has_open_loop |= !ir::evaluate(program, stmt.value) || !ir::evaluate(program, stmt.limit);
        }
        look(program, stmt.body, flow);
        look(program, stmt.otherwise, flow);
    }
}

void look(const ir::Program& program, ir::FunctionId id, Flow& flow) {
    look(program, program.functions[id].body, flow);
}

/// A structure that the translator reads is read through its own translators, through those of the structures that are
/// its memory and, if the last of these is a view, through the view's `at`: weakens `uniform` and the complexity of
/// access where one of these has weaker properties. All members of the view count as read by `at`.
void add_table(const ir::Program& program, ir::StructureId table, ir::Properties& properties,
               std::set<ir::StructureId>& seen) {
    if (!seen.insert(table).second) return;
    const ir::Structure* link = &program.structures[table];
    while (true) {
        for (const ir::Stage& stage : link->via) {
            const ir::Properties& each = program.translators[stage.translator].properties;
            properties.uniform &= each.uniform;
            if (each.access_complexity != constant) properties.access_complexity = not_known;
        }
        if (link->base.empty()) break;
        link = &ir::structure_at(program, *link, link->base);
    }
    if (link->kind != ir::StructureKind::computed || !link->at) return;
    Flow flow;
    look(program, link->at, flow);
    properties.uniform &= !flow.has_open_loop && !flow.has_branch;
    if (flow.has_open_loop) properties.access_complexity = not_known;
    for (const ir::MemberStructure& member : link->members) add_table(program, member.structure, properties, seen);
}

/// Sets Properties::mapping from the attributes of a translator and from `invert`; reports attributes that contradict
/// each other or `invert`.
void declare_mapping(Context& c, ir::Translator& translator, const std::vector<ast::Attribute>& attributes) {
    const auto find = [&](std::string_view name) {
        const auto has_name = [&](const ast::Attribute& each) { return c.text(each.name.name) == name; };
        const auto found = std::ranges::find_if(attributes, has_name);
        return found == attributes.end() ? nullptr : &*found;
    };
    const ast::Attribute* const one = find("one_to_one");
    const ast::Attribute* const many = find("many_to_one");
    ir::Mapping& mapping = translator.properties.mapping;
    if (one || translator.properties.invertible) mapping = ir::Mapping::claimed_one_to_one;
    if (!many) return;
    mapping = ir::Mapping::many_to_one;
    if (translator.properties.invertible)
        note(c.error(Diag::many_to_one_invertible, many->span, {translator.display}),
             c.program.functions[translator.invert].span, "a translator with 'invert' is one-to-one");
    else if (one)
        note(c.error(Diag::mapping_contradicts, many->span, {translator.display}), one->span,
             "declared one-to-one here");
}

}  // namespace

void infer_properties(Context& c, ir::TranslatorId index, const ast::Decl& decl) {
    Flow flow;
    look(c.program, c.program.translators[index].translate, flow);
    ir::Translator& translator = c.program.translators[index];
    ir::Properties& properties = translator.properties;
    properties.uniform = !flow.has_open_loop && !flow.has_branch;
    properties.access_complexity = flow.has_open_loop ? not_known : constant;
    properties.memory_complexity = translator.structures.empty() ? constant : not_known;
    std::set<ir::StructureId> seen;
    for (ir::StructureId table : translator.structures) add_table(c.program, table, properties, seen);
    const auto declared = [&](const std::string& what, std::string& property, const std::string& text, Span span) {
        if (property == constant && text != constant && !text.empty())
            c.error(Diag::property_contradicts, span, {what, text, constant});
        property = text;
    };
    properties.location = "GPU and CPU";
    declare_mapping(c, translator, decl.attributes);
    for (const ast::Attribute& attribute : decl.attributes) {
        const std::string& name = c.text(attribute.name.name);
        auto text = [&]() -> std::string {
            if (attribute.arguments.size() != 1 || c[attribute.arguments[0]].kind != ast::ExprKind::string_literal) {
                c.error(Diag::attribute_argument, attribute.span, {name});
                return "";
            }
            return c.text(c[attribute.arguments[0]].name);
        };
        if (name == "many_to_one" || name == "one_to_one") continue;
        if (name == "access") {
            declared(name, properties.access_complexity, text(), attribute.span);
        } else if (name == "memory") {
            declared(name, properties.memory_complexity, text(), attribute.span);
        } else {
            c.error(Diag::unknown_attribute, attribute.span, {name});
        }
    }
}

}  // namespace gliftc::sema
