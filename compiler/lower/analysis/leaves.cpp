#include "lower/analysis/leaves.h"

namespace gliftc::lower {

using namespace ir;

bool is_struct(const Program& p, TypeId type) { return p.types.kind(type) == TypeKind::struct_; }

std::uint32_t leaves_in(const Program& p, TypeId type) {
    if (!is_struct(p, type)) return 1;
    std::uint32_t count = 0;
    for (const StructField& field : p.structs[p.types[type].struct_].fields) count += leaves_in(p, field.type);
    return count;
}

std::uint32_t first_leaf(const Program& p, TypeId type, std::uint32_t slot) {
    const std::vector<StructField>& fields = p.structs[p.types[type].struct_].fields;
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < slot; ++i) count += leaves_in(p, fields[i].type);
    return count;
}

MemberOf member_of(const Program& p, ExprId id) {
    MemberOf result{id};
    while (p.exprs[result.whole].op == Op::field) {
        const Expr& node = p.exprs[result.whole];
        result.first += first_leaf(p, p.exprs[node.operands[0]].type, node.slot);
        result.whole = node.operands[0];
    }
    return result;
}

}  // namespace gliftc::lower
