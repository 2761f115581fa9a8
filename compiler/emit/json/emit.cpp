#include "emit/json/emit.h"

#include "emit/json/reach.h"
#include "emit/json/words.h"
#include "ir/evaluate.h"
#include "layout/layout.h"

#include <nlohmann/json.hpp>

namespace gliftc::json {

namespace {

using Json = nlohmann::ordered_json;

struct Writer {
    const ir::Program& program;
    const ir::Lowered& lowered;
    const Sources& sources;

    const std::string& name(Name name) const { return (*program.names)[name]; }
    std::string type(ir::TypeId id) const { return ir::to_text(program, id); }
    std::uint32_t line(Span span) const { return span ? sources.line_of(span) : 0; }

    std::string structure_name(std::uint32_t index) const {
        const ir::Structure& s = program.structures[index];
        return s.alias ? name(s.alias) : s.display;
    }
    static void document(Json& json, const std::string& doc) {
        if (!doc.empty()) json["doc"] = doc;
    }

    Json translator(const ir::Translator& t) const;
    Json stages(const ir::Structure& s, const std::vector<Root>& roots) const;
    Json structure(std::uint32_t index) const;
    Json struct_(const ir::Struct& s) const;
    Json enum_(const ir::Enum& e) const;
    Json kernel(std::uint32_t index) const;
    Json form(const ir::Pass& pass, const std::vector<Root>& roots) const;
    Json parameters(const ir::Pass& pass, const std::vector<Root>& roots) const;
    Json bindings(const ir::Pass& pass, const std::vector<Root>& roots) const;
    Json pipeline(const ir::Pipeline& p) const;
};

Json Writer::translator(const ir::Translator& t) const {
    Json json = {{"name", t.display}, {"virtual", type(t.virtual_type)}, {"physical", type(t.physical_type)}};
    const ir::Properties& p = t.properties;
    json["properties"] = {{"partial", p.partial},
                          {"invertible", p.invertible},
                          {"one_to_one", p.one_to_one},
                          {"affine", p.affine},
                          {"uniform", p.uniform},
                          {"memory_complexity", p.memory_complexity},
                          {"access_complexity", p.access_complexity},
                          {"location", p.location}};
    Json state = Json::array();
    for (const ir::StructField& field : t.scalars)
        state.push_back({{"name", name(field.name)}, {"type", type(field.type)}});
    for (std::size_t i = 0; i < t.structures.size(); ++i)
        state.push_back({{"name", name(t.structure_names[i])}, {"type", structure_name(t.structures[i])}});
    json["state"] = state;
    document(json, t.doc);
    return json;
}

Json Writer::stages(const ir::Structure& s, const std::vector<Root>& roots) const {
    Json via = Json::array();
    for (const ir::Stage& stage : s.via) {
        Json json = {{"translator", translator(program.translators[stage.translator])}};
        Json arguments = Json::array();
        for (ir::ExprId scalar : stage.scalars) arguments.push_back(expression_text(program, scalar, roots));
        for (const ir::Place& place : stage.structures) arguments.push_back(place_text(program, roots, place));
        json["arguments"] = arguments;
        via.push_back(std::move(json));
    }
    return via;
}

Json Writer::structure(std::uint32_t index) const {
    const ir::Structure& s = program.structures[index];
    const std::vector<Root> self = {{"", index}};
    Json json = {{"name", structure_name(index)}, {"type", s.display}, {"kind", word(s.kind)}};
    if (s.kind != ir::StructureKind::adaptor) {
        json["domain"] = type(s.domain_type);
        json["element"] = type(s.element);
    }
    json["public"] = s.is_pub;
    json["constructor"] = Json::array();
    for (ir::LocalId id : s.constructor)
        json["constructor"].push_back(
            {{"name", name(program.locals[id].name)}, {"type", type(program.locals[id].type)}});
    json["memories"] = Json::array();
    for (const ir::Memory& m : s.memories) {
        Json memory = {{"name", name(m.name)}, {"kind", word(m.shape)}, {"element", type(m.element)}};
        if (m.shape != ir::MemoryShape::buffer) memory["format"] = word(m.format);
        memory["extent"] = m.extent ? expression_text(program, m.extent, self) : "";
        if (m.linear) memory["filter"] = "linear";
        json["memories"].push_back(std::move(memory));
    }
    json["members"] = Json::array();
    for (const ir::MemberStructure& m : s.members) {
        Json arguments = Json::array();
        for (ir::ExprId argument : m.arguments) arguments.push_back(expression_text(program, argument, self));
        json["members"].push_back({{"name", name(m.name)},
                                   {"type", structure_name(m.structure)},
                                   {"arguments", arguments},
                                   {"by_reference", m.by_reference}});
    }
    json["via"] = stages(s, self);
    if (s.kind == ir::StructureKind::adaptor) {
        json["host"] = Json::array();
        for (const ir::HostField& field : s.host)
            json["host"].push_back({{"name", name(field.name)}, {"type", type(field.type)}});
    }
    document(json, s.doc);
    return json;
}

Json Writer::struct_(const ir::Struct& s) const {
    layout::Size size{s.size, 0};
    std::vector<std::uint32_t> offsets = layout::offsets_of(program, s);
    Json fields = Json::array();
    std::uint32_t end = 0, align = 1;
    for (std::size_t i = 0; i < s.fields.size(); ++i) {
        layout::Size field = layout::size_of(program, s.fields[i].type);
        fields.push_back({{"name", name(s.fields[i].name)}, {"type", type(s.fields[i].type)}, {"offset", offsets[i]}});
        end = std::max(end, offsets[i] + field.size);
        align = std::max(align, field.align);
    }
    if (size.size == 0) size.size = (end + align - 1) / align * align;
    Json json = {{"name", s.display.empty() ? name(s.name) : s.display}, {"size", size.size}, {"fields", fields}};
    if (!s.extern_header.empty()) json["header"] = s.extern_header;
    document(json, s.doc);
    return json;
}

Json Writer::enum_(const ir::Enum& e) const {
    Json values = Json::object();
    for (std::size_t i = 0; i < e.enumerators.size(); ++i) values[name(e.enumerators[i])] = e.values[i];
    Json json = {{"name", name(e.name)}, {"values", values}};
    document(json, e.doc);
    return json;
}

Json Writer::parameters(const ir::Pass& pass, const std::vector<Root>& roots) const {
    Json members = Json::array();
    for (const ir::PassParameter& p : pass.parameters) {
        Json member = {{"name", p.name}, {"type", type(p.type)}, {"offset", p.offset}, {"source", word(p.source)}};
        if (p.source == ir::ParameterSource::uniform && p.value)
            member["value"] = expression_text(program, p.value, roots);
        if (p.source == ir::ParameterSource::origin || p.source == ir::ParameterSource::range_size)
            member["of"] = roots.at(p.param).name;
        if (p.source == ir::ParameterSource::address) member["of"] = pass.bindings.at(p.param).name;
        members.push_back(std::move(member));
    }
    return {{"bytes", pass.parameter_bytes}, {"push_constants", pass.push_constants}, {"members", members}};
}

Json Writer::bindings(const ir::Pass& pass, const std::vector<Root>& roots) const {
    Json all = Json::array();
    for (std::size_t i = 0; i < pass.bindings.size(); ++i) {
        const ir::PassBinding& b = pass.bindings[i];
        const ir::Structure& structure = program.structures[structure_at(program, roots, b.place)];
        Json json = {{"binding", i + 1},
                     {"name", b.name},
                     {"memory", place_text(program, roots, b.place) + "." + name(structure.memories[b.memory].name)},
                     {"kind", word(b.shape)},
                     {"element", type(b.element)},
                     {"access", word(b.access)}};
        if (b.shape != ir::MemoryShape::buffer) {
            json["format"] = word(b.format);
            json["sampled"] = b.sampled;
        }
        all.push_back(std::move(json));
    }
    return all;
}

Json Writer::form(const ir::Pass& pass, const std::vector<Root>& roots) const {
    if (!pass.exists) return nullptr;
    Json json = {{"group", pass.group}, {"parameters", parameters(pass, roots)}, {"bindings", bindings(pass, roots)}};
    json["loop_rounds"] = pass.loop_rounds == UINT64_MAX ? Json(nullptr) : Json(pass.loop_rounds);
    json["exact"] = pass.exact;
    if (pass.shared_bytes) json["shared_bytes"] = pass.shared_bytes;
    if (pass.has_status()) json["status_binding"] = pass.bindings.size() + 1;
    return json;
}

Json Writer::kernel(std::uint32_t index) const {
    const ir::Kernel& k = program.kernels[index];
    Json json = {{"name", k.display.empty() ? name(k.name) : k.display},
                 {"line", line(k.span)},
                 {"public", k.is_pub},
                 {"domain", type(k.domain_type)}};
    if (k.grouped()) json["group"] = k.group;
    json["params"] = Json::array();
    std::vector<Root> roots;
    for (const ir::KernelParam& p : k.params) {
        roots.push_back({name(p.name), p.structure});
        Json param = {{"name", name(p.name)}, {"pattern", word(p.pattern)}};
        if (p.pattern == ir::Pattern::value) param["type"] = type(program.locals[p.local].type);
        else {
            param["direction"] = word(p.direction);
            param["structure"] = structure_name(p.structure);
        }
        if (p.pattern == ir::Pattern::near) param["radius"] = p.radius;
        if (p.pattern == ir::Pattern::scatter) param["combine"] = word(p.combine);
        json["params"].push_back(std::move(param));
    }
    if (index < lowered.passes.size()) {
        const ir::Lowered::Forms& forms = lowered.passes[index];
        json["forms"] = {{"direct", form(forms.direct, roots)},
                         {"general", form(forms.general, roots)},
                         {"wide", form(forms.wide, roots)}};
    }
    document(json, k.doc);
    return json;
}

Json Writer::pipeline(const ir::Pipeline& p) const {
    Json json = {{"name", p.display.empty() ? name(p.name) : p.display}, {"line", line(p.span)}, {"public", p.is_pub}};
    if (p.owner) json["owner"] = structure_name(*p.owner);
    json["params"] = Json::array();
    for (const ir::PipelineParam& param : p.params) {
        Json one = {{"name", name(param.name)}, {"pattern", word(param.pattern)}};
        if (param.pattern == ir::HostPattern::value) one["type"] = type(program.locals[param.local].type);
        else {
            one["direction"] = word(param.direction);
            one["structure"] = structure_name(param.structure);
        }
        json["params"].push_back(std::move(one));
    }
    json["result"] = type(p.result);
    document(json, p.doc);
    return json;
}

std::string file_name(std::string_view path) { return std::string(path.substr(path.find_last_of('/') + 1)); }

/// Tests have pipelines of their own, which are not for callers.
std::set<std::uint32_t> pipelines_of_tests(const ir::Program& program) {
    std::set<std::uint32_t> found;
    for (const ir::Test& test : program.tests) found.insert(test.pipeline);
    return found;
}

}  // namespace

std::string reflection_of(const ir::Program& program, const ir::Lowered& lowered, const Sources& sources,
                          std::uint32_t module) {
    Writer writer{program, lowered, sources};
    const ir::Module& m = program.modules[module];
    const Reached reached = reach(program, module);
    const std::set<std::uint32_t> of_tests = pipelines_of_tests(program);
    Json json = {
        {"schema", schema_version}, {"module", writer.name(m.name)}, {"source", file_name(sources[m.file].path)}};
    Writer::document(json, m.doc);
    for (const char* part : {"structs", "enums", "structures", "kernels", "pipelines", "tests"})
        json[part] = Json::array();
    for (std::uint32_t i : reached.structs) json["structs"].push_back(writer.struct_(program.structs[i]));
    for (std::uint32_t i : reached.enums) json["enums"].push_back(writer.enum_(program.enums[i]));
    for (std::uint32_t i : reached.structures) json["structures"].push_back(writer.structure(i));
    for (std::uint32_t i = 0; i < program.kernels.size(); ++i)
        if (program.kernels[i].module == module) json["kernels"].push_back(writer.kernel(i));
    for (std::uint32_t i = 0; i < program.pipelines.size(); ++i)
        if (program.pipelines[i].module == module && !of_tests.contains(i))
            json["pipelines"].push_back(writer.pipeline(program.pipelines[i]));
    for (const ir::Test& test : program.tests)
        if (test.module == module) json["tests"].push_back({{"title", test.title}, {"line", writer.line(test.span)}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace gliftc::json
