// What the passes over one kernel in one form share.
#pragma once

#include "base/id_set.h"
#include "diag/diagnostics.h"
#include "ir/pass.h"
#include "lower/lower.h"
#include "lower/make.h"
#include "lower/number_memory.h"
#include "lower/trace.h"

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace gliftc::lower {

/// A function made for this pass: a function or a stage's translate, with its structures and state at these places.
struct FunctionKey {
    ir::FunctionId function;
    std::vector<std::vector<std::uint32_t>> places;  ///< of each structure: root, then members
    std::vector<std::uint32_t> state;                ///< translators: place of the structure, then the stage
    bool is_within = false;                          ///< called by a translator or view, whose accesses are not checked
    auto operator<=>(const FunctionKey&) const = default;
};

/// What an affine translator makes of an address: made once with a local in place of the address, and made again for
/// each one.
struct AddressForm {
    struct Naming {
        ExprId value;
        Name name;
        bool is_prefixed = false;  ///< with the name of what is translated
    };
    ir::Place place;
    const ir::Stage* stage = nullptr;
    bool is_known = false;  ///< otherwise it needs statements, or depends on more than components: each one is expanded
    ExprId address, value, has;
    std::vector<ExprId> nodes;  ///< that the value is made of, operands first
    std::vector<Naming> names;
};

struct Context {
    Context(ir::Program& program, const ir::Kernel& kernel, ir::Pass& pass, Diagnostics& diagnostics, Settings settings)
        : p(program), kernel(kernel), pass(pass), diagnostics(diagnostics), checks(settings.checks),
          trace(settings.trace), make(program), first_expr{program.exprs.size()}, first_local{program.locals.size()} {}

    ir::Program& p;
    const ir::Kernel& kernel;
    ir::Pass& pass;
    Diagnostics& diagnostics;
    Checks checks;
    Trace* trace;             ///< or nothing is shown
    bool is_stopped = false;  ///< --stop-after has been reached: what follows is left out
    Make make;
    /// What was made before does not belong to this pass alone.
    ExprId first_expr;
    LocalId first_local;

    /// The value of each immutable local that a `let` of this pass declares.
    NodeMap<LocalId, ExprId> definitions{first_local};
    /// What a value was called in the source; used where it gets a name of its own.
    NodeMap<ExprId, Name> names{first_expr};
    void name(ExprId id, std::string_view text) { names.emplace(id, p.names->intern(text)); }
    std::map<FunctionKey, ir::FunctionId> instances;
    std::vector<std::unique_ptr<AddressForm>> address_forms;
    std::map<std::vector<std::uint64_t>, ExprId> known_calls;  ///< by function and integers: unit(2)
    std::unordered_set<ir::FunctionId> made_functions;         ///< the values of instances: they may load
    std::vector<LocalId> params;                               ///< of the function whose body is being simplified
    ExprId size;                                               ///< the iteration's size
    ir::Part part = ir::Part::whole;                           ///< of a draw: the body that is being made
    NodeMap<ExprId, std::uint32_t> uniform_sizes{first_expr};
    NodeMap<ExprId, std::uint8_t> traits{first_expr};  ///< of number.h; valid once the bindings' access is settled

    std::vector<std::unique_ptr<NumberMemory>> spare_number_memory;
    std::unique_ptr<NumberMemory> take_number_memory();

    bool is_direct() const { return pass.form == ir::Form::direct; }
    bool is_wide() const { return pass.form == ir::Form::wide; }
    std::uint32_t parameter(ir::ParameterSource source, const std::string& name, TypeId type, std::uint32_t param);
    ExprId parameter_expr(std::uint32_t slot);
    StmtId add(ir::Stmt stmt) { return p.stmts.add(std::move(stmt)); }
    LocalId new_local(Name name, TypeId type, Span span, bool is_mutable = false);
    LocalId new_local(std::string_view name, TypeId type, Span span, bool is_mutable = false);
    const ir::Structure& structure_at(const ir::Place& place) const;
    std::string name_of(const ir::Place& place) const;  ///< f, f_table
};

/// Nodes of a value that is the same for all invocations and that the host computes before the pass runs, as the host
/// has it: written out, without locals. 0 where it is none, and beyond largest_uniform: what doubles with each step
/// would never end.
std::uint32_t uniform_size(Context& cx, ExprId id);
constexpr std::uint32_t largest_uniform = 1024;
inline bool is_uniform(Context& cx, ExprId id) { return uniform_size(cx, id) != 0; }

/// Whether it is a name or a number: worth no local of its own.
bool is_trivial(const Context& cx, ExprId id);

}  // namespace gliftc::lower
