// long: the methods of one class, which are defined in several files
// The pass "expand": from structures to memory. Makes a body of loads and stores out of a kernel's body, whose
// operations access elements of structures. The Expander's private methods are in the files named below.
//
// Needs: a kernel that sema accepts. Guarantees: no operation of structures is left; if the offset of a `near` read is
// not a constant within the parameter's radius, an error was reported; every load that could be outside a structure is
// a guarded_load or under a branch (but see rows.cpp for whole vectors), every such store is under a branch; optionals
// are pairs (has, value) wherever they need no storage; functions are inlined where inline.cpp and inline_size.h allow
// it. A value that is used twice is one node with two parents, until share.h gives it a local.
#pragma once

#include "ir/empty.h"
#include "lower/analysis/inline_size.h"
#include "lower/analysis/number.h"
#include "lower/analysis/tree_size.h"
#include "lower/analysis/unroll.h"
#include "lower/context.h"
#include "lower/expand/halos.h"

#include <map>
#include <optional>
#include <tuple>

namespace gliftc::lower {

/// The result of expanding an expression. `has` is present for optional types only: whether there is a value. Also a
/// physical address, where `has` is the condition that the address is mapped; absent: it always is.
struct Pair {
    ExprId value;
    ExprId has;
};

/// The limit of the expression nodes that lowering a kernel to one form makes, tested while a body is expanded: several
/// times what the largest kernel in stdlib needs.
constexpr std::uint32_t most_nodes = 1u << 19;

/// Thrown by the expansion of a body when there are more than most_nodes nodes.
struct KernelTooLarge {
    Span span;  ///< the statement that was being expanded
};

/// The number of neighbour reads that a body may have after unrolling: a square window of the largest radius, 65 x 65.
/// Time and memory of lowering grow faster than this number.
constexpr std::uint32_t most_near_reads = near_unroll_limit;

/// Thrown by the expansion of a body that has more than most_near_reads.
struct TooManyNearReads {
    Span span;            ///< of the read
    std::uint32_t param;  ///< what it reads
};

/// Which body is made. checked: valid for every element, neighbour reads test that they are in the domain. interior:
/// all neighbours are known to be in the domain. block: all elements of a block are known to be visited, and other
/// conditions that depend on the block alone are tested once for it.
enum class Guards { checked, interior, block };

/// For a function that is expanded as statements and returns before its end. The result is in variables; a return sets
/// them and leaves the enclosing loops of the function. Statements after it are put into the other side of an `if`, or
/// test `left`.
struct Leaving {
    LocalId value, has;  ///< variables of the result; `value` absent: it has no data; `has` absent: it is no optional
    LocalId left;        ///< a bool variable: a return was executed; absent: nothing tests it
    unsigned loops = 0;  ///< how many loops of the function enclose the statement that is being expanded
};

/// The function (or kernel) that is being expanded.
struct Frame {
    std::vector<ir::Place> places;  ///< for each Place::root in its body, that structure's place seen from the kernel
    FlatMap<LocalId, Pair> locals;
    const ir::Stage* stage = nullptr;  ///< in a translator's functions: the entry of `via` that gives its state
    ir::Place structure;               ///< in a translator's functions: the structure that has this `via`
    std::string prefix;                ///< put before the names of locals that are made; may be empty
    TypeId result;                     ///< of a function that is not expanded as an expression: its result type
    Leaving* leaving = nullptr;        ///< of a function expanded as statements that returns before its end; else null
};

class Expander {
public:
    Expander(Context& context, Guards guards) : cx(context), p(context.p), build(context.build), guards_(guards) {}

    /// The kernel's body. Reports offsets of `near` reads that are not constant or exceed the radius.
    std::vector<StmtId> kernel_body();
    /// The body of a part of a draw. It begins with the address: the vertex and instance index, or the pixel.
    std::vector<StmtId> draw_part(ir::Part part, const std::vector<StmtId>& body);
    void read_arguments();
    ExprId part_of(ExprId part, ExprId element);

    /// The extent of the range of Pass::address: the domain of a visited structure, or a parameter
    /// (ir::ParameterSource::size).
    ExprId iteration_size();
    std::vector<StmtId> size_statements;  ///< statements that iteration_size needs before it

    /// Whether some neighbour read has a guard, so that an interior variant would differ.
    bool has_near_guards = false;
    std::optional<std::uint32_t> near_root;  ///< the first near parameter whose reads have guards
    bool near_domains_agree = true;          ///< all near parameters whose reads have guards have near_root's domain
    ExprId near_domain;                      ///< near_root's domain, whose inner part the interior variant is for

    /// A read by `near`, at any offset, that no condition or loop encloses; and its value.
    struct NearValue {
        std::uint32_t root;
        std::vector<std::int64_t> offset;
        ExprId value;
    };
    std::vector<NearValue> near_values;
    std::uint32_t near_reads = 0;  ///< neighbour reads expanded up to now
    /// For kernels over blocks, the offsets at which each near parameter is read; only offset zero for a structure that
    /// may map addresses outside its domain, and where blocks may begin anywhere. Absent if a function that is not
    /// inlined reads neighbours.
    std::optional<NearOffsets> near_offsets = NearOffsets();
    std::vector<Halo> halos;  ///< with Guards::block: the local copies from which neighbours are read
    /// The test along y of a neighbour read whose offset is positive along y: at + distance < extent.
    struct RowGuard {
        ExprId condition, at, extent;
        std::int64_t distance;
    };
    std::vector<RowGuard> row_guards;

private:
    using Block = std::vector<StmtId>;

    // expressions.cpp
    Pair expand(ExprId id);
    ExprId value_of(ExprId id) { return expand(id).value; }
    ExprId without_empty(ExprId whole);
    Pair expand_empty(ExprId id);
    void expand_effects(ExprId id);  ///< for an expression whose value is not used: makes only its effects, if any
    Pair expand_local(const ir::Expr& node);
    Pair expand_select(const ir::Expr& node);
    Pair expand_logical(const ir::Expr& node);
    Pair expand_again(ExprId id, const ir::Expr& node);
    Pair workgroup_atomic(ExprId id, const ir::Expr& node);
    Pair of_optional(ExprId whole);                ///< the pair for an optional that is stored as one value
    ExprId stored(const Pair& pair, TypeId type);  ///< one value of the type; an optional is made of the pair
    ExprId expand_member(const ir::Expr& node);
    ExprId expand_invocation(const ir::Expr& node);

    // divisors.cpp
    /// The divisor; or its maximum with 1, if it is unsigned, depends on the state of structures alone, and is neither
    /// a constant nor an extent that is known not to be zero.
    ExprId divisor(ExprId id);
    bool is_visited_extent(ExprId id);

    // statements.cpp
    std::vector<StmtId> expanded_body(const std::vector<StmtId>& written);
    void expand_body(const std::vector<StmtId>& body);
    void expand_statement(StmtId id);
    void expand_let(const ir::Stmt& stmt);
    void expand_assign(const ir::Stmt& stmt);
    void expand_if(const ir::Stmt& stmt);
    void expand_for(const ir::Stmt& stmt);
    void expand_while(const ir::Stmt& stmt);
    void expand_return(const ir::Stmt& stmt);
    ExprId expand_target(ExprId id);
    void zero_by_loops(const std::string& name, ExprId target);
    Block nested(const std::vector<StmtId>& body);
    Block looped(const std::vector<StmtId>& body);

    // inline.cpp
    Pair expand_call(const ir::Expr& node);
    ExprId known_call(const ir::Expr& node, const std::vector<Pair>& arguments);
    bool may_not_end(ir::FunctionId function);
    ir::FunctionId kept_in_kernel(ir::FunctionId id);
    Pair inlined(ir::FunctionId function, std::vector<Pair> arguments, Frame frame);
    Pair bounded(const std::string& name, Pair pair);
    Pair run(const std::vector<StmtId>& body);
    ExprId decided(ExprId condition);
    Pair run_returning_if(const ir::Stmt& stmt, const std::vector<StmtId>& rest);
    void run_if(const ir::Stmt& stmt);
    void run_assign(const ir::Stmt& stmt);
    ExprId replaced(ExprId target, ExprId value);
    Pair merged(ExprId condition, Block yes, Pair a, Block no, Pair b, TypeId type);
    bool is_speculatable(const Block& block);

    // statement_calls.cpp
    Pair expand_as_statements(const ir::Expr& node);
    Pair leave_early(const ir::Function& function, const std::string& name);
    void expand_leaving(const std::vector<StmtId>& body);
    void expand_leave(const ir::Stmt& stmt);
    bool expand_past(const ir::Stmt& stmt, const std::vector<StmtId>& rest);
    bool asks_whether_left(const std::vector<StmtId>& body, bool is_in_loop) const;

    /// The adjacent block along one axis, on one side: its first address along the axis (`begin`), whether that is in
    /// the domain (`exists`), and on the upper side how many addresses the domain has beyond the own block (`room`).
    struct NextBlock {
        ExprId begin, exists, room;
    };
    /// Where the neighbour at an offset along one axis lies: in the own block or in the adjacent one.
    struct Way {
        NextBlock next;
        ExprId offset;   ///< the neighbour's position along the axis, in whichever block it lies
        ExprId crosses;  ///< whether it lies in the adjacent block
        ExprId inside;   ///< with Guards::block: whether it is in the domain, if it lies in the adjacent block
        std::string name;
    };

    /// The block that the invocation's element belongs to.
    struct OwnBlock {
        ExprId address;   ///< the element's address in the structure whose blocks are visited; absent: not computed yet
        ExprId size;      ///< the block's size
        ExprId last;      ///< the address of its last element
        ExprId is_there;  ///< whether the block exists; absent: it does
        ExprId holds;     ///< with Guards::block: further conditions on the block under which the body is valid
        LocalId position;  ///< the element's position in the block, as one number
        struct Axis {
            ExprId offset;           ///< the element's position in the block along the axis
            ExprId begin, last;      ///< the block's first and last address along the axis
            ExprId number;           ///< begin / size, if `begin` is known to be a multiple of size; else absent
            std::uint64_t most = 0;  ///< the largest value of `number`
        };
        std::vector<Axis> axes;
        bool is_of_kernel = false;  ///< false in a function that is not inlined and is passed the element's address
        std::map<std::tuple<std::uint32_t, std::uint32_t, std::int64_t>, Way> ways;  ///< by parameter, axis, offset
    };

    // instances.cpp
    Pair call_instance(ir::FunctionId function, std::vector<Pair> arguments, Frame frame);
    ir::FunctionId instance(ir::FunctionId function, Frame frame);
    bool sees_window(ir::FunctionId function);
    bool has_long_zero(ir::FunctionId function);
    /// The current element's address, and what has been computed from it.
    struct Current {
        LocalId address, in_range;
        Block prelude;
        std::unordered_map<std::uint32_t, Pair> centres;
        std::unordered_map<std::uint32_t, ExprId> addresses;
        OwnBlock block;
    };
    Current enter_window(ir::Function& made);
    void leave_window(ir::Function& made, Current outer);

    // address_form.cpp
    Pair through_form(const ir::Place& place, const ir::Stage& stage, ExprId address, const std::string& name);
    const AddressForm& form_of(const ir::Place& place, const ir::Stage& stage, TypeId address);
    void find_form(AddressForm& form, TypeId address);
    ir::FunctionId translate_of(const ir::Stage& stage) const;  // in translate.cpp
    bool collect_nodes(AddressForm& form, ExprId first);
    Pair made_again(const AddressForm& form, ExprId address, const std::string& name);
    bool varies_in_all(ExprId address);

    // translate.cpp
    Pair linked(const ir::Place& place, ExprId address, const std::string& name);
    template <class Asks> Pair chained(const ir::Place& place, ExprId address, const std::string& name, Asks&& asks);
    Pair translated(const ir::Place& place, ExprId address, const std::string& name);
    Pair written(const ir::Place& place, ExprId address, const std::string& name);
    Pair written_centre(std::uint32_t root);
    std::string link_name(const ir::Place& link) const;
    Pair expanded(const ir::Place& place, const ir::Stage& stage, ExprId address, const std::string& name);
    Pair centre(std::uint32_t root);            ///< physical address of the current element
    ExprId centre_address(std::uint32_t root);  ///< virtual address of the current element
    ExprId domain_of(const ir::Place& place);
    bool is_range(const ir::Place& place) const;
    ExprId range_size(std::uint32_t root);
    ExprId from_origin(const ir::Place& place, ExprId address);
    ExprId inside_domain(const ir::Place& place, ExprId address);
    ExprId inside_memory(const ir::Place& place, ExprId physical);
    ExprId all_less(ExprId address, ExprId extent);
    ExprId less_where_unknown(const ir::Structure& structure, ExprId address, ExprId extent);
    bool is_total(const ir::Structure& structure);  ///< the chain's first translator is not partial, or there is none

    // access.cpp
    ExprId element(std::uint32_t root, Span span);
    ExprId near(const ir::Expr& node);
    std::vector<std::uint32_t> fields_along(const ir::Place& place) const;
    ExprId near_at(const ir::Place& place, const std::vector<std::int64_t>& offset, Span span);
    ExprId neighbour(const ir::Place& place, const std::vector<std::int64_t>& offset);
    ExprId read(const ir::Place& place, ExprId address, const std::string& name);
    ExprId view(const ir::Place& place, ExprId address);
    ExprId view_around(const ir::Place& place, ExprId address);
    ExprId guarded_load(const ir::Place& place, const Pair& physical, ExprId guard, ExprId safe_address,
                        ExprId otherwise, const std::string& name);
    ExprId guarded_field(const ir::Place& place, const Pair& at, ExprId safe, ExprId otherwise,
                         const std::string& name);
    bool is_apart(const ir::Place& place) const;
    template <class FieldOf> ExprId gathered_fields(const ir::Place& place, TypeId whole,
                                                    const std::vector<std::uint32_t>& above, FieldOf&& field_of);
    template <class FieldOf> ExprId gathered(const ir::Place& place, FieldOf&& field_of);
    ExprId projected(const ir::Place& place, const ir::Structure& link, ExprId element);
    ExprId projected(const ir::Place& place, ExprId element);
    ExprId load(const ir::Place& place, ExprId physical);
    ExprId computed(const ir::Place& place, ExprId address, ExprId condition, ExprId otherwise,
                    const std::string& name);
    ExprId otherwise_of(const ir::Place& place);
    ExprId otherwise_around(const ir::Place& place);
    void set_element(const ir::Stmt& stmt);
    void write(const ir::Stmt& stmt);
    void store(const ir::Place& place, const Pair& physical, ExprId guard, const ir::Stmt& stmt, ExprId value);
    Pair atomic(const ir::Expr& node);
    bool is_coherent(const ir::Place& place) const;
    /// The index of the pass's binding for the memory that the elements at a place lie in; adds one if there is none.
    /// `compare`: a sampler that compares depths in this way. `by_direction`: a cube map is bound as a cube, which is
    /// sampled by a direction, instead of as an array of six images.
    std::uint32_t binding(const ir::Place& place, ir::Access access, std::optional<ir::Compare> compare = {},
                          bool by_direction = false);
    std::uint32_t bound(const ir::Place& place, std::uint32_t memory, const std::vector<std::uint32_t>& fields,
                        ir::Access access, std::optional<ir::Compare> compare = {}, bool by_direction = false);
    std::optional<std::vector<std::int64_t>> offset_of(const ir::Expr& node);
    ExprId near_guard(std::uint32_t root, const std::vector<std::int64_t>& offset);
    void note_near_guard(std::uint32_t root);

    // blocks.cpp
    ExprId visited_size();
    Pair of_owner(ir::FunctionId function, std::vector<Pair> arguments);
    ExprId quotient_of(ExprId value, std::uint64_t divisor);
    OwnBlock::Axis block_along(std::uint32_t axis, ExprId first, ExprId size);
    void enter_block();
    ExprId visited_address();
    bool is_at_multiples();
    ExprId origin_of(std::uint32_t root);
    ExprId relative_address();
    ExprId address_in_block(std::uint32_t root);
    ExprId is_element_there();
    ExprId is_block_there();
    bool is_of_block(ExprId id);
    bool is_value_of_block(StmtId id);
    ExprId without_block_tests(ExprId condition);
    Block visited_block(Block body);

    // halos.cpp
    Halo* halo_of(std::uint32_t root);
    ExprId in_halo(Halo& halo, const std::vector<std::int64_t>& offset);
    NextBlock next_block(std::uint32_t root, std::uint32_t width, std::uint32_t axis, int step);
    /// The blocks around the own one, while the code that copies from them is made.
    struct Neighbours {
        std::vector<std::array<NextBlock, 3>> axes;  ///< for each axis the blocks at step -1, 0, 1
        ExprId all;                                  ///< a condition under which all elements to be copied exist
        Block copies;                                ///< the statements that copy
    };
    /// The loops that copy one part of a halo, one element per iteration. `address`: the element's address in the
    /// structure; `index`: its index in the copy; `exists`: whether the block that it lies in is in the domain.
    struct Copied {
        std::string name;
        std::vector<LocalId> loops;  ///< the loops' variables, one per axis
        std::vector<ExprId> limits;  ///< the loops' limits, one per axis
        ExprId address, index, exists;
    };
    Copied places_of(const Halo& halo, const Halo::Part& part, Neighbours& found);
    Pair looked_up(const Halo& halo, const Copied& copied, Block& inner);
    Block loops_over(const Halo::Part& part, const Copied& copied, Block body);
    void copy_from(const Halo& halo, const Halo::Part& part, Neighbours& found);
    void append_where(ExprId condition, Block statements);
    void require_equal_origin(std::uint32_t root);
    StmtId every_element(const Halo& halo, ExprId value);
    void fill(const Halo& halo);
    bool depends_on(ExprId id, const std::vector<LocalId>& locals);

    // neighbour_blocks.cpp
    using Ways = std::vector<const Way*>;  ///< one per axis; null: the offset is zero along it
    /// A block in which a neighbour may lie. It is chosen axis by axis, from x on.
    struct Beside {
        Operands address;  ///< the neighbour's address along the axes for which the block is chosen already
        std::string name;
        bool is_own;  ///< along these axes it is the own block
    };
    std::optional<Pair> beside(const ir::Place& place, const std::vector<std::int64_t>& offset);
    const Way& way_along(std::uint32_t root, std::uint32_t axis, std::int64_t offset);
    std::optional<Pair> choose_block(const ir::Place& place, const Ways& ways, Beside at);
    std::optional<Pair> place_in_block(const ir::Place& place, ExprId address, const std::string& name);
    bool is_loaded_by_element(ExprId id);
    ExprId chosen(ExprId condition, ExprId yes, ExprId no);

    // raster.cpp
    void declare_address(ir::Part part);
    ExprId viewport_origin();
    ExprId window();
    ExprId own_address(std::uint32_t root);

    // rows.cpp
    ExprId several(const ir::Expr& node);
    void write_several(const ir::Stmt& stmt);
    /// `count` rows of `width` elements that are consecutive along x; rows begin `step` addresses apart. `first` is the
    /// first element's address relative to the range, `at` its address in the structure.
    struct Rows {
        ir::Place place;
        std::string name;
        ExprId first, at, step;
        std::uint32_t count = 0, width = 0;
    };
    Rows rows_of(const ir::Place& place, ExprId address, ExprId step, TypeId array);
    template <class Body> void for_each_row(const Rows& rows, Body&& body);
    ExprId item_of(const Rows& rows, ExprId items, ExprId row, std::uint32_t lane);
    ExprId further(ExprId address, ExprId distance);
    ExprId address_in(const Rows& rows, ExprId row, std::uint32_t lane);
    bool lie_in_vectors(const Rows& rows);
    bool is_at_vector(ExprId physical);
    bool is_whole_vector(const Rows& rows, ExprId physical);
    std::optional<std::uint64_t> span_of(const Rows& rows);
    ExprId are_vectors(const Rows& rows, ExprId physical);
    std::uint32_t parts_of(const Rows& rows);
    ExprId first_vector(const Rows& rows, ExprId physical);
    ExprId vector_at(const Rows& rows, ExprId first_vector, ExprId row, std::uint32_t part);
    ExprId number_in(const std::vector<ExprId>& vectors, std::uint32_t i);
    ExprId element_in(const Rows& rows, const std::vector<ExprId>& vectors, std::uint32_t lane);
    ExprId vector_of(const Rows& rows, ExprId items, ExprId row, std::uint32_t part);

    // print.cpp
    void print(const ir::Stmt& stmt);
    ExprId visited_element();

    // check.cpp
    bool checks_range(const ir::Place& place);
    void check_range(const ir::Place& place, ExprId address, ir::Access access, Span span);
    /// Runs `work` for code of a translator, view or function of blocks, whose accesses are not checked (check.cpp).
    template <class F> auto within(F&& work) {
        ++within_;
        auto result = work();
        --within_;
        return result;
    }

    // inside.cpp
    bool is_asking_inside(std::uint32_t root, ExprId condition, ExprId address);
    ExprId without_inside(std::uint32_t root, ExprId condition, ExprId address, bool& asked);
    bool may_map_outside(std::uint32_t root);
    bool is_none_outside(const ir::Place& place);

    // sample.cpp
    ExprId sample(const ir::Expr& node);
    ExprId gather(const ir::Expr& node);
    ExprId compare(const ir::Expr& node);
    /// The elements around a point, from which linear interpolation gives the value there.
    struct Around {
        std::uint32_t axes;  ///< along how many axes it is interpolated: 2^axes elements
        ExprId weight;       ///< where the point lies between them: along each axis from 0 to 1
        ExprId all;          ///< `values` as one vector, if the device gathers them; else absent
        Operands values;     ///< the elements, x advancing first
    };
    Around around(const ir::Place& place, ExprId at);
    Around gathered(const ir::Place& place, ExprId at);
    ExprId mixed(Around found);
    ExprId mixed(ExprId one, ExprId other, ExprId weight);
    bool is_gathered(const ir::Place& place);
    bool is_texel_address(const ir::Place& place);
    ExprId of_floats(TypeId type, double number);
    ExprId image_extent(const ir::Place& place);
    ExprId in_image(const ir::Place& place, ExprId at);
    ExprId sampler_point(const ir::Place& place, ExprId at);
    ExprId texel_near(const ir::Place& place, ExprId texel);
    ExprId of_image(Op op, TypeId type, std::uint32_t slot, Operands operands);

    // expressions.cpp: for the other files
    ir::Place resolved(const ir::Place& place) const;
    /// In the direct form: the same path of members, but from the parameter that stands for all parameters with the
    /// same state (KernelParam::alike). In other forms the place itself.
    ir::Place canonical(const ir::Place& place) const;
    std::uint32_t canonical_root(std::uint32_t root) const;
    bool is_of_one_whole(std::uint32_t root) const;
    /// Makes a `let` of the value, unless it is trivial (is_trivial) or uniform; gives a uniform value the name.
    ExprId named(const std::string& name, ExprId value);
    void note_name(ExprId value, Name name);  ///< notes the name that the source gives to a value
    ExprId guarded_load_of(ExprId value) const;
    LocalId let(const std::string& name, ExprId value, Span span);
    LocalId variable(const std::string& name, TypeId type, ExprId value);
    void assign(LocalId local, ExprId value);
    void append_if(ExprId condition, Block yes, Block no);
    std::string prefixed(std::string_view name) const;
    void append(ir::Stmt stmt) { out_->push_back(cx.add(std::move(stmt))); }
    template <class F> Block collect(F&& make_statements) {
        Block block;
        Block* outer = out_;
        out_ = &block;
        make_statements();
        out_ = outer;
        return block;
    }
    template <class F> auto inside(Frame frame, F&& work) {
        Frame* outer = frame_;
        frame_ = &frame;
        auto result = work();
        frame_ = outer;
        return result;
    }

    Context& cx;
    ir::Program& p;
    Builder& build;
    Numbers numbers_{cx};
    Guards guards_;
    Frame* frame_ = nullptr;
    Block* out_ = nullptr;
    const Block* top_ = nullptr;  ///< the kernel's top-level statements, which no condition or loop encloses
    Block prelude_;               ///< statements before the body, mostly addresses of the current element
    Span span_;                   ///< source location of the statement that is being expanded
    std::unordered_map<std::uint32_t, Pair> centres_;
    std::unordered_map<std::uint32_t, bool> may_map_outside_;  ///< what may_map_outside found, by parameter
    std::unordered_map<std::uint32_t, ExprId> addresses_;
    OwnBlock block_;
    std::vector<std::uint32_t> equal_origins_;  ///< parameters that require_equal_origin() was called for
    /// A condition whose value is known for the code that is being expanded.
    struct Fact {
        ValueNumber condition;
        bool holds = true;
    };
    std::vector<Fact> known_;
    InlineSizes inline_sizes_{cx.p};
    TreeSizes tree_sizes_{cx};
    std::unordered_map<ir::FunctionId, bool> windows_, long_zeros_, endless_;
    std::unordered_map<ir::FunctionId, ir::FunctionId> kept_;  ///< the results of kept_in_kernel
    std::unordered_map<StmtId, bool> returning_;
    std::vector<AddressForm::Naming>* namings_ = nullptr;  ///< names of the address form that is being made
    std::vector<ExprId> made_again_;                       ///< scratch: copies of an address form's nodes
    bool compares_extents_ = false;                        ///< see divisors.cpp
    unsigned depth_ = 0;
    LocalId window_;       ///< in fragment parts: the pixel's centre relative to the viewport's origin, depth, 1 / w
    unsigned within_ = 0;  ///< how many translators, views and functions of blocks enclose the code that is expanded
};

}  // namespace gliftc::lower
