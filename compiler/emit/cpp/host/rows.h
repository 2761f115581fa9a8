// Kernels without a group, for the host device: what the printers of their loops share.
#pragma once

#include "base/id_set.h"
#include "emit/cpp/host/body.h"
#include "emit/cpp/host/updates.h"

#include <functional>
#include <map>

namespace gliftc::host {

/// An access through a row pointer (row_load, row_store, row_item).
struct RowAccess {
    std::uint32_t binding;
    ir::ExprId index;
    ir::LocalId array;  ///< of row_item: the local array; absent: the access is to the binding
};

std::vector<RowAccess> row_accesses(const ir::Program& program, const std::vector<ir::StmtId>& body);

struct Rows {
    Body body;
    const ir::Program& program;
    const ir::Pass& pass;
    cpp::Printer& p;
    std::map<std::uint32_t, ir::Combine> combined;
    std::map<ir::LocalId, std::string> kept_names;  ///< in runs: names of the arrays of locals that are kept
    bool has_runs = false;                          ///< a variant that has been printed runs in lockstep

    Rows(cpp::Globals& globals, const ir::Pass& pass)
        : body(globals, pass), program(globals.program), pass(pass), p(body.p),
          combined(combined_bindings(program, pass)) {
        for (const auto& [binding, combine] : combined)
            body.update_names[binding] = p.names.declare(pass.bindings[binding].name + "_updates");
    }

    void print_address(const std::string& x);
    std::string type_of(const RowAccess& access);
    void print_row_pointers(const std::vector<ir::StmtId>& statements, const std::vector<RowAccess>& accesses,
                            const std::string& begin);
    std::vector<ir::StmtId> without_unused(const std::vector<ir::StmtId>& statements, IdSet<ir::Local>& read) const;
    void print_element(const std::vector<ir::StmtId>& statements);
    void print_values_at(const std::vector<ir::StmtId>& statements, const std::vector<ir::ExprId>& wanted,
                         const std::string& begin);
    void print_inside(const ir::Variant& variant, const ir::Variant& bounded, const std::string& begin,
                      const std::string& end);
    void print_strides(const std::vector<ir::StmtId>& statements, const std::string& begin, const std::string& end);
    void print_updating_loop(const ir::Variant& variant, const std::vector<ir::Stmt>& updates, const std::string& begin,
                             const std::string& end);
    void print_plain_loop(const ir::Variant& variant, const std::string& begin, const std::string& end);
    std::string chosen_row(const RowAccess& access);
    void print_element_of_run(const std::vector<ir::StmtId>& statements, const std::string& run);
    void print_run(const ir::Stmt& stmt, const std::string& run,
                   const std::function<void(const ir::Stmt&)>& print_other);
    void print_runs(const ir::Variant& variant, const std::string& begin, const std::string& end);
    void print_blocks(const ir::Variant& variant, const std::string& begin, const std::string& end);
    void print_part(const ir::Variant& variant, const std::string& begin, const std::string& end);
    void open_sections(const std::string& name, const std::string& begin, const std::string& middle,
                       const std::string& end);
    void close_sections();
    void print_loop(const ir::Variant& variant, const std::string& begin, const std::string& end);
};

}  // namespace gliftc::host
