#include "ir/implied_type.h"
#include "ir/levels.h"
#include "ir/reader.h"
#include "ir/spelling.h"

#include <cctype>
#include <charconv>
#include <limits>

namespace gliftc::ir {

namespace {

/// The number in `called` if it is "state" and a number, the text of Op::state; else absent.
std::optional<std::uint32_t> state_slot(const std::string& called) {
    const std::string_view prefix = "state";
    const bool is_state = called.starts_with(prefix) && called.size() > prefix.size() &&
                          called.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
    if (!is_state) return std::nullopt;
    return static_cast<std::uint32_t>(std::stoul(called.substr(prefix.size())));
}

constexpr std::string_view binary_signs[] = {"<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "*",
                                             "/",  "%",  "+",  "-",  "<",  ">",  "&",  "^",  "|"};

}  // namespace

ExprId Reader::add(Expr node) { return p.exprs.add(std::move(node)); }

ExprId Reader::implied(Expr node) {
    node.type = implied_type(p, &current(), node, [&](const Type& type) { return p.types.intern(type); });
    return add(std::move(node));
}

Operands Reader::list() {
    Operands operands;
    expect("(");
    while (!accept(")")) {
        operands.push_back(expr());
        accept(",");
    }
    return operands;
}

ExprId Reader::expr() {
    const ExprId left = operand();
    if (accept("?")) {
        const ExprId yes = operand();
        expect(":");
        return implied({.op = Op::select, .operands = {left, yes, operand()}});
    }
    for (std::string_view sign : binary_signs) {
        // binary_signs has neither the '=' of an assignment nor the '..' of a loop's bounds.
        if (!accept(sign)) continue;
        const BinaryOp op = *spelled(sign, BinaryOp::logical_or);
        return implied({.op = Op::binary, .binary = op, .operands = {left, operand()}});
    }
    return left;
}

/// Whether the text begins with a number, without its sign.
static bool is_number(std::string_view text) {
    const auto is_of_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    if (!text.empty() && std::isdigit(static_cast<unsigned char>(text[0]))) return true;
    return text.starts_with("inf") && (text.size() == 3 || !is_of_word(text[3]));
}

ExprId Reader::operand() {
    for (std::string_view sign : {"-", "!", "~"}) {
        if (!at(sign)) continue;
        if (sign == "-" && is_number(text_.substr(at_ + 1))) break;  // a literal
        expect(sign);
        return implied({.op = Op::unary, .unary = *spelled(sign, UnaryOp::bit_not), .operands = {operand()}});
    }
    return postfix(primary());
}

ExprId Reader::postfix(ExprId whole) {
    while (true) {
        if (at("..")) return whole;
        if (accept(".row[")) {
            const ExprId at = expr();
            expect("]");
            whole = implied({.op = Op::row_item, .operands = {whole, at}});
        } else if (accept("[")) {
            const ExprId at = expr();
            expect("]");
            whole = implied({.op = Op::index, .operands = {whole, at}});
        } else if (accept(".")) {
            whole = after_dot(whole);
        } else {
            return whole;
        }
    }
}

ExprId Reader::after_dot(ExprId whole) {
    const Type of = p.types[type_of(whole)];
    const std::string called = word();
    if (of.kind == TypeKind::struct_) {
        const auto& fields = p.structs[of.struct_].fields;
        for (std::uint32_t i = 0; i < fields.size(); ++i)
            if ((*p.names)[fields[i].name] == called) return implied({.op = Op::field, .slot = i, .operands = {whole}});
        fail("expected a field before this");
    }
    Expr node{.op = Op::swizzle, .operands = {whole}};
    for (std::size_t i = 0; i < called.size(); ++i) {
        const auto lane = std::string_view("xyzw").find(called[i]);
        if (i >= node.lanes.size() || lane == std::string_view::npos) fail("expected components before this");
        node.lanes[i] = static_cast<std::uint8_t>(lane);
    }
    node.type = p.types.vector(p.types.scalar_of(type_of(whole)), static_cast<std::uint32_t>(called.size()));
    return add(std::move(node));
}

ExprId Reader::literal() {
    const bool is_negative = accept("-");
    Expr node;
    if (accept("inf") || accept("nan")) {
        node.number =
            text_[at_ - 1] == 'f' ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
        if (is_negative) node.number = -node.number;
        node.type = p.types.float_;
        return add(std::move(node));
    }
    const char* const begin = text_.data() + at_;
    // In `0..8` the dots are not part of the number before them.
    const std::size_t dots = text_.find("..", at_);
    const char* const end = text_.data() + std::min(dots, text_.size());
    double number = 0;
    std::uint64_t whole = 0;
    const char* const after = std::from_chars(begin, end, number).ptr;
    const bool is_whole = std::from_chars(begin, end, whole).ptr == after;
    if (after == begin) fail("expected a value");
    at_ = static_cast<std::size_t>(after - text_.data());
    if (accept("h")) node.type = p.types.half;
    else if (accept("d")) node.type = p.types.double_;
    else if (accept("ul")) node.type = p.types.uint64;
    else if (accept("u")) node.type = p.types.uint;
    else if (accept("l")) node.type = p.types.int64;
    else node.type = is_whole ? p.types.int_ : p.types.float_;
    if (p.types.is_floating(node.type)) node.number = is_negative ? -number : number;
    else node.bits = is_negative ? 0 - whole : whole;
    return add(std::move(node));
}

/// Reads the rest of "( expr )" or "( expr : type )".
ExprId Reader::parenthesized() {
    const ExprId inside = expr();
    if (accept(":")) p.exprs[inside].type = type();
    expect(")");
    return inside;
}

/// Reads what begins with a type: a constant of an enum, a conversion, or a construction. With a single operand that
/// has the same shape, or is of an enum, it is a conversion.
ExprId Reader::made_of_type() {
    const TypeId made = type();
    if (p.types.kind(made) == TypeKind::enum_) {
        expect(".");
        const std::string called = word();
        const Enum& of = p.enums[p.types[made].enum_];
        for (std::size_t i = 0; i < of.values.size(); ++i)
            if ((*p.names)[of.enumerators[i]] == called) return add({.type = made, .bits = of.values[i]});
        fail("expected an enumerator before this");
    }
    Operands parts = list();
    const Types& types = p.types;
    const auto is_shaped = [&](TypeId id) { return types.is_scalar(id) || types.is_vector(id) || types.is_matrix(id); };
    const auto same_shape = [&](TypeId a, TypeId b) {
        return types.kind(a) == types.kind(b) || (types.is_scalar(a) && types.is_scalar(b));
    };
    const bool is_converted = parts.size() == 1 && is_shaped(made) && same_shape(made, type_of(parts[0])) &&
                              types.components(made) == types.components(type_of(parts[0]));
    const bool is_of_enum = parts.size() == 1 && types.kind(type_of(parts[0])) == TypeKind::enum_;
    const Op op = is_converted || is_of_enum ? Op::convert : Op::construct;
    return add({.op = op, .type = made, .operands = std::move(parts)});
}

ExprId Reader::intrinsic(const std::string& called) {
    for (std::uint32_t i = 0; i <= static_cast<std::uint32_t>(Intrinsic::atomicCompareExchange); ++i) {
        const auto found = static_cast<Intrinsic>(i);
        if (name_of(found) == called) return implied({.op = Op::intrinsic, .intrinsic = found, .operands = list()});
    }
    fail("expected a function of ir/intrinsics.def before this");
}

/// Reads the rest of "@function(…)". If the text does not declare the function, the host calls it for a uniform value;
/// the text then gives its result type after the call.
ExprId Reader::call() {
    const std::string called = name();
    auto [found, is_new] = functions_.try_emplace(called);
    if (is_new) {
        Function made;
        made.name = p.names->intern(called);
        made.result = p.types.error;
        found->second = p.functions.add(std::move(made));
    }
    Expr node{.op = Op::call, .function = found->second};
    expect("(");
    while (!accept(")")) {
        if (accept("&")) node.places.push_back(place());
        else node.operands.push_back(expr());
        accept(",");
    }
    return implied(std::move(node));
}

std::uint32_t Reader::parameter_slot() {
    const auto found = parameters_.find(name());
    if (found == parameters_.end()) fail("no such parameter before this");
    return found->second;
}

ExprId Reader::parameter() {
    const std::uint32_t slot = parameter_slot();
    return add({.op = Op::parameter, .type = current().parameters[slot].type, .slot = slot});
}

/// The index of the member of that name; the member is created at its first use.
std::uint32_t Reader::member_of(StructureId structure, const std::string& called) {
    const auto& members = p.structures[structure].members;
    for (std::uint32_t i = 0; i < members.size(); ++i)
        if ((*p.names)[members[i].name] == called) return i;
    MemberStructure made;
    made.name = p.names->intern(called);
    made.structure = new_structure(called);
    p.structures[structure].members.push_back(std::move(made));
    return static_cast<std::uint32_t>(p.structures[structure].members.size() - 1);
}

/// Reads a path like f.table, up to its end or to a property (domain, member0, memory0, host0).
Place Reader::place() {
    Place place;
    place.root = kernel_parameter_index();
    StructureId structure = kernel().params[place.root].structure;
    while (at(".")) {
        const std::size_t before = at_;
        expect(".");
        const std::string called = word();
        if (called == "domain" || called.starts_with("member") || called.starts_with("memory") ||
            called.starts_with("host")) {
            at_ = before;
            break;
        }
        const std::uint32_t member = member_of(structure, called);
        place.members.push_back(member);
        structure = p.structures[structure].members[member].structure;
    }
    return place;
}

/// Gives the structure as many constructor arguments, host states and memories as the property needs.
void Reader::grow(StructureId structure, const Expr& property) {
    Structure& of = p.structures[structure];
    while (property.op == Op::member && of.constructor.size() <= property.slot) {
        const std::string called = "member" + std::to_string(of.constructor.size());
        of.constructor.push_back(p.locals.add({.name = p.names->intern(called), .type = p.types.error}));
    }
    while (property.op == Op::host_state && of.host.size() <= property.slot)
        of.host.push_back({.name = p.names->intern("host" + std::to_string(of.host.size())), .type = p.types.error});
    while (property.op == Op::memory_extent && of.memories.size() <= property.slot) {
        Memory made;
        made.name = p.names->intern("memory" + std::to_string(of.memories.size()));
        of.memories.push_back(std::move(made));
    }
}

ExprId Reader::of_place() {
    Expr node{.type = p.types.error, .place = place()};
    expect(".");
    const std::string called = word();
    node.op = called == "domain"             ? Op::domain
              : called.starts_with("member") ? Op::member
              : called.starts_with("host")   ? Op::host_state
                                             : Op::memory_extent;
    if (node.op != Op::domain)
        node.slot = static_cast<std::uint32_t>(std::stoul(called.substr(called.find_first_of("0123456789"))));
    StructureId structure = kernel().params[node.place.root].structure;
    for (std::uint32_t member : node.place.members) structure = p.structures[structure].members[member].structure;
    grow(structure, node);
    return add(std::move(node));
}

ExprId Reader::of_local(const std::string& called) {
    const auto found = locals_.find(called);
    if (const auto slot = state_slot(called); slot && found == locals_.end())
        return add({.op = Op::state, .type = p.types.error, .slot = *slot});
    if (found == locals_.end()) fail(concat("'", called, "' is not declared before this"));
    return add({.op = Op::local, .type = p.locals[found->second].type, .local = found->second});
}

/// Reads the rest of "name(binding, operand…)".
ExprId Reader::of_binding(Op op) {
    expect("(");
    const auto found = bindings_.find(name());
    if (found == bindings_.end()) fail("no such binding before this");
    Expr node{.op = op, .slot = found->second};
    while (accept(",")) node.operands.push_back(expr());
    expect(")");
    return implied(std::move(node));
}

TypeId Reader::type_of(Builtin builtin) {
    if (builtin >= Builtin::is_front) return p.types.bool_;
    if (builtin == Builtin::fragment_place) return p.types.vector(p.types.float_, 4);
    return builtin <= Builtin::group_count ? p.types.vector(p.types.uint, 3) : p.types.uint;
}

ExprId Reader::primary() {
    if (accept("(")) return parenthesized();
    if (accept("$")) return parameter();
    if (accept("@")) return call();
    if (accept("%")) {
        const auto found = spelled(word(), Builtin::adds_floats);
        if (!found) fail("expected a builtin before this");
        return add({.op = Op::builtin, .builtin = *found, .type = type_of(*found)});
    }
    if (accept("true")) return add({.type = p.types.bool_, .bits = 1});
    if (accept("false")) return add({.type = p.types.bool_});
    if (accept("none")) return add({.op = Op::none, .type = p.types.error});
    for (Op op : {Op::guarded_load, Op::image_load, Op::image_sample, Op::image_gather, Op::image_compare})
        if (accept(name_of(op))) return of_binding(op);
    if (at("inf") || at("nan") || !at_name()) return literal();
    const std::size_t before = at_;
    const std::string called = name();
    const bool is_called = at("(");  // a local may have the name of a function
    if (locals_.contains(called) && !is_called) return of_local(called);
    if (auto found = bindings_.find(called); found != bindings_.end()) {
        const bool is_in_row = accept(".row");
        expect("[");
        const ExprId index = expr();
        expect("]");
        return implied({.op = is_in_row ? Op::row_load : Op::load, .slot = found->second, .operands = {index}});
    }
    if (roots_.contains(called)) {
        at_ = before;
        return of_place();
    }
    at_ = before;
    if (at_type()) return made_of_type();
    const std::string function = name();
    if (!is_called) return of_local(function);
    if (function == "some") return implied({.op = Op::some, .operands = list()});
    if (function == "has_value") return implied({.op = Op::has_value, .operands = list()});
    if (function == "value") return implied({.op = Op::value, .operands = list()});
    return intrinsic(function);
}

}  // namespace gliftc::ir
