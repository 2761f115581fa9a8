// `-D name=value`: values for the constants of the modules named on the command line.
#include "sema/names/defines.h"

#include "sema/types/meta.h"

#include <charconv>

namespace gliftc::sema {

namespace {

template <class Number> std::optional<Number> read(std::string_view text, auto... format) {
    Number number{};
    auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number, format...);
    if (failure != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

/// The largest magnitude that a negative, or a non-negative, integer of the type has.
std::uint64_t limit_of(const ir::Types& types, ir::TypeId type, bool negative) {
    bool wide = type == types.int64 || type == types.uint64;
    std::uint64_t all = wide ? ~std::uint64_t{0} : 0xffffffffu;
    if (!types.is_signed(type)) return negative ? 0 : all;
    return (all >> 1) + (negative ? 1u : 0u);
}

std::optional<ir::Lane> whole_number(const ir::Types& types, ir::TypeId type, std::string_view text) {
    bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    if (text.ends_with('u') && !types.is_signed(type)) text.remove_suffix(1);
    bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
    auto value = read<std::uint64_t>(hexadecimal ? text.substr(2) : text, hexadecimal ? 16 : 10);
    if (!value || *value > limit_of(types, type, negative)) return std::nullopt;
    return ir::normalize(types, type, {.bits = negative ? 0 - *value : *value});
}

std::optional<ir::Lane> lane_of(Context& c, ir::TypeId type, std::string_view text) {
    const ir::Types& types = c.types();
    if (type == types.bool_) {
        if (text != "true" && text != "false") return std::nullopt;
        return ir::Lane{.bits = text == "true"};
    }
    if (types.kind(type) == ir::TypeKind::enum_) {
        const ir::Enum& declared = c.program.enums[types[type].enum_];
        for (std::size_t i = 0; i < declared.enumerators.size(); ++i)
            if (c.text(declared.enumerators[i]) == text) return ir::Lane{.bits = declared.values[i]};
        return std::nullopt;
    }
    if (!types.is_scalar(type)) return std::nullopt;
    if (types.is_floating(type)) {
        auto number = read<double>(text);
        return number ? std::optional(ir::normalize(types, type, {.number = *number})) : std::nullopt;
    }
    return whole_number(types, type, text);
}

bool is_root_constant(const Context& c, const std::string& name) {
    for (ir::ModuleId i : c.modules.ids()) {
        if (!c.modules[i].is_root) continue;
        auto found = c.scopes[i].names.find(c.names.intern(name));
        if (found != c.scopes[i].names.end() && std::holds_alternative<ast::Const>(c[found->second[0]].body))
            return true;
    }
    return false;
}

}  // namespace

void check_defines(Context& c) {
    for (const auto& [name, value] : c.settings.defines)
        if (!is_root_constant(c, name))
            note(c.error(Diag::unknown_define, {}, {name}), {},
                 "'-D name=value' replaces the value of 'const name' in the files on the command line");
}

ir::ExprId defined_value(Context& c, ast::DeclId id, ir::ExprId written) {
    const ast::Decl& decl = c[id];
    if (!c.modules[c.module_of.at(id)].is_root) return written;
    const std::string& name = c.text(decl.name.name);
    ir::ExprId result = written;
    for (const auto& [defined, value] : c.settings.defines) {
        if (defined != name) continue;
        ir::TypeId type = c.program.exprs[written].type;
        auto lane = lane_of(c, type, value);
        if (!lane) {
            c.error(Diag::define_value, decl.name.span, {name, c.text(type), value});
            return {};
        }
        result = ir::materialize(c.program, {type, {*lane}}, decl.span);
    }
    return result;
}

}  // namespace gliftc::sema
