// The number of blocks that a kernel visits, where the host does not know it: a pipeline gives it as a value on the
// device.
#include "ir/chain.h"
#include "ir/evaluate.h"
#include "sema/structures/blocks.h"
#include "sema/structures/components.h"
#include "sema/types/instances.h"

namespace gliftc::sema {

namespace {

/// Whether the value is an element of type uint, at a constant address of one dimension, of a stored structure that is
/// a member of `owner`, or a member of one of its members, and so on.
bool is_stored_element(const ir::Program& p, const ir::Structure& owner, ir::ExprId id) {
    const ir::Expr& read = p.exprs[id];
    if (read.op != ir::Op::read || read.operands.size() != 1 || read.place.root != 0 || read.place.members.empty())
        return false;
    const ir::Structure& stored = ir::structure_at(p, owner, read.place.members);
    return stored.kind == ir::StructureKind::stored && stored.domain_type == p.types.uint &&
           read.type == p.types.uint && ir::evaluate(p, read.operands[0]);
}

/// The element that gives the number of blocks: `state[0]` where the number is `min(state[0], capacity)` and `capacity`
/// the bound of the blocks, or where it is `state[0]` alone. Absent: the number is another value.
ir::ExprId counted_element(const ir::Program& p, const ir::Structure& owner) {
    const ir::Blocks& blocks = *owner.blocks;
    const ir::ExprId value = single_return(p, blocks.count);
    if (!value) return {};
    if (is_stored_element(p, owner, value)) return value;
    const ir::Expr& least = p.exprs[value];
    if (least.op != ir::Op::intrinsic || least.intrinsic != ir::Intrinsic::min || !blocks.bound) return {};
    for (std::size_t i : {0u, 1u})
        if (least.operands[1 - i] == blocks.bound && is_stored_element(p, owner, least.operands[i]))
            return least.operands[i];
    return {};
}

/// Begins the pipeline with a return of the element, without a copy, if the structure that it lies in has that address:
///
///     if 0 < self.state.domain() { return self.state[0]; }
void return_element(Context& c, ir::Pipeline& pipeline, const ir::Structure& owner, ir::ExprId element) {
    ir::Program& p = c.program;
    const ir::Expr read = p.exprs[element];
    const Span span = pipeline.span;
    const auto of_self = [&](ir::Op op, ir::TypeId type, ir::Operands operands) {
        const ir::ExprId made = add(p, op, type, span, std::move(operands));
        p.exprs[made].place = read.place;
        p.exprs[made].local = pipeline.params[0].local;
        return made;
    };
    ir::StructureId stored;
    for (const ir::Structure* at = &owner; std::uint32_t member : read.place.members) {
        stored = at->members[member].structure;
        at = &p.structures[stored];
    }
    require_transfers(c, stored, span);
    const ir::ExprId domain = of_self(ir::Op::domain, p.types.uint, {});
    const ir::ExprId is_there = add(p, ir::Op::binary, p.types.bool_, span, {read.operands[0], domain});
    p.exprs[is_there].binary = ir::BinaryOp::less;
    const ir::ExprId in_place = of_self(ir::Op::device_read, pipeline.result, {read.operands[0]});
    p.exprs[in_place].slot = 1;
    const ir::StmtId give = add(p, ir::StmtOp::return_, span);
    p.stmts[give].value = in_place;
    const ir::StmtId choice = add(p, ir::StmtOp::if_, span);
    p.stmts[choice].value = is_there;
    p.stmts[choice].body = {give};
    pipeline.body.push_back(choice);
}

}  // namespace

// Where the number is such an element as is_stored_element() accepts, or the `min` of one and the blocks' bound, the
// pipeline gives the element itself, not a copy: the dispatch that follows uses it at once, and applies the bound.
// Kernels over the same blocks then share the pass that prepares their dispatches, as long as nothing writes the
// element between them.
ir::PipelineId counter_of_blocks(Context& c, ir::StructureId index, Span use) {
    const ir::FunctionId count = c.program.structures[index].blocks->count;
    const auto general = pipeline_of_function(c, count, use);
    const ir::Structure owner = c.program.structures[index];
    const ir::ExprId element = counted_element(c.program, owner);
    if (!general || !element) return general;
    ir::Pipeline pipeline;
    const ir::Pipeline& called = c.program.pipelines[general];
    pipeline.name = c.names.intern("block_count");
    pipeline.display = owner.display + ".blocks, the element";
    pipeline.key = owner.key + ".block_count<" + owner.key + ">";
    pipeline.span = called.span;
    pipeline.module = called.module;
    pipeline.result = called.result;
    pipeline.params.push_back(structure_param(c, index, called.span));
    return_element(c, pipeline, owner, element);
    const ir::ExprId call = add(c.program, ir::Op::pipeline_call, pipeline.result, pipeline.span,
                                {structure_argument(c, pipeline.params[0].local, pipeline.span)});
    c.program.exprs[call].slot = general.index;
    const ir::StmtId give = add(c.program, ir::StmtOp::return_, pipeline.span);
    c.program.stmts[give].value = call;
    pipeline.body.push_back(give);
    return c.program.pipelines.add(std::move(pipeline));
}

}  // namespace gliftc::sema
