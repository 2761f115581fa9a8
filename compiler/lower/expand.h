// From structures to memory: makes the body of a kernel that speaks of loads and stores only.
//
// Needs: a checked kernel. Guarantees: no operation of structures is left; near offsets are constants inside the
// radius; every load that could leave a structure is a guarded_load, every such store under a branch; optionals are
// pairs (has, value) wherever they need no storage; functions are inlined where that is straight-line code. Values are
// shared by node, so a body is a graph until share.h has named what is used twice.
#pragma once

#include "ir/empty.h"
#include "lower/context.h"
#include "lower/halos.h"
#include "lower/inline_size.h"
#include "lower/number.h"
#include "lower/tree_size.h"

#include <map>
#include <optional>
#include <tuple>

namespace gliftc::lower {

/// What an expression became. `has` only of an optional type: whether there is a value.
struct Pair {
    ExprId value;
    ExprId has;
};

/// Nodes that a kernel may become: ten times what the library's largest has.
constexpr std::uint32_t most_nodes = 1u << 19;

/// Expanding a kernel has made more.
struct KernelTooLarge {
    Span span;  ///< the statement that it was at
};

/// Whether near accesses check that they stay in the domain: interior bodies know it. Those of whole blocks know that
/// all elements of the block are visited, and what else they ask of a block is asked once.
enum class Guards { checked, interior, block };

/// A function that becomes statements and returns before its end: the value is in a variable, and what follows a return
/// is left out by leaving loops and by asking whether it has been reached.
struct Leaving {
    LocalId value, has;  ///< the result; absent: none
    LocalId left;        ///< a bool; absent: nothing asks
    unsigned loops = 0;  ///< of the function, around what is being expanded
};

/// One function (or the kernel) being expanded.
struct Frame {
    std::vector<ir::Place> places;  ///< of each Place root, as seen from the kernel
    FlatMap<LocalId, Pair> locals;
    const ir::Stage* stage = nullptr;  ///< in a translator's functions: whose state
    ir::Place structure;               ///< … and the structure that the stage belongs to
    std::string prefix;                ///< of names made here
    TypeId result;                     ///< of a function expanded as statements
    Leaving* leaving = nullptr;
};

class Expander {
public:
    Expander(Context& context, Guards guards) : cx(context), p(context.p), make(context.make), guards_(guards) {}

    /// The kernel's body; reports offsets that are not constant or too large.
    std::vector<StmtId> kernel_body();
    /// A part of a draw, which begins with where it is: the corner and its instance, or the pixel.
    std::vector<StmtId> draw_part(ir::Part part, const std::vector<StmtId>& body);
    void read_arguments();
    ExprId part_of(ExprId part, ExprId element);

    /// The size of the iteration: that of the first range, or a parameter.
    ExprId iteration_size();
    std::vector<StmtId> size_statements;  ///< which it needs before it

    /// Whether a near access had a guard: the interior body is different.
    bool has_near_guards = false;
    /// A near parameter whose guards were made; the interior is inside its domain.
    std::optional<std::uint32_t> near_root;
    bool near_domains_agree = true;
    ExprId near_domain;

    /// What near accesses gave that every invocation makes.
    struct NearValue {
        std::uint32_t root;
        std::vector<std::int64_t> offset;
        ExprId value;
    };
    std::vector<NearValue> near_values;
    /// Of each near parameter, what was asked for; absent where a function that is no part of the body asks.
    std::optional<NearOffsets> near_offsets = NearOffsets();
    std::vector<Halo> halos;  ///< Guards::block: what near reads from copies
    /// The guards of rows further down: at + distance < extent.
    struct RowGuard {
        ExprId condition, at, extent;
        std::int64_t distance;
    };
    std::vector<RowGuard> row_guards;

private:
    using Block = std::vector<StmtId>;

    // expand_expressions.cpp
    Pair expand(ExprId id);
    ExprId value_of(ExprId id) { return expand(id).value; }
    ExprId without_empty(ExprId whole);
    Pair expand_local(const ir::Expr& node);
    Pair expand_select(const ir::Expr& node);
    Pair expand_logical(const ir::Expr& node);
    Pair expand_again(ExprId id, const ir::Expr& node);
    Pair of_optional(ExprId whole);                ///< the pair of an optional that has storage
    ExprId stored(const Pair& pair, TypeId type);  ///< the value as its type stores it
    ExprId expand_member(const ir::Expr& node);
    ExprId expand_invocation(const ir::Expr& node);

    // divisors.cpp
    ExprId divisor(ExprId id);  ///< what is divided by instead: never zero, where that costs the shader nothing
    bool is_visited_extent(ExprId id);

    // expand_statements.cpp
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

    /// A neighbour of a block along one axis.
    struct NextBlock {
        ExprId begin, exists, room;
    };
    /// Where an offset along one axis leads: into the own block, or into the next one.
    struct Way {
        NextBlock next;
        ExprId offset;   ///< of the element, in whichever block it is
        ExprId crosses;  ///< whether that is the next one
        ExprId inside;   ///< Guards::block: whether the next one has it
        std::string name;
    };

    /// The block that the invocation's element is one of.
    struct OwnBlock {
        ExprId address;   ///< of the element, in the structure whose blocks are visited; absent: not worked out yet
        ExprId size;      ///< of the block
        ExprId last;      ///< the address of its last element
        ExprId is_there;  ///< or absent: it is
        ExprId holds;     ///< Guards::block: what else the block must be for the body to be right
        LocalId position;
        struct Axis {
            ExprId offset;       ///< of the element, in the block
            ExprId begin, last;  ///< addresses of the block
            ExprId number;       ///< that times the size is `begin`, if such a one is known
            std::uint64_t most = 0;
        };
        std::vector<Axis> axes;
        bool is_of_kernel = false;  ///< not of a function that is told where it stands
        std::map<std::tuple<std::uint32_t, std::uint32_t, std::int64_t>, Way> ways;  ///< by parameter, axis, offset
    };

    // instances.cpp
    Pair call_instance(ir::FunctionId function, std::vector<Pair> arguments, Frame frame);
    ir::FunctionId instance(ir::FunctionId function, Frame frame);
    bool sees_window(ir::FunctionId function);
    bool has_long_zero(ir::FunctionId function);
    /// Where the current element is, and what has been worked out about it.
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
    ir::FunctionId translate_of(const ir::Translator& translator, TypeId address, const ir::Structure& structure) const;
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
    ExprId centre_address(std::uint32_t root);  ///< its virtual address
    ExprId domain_of(const ir::Place& place);
    bool is_range(const ir::Place& place) const;
    ExprId range_size(std::uint32_t root);
    ExprId from_origin(const ir::Place& place, ExprId address);
    ExprId inside_domain(const ir::Place& place, ExprId address);
    ExprId inside_memory(const ir::Place& place, ExprId physical);
    ExprId all_less(ExprId address, ExprId extent);
    ExprId less_where_unknown(const ir::Structure& structure, ExprId address, ExprId extent);
    bool is_total(const ir::Structure& structure);  ///< the first translator maps every address of the domain

    // access.cpp
    ExprId element(std::uint32_t root, Span span);
    ExprId near(const ir::Expr& node);
    ExprId neighbour(const ir::Place& place, const std::vector<std::int64_t>& offset);
    ExprId read(const ir::Place& place, ExprId address, const std::string& name);
    ExprId view(const ir::Place& place, ExprId address);
    ExprId view_around(const ir::Place& place, ExprId address);
    ExprId guarded_load(const ir::Place& place, const Pair& physical, ExprId guard, ExprId safe_address,
                        ExprId otherwise, const std::string& name);
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
    /// Of the memory that elements lie in; `compare`: of a sampler that compares; `by_direction`: of a cube that is not
    /// seen as its faces.
    std::uint32_t binding(const ir::Place& place, ir::Access access, std::optional<ir::Compare> compare = {},
                          bool by_direction = false);
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
    struct Neighbours {
        std::vector<std::array<NextBlock, 3>> axes;  ///< by step + 1
        ExprId all;                                  ///< whether everything that is copied is there
        Block copies;
    };
    struct Copied {
        std::string name;
        std::vector<LocalId> loops;  ///< over the elements, one an axis
        std::vector<ExprId> limits;
        ExprId address, index, exists;
    };
    Copied places_of(const Halo& halo, const Halo::Part& part, Neighbours& found);
    Pair looked_up(const Halo& halo, const Copied& copied, Block& inner);
    Block loops_over(const Halo::Part& part, const Copied& copied, Block body);
    void copy_from(const Halo& halo, const Halo::Part& part, Neighbours& found);
    void append_where(ExprId condition, Block statements);
    void ask_for_one_origin(const Halo& halo);
    StmtId every_element(const Halo& halo, ExprId value);
    void fill(const Halo& halo);
    bool depends_on(ExprId id, const std::vector<LocalId>& locals);

    // beside.cpp
    using Ways = std::vector<const Way*>;  ///< along each axis; null: no offset
    /// A block that an offset may reach, as far as it is chosen.
    struct Beside {
        Operands address;
        std::string name;
        bool is_own;
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
    /// `count` rows of `width` neighbours, `step` addresses from one to the next. `at` is `first` from the structure's
    /// origin.
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

    // check.cpp
    bool checks_range(const ir::Place& place);
    void check_range(const ir::Place& place, ExprId address, ir::Access access, Span span);
    template <class F> auto within(F&& work) {  ///< what a translator or view does is not checked
        ++within_;
        auto result = work();
        --within_;
        return result;
    }

    // inside.cpp
    bool is_asking_inside(std::uint32_t root, ExprId condition, ExprId address);
    ExprId without_inside(std::uint32_t root, ExprId condition, ExprId address, bool& asked);

    // sample.cpp
    ExprId sample(const ir::Expr& node);
    ExprId gather(const ir::Expr& node);
    ExprId compare(const ir::Expr& node);
    /// The elements around a point, x first, and where it lies between them.
    struct Around {
        std::uint32_t axes;
        ExprId weight;
        ExprId all;  ///< the same as one vector, if they are
        Operands values;
    };
    Around around(const ir::Place& place, ExprId at);
    Around gathered(const ir::Place& place, ExprId at);
    ExprId mixed(Around found);
    bool is_gathered(const ir::Place& place);
    bool is_texel_address(const ir::Place& place);
    ExprId of_floats(TypeId type, double number);
    ExprId image_extent(const ir::Place& place);
    ExprId in_image(const ir::Place& place, ExprId at);
    ExprId sampler_point(const ir::Place& place, ExprId at);
    ExprId texel_near(const ir::Place& place, ExprId texel);
    ExprId of_image(Op op, TypeId type, std::uint32_t slot, Operands operands);

    // shared
    ir::Place resolved(const ir::Place& place) const;
    ir::Place canonical(const ir::Place& place) const;  ///< of what parameters of one structure share
    std::uint32_t canonical_root(std::uint32_t root) const;
    ExprId named(const std::string& name, ExprId value);  ///< a let, unless trivial
    void note_name(ExprId value, Name name);              ///< which the source gives it
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
    Make& make;
    Numbers numbers_{cx};
    Guards guards_;
    Frame* frame_ = nullptr;
    Block* out_ = nullptr;
    const Block* top_ = nullptr;  ///< of the kernel: no condition stands around it
    Block prelude_;               ///< comes before the body: the centre's addresses
    Span span_;                   ///< of the statement being expanded
    std::unordered_map<std::uint32_t, Pair> centres_;
    std::unordered_map<std::uint32_t, ExprId> addresses_;
    OwnBlock block_;
    std::vector<ValueNumber> known_;  ///< conditions that hold where something is being expanded
    InlineSizes inline_sizes_{cx.p};
    TreeSizes tree_sizes_{cx};
    std::unordered_map<ir::FunctionId, bool> windows_, long_zeros_;
    std::unordered_map<StmtId, bool> returning_;
    std::vector<AddressForm::Naming>* namings_ = nullptr;  ///< of the form that is being found
    std::vector<ExprId> made_again_;                       ///< for each node of a form
    bool compares_extents_ = false;                        ///< divisors.cpp
    unsigned depth_ = 0;
    LocalId window_;       ///< fragment parts: the pixel's centre from the viewport's origin, depth, 1 / w
    unsigned within_ = 0;  ///< translators and views around what is being expanded
};

}  // namespace gliftc::lower
