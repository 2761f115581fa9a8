// Functions that a running program can replace (cpp::Options::reload): each has its body in a function of its own, and
// an object through which it calls the newest body that the program has loaded (glift/reload.h).
#pragma once

#include "emit/cpp/unit.h"

namespace gliftc::cpp {

struct FunctionParts {
    std::string linkage;    ///< what stands before the definition; may be empty
    std::string head;       ///< as the source defines it: "void step(const glift::Commands& commands, float rate)"
    std::string declared;   ///< as headers declare it
    std::string name;       ///< as in both of them
    std::string arguments;  ///< the names of its parameters: "commands, rate"
    std::string stem;       ///< differs from those of the other functions in this namespace
    std::string kernel;     ///< the data of the kernel that it calls; empty: it is a pipeline
};

/// Prints a function whose statements, one level deep, are `body`.
void print_function(const Unit& unit, Writer& out, const FunctionParts& parts, const std::string& body);

/// Prints a hash of what the functions of this namespace may call: Globals::functions, which must be complete.
void print_hash_of_functions(const Unit& unit, Writer& out);

/// Prints the objects by which the runtime sees that types and structures are still as they were declared. `members` is
/// the C++ of the functions of each class.
void print_declared_types(Unit& unit, Writer& out, const std::map<ir::StructureId, std::string>& members);

}  // namespace gliftc::cpp
