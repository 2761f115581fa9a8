#include "ir/print.h"

#include "ir/evaluate.h"

#include <unordered_map>

namespace gliftc::ir {

namespace {

std::string_view sign_of(BinaryOp op) {
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
    }
    return "?";
}

std::string_view sign_of(UnaryOp op) {
    switch (op) {
    case UnaryOp::minus: return "-";
    case UnaryOp::logical_not: return "!";
    case UnaryOp::bit_not: return "~";
    }
    return "?";
}

std::string_view name_of(Invocation id) {
    switch (id) {
    case Invocation::local_index: return "local_index";
    case Invocation::group_index: return "group_index";
    case Invocation::group_count: return "group_count";
    case Invocation::group_size: return "group_size";
    case Invocation::subgroup_size: return "subgroup_size";
    case Invocation::subgroup_lane: return "subgroup_lane";
    case Invocation::subgroup_index: return "subgroup_index";
    case Invocation::subgroup_count: return "subgroup_count";
    }
    return "?";
}

std::string_view name_of(Builtin id) {
    switch (id) {
    case Builtin::global_id: return "$global_id";
    case Builtin::local_id: return "$local_id";
    case Builtin::group_id: return "$group_id";
    case Builtin::group_count: return "$group_count";
    case Builtin::local_index: return "$local_index";
    case Builtin::subgroup_size: return "$subgroup_size";
    case Builtin::subgroup_lane: return "$subgroup_lane";
    case Builtin::subgroup_index: return "$subgroup_index";
    case Builtin::subgroup_count: return "$subgroup_count";
    }
    return "?";
}

std::string_view name_of(Combine combine) {
    switch (combine) {
    case Combine::replace: return "replace";
    case Combine::min: return "min";
    case Combine::max: return "max";
    case Combine::add: return "add";
    case Combine::bit_and: return "and";
    case Combine::bit_or: return "or";
    case Combine::bit_xor: return "xor";
    }
    return "?";
}

class Printer {
public:
    Printer(const Program& program, const Pass* pass, const Kernel* kernel = nullptr)
        : p(program), pass_(pass), kernel_(kernel) {
        if (pass != nullptr && pass->kernel != no_kernel) kernel_ = &program.kernels[pass->kernel];
    }

    std::string expr(ExprId id);
    void body(const std::vector<StmtId>& body);
    void function(FunctionId id);
    void pass();
    void kernel();
    void line(const std::string& text) { text_ += std::string(indent_ * 4, ' ') + text + "\n"; }
    std::string take() { return std::move(text_); }

    unsigned indent_ = 0;

private:
    std::string list(const Operands& operands, std::size_t from = 0);
    std::string place(const Place& place);
    std::string local(LocalId id);
    std::string low(const Expr& node);
    std::string operand(ExprId id);
    std::string binding(std::uint32_t slot) {
        return pass_ ? pass_->bindings[slot].name : "binding" + std::to_string(slot);
    }
    void stmt(const Stmt& stmt);
    void host_stmt(const Stmt& stmt);
    std::string name(Name name) const { return (*p.names)[name]; }

    const Program& p;
    const Pass* pass_;
    const Kernel* kernel_;
    std::string text_;
    std::unordered_map<LocalId, std::string> locals_;
    std::unordered_map<std::string, unsigned> taken_;
};

std::string Printer::list(const Operands& operands, std::size_t from) {
    std::string text;
    for (std::size_t i = from; i < operands.size(); ++i) text += (i > from ? ", " : "") + expr(operands[i]);
    return text;
}

/// Locals of one name are told apart: sum, sum.2, sum.3.
std::string Printer::local(LocalId id) {
    if (!id) return "?";
    if (auto found = locals_.find(id); found != locals_.end()) return found->second;
    std::string text = name(p.locals[id].name);
    if (text.empty()) text = "unnamed";
    if (unsigned count = ++taken_[text]; count > 1) text += "." + std::to_string(count);
    return locals_[id] = text;
}

std::string Printer::place(const Place& place) {
    std::string text = kernel_ && place.root < kernel_->params.size() ? name(kernel_->params[place.root].name)
                                                                      : "@" + std::to_string(place.root);
    const Structure* structure =
        kernel_ && place.root < kernel_->params.size() ? &p.structures[kernel_->params[place.root].structure] : nullptr;
    for (std::uint32_t member : place.members) {
        text += "." + (structure ? name(structure->members[member].name) : std::to_string(member));
        if (structure) structure = &p.structures[structure->members[member].structure];
    }
    return text;
}

std::string Printer::operand(ExprId id) {
    Op op = p.exprs[id].op;
    bool compound = op == Op::binary || op == Op::unary || op == Op::select;
    return compound ? "(" + expr(id) + ")" : expr(id);
}

std::string Printer::low(const Expr& node) {
    switch (node.op) {
    case Op::parameter: return "$" + (pass_ ? pass_->parameters[node.slot].name : std::to_string(node.slot));
    case Op::load: return binding(node.slot) + "[" + list(node.operands) + "]";
    case Op::image_load: return "fetch(" + binding(node.slot) + ", " + list(node.operands) + ")";
    case Op::image_sample: return "sample(" + binding(node.slot) + ", " + list(node.operands) + ")";
    default: return std::string(name_of(node.builtin));
    }
}

std::string Printer::expr(ExprId id) {
    if (!id) return "<absent>";
    const Expr& node = p.exprs[id];
    const auto& o = node.operands;
    switch (node.op) {
    case Op::constant:
        return to_text(p, Value{node.type, {Lane{node.bits, node.number}}}) + (node.type == p.types.uint ? "u" : "");
    case Op::local: return local(node.local);
    case Op::construct:
    case Op::convert: return to_text(p, node.type) + "(" + list(o) + ")";
    case Op::unary: return std::string(sign_of(node.unary)) + operand(o[0]);
    case Op::binary: return operand(o[0]) + " " + std::string(sign_of(node.binary)) + " " + operand(o[1]);
    case Op::select: return operand(o[0]) + " ? " + operand(o[1]) + " : " + operand(o[2]);
    case Op::swizzle: {
        std::string text = operand(o[0]) + ".";
        for (std::uint32_t i = 0; i < p.types.components(node.type); ++i) text += "xyzw"[node.lanes[i]];
        return text;
    }
    case Op::index: return operand(o[0]) + "[" + expr(o[1]) + "]";
    case Op::field:
        return operand(o[0]) + "." + name(p.structs[p.types[p.exprs[o[0]].type].index].fields[node.slot].name);
    case Op::call: {
        std::string text = name(p.functions[node.function].name) + "(" + list(o);
        for (const Place& at : node.places) text += (text.back() == '(' ? "" : ", ") + place(at);
        return text + ")";
    }
    case Op::intrinsic: return std::string(name_of(node.intrinsic)) + "(" + list(o) + ")";
    case Op::none: return "none";
    case Op::some: return "some(" + expr(o[0]) + ")";
    case Op::has_value: return "has_value(" + expr(o[0]) + ")";
    case Op::value: return "value(" + expr(o[0]) + ")";
    case Op::element: return place(node.place);
    case Op::address: return place(node.place) + ".address";
    case Op::near: return place(node.place) + "[near " + list(o) + "]";
    case Op::read: return place(node.place) + "[" + list(o) + "]";
    case Op::sample: return place(node.place) + ".sample(" + list(o) + ")";
    case Op::member: return place(node.place) + ".member" + std::to_string(node.slot);
    case Op::memory_extent: return place(node.place) + ".memory" + std::to_string(node.slot) + ".extent";
    case Op::domain: return place(node.place) + ".domain";
    case Op::position: return "position";
    case Op::state: return "state" + std::to_string(node.slot);
    case Op::translate: return place(node.place) + ".translate(" + list(o) + ")";
    case Op::invocation: return std::string(name_of(node.invocation));
    case Op::host_read: return "host_read " + place(node.place) + "[" + list(o) + "]";
    case Op::device_read: return "device_read " + place(node.place) + "[" + list(o) + "]";
    case Op::await_value: return "await " + list(o);
    case Op::host_state: return place(node.place) + ".host" + std::to_string(node.slot);
    case Op::slice: return place(node.place) + "[slice " + list(o) + "]";
    case Op::structure_value: return node.local ? local(node.local) : place(node.place);
    case Op::pipeline_call: return name(p.pipelines[node.slot].name) + "(" + list(o) + ")";
    case Op::device_property: return "device.property" + std::to_string(node.slot);
    case Op::element_count: return "count(" + (node.local ? local(node.local) : place(node.place)) + ")";
    case Op::parameter:
    case Op::load:
    case Op::image_load:
    case Op::image_sample:
    case Op::builtin: return low(node);
    }
    return "?";
}

void Printer::body(const std::vector<StmtId>& body) {
    ++indent_;
    for (StmtId id : body) stmt(p.stmts[id]);
    --indent_;
}

void Printer::stmt(const Stmt& stmt) {
    switch (stmt.op) {
    case StmtOp::let: {
        const Local& of = p.locals[stmt.local];
        line((of.is_mutable ? "var " : "let ") + local(stmt.local) + ": " + to_text(p, of.type) +
             (stmt.value           ? " = " + expr(stmt.value)
              : stmt.uninitialized ? " = uninitialized"
                                   : "") +
             ";");
        break;
    }
    case StmtOp::assign: line(expr(stmt.target) + " = " + expr(stmt.value) + ";"); break;
    case StmtOp::if_:
        line("if " + expr(stmt.value) + " {");
        body(stmt.body);
        if (!stmt.otherwise.empty()) {
            line("} else {");
            body(stmt.otherwise);
        }
        line("}");
        break;
    case StmtOp::for_:
        line("for " + local(stmt.local) + " in " + expr(stmt.value) + ".." + expr(stmt.limit) + " {");
        body(stmt.body);
        line("}");
        break;
    case StmtOp::while_:
        line("while " + expr(stmt.value) + " {");
        body(stmt.body);
        line("}");
        break;
    case StmtOp::break_: line("break;"); break;
    case StmtOp::continue_: line("continue;"); break;
    case StmtOp::return_: line(stmt.value ? "return " + expr(stmt.value) + ";" : "return;"); break;
    case StmtOp::block:
        line("{");
        body(stmt.body);
        line("}");
        break;
    case StmtOp::evaluate: line(expr(stmt.value) + ";"); break;
    case StmtOp::barrier: line("barrier();"); break;
    case StmtOp::subgroup_barrier: line("subgroupBarrier();"); break;
    case StmtOp::set_element: line(place(stmt.place) + " = " + expr(stmt.value) + ";"); break;
    case StmtOp::write:
        line(place(stmt.place) + "[" + expr(stmt.target) + "] = " + expr(stmt.value) + ";" +
             (stmt.combine == Combine::replace ? "" : "  // " + std::string(name_of(stmt.combine))));
        break;
    case StmtOp::store: line(binding(stmt.slot) + "[" + expr(stmt.target) + "] = " + expr(stmt.value) + ";"); break;
    case StmtOp::image_store:
        line("store(" + binding(stmt.slot) + ", " + expr(stmt.target) + ", " + expr(stmt.value) + ");");
        break;
    case StmtOp::atomic:
        line("atomic_" + std::string(name_of(stmt.combine)) + "(" + binding(stmt.slot) + "[" + expr(stmt.target) +
             "], " + expr(stmt.value) + ");");
        break;
    case StmtOp::report:
        line("report(" + (stmt.slot == no_binding ? "view" : binding(stmt.slot)) + ", " + expr(stmt.target) + ");");
        break;
    default: host_stmt(stmt); break;
    }
}

void Printer::host_stmt(const Stmt& stmt) {
    switch (stmt.op) {
    case StmtOp::temp:
        line((stmt.uninitialized ? "uninitialized temp " : "temp ") + local(stmt.local) + " = " +
             to_text(p, p.locals[stmt.local].type) + "(" + list(stmt.arguments) + ");");
        break;
    case StmtOp::release: {
        std::string text = "release";
        for (LocalId id : stmt.locals) text += " " + local(id);
        line(text + ";");
        break;
    }
    case StmtOp::dispatch:
        line("dispatch " + name(p.kernels[stmt.slot].name) + "(" + list(stmt.arguments) + ");");
        break;
    case StmtOp::expect: line("expect(" + expr(stmt.value) + ");"); break;
    case StmtOp::expect_near: line("expect_near(" + list(stmt.arguments) + ");"); break;
    case StmtOp::expect_same: line("expect_same(" + list(stmt.arguments) + ");"); break;
    case StmtOp::host_assign: line("host " + expr(stmt.target) + " = " + expr(stmt.value) + ";"); break;
    default: break;
    }
}

void Printer::function(FunctionId id) {
    const Function& of = p.functions[id];
    std::string text = "fn " + (of.display.empty() ? name(of.name) : of.display) + "(";
    for (std::size_t i = 0; i < of.params.size(); ++i)
        text += (i ? ", " : "") + local(of.params[i]) + ": " + to_text(p, p.locals[of.params[i]].type);
    line(text + ") -> " + to_text(p, of.result) + " {");
    body(of.body);
    line("}");
}

std::string_view form_name(Form form) {
    switch (form) {
    case Form::direct: return "direct";
    case Form::general: return "general";
    case Form::wide: return "wide";
    }
    return "?";
}

std::string_view access_name(Access access) {
    switch (access) {
    case Access::read: return "read";
    case Access::write: return "write";
    case Access::read_write: return "read_write";
    }
    return "?";
}

std::string_view shape_name(MemoryShape shape) {
    switch (shape) {
    case MemoryShape::buffer: return "buffer";
    case MemoryShape::image1d: return "image1d";
    case MemoryShape::image2d: return "image2d";
    case MemoryShape::image3d: return "image3d";
    case MemoryShape::imagecube: return "imagecube";
    }
    return "?";
}

std::string source_text(const PassParameter& parameter, const std::string& value) {
    switch (parameter.source) {
    case ParameterSource::uniform: return value;
    case ParameterSource::origin: return "origin of parameter " + std::to_string(parameter.param);
    case ParameterSource::size: return "iteration size";
    case ParameterSource::range_size: return "range size of parameter " + std::to_string(parameter.param);
    case ParameterSource::address: return "address of binding " + std::to_string(parameter.param);
    }
    return "?";
}

void Printer::pass() {
    const Pass& pass = *pass_;
    line("pass " + name(kernel_->name) + " " + std::string(form_name(pass.form)) + " {");
    ++indent_;
    line("group " + std::to_string(pass.group[0]) + " " + std::to_string(pass.group[1]) + " " +
         std::to_string(pass.group[2]) + ", rank " + std::to_string(pass.rank));
    for (const PassBinding& of : pass.bindings)
        line("binding " + of.name + ": " + std::string(shape_name(of.shape)) + "<" + to_text(p, of.element) + "> " +
             std::string(access_name(of.access)) + (of.sampled ? " sampled" : "") + (of.atomic ? " atomic" : ""));
    for (const PassParameter& of : pass.parameters)
        line("parameter " + of.name + ": " + to_text(p, of.type) + " = " +
             source_text(of, of.value ? expr(of.value) : ""));
    if (pass.loop_rounds)
        line("loops " + (pass.loop_rounds == ~0ull ? std::string("unbounded") : std::to_string(pass.loop_rounds)));
    if (pass.has_status()) line("has status");
    if (!pass.exact) line("inexact");
    for (FunctionId of : pass.functions) function(of);
    line("prologue");
    body(pass.prologue);
    line("body");
    body(pass.body);
    if (!pass.pair_body.empty()) {
        line("two elements");
        body(pass.pair_body);
    }
    if (!pass.interior_body.empty()) {
        line("interior radius " + std::to_string(pass.interior_radius));
        body(pass.interior_body);
    }
    --indent_;
    line("}");
}

void Printer::kernel() {
    std::string text = "kernel " + name(kernel_->name) + "(";
    for (std::size_t i = 0; i < kernel_->params.size(); ++i) {
        const KernelParam& param = kernel_->params[i];
        bool is_value = param.pattern == Pattern::value;
        text += (i ? ", " : "") + name(param.name) + ": " +
                (is_value ? to_text(p, p.locals[param.local].type) : p.structures[param.structure].display);
    }
    line(text + ") {");
    body(kernel_->body);
    line("}");
}

}  // namespace

std::string print(const Program& program, ExprId expr, const Pass* pass) { return Printer(program, pass).expr(expr); }

std::string print(const Program& program, const std::vector<StmtId>& body, const Pass* pass) {
    Printer printer(program, pass);
    printer.body(body);
    return printer.take();
}

std::string print(const Program& program, FunctionId function, const Pass* pass) {
    Printer printer(program, pass);
    printer.function(function);
    return printer.take();
}

std::string print(const Program& program, const Pass& pass) {
    Printer printer(program, &pass);
    printer.pass();
    return printer.take();
}

std::string print(const Program& program, const Lowered& lowered) {
    std::string text;
    for (const Lowered::Forms& forms : lowered.passes)
        for (const Pass* pass : {&forms.direct, &forms.general, &forms.wide})
            if (pass->exists) text += print(program, *pass) + "\n";
    return text;
}

std::string print(const Program& program) {
    std::string text;
    for (std::uint32_t i = 0; i < program.functions.size(); ++i) text += print(program, FunctionId{i}) + "\n";
    for (const Structure& structure : program.structures) text += "structure " + structure.display + "\n";
    for (const Kernel& kernel : program.kernels) {
        Printer printer(program, nullptr, &kernel);
        printer.kernel();
        text += "\n" + printer.take();
    }
    for (const Pipeline& pipeline : program.pipelines) {
        Printer printer(program, nullptr);
        printer.line("\npipeline " + (*program.names)[pipeline.name] + " {");
        printer.body(pipeline.body);
        printer.line("}");
        text += printer.take();
    }
    return text;
}

}  // namespace gliftc::ir
