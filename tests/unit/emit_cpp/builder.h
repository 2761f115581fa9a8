// Builds lowered programs by hand, to test the printers without a front end.
#pragma once

#include "ir/pass.h"
#include "source/source.h"

#include <string>

namespace gliftc::test {

struct Builder {
    Names names;
    Sources sources;
    ir::Program program;

    Builder() {
        program.names = &names;
        sources.add(
            "dir/heat.glift",
            "module heat;\n\n// kernel\nkernel heat(f: in near<Field, 1>, g: out each<Field>) {\n    g = f[0];\n}\n");
        program.modules.push_back({.name = names.intern("heat"), .file = 0, .is_root = true, .doc = ""});
    }

    Span line(std::uint32_t number) const {
        const std::uint32_t begin = sources[0].line_starts[number - 1];
        return {0, begin, begin + 1};
    }
    ir::Types& types() { return program.types; }
    ir::TypeId uint_vector(std::uint32_t n) { return types().vector(types().uint, n); }

    ir::ExprId add(ir::Expr expr) { return program.exprs.add(std::move(expr)); }
    ir::ExprId constant(std::uint32_t bits) {
        return add({.op = ir::Op::constant, .type = types().uint, .bits = bits});
    }
    ir::ExprId number(double value) { return add({.op = ir::Op::constant, .type = types().float_, .number = value}); }
    ir::ExprId local(ir::LocalId id) {
        return add({.op = ir::Op::local, .type = program.locals[id].type, .local = id});
    }
    ir::ExprId binary(ir::BinaryOp op, ir::ExprId a, ir::ExprId b) {
        return add({.op = ir::Op::binary, .binary = op, .type = program.exprs[a].type, .operands = {a, b}});
    }
    ir::ExprId compare(ir::BinaryOp op, ir::ExprId a, ir::ExprId b) {
        return add({.op = ir::Op::binary, .binary = op, .type = types().bool_, .operands = {a, b}});
    }
    ir::ExprId plus(ir::ExprId a, ir::ExprId b) { return binary(ir::BinaryOp::add, a, b); }
    ir::ExprId minus(ir::ExprId a, ir::ExprId b) { return binary(ir::BinaryOp::subtract, a, b); }
    ir::ExprId times(ir::ExprId a, ir::ExprId b) { return binary(ir::BinaryOp::multiply, a, b); }
    ir::ExprId lane(ir::ExprId vector, std::uint8_t i) {
        return add({.op = ir::Op::swizzle,
                    .lanes = {i},
                    .type = types().scalar_of(program.exprs[vector].type),
                    .operands = {vector}});
    }
    ir::ExprId select(ir::ExprId c, ir::ExprId a, ir::ExprId b) {
        return add({.op = ir::Op::select, .type = program.exprs[a].type, .operands = {c, a, b}});
    }
    ir::ExprId parameter(std::uint32_t slot, ir::TypeId type) {
        return add({.op = ir::Op::parameter, .type = type, .slot = slot});
    }
    ir::ExprId load(std::uint32_t slot, ir::TypeId type, ir::ExprId index, ir::Op op = ir::Op::load) {
        return add({.op = op, .type = type, .slot = slot, .operands = {index}});
    }

    ir::LocalId declare(const char* name, ir::TypeId type, bool is_mutable = false) {
        return program.locals.add({.name = names.intern(name), .type = type, .span = {}, .is_mutable = is_mutable});
    }
    ir::StmtId add(ir::Stmt stmt) { return program.stmts.add(std::move(stmt)); }
    ir::StmtId let(ir::LocalId id, ir::ExprId value, Span span = {}) {
        return add(ir::Stmt{.op = ir::StmtOp::let, .span = span, .local = id, .value = value});
    }
    ir::StmtId assign(ir::ExprId target, ir::ExprId value, Span span = {}) {
        return add(ir::Stmt{.op = ir::StmtOp::assign, .span = span, .target = target, .value = value});
    }
    ir::StmtId row_store(std::uint32_t slot, ir::ExprId index, ir::ExprId value, Span span = {}) {
        return add(ir::Stmt{.op = ir::StmtOp::row_store, .span = span, .target = index, .value = value, .slot = slot});
    }
};

/// A 3-D diffusion step over dense buffers: g = f + k * (sum of the six neighbours - 6 f); reads outside give zero. Its
/// second variant is for the interior, without bounds checks.
inline ir::Pass heat_pass(Builder& b) {
    using ir::BinaryOp;
    const ir::TypeId f32 = b.types().float_, u3 = b.uint_vector(3);
    ir::Pass pass;
    pass.kernel = b.program.kernels.add(
        {.name = b.names.intern("heat"), .display = "heat", .span = b.line(4), .module = {0}, .domain_type = u3});
    pass.rank = 3;
    pass.bindings = {{.name = "f_data", .element = f32, .access = ir::Access::read},
                     {.name = "g_data", .element = f32, .access = ir::Access::write}};
    pass.parameters = {{.name = "f_extent", .type = u3, .offset = 0}, {.name = "k", .type = f32, .offset = 12}};
    pass.parameter_bytes = 16;
    pass.address = b.declare("address", u3);
    const ir::ExprId a = b.local(pass.address), extent = b.parameter(0, u3);
    const auto body = [&](bool guarded) {
        const ir::LocalId index = b.declare("f_index", b.types().uint), sum = b.declare("sum", f32, true);
        std::vector<ir::StmtId> body;
        body.push_back(
            b.let(index,
                  b.plus(b.times(b.plus(b.times(b.lane(a, 2), b.lane(extent, 1)), b.lane(a, 1)), b.lane(extent, 0)),
                         b.lane(a, 0)),
                  b.line(5)));
        body.push_back(b.let(sum, b.times(b.number(-6), b.load(0, f32, b.local(index), ir::Op::row_load)), b.line(5)));
        for (std::uint8_t axis = 0; axis < 3; ++axis) {
            ir::ExprId stride = axis == 0 ? b.constant(1) : b.lane(extent, 0);
            if (axis == 2) stride = b.times(stride, b.lane(extent, 1));
            for (bool up : {true, false}) {
                ir::ExprId at = up ? b.plus(b.local(index), stride) : b.minus(b.local(index), stride);
                ir::ExprId value = b.load(0, f32, at, guarded ? ir::Op::load : ir::Op::row_load);
                ir::ExprId inside =
                    up ? b.compare(BinaryOp::less, b.plus(b.lane(a, axis), b.constant(1)), b.lane(extent, axis))
                       : b.compare(BinaryOp::greater, b.lane(a, axis), b.constant(0));
                if (guarded) value = b.select(inside, value, b.number(0));
                body.push_back(b.assign(b.local(sum), b.plus(b.local(sum), value), b.line(5)));
            }
        }
        body.push_back(b.row_store(
            1, b.local(index),
            b.plus(b.load(0, f32, b.local(index), ir::Op::row_load), b.times(b.parameter(1, f32), b.local(sum))),
            b.line(5)));
        return body;
    };
    pass.variants = {{.devices = ir::Devices::host, .body = body(true)}};
    pass.variants.push_back(
        {ir::Part::whole, ir::Devices::host, {.interior = ir::Interior{.radius = 1, .domain = 0}}, body(false)});
    return pass;
}

}  // namespace gliftc::test
