// Translators as C++ for the host, for generated code that computes physical addresses itself.
#pragma once

#include "emit/cpp/unit.h"

namespace gliftc::cpp {

/// Whether a function that the translator's function calls directly uses the translator's state. print_method cannot
/// print such a translator's function.
bool uses_state_elsewhere(const ir::Program& program, ir::FunctionId function);

/// Declares the scalar state of a stage (one translator of `via`), in terms of the structure that `object` reaches
/// ("structure.", or "" for this), and gives the names. None of them is one of `taken`, a type's name, or one that the
/// class's own functions use.
std::vector<std::string> print_state(Unit& unit, Writer& out, std::uint32_t structure, const ir::Stage& stage,
                                     const std::string& object, std::initializer_list<const char*> taken);

/// `const auto translate = [&](uint4 va) -> std::optional<uint> { … };` Operations on structures are spelled by
/// `surroundings`.
void print_method(Unit& unit, Writer& out, const char* name, ir::FunctionId id, const std::string& result,
                  const std::vector<std::string>& states,
                  const std::function<Text(Printer&, const ir::Expr&)>& surroundings = {});

/// Whether elements that follow each other along x may lie one after the other in a buffer, in the same layout as on
/// the host: boxes of such a structure are copied by rows. Each structure from it down to the one with the memory has
/// no translator (elements in order) or one affine map, which says where a row begins.
bool has_rows(const ir::Program& program, const ir::Structure& structure);

/// The memory that the elements of a structure which has rows lie in.
std::string rows_of(const Unit& unit, std::uint32_t structure);

/// `std::uint64_t place(uint4 address) const`, where a structure that has rows keeps an element.
void print_place(Unit& unit, Writer& out, std::uint32_t structure);

}  // namespace gliftc::cpp
