#include "emit/cpp/sharing.h"

#include "ir/effects.h"
#include "ir/walk.h"
#include "layout/layout.h"

#include <algorithm>
#include <optional>

namespace gliftc::cpp {

namespace {

bool writes(const ir::PassBinding& binding) { return binding.access != ir::Access::read; }

/// The parameter's number among the kernel's parameters that are structures or values on the device.
std::size_t structure_number(const ir::Kernel& kernel, std::uint32_t root) {
    const auto is_structure = [](const ir::KernelParam& param) { return param.pattern != ir::Pattern::value; };
    const auto last = kernel.params.begin() + root;
    return static_cast<std::size_t>(std::count_if(kernel.params.begin(), last, is_structure));
}

/// The parameters that the kernel declares @disjoint from the parameter `root`: a bit each, by their structure_number;
/// those numbered 32 or more are left out.
std::uint32_t promised_apart(const ir::Kernel& kernel, std::uint32_t root) {
    std::uint32_t bits = 0;
    for (std::uint32_t other = 0; other < kernel.params.size(); ++other) {
        const std::size_t number = structure_number(kernel, other);
        if (ir::is_promised_apart(kernel, root, other) && number < 32) bits |= 1u << number;
    }
    return bits;
}

const char* reach_text(ir::Reach reach) {
    switch (reach) {
    case ir::Reach::element: return "element";
    case ir::Reach::window: return "window";
    case ir::Reach::anywhere: return "range";
    case ir::Reach::nothing: break;
    }
    return "memory";
}

const char* combine_text(ir::Combine combine) {
    switch (combine) {
    case ir::Combine::replace: return "none";
    case ir::Combine::min: return "min";
    case ir::Combine::max: return "max";
    case ir::Combine::add: return "add";
    case ir::Combine::bit_and: return "bit_and";
    case ir::Combine::bit_or: return "bit_or";
    case ir::Combine::bit_xor: return "bit_xor";
    }
    return "none";
}

/// Where the binding's fields lead to within an element, and how many bytes that part has.
std::pair<std::uint32_t, std::uint32_t> part_of_element(const ir::Program& program, const ir::PassBinding& binding) {
    std::uint32_t offset = 0;
    ir::TypeId type = binding.element;
    for (std::uint32_t field : binding.fields) {
        const ir::Struct& of = program.structs[program.types[type].struct_];
        offset += layout::offsets_of(program, of)[field];
        type = of.fields[field].type;
    }
    return {offset, layout::size_of(program, type).size};
}

/// The kind of the numbers that are combined, where that is not unsigned integers.
std::string number_text(const ir::Program& program, const ir::PassBinding& binding) {
    if (binding.access == ir::Access::read) return "";
    ir::TypeId type = binding.element;
    for (std::uint32_t field : binding.fields) type = program.structs[program.types[type].struct_].fields[field].type;
    const ir::TypeId scalar = program.types.scalar_of(type);
    if (program.types.is_floating(scalar)) return ", .number = glift::Number::real";
    if (program.types.is_signed(scalar)) return ", .number = glift::Number::signed_integer";
    return "";
}

/// Whether the statements give the current element of the parameter `root` a new value on every path.
bool assign_element(const ir::Program& program, const std::vector<ir::StmtId>& body, std::uint32_t root) {
    for (const ir::StmtId id : body) {
        const ir::Stmt& stmt = program.stmts[id];
        if (stmt.op == ir::StmtOp::set_element && stmt.place.root == root && stmt.path.empty()) return true;
        if (stmt.op == ir::StmtOp::block && assign_element(program, stmt.body, root)) return true;
        if (stmt.op == ir::StmtOp::if_ && assign_element(program, stmt.body, root) &&
            assign_element(program, stmt.otherwise, root))
            return true;
        bool may_leave = false;
        ir::for_each_statement(program, std::vector{id}, [&](const ir::Stmt& inner) {
            may_leave = may_leave || inner.op == ir::StmtOp::return_;
        });
        if (may_leave) return false;
    }
    return false;
}

}  // namespace

bool may_share(const ir::Pass& pass) {
    for (std::size_t k = 1; k < pass.bindings.size(); ++k) {
        const ir::PassBinding& other = pass.bindings[k];
        for (std::size_t i = 0; i < k; ++i) {
            const ir::PassBinding& one = pass.bindings[i];
            // Images of different shapes may share texels: a cube and a face of it.
            if (one.is_workspace || other.is_workspace) continue;
            const bool are_alike = (one.shape == ir::MemoryShape::buffer) == (other.shape == ir::MemoryShape::buffer);
            if (are_alike && one.format == other.format && (writes(one) || writes(other))) return true;
        }
    }
    return false;
}

std::string sharing_fields(const ir::Program& program, const ir::Kernel& kernel, const ir::PassBinding& binding) {
    if (binding.is_workspace) return "";
    const ir::KernelParam& param = kernel.params[binding.place.root];
    std::string text;
    if (!binding.fields.empty()) {
        const auto [offset, bytes] = part_of_element(program, binding);
        text += ", .field_offset = " + std::to_string(offset) + ", .field_bytes = " + std::to_string(bytes);
    }
    if (const std::size_t number = structure_number(kernel, binding.place.root))
        text += ", .parameter = " + std::to_string(number);
    if (ir::is_addressed(program, kernel, binding))
        text += std::string(", .reach = glift::Reach::") + reach_text(ir::traits_of(param.pattern).reach);
    if (ir::traits_of(param.pattern).reach == ir::Reach::window)
        text += ", .radius = " + std::to_string(param.radius.largest());
    if (const std::uint32_t apart = promised_apart(kernel, binding.place.root))
        text += ", .apart_from = " + std::to_string(apart) + "u";
    if (binding.coherent) text += ", .combine = glift::Combine::coherent";
    else if (param.combine != ir::Combine::replace)
        text += std::string(", .combine = glift::Combine::") + combine_text(param.combine);
    return text;
}

std::string update_fields(const ir::Program& program, const ir::Kernel& kernel, const ir::Pass& pass,
                          std::size_t number) {
    const ir::PassBinding& binding = pass.bindings[number];
    if (binding.access == ir::Access::read || binding.is_workspace || binding.coherent) return "";
    std::optional<ir::Combine> combine;
    bool is_pure = binding.shape == ir::MemoryShape::buffer;
    const auto look_at = [&](const std::vector<ir::StmtId>& body) {
        ir::for_each_statement(program, body, [&](const ir::Stmt& stmt) {
            const bool updates = stmt.op == ir::StmtOp::store || stmt.op == ir::StmtOp::atomic;
            if (!updates || stmt.slot != number) return;
            is_pure = is_pure && (!combine || *combine == stmt.combine);
            combine = stmt.combine;
        });
        ir::for_each_expression(program, body, [&](ir::ExprId id) {
            const ir::Expr& expr = program.exprs[id];
            if (expr.op == ir::Op::load && expr.slot == number) is_pure = false;
        });
    };
    look_at(pass.plain().body);
    for (ir::FunctionId function : pass.functions) look_at(program.functions[function].body);
    if (!is_pure || !combine) return "";
    std::string name = *combine == ir::Combine::replace ? "store" : combine_text(*combine);
    if (*combine == ir::Combine::replace && assign_element(program, kernel.body, binding.place.root)) name = "assign";
    return ", .update = glift::Update::" + name + number_text(program, binding);
}

}  // namespace gliftc::cpp
