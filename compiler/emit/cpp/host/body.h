// What the printers of the three kinds of kernels for the host device share (see emit.h: those for rows, for
// workgroups, and draws): names of bindings and parameters, memory operations.
#pragma once

#include "emit/cpp/printer.h"
#include "ir/pass.h"

#include <map>
#include <set>
#include <span>

namespace gliftc::host {

struct Body {
    const ir::Pass& pass;
    cpp::Printer p;
    std::vector<std::string> binding_names;
    std::vector<std::string> parameter_names;
    std::set<std::uint32_t> used_bindings, used_parameters;
    std::set<std::uint32_t>
        updated_bindings;  ///< in rows: those that are updated through such an object (update_names)
    /// Names of the pointers through which row_load and row_store access buffers, by the access's binding and index
    /// operand.
    std::map<std::pair<std::uint32_t, ir::ExprId>, std::string> row_pointers;
    /// The same for row_item, which accesses local arrays, by the array and the index operand.
    std::map<std::pair<ir::LocalId, ir::ExprId>, std::string> item_pointers;
    /// In rows: names of the objects that combine a thread's updates of a buffer (glift::host::Updates), by binding.
    std::map<std::uint32_t, std::string> update_names;
    /// In rows: names of the objects that combine a row's updates of one element, by binding and index.
    std::map<std::pair<std::uint32_t, ir::ExprId>, std::string> row_updates;
    bool first_only = false;  ///< in workgroups: the printed code runs once, with the values of the first invocation
    std::string group_text;   ///< in workgroups: their size, as a uint3

    /// `taken`: names that code of this kind declares itself, beside those of all kernels (emit/cpp/names.h).
    Body(cpp::Globals& globals, const ir::Pass& pass, std::span<const char* const> taken = {});
    Body(const Body&) = delete;
};

/// An element of a buffer: `f_data[index]`, or through its row pointer, `f_data_row[i]`.
std::string element_text(Body& body, std::uint32_t binding, ir::ExprId index);
/// Prints the functions of the pass that are not pure (cpp::is_pure), as lambdas.
void print_local_functions(Body& body);
/// Prints declarations of the bindings and parameters that `body` has used so far, to stand before its code: they read
/// the HostCall `call`, whose parameters are a `<name>_parameters`.
void declare_used(Body& body, cpp::Writer& out, const std::string& name);
bool returns_early(const ir::Program& program, const std::vector<ir::StmtId>& body);

// rows.cpp, groups.cpp
std::string row_kernel(cpp::Globals& globals, const ir::Pass& pass, const std::string& name);
std::string group_kernel(cpp::Globals& globals, const ir::Pass& pass, const std::string& name);
// vertices.cpp, fragments.cpp, draws.cpp
std::string vertex_part(cpp::Globals& globals, const ir::Pass& pass, const std::string& name);
std::string fragment_part(cpp::Globals& globals, const ir::Pass& pass, const std::string& name);
std::string draw_kernel(cpp::Globals& globals, const ir::Pass& pass, const std::string& name);
/// The number of floats of a varying. A vertex's output is its position, then its clip distances, then its varyings.
std::uint32_t floats_of(const ir::Program& program, const ir::Varying& varying);

}  // namespace gliftc::host
