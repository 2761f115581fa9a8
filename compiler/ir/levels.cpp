#include "ir/levels.h"

#include "base/concat.h"

#include <stdexcept>

namespace gliftc::ir {

namespace {

struct Described {
    std::string_view name;
    Level level;
};

constexpr Described operations[] = {
#define OPERATION(name, level) {#name, Level::level},
#include "ir/operations.def"
};

constexpr Described statements[] = {
#define STATEMENT(name, level) {#name, Level::level},
#include "ir/statements.def"
};

const Described& described(Op op) { return operations[static_cast<std::size_t>(op)]; }
const Described& described(StmtOp op) { return statements[static_cast<std::size_t>(op)]; }

}  // namespace

Level level_of(Op op) { return described(op).level; }
Level level_of(StmtOp op) { return described(op).level; }
std::string_view name_of(Op op) { return described(op).name; }
std::string_view name_of(StmtOp op) { return described(op).name; }

std::string_view name_of(Level level) {
    switch (level) {
    case Level::value: return "value";
    case Level::shape: return "shape";
    case Level::structure: return "structure";
    case Level::host: return "host";
    case Level::guarded: return "guarded";
    case Level::memory: return "memory";
    case Level::cpu: return "cpu";
    }
    return "?";
}

void misplaced(Op op, std::string_view where) {
    throw std::logic_error(
        concat(where, ": the operation '", name_of(op), "' of level '", name_of(level_of(op)), "' cannot stand here"));
}

void misplaced(StmtOp op, std::string_view where) {
    throw std::logic_error(
        concat(where, ": the statement '", name_of(op), "' of level '", name_of(level_of(op)), "' cannot stand here"));
}

}  // namespace gliftc::ir
