#include "ir/reader.h"

namespace gliftc::ir {

namespace {

struct Scalar {
    std::string_view name;
    TypeId Types::*type;
};

constexpr Scalar scalars[] = {
    {"uint64", &Types::uint64}, {"int64", &Types::int64},  {"bool", &Types::bool_}, {"uint", &Types::uint},
    {"int", &Types::int_},      {"float", &Types::float_}, {"half", &Types::half},  {"double", &Types::double_},
};

}  // namespace

/// Reads a built-in type, such as float, float3 or float4x4, whose digits are part of the word.
std::optional<TypeId> Reader::accept_builtin_type() {
    if (accept("nothing")) return p.types.void_;
    if (accept("vec<")) {
        const auto count = static_cast<std::uint32_t>(number());
        expect(",");
        const TypeId element = type();
        expect(">");
        return p.types.vector(element, count);
    }
    const std::size_t before = at_;
    if (!at_name()) return std::nullopt;
    const std::string text = word();
    for (const Scalar& scalar : scalars) {
        const TypeId id = p.types.*scalar.type;
        if (text == scalar.name) return id;
        const std::string rest = text.starts_with(scalar.name) ? text.substr(scalar.name.size()) : "";
        const auto digit = [&](std::size_t i) { return static_cast<std::uint32_t>(rest[i] - '0'); };
        if (rest.size() == 1 && digit(0) >= 2 && digit(0) <= 4) return p.types.vector(id, digit(0));
        if (rest.size() == 3 && rest[1] == 'x') return p.types.matrix(id, digit(0), digit(2));
    }
    at_ = before;
    return std::nullopt;
}

std::optional<TypeId> Reader::accept_base_type() {
    for (const auto& [name, type] : types_)
        if (accept(name)) return type;
    return accept_builtin_type();
}

bool Reader::at_type() {
    const std::size_t before = at_;
    const bool found = accept_base_type().has_value();
    at_ = before;
    return found;
}

TypeId Reader::type() {
    std::optional<TypeId> found = accept_base_type();
    if (!found) fail("expected a type");
    while (true) {
        if (accept("?")) {
            found = p.types.optional(*found);
        } else if (accept("[")) {
            found = p.types.array(*found, static_cast<std::uint32_t>(number()));
            expect("]");
        } else {
            return *found;
        }
    }
}

/// Reads a struct. Its name extends to the brace, since it may contain generic arguments and commas.
void Reader::declare_struct() {
    skip_space();
    const std::size_t end = text_.find(" {", at_);
    if (end == std::string_view::npos) fail("expected the fields of a struct");
    const std::string name(text_.substr(at_, end - at_));
    at_ = end;
    Struct made;
    made.name = p.names->intern(name);
    made.display = name;
    expect("{");
    while (!accept("}")) {
        StructField field;
        field.name = p.names->intern(word());
        expect(":");
        field.type = type();
        made.fields.push_back(std::move(field));
        accept(",");
    }
    types_[name] = p.types.of_struct(p.structs.add(std::move(made)));
}

void Reader::declare_enum() {
    const std::string name = this->name();
    Enum made;
    made.name = p.names->intern(name);
    expect("{");
    while (!accept("}")) {
        made.enumerators.push_back(p.names->intern(word()));
        expect("=");
        made.values.push_back(static_cast<std::uint32_t>(number()));
        accept(",");
    }
    types_[name] = p.types.of_enum(p.enums.add(std::move(made)));
}

}  // namespace gliftc::ir
