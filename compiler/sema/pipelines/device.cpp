// `device.subgroup_size` and the like: properties of the device that a pipeline runs on.
#include "sema/bodies/body.h"

#include <array>

namespace gliftc::sema {

namespace {

struct Property {
    std::string_view name;
    ir::DeviceProperty property;
    bool is_truth;
};

constexpr std::array<Property, 6> properties{{
    {"is_host", ir::DeviceProperty::is_host, true},
    {"is_gpu", ir::DeviceProperty::is_gpu, true},
    {"subgroup_size", ir::DeviceProperty::subgroup_size, false},
    {"subgroup_arithmetic", ir::DeviceProperty::subgroup_arithmetic, true},
    {"int64", ir::DeviceProperty::int64, true},
    {"shared_memory_bytes", ir::DeviceProperty::shared_memory_bytes, false},
}};

/// Whether the expression is the name `device` in a pipeline, where no declaration gives that name another meaning.
bool is_device(Body& body, ast::ExprId id) {
    Context& c = body.context;
    const ast::Expr& expr = c[id];
    if (body.kind != BodyKind::pipeline || expr.kind != ast::ExprKind::name || c.text(expr.name) != "device")
        return false;
    return !find_symbol(body, expr.name) && find_meta(c, body.env, {expr.name, expr.span}).kind == MetaKind::none;
}

}  // namespace

std::optional<Operand> check_device_member(Body& body, const ast::Expr& expr) {
    if (!is_device(body, expr.operands[0])) return std::nullopt;
    Context& c = body.context;
    std::vector<std::string_view> known;
    for (const Property& property : properties) {
        known.push_back(property.name);
        if (property.name != c.text(expr.name)) continue;
        ir::TypeId type = property.is_truth ? body.types().bool_ : body.types().uint;
        ir::ExprId id = add(body.program(), ir::Op::device_property, type, expr.span);
        body.program().exprs[id].slot = static_cast<std::uint32_t>(property.property);
        return value_operand(body, id, expr.span);
    }
    return unknown_member(body, "the device", {expr.name, expr.name_span}, known);
}

}  // namespace gliftc::sema
