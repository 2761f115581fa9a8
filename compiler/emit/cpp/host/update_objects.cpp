#include "emit/cpp/host/update_objects.h"

#include "base/concat.h"

#include <algorithm>

namespace gliftc::host {

namespace {

std::string memory_text(const char* type, std::size_t index) {
    return concat("glift::host::elements<", type, ">(call.memories[", std::to_string(index), "])");
}

/// The arguments of glift::host::PartialSums for the ordered sum with this number: the call, the orders and which of
/// them it has, its memory, and that in which the parts meet.
std::string sums_arguments(const Rows& rows, const ir::PassUpdate& update, std::size_t number) {
    const ir::Pass& pass = rows.pass;
    const auto workspace = std::ranges::find_if(pass.bindings, &ir::PassBinding::is_workspace);
    return concat("call, ", rows.p.globals.kernel_stems.at(pass.kernel), "_sums, ", std::to_string(number), ", ",
                  memory_text("float", update.binding), ", ",
                  memory_text("uint", static_cast<std::size_t>(workspace - pass.bindings.begin())));
}

/// The begin of the call that loops over the parts of sums.
std::string loop_over_parts(const ir::SumOrder& order) {
    const std::string part = std::to_string(order.part) + "u, ";
    if (order.axis == 0) return "for_row_parts(call.size, " + part;
    return "for_column_parts<" + std::to_string(order.axis) + ">(call.size, " + part;
}

void add_sum(const Rows& rows, UpdateTexts& texts, cpp::Writer& objects, const ir::PassUpdate& update,
             std::size_t number) {
    texts.loop = loop_over_parts(*update.order);
    const std::string arguments = sums_arguments(rows, update, number);
    texts.after.push_back("glift::host::PartialSums(" + arguments + ").finish();");
    if (!rows.body.updated_bindings.contains(update.binding)) return;
    const bool is_of_rows = update.order->axis == 0;
    const char* type = is_of_rows ? "RowSums " : rows.pass.is_wide ? "ColumnSums<std::uint64_t> " : "ColumnSums<uint> ";
    objects.line(concat("glift::host::", type, rows.body.update_names.at(update.binding), "(", arguments,
                        is_of_rows ? ");" : ", rows);"));
}

/// Copies of the elements of a binding, one for each thread.
void add_copies(const Rows& rows, UpdateTexts& texts, cpp::Writer& objects, std::uint32_t binding,
                ir::Combine combine) {
    const std::string name = rows.body.binding_names[binding] + "_copies";
    const std::string updated = concat("<", cpp::storage_text(rows.p.globals, rows.pass.bindings[binding].element),
                                       ", glift::host::", operation_name(combine), ">");
    texts.before.push_back(
        concat("glift::host::UpdateCopies", updated, " ", name, "(call, ", std::to_string(binding), ");"));
    texts.parameters += concat(", glift::host::UpdateCopies", updated, "& ", name);
    texts.arguments += ", " + name;
    objects.line(concat("glift::host::Updates", updated, " ", rows.body.update_names.at(binding), "(", name, ");"));
    texts.after.push_back(name + ".finish();");
}

}  // namespace

UpdateTexts update_texts(const Rows& rows) {
    UpdateTexts texts;
    cpp::Writer objects;
    objects.indent();
    std::size_t number = 0;
    for (const ir::PassUpdate& update : rows.pass.updates)
        if (update.order) add_sum(rows, texts, objects, update, number++);
    for (const auto& [binding, combine] : rows.combined)
        if (rows.body.updated_bindings.contains(binding) && rows.pass.ordered_sum(binding) == nullptr)
            add_copies(rows, texts, objects, binding, combine);
    texts.objects = objects.take();
    return texts;
}

}  // namespace gliftc::host
