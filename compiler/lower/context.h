// The context of lowering one kernel in one form: what the transformations of its bodies share.
#pragma once

#include "base/id_set.h"
#include "diag/diagnostics.h"
#include "ir/pass.h"
#include "lower/analysis/number_memory.h"
#include "lower/build/builder.h"
#include "lower/lower.h"
#include "lower/trace.h"

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace gliftc::lower {

/// Identifies a lowered instance of a function: the function before lowering, which may be a translator's, the places
/// of the structures that it takes, and the stage whose translator state it reads.
struct FunctionKey {
    ir::FunctionId function;
    std::vector<std::vector<std::uint32_t>> places;  ///< for each structure its Place: root, then members
    std::vector<std::uint32_t> state;  ///< of a translator's function: place of the structure, then index of the stage
    bool is_within = false;  ///< called by a translator, a view or a function of blocks: checked builds do not check
                             ///< its accesses
    auto operator<=>(const FunctionKey&) const = default;
};

/// The code of an affine translator for one stage of one structure, with the local `address` in place of the virtual
/// address: expanded once, then copied for each address.
struct AddressForm {
    /// A name of a value, from the source or made by the expander (f_domain).
    struct Naming {
        ExprId value;
        Name name;
        bool is_prefixed = false;  ///< the name of the translated address is put before it
    };
    ir::Place place;
    const ir::Stage* stage = nullptr;
    /// Whether the code can be copied: it may be inlined, it is an expression without statements and without bindings
    /// that the pass did not have before, it uses a vector address only by its components, and whether it maps the
    /// address is known at compile time.
    bool is_known = false;
    /// address: the local that stands for the virtual address. value: the physical address. has: the condition that
    /// there is a physical address; absent if there always is one, else a constant if `is_known`.
    ExprId address, value, has;
    std::vector<ExprId> nodes;  ///< the nodes of `value` that the expansion made, operands first
    std::vector<Naming> names;
};

struct Context {
    Context(ir::Program& program, const ir::Kernel& kernel, ir::Pass& pass, Diagnostics& diagnostics, Settings settings)
        : p(program), kernel(kernel), pass(pass), diagnostics(diagnostics), checks(settings.checks),
          trace(settings.trace), build(program), first_expr{program.exprs.size()}, first_local{program.locals.size()} {}

    ir::Program& p;
    const ir::Kernel& kernel;
    ir::Pass& pass;
    Diagnostics& diagnostics;
    Checks checks;
    Trace* trace;             ///< null: nothing is traced
    bool is_stopped = false;  ///< the transformation named by --stop-after has run: later ones are skipped
    Builder build;
    /// The ids of the first nodes that this lowering makes. Nodes with smaller ids are the program's.
    ExprId first_expr;
    LocalId first_local;

    /// The values of immutable locals that `let`s of the lowered bodies declare (not all of them: `address` and
    /// `in_range`, for example, are left out).
    NodeMap<LocalId, ExprId> definitions{first_local};
    /// Names of values, from the source or made by the compiler (f_domain): for locals and parameters that passes
    /// introduce for these values.
    NodeMap<ExprId, Name> names{first_expr};
    void name(ExprId id, std::string_view text) { names.emplace(id, p.names->intern(text)); }
    std::map<FunctionKey, ir::FunctionId> instances;
    std::vector<std::unique_ptr<AddressForm>> address_forms;
    /// Results of calls whose arguments are all constants of integers, bools or enums, such as unit(2), by function and
    /// arguments. An entry with an invalid id: the call cannot be evaluated.
    std::map<std::vector<std::uint64_t>, ExprId> known_calls;
    /// The functions in `instances`. They may load, so calls of them are not uniform.
    std::unordered_set<ir::FunctionId> made_functions;
    std::vector<LocalId> params;      ///< parameters of the function whose body is being simplified
    ExprId size;                      ///< the extent of the range of Pass::address (Expander::iteration_size)
    ir::Part part = ir::Part::whole;  ///< in a kernel that draws: the part that is being lowered
    NodeMap<ExprId, std::uint32_t> uniform_sizes{first_expr};  ///< caches uniform_size
    /// Caches Numbers::traits_of (number.h). Cleared after each expansion, during which bindings may become written.
    NodeMap<ExprId, std::uint8_t> traits{first_expr};

    /// Tables of value numbering that are not in use (number_memory.h).
    std::vector<std::unique_ptr<NumberMemory>> spare_number_memory;
    std::unique_ptr<NumberMemory> take_number_memory();

    bool is_direct() const { return pass.form == ir::Form::direct; }
    bool is_wide() const { return pass.is_wide; }
    std::uint32_t parameter(ir::ParameterSource source, const std::string& name, TypeId type, std::uint32_t param);
    ExprId parameter_expr(std::uint32_t slot);
    StmtId add(ir::Stmt stmt) { return p.stmts.add(std::move(stmt)); }
    LocalId new_local(Name name, TypeId type, Span span, bool is_mutable = false);
    LocalId new_local(std::string_view name, TypeId type, Span span, bool is_mutable = false);
    const ir::Structure& structure_at(const ir::Place& place) const;
    std::string name_of(const ir::Place& place) const;  ///< a name for the place in generated code: f, f_table
};

/// The number of nodes of a uniform value: one that is the same for all invocations and that the host can compute
/// before the pass runs, with the definitions of locals substituted. 0 if the value is not uniform, or has more than
/// largest_uniform nodes, since substitution can double the size with each local.
std::uint32_t uniform_size(Context& cx, ExprId id);
constexpr std::uint32_t largest_uniform = 1024;
inline bool is_uniform(Context& cx, ExprId id) { return uniform_size(cx, id) != 0; }

/// Whether the expression is so short that a local for it is not worth it: a constant, parameter, builtin, immutable
/// local or property of a structure, or a component, field or optional's part of one.
bool is_trivial(const Context& cx, ExprId id);

}  // namespace gliftc::lower
