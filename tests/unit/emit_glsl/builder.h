// Builds small lowered kernels by hand, to test the printer without a front end.
#pragma once

#include "ir/pass.h"
#include "source/source.h"

#include <string>
#include <utility>
#include <vector>

namespace gliftc::test {

using namespace ir;

struct Builder {
    Names names;
    Program program;
    Sources sources;
    Pass pass;
    Span here;

    Builder() {
        program.names = &names;
        std::uint32_t file =
            sources.add("somewhere/sample.glift", "module sample;\n\nkernel sample() {\n    a line\n    another\n}\n");
        here = {file, 16, 22};
        Kernel kernel;
        kernel.name = names.intern("sample");
        kernel.display = "sample";
        kernel.span = here;
        pass.kernel = program.kernels.add(kernel);
        pass.push_constants = true;
    }

    Types& types() { return program.types; }
    Span line(std::uint32_t number) {
        std::uint32_t at = 0;
        for (std::uint32_t i = 1; i < number; ++i) at = static_cast<std::uint32_t>(sources[0].text.find('\n', at) + 1);
        return {0, at, at + 1};
    }

    ExprId add(Expr expr) { return program.exprs.add(std::move(expr)); }
    ExprId make(Op op, TypeId type, Operands operands = {}) {
        Expr expr;
        expr.op = op;
        expr.type = type;
        expr.operands = std::move(operands);
        return add(std::move(expr));
    }
    ExprId with(Op op, TypeId type, Operands operands, std::uint32_t slot) {
        ExprId id = make(op, type, std::move(operands));
        program.exprs[id].slot = slot;
        return id;
    }
    TypeId type_of(ExprId id) { return program.exprs[id].type; }

    ExprId constant(TypeId type, std::uint64_t bits) {
        ExprId id = make(Op::constant, type);
        program.exprs[id].bits = bits;
        return id;
    }
    ExprId u(std::uint64_t value) { return constant(types().uint, value); }
    ExprId i(std::int64_t value) { return constant(types().int_, static_cast<std::uint64_t>(value)); }
    ExprId f(double value) {
        ExprId id = make(Op::constant, types().float_);
        program.exprs[id].number = value;
        return id;
    }
    ExprId binary(BinaryOp op, ExprId a, ExprId b) {
        TypeId type = types().components(type_of(b)) > types().components(type_of(a)) ? type_of(b) : type_of(a);
        if (op >= BinaryOp::less && op <= BinaryOp::not_equal) type = types().bool_;
        ExprId id = make(Op::binary, type, {a, b});
        program.exprs[id].binary = op;
        return id;
    }
    ExprId plus(ExprId a, ExprId b) { return binary(BinaryOp::add, a, b); }
    ExprId minus(ExprId a, ExprId b) { return binary(BinaryOp::subtract, a, b); }
    ExprId times(ExprId a, ExprId b) { return binary(BinaryOp::multiply, a, b); }
    ExprId less(ExprId a, ExprId b) { return binary(BinaryOp::less, a, b); }
    ExprId unary(UnaryOp op, ExprId a) {
        ExprId id = make(Op::unary, type_of(a), {a});
        program.exprs[id].unary = op;
        return id;
    }
    ExprId intrinsic(Intrinsic which, TypeId type, Operands operands) {
        ExprId id = make(Op::intrinsic, type, std::move(operands));
        program.exprs[id].intrinsic = which;
        return id;
    }
    ExprId lanes(ExprId a, std::vector<std::uint8_t> which) {
        ExprId id = make(Op::swizzle,
                         types().vector(types().scalar_of(type_of(a)), static_cast<std::uint32_t>(which.size())), {a});
        for (std::size_t n = 0; n < which.size(); ++n) program.exprs[id].lanes[n] = which[n];
        return id;
    }

    LocalId local(const std::string& name, TypeId type, bool is_mutable = true) {
        Local local;
        local.name = names.intern(name);
        local.type = type;
        local.is_mutable = is_mutable;
        return program.locals.add(local);
    }
    ExprId use(LocalId id) {
        ExprId expr = make(Op::local, program.locals[id].type);
        program.exprs[expr].local = id;
        return expr;
    }

    StmtId add(Stmt stmt) { return program.stmts.add(std::move(stmt)); }
    Stmt statement(StmtOp op) {
        Stmt stmt;
        stmt.op = op;
        stmt.span = here;
        return stmt;
    }
    StmtId let(LocalId local, ExprId value = {}) {
        Stmt stmt = statement(StmtOp::let);
        stmt.local = local;
        stmt.value = value;
        return add(stmt);
    }
    StmtId assign(ExprId target, ExprId value) {
        Stmt stmt = statement(StmtOp::assign);
        stmt.target = target;
        stmt.value = value;
        return add(stmt);
    }
    StmtId store(std::uint32_t binding, ExprId at, ExprId value, StmtOp op = StmtOp::store) {
        Stmt stmt = statement(op);
        stmt.slot = binding;
        stmt.target = at;
        stmt.value = value;
        return add(stmt);
    }
    StmtId branch(ExprId condition, std::vector<StmtId> body, std::vector<StmtId> otherwise = {}) {
        Stmt stmt = statement(StmtOp::if_);
        stmt.value = condition;
        stmt.body = std::move(body);
        stmt.otherwise = std::move(otherwise);
        return add(stmt);
    }
    StmtId loop(LocalId variable, ExprId low, ExprId high, std::vector<StmtId> body) {
        Stmt stmt = statement(StmtOp::for_);
        stmt.local = variable;
        stmt.value = low;
        stmt.limit = high;
        stmt.body = std::move(body);
        return add(stmt);
    }

    std::uint32_t buffer(const std::string& name, TypeId element, Access access) {
        PassBinding binding;
        binding.name = name;
        binding.element = element;
        binding.access = access;
        binding.one_place = static_cast<std::uint32_t>(pass.bindings.size());
        pass.bindings.push_back(binding);
        return static_cast<std::uint32_t>(pass.bindings.size() - 1);
    }
    std::uint32_t image(const std::string& name, MemoryShape shape, TypeId element, Format format, Access access) {
        std::uint32_t index = buffer(name, element, access);
        pass.bindings[index].shape = shape;
        pass.bindings[index].format = format;
        return index;
    }
    ExprId parameter(const std::string& name, TypeId type, ParameterSource source = ParameterSource::uniform) {
        PassParameter parameter;
        parameter.name = name;
        parameter.type = type;
        parameter.source = source;
        pass.parameters.push_back(parameter);
        return with(Op::parameter, type, {}, static_cast<std::uint32_t>(pass.parameters.size() - 1));
    }
    /// A uniform parameter whose value is the extent of the first kernel parameter's structure.
    ExprId extent_parameter(const std::string& name, TypeId type) {
        ExprId id = parameter(name, type);
        pass.parameters.back().value = make(Op::domain, type);
        return id;
    }
    ExprId load(std::uint32_t binding, ExprId at) {
        return with(Op::load, pass.bindings[binding].element, {at}, binding);
    }

    /// Sets up a one-dimensional kernel: address = gl_GlobalInvocationID.x, in_range = address < size. Returns the
    /// address.
    ExprId one_axis() {
        ExprId size = parameter("size", types().uint, ParameterSource::size);
        ExprId global = make(Op::builtin, types().vector(types().uint, 3));
        program.exprs[global].builtin = Builtin::global_id;
        pass.address = local("address", types().uint, false);
        pass.in_range = local("in_range", types().bool_, false);
        Span kept = std::exchange(here, Span{});
        pass.prologue = {let(pass.address, lanes(global, {0})), let(pass.in_range, less(use(pass.address), size))};
        here = kept;
        return use(pass.address);
    }
};

}  // namespace gliftc::test
