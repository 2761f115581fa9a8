#include "lower/run_passes.h"

#include "ir/validate.h"
#include "lower/passes.h"

#include <cassert>
#include <cstdio>

namespace gliftc::lower {

using namespace ir;

namespace {

/// In development builds: validates a body after a pass.
void check([[maybe_unused]] const Context& cx, [[maybe_unused]] const std::vector<StmtId>& body,
           [[maybe_unused]] std::string_view pass) {
#ifndef NDEBUG
    std::vector<std::string> problems = validate(cx.p, cx.pass, body, cx.params);
    for (const std::string& problem : problems)
        std::fprintf(stderr, "gliftc: %.*s of %s: %s\n", static_cast<int>(pass.size()), pass.data(),
                     (*cx.p.names)[cx.kernel.name].c_str(), problem.c_str());
    assert(problems.empty());
#endif
}

}  // namespace

void finished(Context& cx, std::string_view pass, const std::vector<Variant>& variants,
              const std::vector<ExprId>& facts, std::string_view what) {
    for (const Variant& variant : variants) check(cx, statements_of(variant), pass);
    if (cx.trace == nullptr) return;
    cx.trace->note(pass, cx.p, cx.pass, variants, facts, what);
    cx.is_stopped |= pass == cx.trace->stop_after;
}

void finished(Context& cx, std::string_view pass, const std::vector<StmtId>& body, const std::vector<ExprId>& facts,
              std::string_view what) {
    finished(cx, pass, std::vector<Variant>{{.part = cx.part, .assumes = cx.pass.plain().assumes, .body = body}}, facts,
             what);
}

std::vector<StmtId> simplified(Context& cx, std::string_view what, std::vector<StmtId> body,
                               const std::vector<ExprId>& facts) {
    for (const BodyPass& pass : body_passes()) {
        if (cx.is_stopped) break;
        body = pass.run(cx, body, facts);
        finished(cx, pass.name, body, facts, what);
    }
    return body;
}

}  // namespace gliftc::lower
