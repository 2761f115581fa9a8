#include "sema/properties.h"

namespace gliftc::sema {

namespace {

/// What the control flow of a translation shows.
struct Flow {
    bool has_branch = false;
    bool has_counted_loop = false;
    bool has_open_loop = false;
    bool reads_structure = false;
};

void look(const ir::Program& program, ir::FunctionId id, Flow& flow);

void look(const ir::Program& program, ir::ExprId id, Flow& flow) {
    if (!id) return;
    const ir::Expr& expr = program.exprs[id];
    flow.reads_structure |= expr.op == ir::Op::read || expr.op == ir::Op::sample;
    if (expr.op == ir::Op::call) look(program, expr.function, flow);
    for (ir::ExprId operand : expr.operands) look(program, operand, flow);
}

void look(const ir::Program& program, const std::vector<ir::StmtId>& body, Flow& flow) {
    for (ir::StmtId id : body) {
        const ir::Stmt& stmt = program.stmts[id];
        look(program, stmt.value, flow);
        look(program, stmt.target, flow);
        if (stmt.op == ir::StmtOp::if_) flow.has_branch = true;
        if (stmt.op == ir::StmtOp::while_) flow.has_open_loop = true;
        if (stmt.op == ir::StmtOp::for_) {
            bool counted = ir::evaluate(program, stmt.value) && ir::evaluate(program, stmt.limit);
            (counted ? flow.has_counted_loop : flow.has_open_loop) = true;
        }
        look(program, stmt.body, flow);
        look(program, stmt.otherwise, flow);
    }
}

void look(const ir::Program& program, ir::FunctionId id, Flow& flow) {
    look(program, program.functions[id].body, flow);
}

}  // namespace

void infer_properties(Context& c, std::uint32_t index, const ast::Decl& decl) {
    Flow flow;
    look(c.program, c.program.translators[index].translate, flow);
    ir::Translator& translator = c.program.translators[index];
    ir::Properties& properties = translator.properties;
    // An early `return none` is not work that differs between addresses; an open loop is.
    properties.uniform = !flow.has_open_loop;
    properties.access_complexity = flow.has_open_loop ? "O(log n)" : "O(1)";
    properties.memory_complexity = translator.structures.empty() ? "O(1)" : "O(n)";
    properties.location = "GPU and CPU";
    if (properties.invertible) properties.mapping = ir::Mapping::claimed_one_to_one;
    for (const ast::Attribute& attribute : decl.attributes) {
        const std::string& name = c.text(attribute.name.name);
        auto text = [&]() -> std::string {
            if (attribute.arguments.size() != 1 || c[attribute.arguments[0]].kind != ast::ExprKind::string_literal) {
                c.error(Diag::attribute_argument, attribute.span, {name});
                return "";
            }
            return c.text(c[attribute.arguments[0]].name);
        };
        if (name == "many_to_one") {
            properties.mapping = ir::Mapping::many_to_one;
            if (properties.invertible)
                note(c.error(Diag::many_to_one_invertible, attribute.span, {translator.display}),
                     c.program.functions[translator.invert].span, "a translator with 'invert' is one-to-one");
        } else if (name == "one_to_one") {
            properties.mapping = ir::Mapping::claimed_one_to_one;
        } else if (name == "access") {
            std::string declared = text();
            if (!flow.has_open_loop && declared != "O(1)" && !declared.empty())
                c.error(Diag::property_contradicts, attribute.span, {"access", declared, "O(1)"});
            properties.access_complexity = declared;
        } else if (name == "memory") {
            properties.memory_complexity = text();
        } else {
            c.error(Diag::unknown_attribute, attribute.span, {name});
        }
    }
}

}  // namespace gliftc::sema
