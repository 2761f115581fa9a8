// Translators as C++ for the host, for generated code that computes physical addresses itself.
#pragma once

#include "emit/cpp/unit.h"

namespace gliftc::cpp {

/// Whether a translator's function calls a function that uses the translator's state: print_method cannot print such a
/// function. Only direct calls are looked at.
bool uses_state_elsewhere(const ir::Program& program, ir::FunctionId function);

/// Declares the scalar state of a stage (one translator of `via`), in terms of the structure that `object` reaches
/// ("structure.", or "" for this), and gives the names. None of them is one of `taken`, a type's name, or one that the
/// class's own functions use. `hiding`: within a class, the names that hide those of the namespace
/// (Printer::class_names).
std::vector<std::string> print_state(Unit& unit, Writer& out, ir::StructureId structure, const ir::Stage& stage,
                                     const std::string& object, std::initializer_list<const char*> taken,
                                     const NameSet* hiding = nullptr);

/// `const auto translate = [&](uint4 va) -> std::optional<uint> { … };` Operations on structures, and the names of
/// functions that take structures, are spelled by `surroundings`; `hiding` as above.
void print_method(Unit& unit, Writer& out, const std::string& name, ir::FunctionId id, const std::string& result,
                  const std::vector<std::string>& states,
                  const std::function<Text(Printer&, const ir::Expr&)>& surroundings = {},
                  const NameSet* hiding = nullptr);

/// Whether the class of a structure gets place() and row_memory(), with which the runtime copies a box by rows where it
/// finds that the elements of a row are contiguous. This holds if the elements are structs, bools, or numbers or
/// vectors or matrices of numbers (not enums or arrays), and lie in a buffer, and each structure on the way to that
/// buffer (the structure, its memory, that one's memory, …) has no translator (its elements lie in order) or one that
/// is affine, total, not many-to-one, reads no structures and can be printed by print_method; no address leads beyond
/// the memory of any of them.
bool has_rows(const ir::Program& program, const ir::Structure& structure);

/// The C++ expression, within the class, of the memory that holds the elements of a structure which has rows.
std::string rows_of(const Unit& unit, ir::StructureId structure);

/// `std::uint64_t place(uint4 address) const`: the index, in the memory of rows_of, of an element of a structure that
/// has rows.
void print_place(Unit& unit, Writer& out, ir::StructureId structure);

/// Whether the class of a structure without rows gets index_of(), with which the runtime finds out how its elements lie
/// in a buffer. This holds if they lie in buffers of the structure's own, and if no translator reads structures, is
/// many-to-one, or cannot be printed by print_method; and for components of such structures and of those with rows.
bool has_indices(const ir::Program& program, const ir::Structure& structure);

/// The C++ expression, within the class, of the memory that has the elements: what index_memory() returns. Empty if
/// they lie apart in several memories.
std::string index_memory_of(const Unit& unit, ir::StructureId structure);

/// `std::uint64_t index_of(uint4 address) const`: the index of an element in its memory; UINT64_MAX where the address
/// leads nowhere.
void print_index(Unit& unit, Writer& out, ir::StructureId structure);

}  // namespace gliftc::cpp
