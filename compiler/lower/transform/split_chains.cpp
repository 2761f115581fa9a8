#include "lower/transform/split_chains.h"

#include "ir/walk.h"

#include <algorithm>
#include <ranges>

namespace gliftc::lower {

using namespace ir;

namespace {

using Body = std::vector<StmtId>;

/// The `if` at the end of the `else` branch, if it is the next link of the chain; else none. What follows it, its own
/// `else` branch, must not use what the statements before it declare.
StmtId next_link(const Program& p, const Stmt& link) {
    if (link.otherwise.empty()) return {};
    const StmtId last = link.otherwise.back();
    if (p.stmts[last].op != StmtOp::if_) return {};
    const Body rest(p.stmts[last].otherwise.begin(), p.stmts[last].otherwise.end());
    for (StmtId id : link.otherwise) {
        const Stmt& stmt = p.stmts[id];
        if (stmt.op == StmtOp::let && mentions(p, rest, stmt.local)) return {};
    }
    return last;
}

class Splitting {
public:
    explicit Splitting(Builder& builder) : build(builder), p(builder.p) {}

    Body run(const Body& body) {
        Body result;
        result.reserve(body.size());
        for (StmtId id : body) visit(id, result);
        return result;
    }

private:
    void visit(StmtId id, Body& result) {
        if (p.stmts[id].op != StmtOp::if_) return result.push_back(with_inner_split(id));
        Body links;
        for (StmtId link = id; link; link = next_link(p, p.stmts[link])) links.push_back(link);
        if (links.size() <= longest_chain) return result.push_back(part(links, {}));
        split(links, result);
    }

    StmtId with_inner_split(StmtId id) {
        const Stmt stmt = p.stmts[id];
        return build.again(id, {stmt.target, stmt.value, stmt.limit, run(stmt.body), run(stmt.otherwise)});
    }

    /// The links as one chain. Its last `else` branch sets `rest` if that is given, else it is that of the last link.
    StmtId part(std::span<const StmtId> links, LocalId rest) {
        StmtId made;
        for (std::size_t i = links.size(); i-- > 0;) {
            const Stmt link = p.stmts[links[i]];
            Body otherwise;
            if (i + 1 < links.size()) otherwise = before_next(link, made);
            else if (rest) otherwise.push_back(assigned(rest, true, link.span));
            else otherwise = run(link.otherwise);
            made = build.again(links[i], {link.target, link.value, link.limit, run(link.body), std::move(otherwise)});
        }
        return made;
    }

    /// The `else` branch of a link, with `next` in place of the next link.
    Body before_next(const Stmt& link, StmtId next) {
        Body body;
        for (StmtId id : link.otherwise)
            if (id != link.otherwise.back()) visit(id, body);
        body.push_back(next);
        return body;
    }

    void split(std::span<const StmtId> links, Body& result) {
        const Span span = p.stmts[links.front()].span;
        Local local;
        local.name = p.names->intern("rest");
        local.type = p.types.bool_;
        local.span = span;
        local.is_mutable = true;
        const LocalId rest = p.locals.add(std::move(local));
        Stmt declaration = statement(StmtOp::let, span);
        declaration.local = rest;
        declaration.value = build.truth(false);
        result.push_back(p.stmts.add(std::move(declaration)));
        for (std::size_t first = 0; first < links.size(); first += longest_chain) {
            const auto here = links.subspan(first, std::min(longest_chain, links.size() - first));
            const bool is_last = first + here.size() == links.size();
            const StmtId chain = part(here, is_last ? LocalId{} : rest);
            if (first == 0) {
                result.push_back(chain);
                continue;
            }
            Stmt behind = statement(StmtOp::if_, p.stmts[here.front()].span);
            behind.value = build.local(rest);
            Body inside;
            if (!is_last) inside.push_back(assigned(rest, false, behind.span));
            for (StmtId id : before_next(p.stmts[links[first - 1]], chain)) inside.push_back(id);
            for (StmtId id : inside) behind.body.push_back(id);
            result.push_back(p.stmts.add(std::move(behind)));
        }
    }

    StmtId assigned(LocalId local, bool value, Span span) {
        Stmt stmt = statement(StmtOp::assign, span);
        stmt.target = build.local(local);
        stmt.value = build.truth(value);
        return p.stmts.add(std::move(stmt));
    }

    Builder& build;
    Program& p;
};

}  // namespace

std::vector<StmtId> split_chains(Context& cx, const std::vector<StmtId>& body) { return Splitting(cx.build).run(body); }

std::vector<FunctionId> split_chains(Program& program) {
    Builder build(program);
    std::vector<FunctionId> changed;
    for (std::uint32_t i = 0; i < program.functions.size(); ++i) {
        const FunctionId id{i};
        if (!program.functions[id].structures.empty()) continue;  // passes call lowered instances of it (instances.cpp)
        Body body = Splitting(build).run(program.functions[id].body);
        if (body == program.functions[id].body) continue;
        program.functions[id].body = std::move(body);
        changed.push_back(id);
    }
    return changed;
}

}  // namespace gliftc::lower
