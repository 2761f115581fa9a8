#include "sema/structures/blocks.h"

#include "ir/chain.h"
#include "ir/effects.h"
#include "ir/levels.h"
#include "ir/walk.h"
#include "sema/structures/components.h"
#include "sema/types/instances.h"
#include "sema/types/typing.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

bool says_none(const Context& c, ast::ExprId id) {
    if (!id) return false;
    if (c[id].kind == ast::ExprKind::none_literal) return true;
    return std::ranges::any_of(c[id].operands, [&](ast::ExprId operand) { return says_none(c, operand); });
}

/// Whether the value of some `return` contains `none`.
bool returns_none(const Context& c, const std::vector<ast::StmtId>& body) {
    return std::ranges::any_of(body, [&](ast::StmtId id) {
        const ast::Stmt& stmt = c[id];
        return (stmt.kind == ast::StmtKind::return_ && says_none(c, stmt.value)) || returns_none(c, stmt.body) ||
               returns_none(c, stmt.otherwise);
    });
}

/// Makes the function blocks(), block(i) or block_size() of a structure. The language fixes its types; it is an
/// error if the declaration gives others. Absent after an error.
ir::FunctionId make_function(Context& c, const Env& env, ir::StructureId index, ast::DeclId id,
                             const std::vector<ir::TypeId>& params, ir::TypeId result) {
    const ast::Decl& decl = c[id];
    const auto& written = std::get<ast::Function>(decl.body);
    const std::string& name = c.text(decl.name.name);
    const std::size_t errors = c.diagnostics.own_error_count();
    if (written.params.size() != params.size()) {
        c.error(Diag::method_params, decl.name.span, {name, std::to_string(params.size())});
        return {};
    }
    ir::Function function;
    function.name = decl.name.name;
    function.display = c.program.structures[index].display + "." + name;
    function.key = c.program.structures[index].key + "." + name;
    function.span = decl.name.span;
    function.module = c.module_of.at(id);
    function.structures = {index};
    function.result = result;
    function.doc = decl.doc;
    Body body{.context = c, .env = env, .kind = BodyKind::function, .block = &function.body, .result = result};
    bring_members_into_scope(body, index);
    check_fixed_type(c, env, written.result, result);
    open_scope(body);
    for (std::size_t i = 0; i < params.size(); ++i) {
        check_fixed_type(c, env, written.params[i].type, params[i]);
        function.params.push_back(declare_local(body, written.params[i].name, params[i], false, false));
    }
    check_block(body, written.body);
    close_scope(body);
    if (c.diagnostics.own_error_count() == errors && !always_returns(c.program, function.body))
        c.error(Diag::missing_return, decl.name.span, {name, c.text(result)});
    if (c.diagnostics.own_error_count() != errors) return {};
    function.reads_memory = reads_memory(c.program, function.body);
    return c.program.functions.add(std::move(function));
}

bool reads_elements(const ir::Program& p, ir::ExprId id) {
    bool reads = false;
    ir::for_each_node(p, id, [&](ir::ExprId node) {
        const ir::Expr& expr = p.exprs[node];
        reads = reads || ir::level_of(expr.op) == ir::Level::structure || expr.op == ir::Op::local ||
                (expr.op == ir::Op::call && p.functions[expr.function].reads_memory);
    });
    return reads;
}

/// An upper bound of the value, one that the host can compute: the value itself, or if it is a `min`, a bound of one of
/// its operands. Absent: none is known.
ir::ExprId bound_of(const ir::Program& p, ir::ExprId value) {
    if (!value || !reads_elements(p, value)) return value;
    const ir::Expr& expr = p.exprs[value];
    if (expr.op != ir::Op::intrinsic || expr.intrinsic != ir::Intrinsic::min) return {};
    for (ir::ExprId operand : expr.operands)
        if (const ir::ExprId bound = bound_of(p, operand)) return bound;
    return {};
}

}  // namespace

void BlockItems::note(Context& c, ast::DeclId decl) {
    const std::string& name = c.text(c[decl].name.name);
    const auto keep = [&](const char* wanted, ast::DeclId& kept) {
        if (name != wanted) return;
        if (kept) c.error(Diag::duplicate_name, c[decl].name.span, {name});
        kept = decl;
    };
    keep("blocks", blocks);
    keep("block", block);
    keep("block_size", block_size);
}

void add_blocks(Context& c, const Env& env, ir::StructureId index, const BlockItems& items) {
    if (!items.blocks && !items.block && !items.block_size) return;
    const auto missing = [&](std::string_view name, ast::DeclId there) {
        note(c.error(Diag::blocks_incomplete, c.program.structures[index].span,
                     {c.program.structures[index].display, std::string(name)}),
             c[there].name.span, "blocks are declared together: blocks(), block(i), block_size()");
    };
    const ast::DeclId any = items.blocks ? items.blocks : items.block ? items.block : items.block_size;
    if (!items.blocks) return missing("blocks", any);
    if (!items.block) return missing("block", any);
    if (!items.block_size) return missing("block_size", any);
    const ir::TypeId address = c.program.structures[index].domain_type, uint = c.types().uint;
    const auto& block = std::get<ast::Function>(c[items.block].body);
    const bool is_optional =
        returns_none(c, block.body) || (block.result && c[block.result].kind == ast::ExprKind::optional);
    ir::Blocks made;
    made.count = make_function(c, env, index, items.blocks, {}, uint);
    made.first = make_function(c, env, index, items.block, {uint}, is_optional ? c.types().optional(address) : address);
    made.size = make_function(c, env, index, items.block_size, {}, address);
    if (!made.count || !made.first || !made.size) return;
    made.extent = single_return(c.program, made.size);
    if (!made.extent || reads_elements(c.program, made.extent)) {
        note(c.error(Diag::block_size_form, c[items.block_size].name.span), c[items.block_size].name.span,
             "all blocks are of one size, which the host knows: constants, generic and constructor's arguments");
        return;
    }
    const ir::ExprId value = single_return(c.program, made.count);
    made.bound = bound_of(c.program, value);
    made.is_known = value && made.bound == value;
    c.program.structures[index].blocks = made;
}

std::optional<Operand> call_of_blocks(Body& body, const Operand& self, ast::Identifier method, const ast::Expr& call) {
    Context& c = body.context;
    const std::string& name = c.text(method.name);
    const bool is_block = name == "block";
    if (!is_block && name != "blocks" && name != "block_size") return std::nullopt;
    const std::size_t given = call.operands.size() - 1, wanted = is_block ? 1 : 0;
    if (given != wanted) {
        c.error(Diag::argument_count, call.span, {name, std::to_string(wanted), std::to_string(given)});
        return error_operand(call.span);
    }
    ir::Operands values;
    if (is_block) {
        values.push_back(check_value(body, call.operands[1], body.types().uint));
        if (is_error(body, values[0])) return error_operand(call.span);
    }
    const ir::Structure& structure = c.program.structures[self.structure];
    const auto owner = ir::blocks_of(c.program, structure, self.place);
    const ir::TypeId address = structure.domain_type;
    if (!owner) {  // the domain is one block
        if (name == "blocks") return value_operand(body, make_uint(c.program, 1, call.span), call.span);
        if (name == "block_size")
            return value_operand(body, structure_operation(body, ir::Op::domain, address, self, call.span), call.span);
        ir::ExprId zero = make_uint(c.program, 0, call.span);
        if (body.types().is_vector(address)) zero = add(c.program, ir::Op::construct, address, call.span, {zero});
        return value_operand(body, zero, call.span);
    }
    Operand of = self;
    of.place = *owner;
    const std::size_t depth = self.place.members.size();
    for (std::size_t i = depth; i < owner->members.size(); ++i)
        of.structure = c.program.structures[of.structure].members[owner->members[i]].structure;
    if (of.structure != self.structure) of.is_slice = false;
    const ir::Blocks& blocks = *c.program.structures[of.structure].blocks;
    return call_of(body,
                   is_block           ? blocks.first
                   : name == "blocks" ? blocks.count
                                      : blocks.size,
                   of, std::move(values), call.span);
}

namespace {

/// The structure that declares the blocks of the parameter's structure, as ir::blocks_of() finds it; empty if there are
/// no blocks.
ir::StructureId owner_of(const ir::Program& p, const ir::KernelParam& param) {
    const auto place = ir::blocks_of(p, p.structures[param.structure], {});
    if (!place) return {};
    ir::StructureId owner = param.structure;
    for (std::uint32_t member : place->members) owner = p.structures[owner].members[member].structure;
    return owner;
}

/// The parameters whose ranges decide what the kernel visits. A `near` is never before an `each`: its range may be
/// larger than the visited one, which is that of the first parameter here.
std::vector<std::uint32_t> deciding(const ir::Kernel& kernel) {
    const auto chosen = [&](const auto& decides) {
        std::vector<std::uint32_t> found;
        for (std::uint32_t i = 0; i < kernel.params.size(); ++i)
            if (decides(kernel.params[i])) found.push_back(i);
        return found;
    };
    using ir::Pattern;
    auto found = chosen([](const ir::KernelParam& param) {
        return param.pattern == Pattern::each && param.direction != ir::Direction::in;
    });
    if (found.empty()) found = chosen([](const ir::KernelParam& param) { return param.pattern == Pattern::at; });
    if (found.empty())
        found = chosen([](const ir::KernelParam& param) {
            return param.pattern == Pattern::each || param.pattern == Pattern::near;
        });
    std::ranges::stable_partition(found, [&](std::uint32_t i) { return kernel.params[i].pattern != Pattern::near; });
    return found;
}

/// The kernel writes structures with blocks and others without: it visits the whole domain, which may be large.
void warn_of_whole_domain(Context& c, const ir::Kernel& kernel, const std::vector<std::uint32_t>& params) {
    const auto has_blocks = [&](std::uint32_t param) { return bool(owner_of(c.program, kernel.params[param])); };
    const ir::KernelParam& sparse = kernel.params[*std::ranges::find_if(params, has_blocks)];
    const ir::KernelParam& dense = kernel.params[*std::ranges::find_if_not(params, has_blocks)];
    if (sparse.pattern != ir::Pattern::each || sparse.direction == ir::Direction::in) return;
    note(c.error(Diag::whole_domain, dense.span, {kernel.display, c.text(dense.name), c.text(sparse.name)}),
         sparse.span,
         "to visit the blocks alone, write '" + c.text(dense.name) + "' by 'scatter', at the address that 'at' gives");
}

}  // namespace

void find_space(Context& c, ir::Kernel& kernel) {
    // Draws run over corners and pixels. Kernels with a group, and those whose invocations take several elements,
    // compute with positions in the range.
    if (kernel.raster || kernel.grouped() || kernel.items != 1) return;
    const std::vector<std::uint32_t> params = deciding(kernel);
    if (params.empty()) return;
    const auto has_blocks = [&](std::uint32_t param) { return bool(owner_of(c.program, kernel.params[param])); };
    if (!std::ranges::all_of(params, has_blocks)) {
        if (std::ranges::any_of(params, has_blocks)) warn_of_whole_domain(c, kernel, params);
        return;
    }
    const ir::KernelParam& first = kernel.params[params[0]];
    const ir::StructureId owner = owner_of(c.program, first);
    for (std::uint32_t param : params) {
        const ir::KernelParam& other = kernel.params[param];
        if (owner_of(c.program, other) == owner) continue;
        note(c.error(Diag::different_blocks, other.span, {c.text(first.name), c.text(other.name)}), first.span,
             "one of them says what is visited: take the other by 'any' or 'scatter', at the address that 'at' gives");
        return;
    }
    kernel.space = params[0];
    kernel.same_space.assign(params.begin() + 1, params.end());
    const ir::Blocks& blocks = *c.program.structures[owner].blocks;
    if (blocks.is_known || blocks.counter) return;
    const auto counter = counter_of_blocks(c, owner, kernel.span);  // may reallocate Program::structures
    c.program.structures[owner].blocks->counter = counter;
}

}  // namespace gliftc::sema
