// Statements and built-in functions of the vertex and fragment parts of a draw: assignments to targets, `discard`,
// `place`, `clip_distance`, `window`, `front_facing`, `position`.
#include "sema/kernels/raster.h"
#include "sema/types/typing.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

constexpr std::size_t most_clip_distances = 8;

const char* word_of(ir::Part part) { return part == ir::Part::vertex ? "vertex" : "fragment"; }

Operand nothing(Body& body, Span span) {
    return value_operand(body, add(body.program(), ir::Op::constant, body.types().void_, span), span);
}

void emit_assign(Body& body, ir::LocalId local, ir::ExprId value, Span span) {
    const ir::StmtId id = add(body.program(), ir::StmtOp::assign, span);
    body.program().stmts[id].target = make_local(body.program(), local, span);
    body.program().stmts[id].value = value;
    emit(body, id);
}

/// The argument of a call of place or clip_distance, which take exactly one.
ir::ExprId only_argument(Body& body, std::string_view name, const ast::Expr& call, ir::TypeId type) {
    if (call.operands.size() == 2) return check_value(body, call.operands[1], type);
    body.context.error(Diag::argument_count, call.span, {name, "1", std::to_string(call.operands.size() - 1)});
    return error_value(body, call.span);
}

Operand place_corner(Body& body, const ast::Expr& call) {
    const ir::LocalId place = body.kernel->raster->place;
    const ir::ExprId value = only_argument(body, "place", call, body.program().locals[place].type);
    if (!is_error(body, value)) emit_assign(body, place, value, call.span);
    return nothing(body, call.span);
}

Operand clip(Body& body, const ast::Expr& call) {
    std::vector<ir::LocalId>& distances = body.kernel->raster->clip_distances;
    const ir::ExprId value = only_argument(body, "clip_distance", call, body.types().float_);
    if (distances.size() == most_clip_distances)
        body.context.error(Diag::clip_distances, call.span, {std::to_string(most_clip_distances)});
    if (is_error(body, value)) return error_operand(call.span);
    distances.push_back(
        add_local(body.program(), body.context.names.intern("clip_distance"), body.types().float_, call.span, true));
    emit_assign(body, distances.back(), value, call.span);
    return nothing(body, call.span);
}

/// A built-in value without arguments that the rasteriser computes for each fragment.
Operand given(Body& body, std::string_view name, const ast::Expr& call, ir::Op op, ir::TypeId type) {
    if (call.operands.size() != 1)
        body.context.error(Diag::argument_count, call.span, {name, "0", std::to_string(call.operands.size() - 1)});
    return value_operand(body, add(body.program(), op, type, call.span), call.span);
}

}  // namespace

ir::Part part_of(ir::Pattern pattern) {
    switch (pattern) {
    case ir::Pattern::each:
    case ir::Pattern::instance: return ir::Part::vertex;
    case ir::Pattern::at:
    case ir::Pattern::target: return ir::Part::fragment;
    case ir::Pattern::value:
    case ir::Pattern::argument:
    case ir::Pattern::near:
    case ir::Pattern::any:
    case ir::Pattern::scatter:
    case ir::Pattern::coherent:
    case ir::Pattern::calls: return ir::Part::whole;
    }
    return ir::Part::whole;
}

bool is_in_part(Body& body, ir::Part wanted, std::string_view name, Span span) {
    if (wanted == ir::Part::whole || body.part == wanted) return true;
    note(body.context.error(Diag::only_in_part, span, {name, word_of(wanted)}), span,
         body.part != ir::Part::whole ? wanted == ir::Part::vertex
                                            ? "hand a value on: 'smooth name: type;', assigned in the vertex part"
                                            : "it is a matter of pixels"
                                      : "functions that the part calls take values: pass what they need");
    return false;
}

void assign_target(Body& body, const ast::Stmt& stmt, const Symbol& symbol, ast::ExprId root) {
    Context& c = body.context;
    const ir::KernelParam& param = body.kernel->params[symbol.slot];
    const std::string& name = c.text(param.name);
    if (!is_in_part(body, ir::Part::fragment, name, c[stmt.target].span)) return;
    const ir::LocalId local = target_value(*body.kernel, symbol.slot);
    if (!local) return;  // the parameter has an error, which was reported
    if (stmt.op || root != stmt.target) {
        note(c.error(Diag::target_read, stmt.span, {name}), param.span,
             "make the value in a local, then assign it: the whole target is written at once");
        return;
    }
    auto& depth = body.kernel->raster->depth;
    if (depth && depth->param == symbol.slot) {
        if (!depth->is_written) {
            note(c.error(Diag::in_written, c[stmt.target].span, {name}), param.span,
                 "declared 'in': it is tested, not written");
            return;
        }
        depth->is_set = true;
    }
    const ir::ExprId value = check_value(body, stmt.value, body.program().locals[local].type);
    if (!is_error(body, value)) emit_assign(body, local, value, stmt.span);
}

void check_discard(Body& body, const ast::Stmt& stmt) {
    if (is_in_part(body, ir::Part::fragment, "discard", stmt.span))
        emit(body, add(body.program(), ir::StmtOp::discard, stmt.span));
}

std::optional<Operand> call_in_raster(Body& body, std::string_view name, const ast::Expr& call) {
    ir::Types& types = body.types();
    const bool of_vertex = name == "place" || name == "clip_distance";
    const bool of_fragment = name == "window" || name == "front_facing";
    if (!of_vertex && !of_fragment && !(name == "position" && body.part != ir::Part::whole)) return std::nullopt;
    const ir::Part wanted = of_vertex ? ir::Part::vertex : ir::Part::fragment;
    if (!is_in_part(body, wanted, name, call.span)) return error_operand(call.span);
    if (name == "place") return place_corner(body, call);
    if (name == "clip_distance") return clip(body, call);
    if (name == "window") return given(body, name, call, ir::Op::window, types.vector(types.float_, 4));
    if (name == "front_facing") return given(body, name, call, ir::Op::front_facing, types.bool_);
    return given(body, name, call, ir::Op::position, body.kernel->domain_type);
}

}  // namespace gliftc::sema
