#include "sema/pipelines/values.h"

#include "ir/effects.h"
#include "ir/print.h"
#include "ir/walk.h"
#include "sema/bodies/order.h"
#include "sema/structures/components.h"
#include "sema/types/instances.h"
#include "sema/types/typing.h"

#include <algorithm>
#include <map>

namespace gliftc::sema {

namespace {

/// Computes an expression on the device: makes a kernel of one invocation for it, and the pipeline that runs the
/// kernel. The expression is open (sema/pipelines/values.h), or known to the host.
class Maker {
public:
    Maker(Body& body, Span span) : body_(body), c_(body.context), p_(body.program()), span_(span) {
        kernel_.name = c_.names.intern("value");
        kernel_.display = "value";
        kernel_.span = span;
        kernel_.module = body.env.module;
        kernel_.domain_type = p_.types.uint;
    }

    ir::ExprId call(ir::ExprId expr, ir::StructureId box);

private:
    void add_param(ir::KernelParam param);
    ir::LocalId passed(ir::Pattern pattern, std::string_view name, ir::TypeId type, ir::ExprId argument);
    ir::ExprId argument(ir::ExprId leaf);
    ir::ExprId rewritten(ir::ExprId id);
    std::string key_for(ir::ExprId value) const;
    bool is_known(ir::ExprId id) const;

    Body& body_;
    Context& c_;
    ir::Program& p_;
    Span span_;
    ir::Kernel kernel_;
    ir::Operands arguments_;
    std::map<ir::LocalId, ir::LocalId> known_;  ///< the kernel's parameter for each local that lies on the device
};

void Maker::add_param(ir::KernelParam param) {
    param.span = span_;
    param.alike = static_cast<std::uint32_t>(kernel_.params.size());
    kernel_.params.push_back(std::move(param));
}

ir::LocalId Maker::passed(ir::Pattern pattern, std::string_view name, ir::TypeId type, ir::ExprId argument) {
    std::string unique(name);
    const auto is_taken = [&] {
        return std::ranges::any_of(kernel_.params,
                                   [&](const ir::KernelParam& other) { return c_.text(other.name) == unique; });
    };
    for (unsigned i = 2; is_taken(); ++i) unique = std::string(name) + "_" + std::to_string(i);
    ir::KernelParam param;
    param.name = c_.names.intern(unique);
    param.pattern = pattern;
    param.local = add_local(p_, param.name, type, span_);
    if (pattern == ir::Pattern::argument) param.structure = box_of(c_, 1, type, span_);
    const ir::LocalId local = param.local;
    add_param(std::move(param));
    arguments_.push_back(argument);
    return local;
}

std::string_view name_of(const Body& body, const ir::Expr& expr) {
    if (expr.op == ir::Op::local) return body.context.text(body.context.program.locals[expr.local].name);
    return expr.op == ir::Op::device_read ? "element" : "found";
}

ir::ExprId Maker::argument(ir::ExprId leaf) {
    const ir::Expr source = p_.exprs[p_.exprs[leaf].operands[0]];
    const ir::TypeId type = p_.exprs[leaf].type;
    if (source.op != ir::Op::local) {
        const ir::ExprId whole = p_.exprs[leaf].operands[0];
        return make_local(p_, passed(ir::Pattern::argument, name_of(body_, source), type, whole), span_);
    }
    ir::LocalId& local = known_[source.local];
    if (!local) local = passed(ir::Pattern::argument, name_of(body_, source), type, p_.exprs[leaf].operands[0]);
    return make_local(p_, local, span_);
}

bool Maker::is_known(ir::ExprId id) const {
    const ir::Expr& expr = p_.exprs[id];
    return expr.op == ir::Op::constant || expr.op == ir::Op::none ||
           (expr.op == ir::Op::construct &&
            std::ranges::all_of(expr.operands, [&](ir::ExprId part) { return is_known(part); }));
}

/// The expression for the kernel's body. Leaves that lie on the device, and the largest parts that the host can
/// evaluate, become parameters; constants stay.
ir::ExprId Maker::rewritten(ir::ExprId id) {
    if (p_.exprs[id].op == ir::Op::device_value) return argument(id);
    if (is_known(id)) return id;
    if (!is_open(body_, id)) {
        const ir::Expr expr = p_.exprs[id];
        return make_local(
            p_, passed(ir::Pattern::value, expr.op == ir::Op::local ? name_of(body_, expr) : "host", expr.type, id),
            span_);
    }
    ir::Expr copy = p_.exprs[id];
    for (ir::ExprId& operand : copy.operands) operand = rewritten(operand);
    return p_.exprs.add(std::move(copy));
}

/// The kernel's key (ir::Kernel::key): the declaration of the pipeline, and all that the kernel's code depends on.
/// Equal expressions of a pipeline share a kernel, also those of the instances of a generic pipeline.
std::string Maker::key_for(ir::ExprId value) const {
    std::string key = body_.key + "<" + ir::print(p_, value);
    for (const ir::KernelParam& param : kernel_.params)
        key += ", " + c_.text(param.name) + (param.pattern == ir::Pattern::value ? "" : " on the device");
    ir::for_each_node(p_, value, [&](ir::ExprId node) {
        const ir::Expr& expr = p_.exprs[node];
        if (expr.op == ir::Op::constant && p_.types.kind(expr.type) != ir::TypeKind::enum_) return;  // print() says it
        key += ", " + ir::to_qualified_text(p_, expr.type);
        if (expr.op == ir::Op::call) key += " of " + p_.functions[expr.function].key;
    });
    return key + ">";
}

ir::ExprId Maker::call(ir::ExprId expr, ir::StructureId box) {
    const ir::TypeId type = p_.exprs[expr].type;
    const ir::StmtId set = add(p_, ir::StmtOp::set_element, span_);
    const ir::ExprId value = rewritten(expr);
    p_.stmts[set].value = value;
    p_.stmts[set].place.root = static_cast<std::uint32_t>(kernel_.params.size());
    kernel_.body.push_back(set);
    kernel_.key = key_for(value);
    add_param({.name = c_.names.intern("result"),
               .pattern = ir::Pattern::each,
               .direction = ir::Direction::out,
               .structure = box});
    ir::Pipeline pipeline;
    pipeline.name = kernel_.name;
    pipeline.display = kernel_.display;
    pipeline.key = kernel_.key;
    pipeline.span = span_;
    pipeline.module = kernel_.module;
    pipeline.is_value = true;
    ir::Operands passed_on;
    for (const ir::KernelParam& param : kernel_.params) {
        if (ir::is_structure(param)) continue;
        const ir::TypeId of = p_.locals[param.local].type;
        const ir::LocalId local =
            add_local(p_, param.name, param.pattern == ir::Pattern::argument ? c_.types().device(of) : of, span_);
        pipeline.params.push_back({.name = param.name, .span = span_, .local = local});
        passed_on.push_back(make_local(p_, local, span_));
    }
    Instance& known = c_.instances["value " + kernel_.key];
    if (known.state != Instance::State::done) {
        known.index = pipeline_of_kernel(c_, std::move(kernel_), std::move(pipeline), std::move(passed_on), box).index;
        known.state = Instance::State::done;
    }
    const ir::ExprId call = add(p_, ir::Op::pipeline_call, c_.types().device(type), span_, std::move(arguments_));
    p_.exprs[call].slot = known.index;
    return call;
}

}  // namespace

Operand check_part(Body& body, ast::ExprId id) {
    const Parts parts(body);
    return check(body, id);
}

bool is_on_device(const Body& body, ir::ExprId id) {
    return body.context.program.types.kind(body.context.program.exprs[id].type) == ir::TypeKind::device;
}

bool is_open(const Body& body, ir::ExprId id) {
    bool found = false;
    ir::for_each_node(body.context.program, id, [&](ir::ExprId node) {
        found = found || body.context.program.exprs[node].op == ir::Op::device_value;
    });
    return found;
}

ir::ExprId opened(Body& body, ir::ExprId id) {
    if (!is_on_device(body, id)) return id;
    const ir::Expr source = body.program().exprs[id];
    if (source.op != ir::Op::local && source.op != ir::Op::device_read)
        id = make_local(body.program(), emit_temporary(body, "found", id, source.span), source.span);
    if (source.op == ir::Op::device_read) body.program().exprs[id].slot = 1;
    const ir::TypeId type = body.types()[source.type].element;
    return add(body.program(), ir::Op::device_value, type, source.span, {id});
}

Operand opened(Body& body, Operand operand) {
    if (operand.kind != OperandKind::value || !is_on_device(body, operand.expr)) return operand;
    return value_operand(body, opened(body, operand.expr), operand.span);
}

ir::ExprId on_device(Body& body, ir::ExprId id) {
    const ir::TypeId type = body.program().exprs[id].type;
    const Span span = body.program().exprs[id].span;
    if (type == body.types().error || type == body.types().void_) return id;
    const ir::TypeKind kind = body.types().kind(type);
    if (kind == ir::TypeKind::slice || kind == ir::TypeKind::structure) {
        note(body.context.error(Diag::device_value_type, span, {body.context.text(type)}), span,
             "the host chooses structures and their parts: 'await' the condition");
        return error_value(body, span);
    }
    if (!memory_holds(body.program(), type)) {
        note(body.context.error(Diag::device_value_type, span, {body.context.text(type)}), span,
             "memory holds neither optionals nor structs without fields: keep a value and a bool instead");
        return error_value(body, span);
    }
    const auto box = box_of(body.context, 1, type, span);
    if (!box) return error_value(body, span);
    require_transfers(body.context, box, span);
    const ir::ExprId value = Maker(body, span).call(id, box);
    add_read(body, value);
    return value;
}

ir::ExprId closed(Body& body, ir::ExprId id) {
    if (!is_open(body, id)) return id;
    const ir::Expr expr = body.program().exprs[id];
    if (expr.op != ir::Op::device_value) return on_device(body, id);
    if (body.program().exprs[expr.operands[0]].op == ir::Op::device_read)
        body.program().exprs[expr.operands[0]].slot = 0;
    return expr.operands[0];
}

Operand closed(Body& body, Operand operand) {
    if (operand.kind != OperandKind::value || !is_open(body, operand.expr)) return operand;
    return value_operand(body, closed(body, operand.expr), operand.span);
}

void make_argument(Context& c, ir::Kernel& kernel, std::size_t index, Span use) {
    ir::KernelParam& param = kernel.params[index];
    param.pattern = ir::Pattern::argument;
    param.structure = box_of(c, 1, c.program.locals[param.local].type, use);
    kernel.key += "<device " + c.text(param.name) + ">";
    kernel.is_pub = false;
}

ir::KernelId kernel_with_arguments(Context& c, ir::KernelId index, const std::vector<bool>& on_device, Span use) {
    ir::Kernel kernel = c.program.kernels[index];
    for (std::size_t i = 0; i < kernel.params.size(); ++i)
        if (on_device[i]) make_argument(c, kernel, i, use);
    Instance& instance = c.instances["kernel " + kernel.key];
    if (instance.state == Instance::State::done) return {instance.index};
    instance.state = Instance::State::done;
    const ir::KernelId made = c.program.kernels.add(std::move(kernel));
    instance.index = made.index;
    return made;
}

}  // namespace gliftc::sema
