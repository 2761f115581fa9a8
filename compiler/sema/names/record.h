// Recording into the index (sema/index.h). Without an index, and for spans outside of its file, these functions do
// nothing.
#pragma once

#include "sema/context.h"

namespace gliftc::sema {

struct Body;
struct Operand;

/// Records that the name denotes what is declared at `declared`.
void record_use(const Context&, Span name, Span declared);
/// Records declarations that the name denotes, several if they are overloads.
void record_uses(const Context&, Span name, const std::vector<ast::DeclId>& declared);
/// Records which overload a call means.
void record_choice(const Context&, const ast::Expr& call, ast::DeclId chosen);
/// Records the use of a struct's field, or of an enumerator, by its index.
void record_field(const Context&, Span name, ir::StructId owner, std::size_t index);
void record_enumerator(const Context&, Span name, const ir::Enum& owner, std::size_t index);
/// Records the use of a component (sema/structures/projection.h): of that field of the structure's elements.
void record_component(const Context&, ir::StructureId whole, ast::Identifier field);

void record_type(const Context&, Span, ir::TypeId);
/// Records the type of a checked expression: of a structure its type, of an iterator that of the current element.
void record_operand(Body&, const ast::Expr&, const Operand&);

}  // namespace gliftc::sema
