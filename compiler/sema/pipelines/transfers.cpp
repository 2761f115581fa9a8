// Transfers of a structure's elements between host and device: instantiates the kernels of std.transfer.
#include "ir/chain.h"
#include "ir/effects.h"
#include "sema/kernels/raster.h"
#include "sema/structures/components.h"
#include "sema/types/generics.h"
#include "sema/types/instances.h"

namespace gliftc::sema {

std::optional<ast::DeclId> find_transfer(Context& c, std::string_view name) {
    for (ir::ModuleId i : c.modules.ids()) {
        if (c.text(c.modules[i].tree->name.name) != transfer_module) continue;
        auto found = c.scopes[i].names.find(c.names.intern(name));
        if (found != c.scopes[i].names.end()) return found->second[0];
    }
    return std::nullopt;
}

namespace {

Meta of_structure(Context& c, ir::StructureId index) {
    Meta meta;
    meta.kind = MetaKind::type;
    meta.type = c.types().of_structure(index);
    return meta;
}

ir::KernelId transfer_kernel(Context& c, std::string_view name, std::vector<Meta> metas, Span use) {
    auto decl = find_transfer(c, name);
    if (!decl) return {};
    Env& env = c.new_env(c.module_of.at(*decl));
    Arguments arguments(c, c[*decl], env, use);
    arguments.give(std::move(metas));
    if (!arguments.finish()) return {};
    return instantiate_kernel(c, *decl, env, use);
}

}  // namespace

ir::StructureId box_of(Context& c, std::uint32_t axes, ir::TypeId of, Span use) {
    auto decl = find_transfer(c, "Box");
    if (!decl) return {};
    Env& env = c.new_env(c.module_of.at(*decl));
    Arguments arguments(c, c[*decl], env, use);
    Meta dimensions, element;
    dimensions.kind = MetaKind::value;
    dimensions.value = {c.types().uint, {ir::Lane{.bits = axes}}};
    element.kind = MetaKind::type;
    element.type = of;
    arguments.give({dimensions, element});
    if (!arguments.finish()) return {};
    ir::TypeId type = instantiate_type(c, *decl, env, use);
    if (type == c.types().error) return {};
    return c.types()[type].structure;
}

/// Adds the kernel by which C++ lists the elements that are there (read_resident), and the types of the boxes that it
/// fills. Adds none for views and structures whose elements are computed, nor for a structure without blocks in which
/// every address is known to have an element of its own.
static void list_of(Context& c, ir::Program::Transfer& transfer, Span use) {
    const ir::Structure structure = c.program.structures[transfer.structure];
    if (!ir::has_resident_part(c.program, structure)) return;
    ir::StructureId translated = transfer.structure;
    for (std::uint32_t member : ir::translated_by(c.program, structure))
        translated = c.program.structures[translated].members[member].structure;
    const ir::TypeId place = ir::physical_type(c.program, c.program.structures[translated]);
    const auto addresses = box_of(c, 1, structure.domain_type, use);
    const auto places = box_of(c, 1, place ? place : structure.domain_type, use);
    const auto values = box_of(c, 1, structure.element, use);
    const auto counter = box_of(c, 1, c.types().uint, use);
    if (!addresses || !places || !values || !counter) return;
    const auto of = [&](ir::StructureId index) { return of_structure(c, index); };
    const auto list = transfer_kernel(
        c, "list_there", {of(transfer.structure), of(translated), of(addresses), of(places), of(values), of(counter)},
        use);
    if (!list) return;
    transfer.list_kernel = list;
    transfer.addresses = addresses;
    transfer.places = places;
    transfer.values = values;
    transfer.counter = counter;
}

void require_transfers(Context& c, ir::StructureId index, Span use) {
    for (const auto& transfer : c.program.transfers)
        if (transfer.structure == index) return;
    const ir::Structure structure = c.program.structures[index];
    bool addressed = structure.kind == ir::StructureKind::stored ||
                     (structure.kind == ir::StructureKind::computed && structure.domain);
    if (structure.kind == ir::StructureKind::no_elements) {
        for (const ir::MemberStructure& member : structure.members)
            if (!member.is_component) require_transfers(c, member.structure, use);
        return;
    }
    if (!addressed) return;
    if (!find_transfer(c, "Box")) {
        c.error(Diag::unknown_module, use, {transfer_module});
        return;
    }
    auto box = box_of(c, c.types().components(structure.domain_type), structure.element, use);
    if (!box) return;
    Meta self = of_structure(c, index), linear = of_structure(c, box);
    auto read = transfer_kernel(c, "read_box", {self, linear}, use);
    if (!read) return;
    ir::KernelId write, fill;
    if (ir::is_written_in_boxes(c.program, index)) {
        Meta element;
        element.kind = MetaKind::type;
        element.type = structure.element;
        write = transfer_kernel(c, "write_box", {linear, self}, use);
        // The kernel visits all elements of the box, not the structure's blocks (docs/reference/language.md,
        // "Iteration space").
        if (write) c.program.kernels[write].space.reset();
        fill = transfer_kernel(c, "fill_box", {self, element}, use);
    }
    ir::Program::Transfer transfer{
        .structure = index, .read_kernel = read, .write_kernel = write, .fill_kernel = fill, .box_structure = box};
    // `gliftc test` reads elements by their addresses, and needs no lists of them.
    if (!c.settings.looks_into_tables) list_of(c, transfer, use);
    c.program.transfers.push_back(transfer);
    // C++ programs reach the structure's members by name, and read and write them, too.
    for (const ir::MemberStructure& member : structure.members)
        if (!member.is_component) require_transfers(c, member.structure, use);
}

}  // namespace gliftc::sema
