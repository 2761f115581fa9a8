// An index of one file: what its names and expressions mean. sema fills it as it checks, for the language server, if
// Settings::index is set. The index has nothing of code that is not checked: generic declarations that nothing uses.
#pragma once

#include "ir/ir.h"

#include <vector>

namespace gliftc::sema {

/// A name in the source and a declaration that it denotes.
struct NameUse {
    Span name;      ///< a declaration's own name is a use of itself
    Span declared;  ///< the name in the declaration, possibly in another file
    /// Whether overload resolution chose this declaration. Where it did for a name, uses of the name without this mark
    /// are only declarations that were visible.
    bool is_chosen = false;
};

/// The type of an expression, of a declared variable, or of a name where a type stands. Structures have types, too.
struct TypedSpan {
    Span span;
    ir::TypeId type;
    ir::ModuleId module;  ///< where the expression is a module's name, instead of `type`
};

/// The entries are in the order of checking. Code that is checked several times (generic code for each instance) has an
/// entry for each time.
struct Index {
    std::uint32_t file = 0;  ///< only spans of this file are recorded
    std::vector<NameUse> uses;
    std::vector<TypedSpan> types;
};

}  // namespace gliftc::sema
