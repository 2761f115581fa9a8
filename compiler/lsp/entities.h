// Everything that a file declares, down to parameters and variables: what it is, where it is written, where its name
// can be used. Read from the syntax tree alone, so that it is there whatever sema finds.
#pragma once

#include "syntax/ast.h"

#include <string>
#include <string_view>
#include <vector>

namespace gliftc::lsp {

enum class EntityKind : std::uint8_t {
    function,
    structure,
    translator,
    kernel,
    raster,
    pipeline,
    test,
    struct_,
    enum_,
    interface,
    alias,
    constant,
    field,  // of a struct, of a translator's state, a varying of a raster
    enumerator,
    generic,  // a generic parameter
    parameter,
    memory,  // an item of a structure
    member,  // a structure within a structure
    host_state,
    variable,
};

struct Entity {
    EntityKind kind = EntityKind::variable;
    ast::Identifier name;         ///< of a test: no name, but the span of its declaration's first word
    std::string title;            ///< of a test
    Span written;                 ///< the whole declaration, with its body
    Span scope;                   ///< where its plain name means it; empty: nowhere (fields, enumerators)
    std::uint32_t parent = none;  ///< the index of the entity that it is part of
    std::string doc;
    bool is_pub = false;

    static constexpr std::uint32_t none = 0xffffffffu;
};

/// The entities of a module in the order of the source, each after its parent. `size` is that of its file in bytes.
std::vector<Entity> entities_of(const ast::Module& module, const ast::Tree& tree, std::size_t size);

/// Whether the name can be called, with arguments in parentheses.
bool is_callable(EntityKind kind);
/// The text of a declaration, without line breaks, up to its body: `kernel difference<N: uint>(f: in near<S, 1>)`.
std::string header_of(const Entity& entity, std::string_view file_text);

}  // namespace gliftc::lsp
