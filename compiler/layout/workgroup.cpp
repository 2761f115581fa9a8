#include "layout/workgroup.h"

#include "ir/walk.h"
#include "layout/layout.h"

#include <algorithm>
#include <unordered_map>

namespace gliftc::layout {

using namespace ir;

namespace {

/// The positions of the first and last top-level statement that name an array. Top-level: under no condition and in no
/// loop.
struct Lifetime {
    std::size_t first = 0, last = 0;
};

struct Lifetimes {
    std::unordered_map<LocalId, Lifetime> of;
    std::vector<std::size_t> barriers;
};

void mention(Lifetimes& lifetimes, LocalId local, std::size_t place) {
    lifetimes.of.try_emplace(local, Lifetime{place, place}).first->second.last = place;
}

void mention_all(const Program& program, StmtId id, std::size_t place, Lifetimes& lifetimes) {
    for_each_expression(program, {id}, [&](ExprId node) {
        const Expr& expr = program.exprs[node];
        if (expr.op == Op::local && program.locals[expr.local].storage == Storage::shared)
            mention(lifetimes, expr.local, place);
    });
}

void find(const Program& program, const std::vector<StmtId>& body, std::size_t& place, Lifetimes& lifetimes) {
    for (StmtId id : body) {
        const Stmt& stmt = program.stmts[id];
        ++place;
        if (stmt.op == StmtOp::block) find(program, stmt.body, place, lifetimes);
        else if (stmt.op == StmtOp::barrier) lifetimes.barriers.push_back(place);
        else mention_all(program, id, place, lifetimes);
    }
}

bool has_barrier_between(const Lifetimes& lifetimes, std::size_t after, std::size_t before) {
    const auto barrier = std::ranges::upper_bound(lifetimes.barriers, after);
    return barrier != lifetimes.barriers.end() && *barrier < before;
}

/// Arrays that share one allocation, in the order of their lifetimes.
struct Slot {
    std::vector<LocalId> arrays;
    std::size_t last = 0;
    std::uint32_t bytes = 0;
};

bool fits(const Program& program, const Lifetimes& lifetimes, const Slot& slot, LocalId array) {
    const Type &type = program.types[program.locals[array].type],
               &other = program.types[program.locals[slot.arrays.front()].type];
    return type.kind == TypeKind::array && other.kind == TypeKind::array && type.element == other.element &&
           has_barrier_between(lifetimes, slot.last, lifetimes.of.at(array).first);
}

}  // namespace

void place_shared(const Program& program, Pass& pass) {
    if (pass.shared.empty()) return;
    Lifetimes lifetimes;
    std::size_t place = 0;
    find(program, variant_for(pass, Devices::shaders).body, place, lifetimes);
    std::vector<LocalId> arrays;
    for (LocalId array : pass.shared)
        if (lifetimes.of.contains(array)) arrays.push_back(array);
    std::ranges::stable_sort(arrays, {}, [&](LocalId array) { return lifetimes.of.at(array).first; });
    std::vector<Slot> slots;
    for (LocalId array : arrays) {
        auto found = std::ranges::find_if(
            slots, [&](const Slot& candidate) { return fits(program, lifetimes, candidate, array); });
        if (found == slots.end()) found = slots.emplace(slots.end());
        found->arrays.push_back(array);
        found->last = lifetimes.of.at(array).last;
        found->bytes = std::max(found->bytes, size_of(program, program.locals[array].type).size);
    }
    pass.shared_places.clear();
    pass.shared_bytes = 0;
    for (Slot& one : slots) {
        pass.shared_bytes += one.bytes;
        pass.shared_places.push_back(std::move(one.arrays));
    }
}

}  // namespace gliftc::layout
