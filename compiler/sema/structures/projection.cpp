#include "sema/structures/projection.h"

#include "sema/structures/components.h"
#include "sema/types/generics.h"

#include <algorithm>

namespace gliftc::sema {

namespace {

const std::vector<ir::StructField>* fields_of(const Context& c, ir::StructureId whole) {
    const ir::Types& types = c.program.types;
    const ir::TypeId element = c.program.structures[whole].element;
    return types.kind(element) == ir::TypeKind::struct_ ? &c.program.structs[types[element].struct_].fields : nullptr;
}

/// Makes the structure of the field with that number, named after it.
ir::StructureId make_component(Context& c, ir::StructureId whole, std::uint32_t number, const ir::StructField& field,
                               Span use) {
    const std::optional<ast::DeclId> decl = find_transfer(c, "Component");
    if (!decl) return {};
    Env& env = c.new_env(c.module_of.at(*decl));
    Arguments arguments(c, c[*decl], env, use);
    Meta of;
    of.kind = MetaKind::type;
    of.type = c.types().of_structure(whole);
    arguments.give({of});
    if (!arguments.finish()) return {};
    const ir::TypeId type = make_structure(c, *decl, env);
    if (type == c.types().error) return {};
    const ir::Structure& owner = c.program.structures[whole];
    const std::string name = "." + c.text(field.name);
    ir::Structure& made = c.program.structures[c.types()[type].structure];
    made.name = c.names.intern(c.text(owner.name) + "_" + c.text(field.name));
    made.display = owner.display + name;
    made.key = owner.key + name;
    made.module = owner.module;
    made.doc = field.doc;
    made.field = number;
    made.element = field.type;
    return c.types()[type].structure;
}

}  // namespace

std::optional<std::uint32_t> component_of(Context& c, ir::StructureId whole, ast::Identifier name) {
    const std::vector<ir::StructField>* fields = fields_of(c, whole);
    if (fields == nullptr) return std::nullopt;
    const auto found = std::ranges::find(*fields, name.name, &ir::StructField::name);
    if (found == fields->end()) return std::nullopt;
    const ir::StructField field = *found;
    const auto number = static_cast<std::uint32_t>(found - fields->begin());
    const ir::StructureId component = make_component(c, whole, number, field, name.span);
    if (!component) return std::nullopt;
    ir::MemberStructure member;
    member.name = field.name;
    member.structure = component;
    member.structures = {ir::Place{}};
    member.is_component = true;
    member.span = name.span;
    std::vector<ir::MemberStructure>& members = c.program.structures[whole].members;
    members.push_back(std::move(member));
    return static_cast<std::uint32_t>(members.size() - 1);
}

std::vector<std::string_view> component_names(const Context& c, ir::StructureId whole) {
    std::vector<std::string_view> names;
    if (const std::vector<ir::StructField>* fields = fields_of(c, whole))
        for (const ir::StructField& field : *fields) names.push_back(c.text(field.name));
    return names;
}

}  // namespace gliftc::sema
