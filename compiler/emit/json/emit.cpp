#include "emit/json/emit.h"

#include "emit/json/reach.h"
#include "emit/json/text.h"
#include "emit/json/words.h"
#include "ir/aliases.h"
#include "ir/evaluate.h"
#include "ir/spelling.h"
#include "layout/layout.h"

#include <algorithm>

namespace gliftc::json {

namespace {

struct Writer {
    const ir::Program& program;
    const ir::Lowered& lowered;
    const Sources& sources;
    ir::ModuleId module;
    Text out;

    const std::string& name(Name name) const { return (*program.names)[name]; }
    std::string type(ir::TypeId id) const { return ir::to_text(program, id); }
    std::uint32_t line(Span span) const { return span ? sources.line_of(span) : 0; }

    std::string structure_name(ir::StructureId index) const {
        const ir::Structure& s = program.structures[index];
        const Name alias = ir::name_in(program, s, module);
        return alias ? name(alias) : s.display;
    }
    void document(const std::string& doc) {
        if (!doc.empty()) out.field("doc", doc);
    }
    /// Writes the entry `key`: an array with the values that write(item) writes for each item.
    template <class Items, class Write> void list(std::string_view key, const Items& items, Write&& write) {
        out.key(key);
        out.array([&] {
            for (const auto& item : items) write(item);
        });
    }
    void named(std::string_view name, std::string_view type) {
        out.object([&] {
            out.field("name", name);
            out.field("type", type);
        });
    }

    void translator(const ir::Translator& t);
    void stages(const ir::Structure& s, const std::vector<Root>& roots);
    void memory(const ir::Memory& m, const std::vector<Root>& roots);
    void member(const ir::MemberStructure& m, const std::vector<Root>& roots);
    void function(const ir::Function& f, const std::vector<Root>& roots);
    void functions(ir::StructureId structure, const std::vector<Root>& roots);
    void structure(ir::StructureId index);
    void struct_(const ir::Struct& s);
    void enum_(const ir::Enum& e);
    void kernel_param(const ir::KernelParam& p);
    void kernel(ir::KernelId index);
    void draw(const ir::Kernel& k);
    void form(const ir::Pass& pass, const std::vector<Root>& roots);
    void parameters(const ir::Pass& pass, const std::vector<Root>& roots);
    void binding(const ir::Pass& pass, std::size_t index, const std::vector<Root>& roots);
    void pipeline_param(const ir::PipelineParam& p);
    void pipeline(const ir::Pipeline& p);
};

void Writer::translator(const ir::Translator& t) {
    out.object([&] {
        out.field("name", t.display);
        out.field("virtual", type(t.virtual_type));
        out.field("physical", type(t.physical_type));
        const ir::Properties& p = t.properties;
        out.key("properties");
        out.object([&] {
            out.field("partial", p.partial);
            out.field("invertible", p.invertible);
            out.field("mapping", word(p.mapping));
            out.field("affine", p.affine);
            out.field("uniform", p.uniform);
            out.field("memory_complexity", p.memory_complexity);
            out.field("access_complexity", p.access_complexity);
            out.field("location", p.location);
        });
        out.key("state");
        out.array([&] {
            for (const ir::StructField& field : t.scalars) named(name(field.name), type(field.type));
            for (std::size_t i = 0; i < t.structures.size(); ++i)
                named(name(t.structure_names[i]), structure_name(t.structures[i]));
        });
        document(t.doc);
    });
}

void Writer::stages(const ir::Structure& s, const std::vector<Root>& roots) {
    list("via", s.via, [&](const ir::Stage& stage) {
        out.object([&] {
            out.key("translator");
            translator(program.translators[stage.translator]);
            out.key("arguments");
            out.array([&] {
                for (ir::ExprId scalar : stage.scalars) out.value(expression_text(program, scalar, roots));
                for (const ir::Place& place : stage.structures) out.value(place_text(program, roots, place));
            });
        });
    });
}

void Writer::memory(const ir::Memory& m, const std::vector<Root>& roots) {
    out.object([&] {
        out.field("name", name(m.name));
        out.field("kind", word(m.shape));
        out.field("element", type(m.element));
        if (m.shape != ir::MemoryShape::buffer) out.field("format", word(m.format));
        out.field("extent", m.extent ? expression_text(program, m.extent, roots) : "");
        if (m.linear) out.field("filter", "linear");
        if (m.compare != ir::Compare::less_equal) out.field("compare", ir::spelling(m.compare));
    });
}

void Writer::member(const ir::MemberStructure& m, const std::vector<Root>& roots) {
    out.object([&] {
        out.field("name", name(m.name));
        out.field("type", structure_name(m.structure));
        list("arguments", m.arguments,
             [&](ir::ExprId argument) { out.value(expression_text(program, argument, roots)); });
        out.field("by_reference", m.by_reference);
    });
}

void Writer::function(const ir::Function& f, const std::vector<Root>& roots) {
    out.object([&] {
        out.field("name", name(f.name));
        list("params", f.params,
             [&](ir::LocalId id) { named(name(program.locals[id].name), type(program.locals[id].type)); });
        out.field("result", type(f.result));
        out.field("reads_elements", f.reads_memory);
        if (!f.effects.empty())
            list("writes", f.effects, [&](const ir::Effect& effect) {
                out.object([&] {
                    out.field("member", place_text(program, roots, effect.place));
                    out.field("pattern", word(effect.pattern));
                    if (effect.pattern == ir::Pattern::scatter) out.field("combine", word(effect.combine));
                });
            });
        document(f.doc);
    });
}

void Writer::functions(ir::StructureId structure, const std::vector<Root>& roots) {
    const std::vector<ir::FunctionId> found = ir::public_functions(program, structure);
    if (!found.empty()) list("functions", found, [&](ir::FunctionId id) { function(program.functions[id], roots); });
}

void Writer::structure(ir::StructureId index) {
    const ir::Structure& s = program.structures[index];
    const std::vector<Root> self = {{"", index}};
    out.object([&] {
        out.field("name", structure_name(index));
        out.field("type", s.display);
        out.field("kind", word(s.kind));
        if (s.kind != ir::StructureKind::no_elements) {
            out.field("domain", type(s.domain_type));
            out.field("element", type(s.element));
        }
        const std::vector<Name> names = ir::public_names(s, module);
        out.field("public", !names.empty());
        if (names.size() > 1)
            list("other_names", std::vector(names.begin() + 1, names.end()),
                 [&](Name other) { out.value(name(other)); });
        list("constructor", s.constructor,
             [&](ir::LocalId id) { named(name(program.locals[id].name), type(program.locals[id].type)); });
        list("memories", s.memories, [&](const ir::Memory& m) { memory(m, self); });
        if (!s.base.empty()) out.field("memory", place_text(program, self, {0, s.base}));
        std::vector<ir::MemberStructure> members = s.members;
        std::erase_if(members, [](const ir::MemberStructure& m) { return m.is_component; });
        list("members", members, [&](const ir::MemberStructure& m) { member(m, self); });
        stages(s, self);
        if (s.blocks) {
            out.key("blocks");
            out.object([&] {
                out.field("size", expression_text(program, s.blocks->extent, self));
                if (s.blocks->bound) out.field("most", expression_text(program, s.blocks->bound, self));
                out.field("counted_on_device", !s.blocks->is_known);
            });
        }
        functions(index, self);
        if (s.is_container)
            list("host", s.host, [&](const ir::HostField& field) { named(name(field.name), type(field.type)); });
        document(s.doc);
    });
}

void Writer::struct_(const ir::Struct& s) {
    const std::vector<std::uint32_t> offsets = layout::offsets_of(program, s);
    std::uint32_t end = 0, align = 1;
    for (std::size_t i = 0; i < s.fields.size(); ++i) {
        const layout::Size field = layout::size_of(program, s.fields[i].type);
        end = std::max(end, offsets[i] + field.size);
        align = std::max(align, field.align);
    }
    out.object([&] {
        out.field("name", s.display.empty() ? name(s.name) : s.display);
        out.field("size", s.size != 0 ? s.size : (end + align - 1) / align * align);
        out.key("fields");
        out.array([&] {
            for (std::size_t i = 0; i < s.fields.size(); ++i)
                out.object([&] {
                    out.field("name", name(s.fields[i].name));
                    out.field("type", type(s.fields[i].type));
                    out.field("offset", offsets[i]);
                });
        });
        if (!s.extern_header.empty()) out.field("header", s.extern_header);
        document(s.doc);
    });
}

void Writer::enum_(const ir::Enum& e) {
    out.object([&] {
        out.field("name", name(e.name));
        out.key("values");
        out.object([&] {
            for (std::size_t i = 0; i < e.enumerators.size(); ++i) out.field(name(e.enumerators[i]), e.values[i]);
        });
        document(e.doc);
    });
}

void Writer::parameters(const ir::Pass& pass, const std::vector<Root>& roots) {
    out.object([&] {
        out.field("bytes", pass.parameter_bytes);
        out.field("push_constants", pass.push_constants);
        if (pass.uniform_buffer) out.field("uniform_buffer", true);
        list("members", pass.parameters, [&](const ir::PassParameter& p) {
            out.object([&] {
                out.field("name", p.name);
                out.field("type", type(p.type));
                out.field("offset", p.offset);
                out.field("source", word(p.source));
                if (p.source == ir::ParameterSource::uniform && p.value)
                    out.field("value", expression_text(program, p.value, roots));
                if (p.source == ir::ParameterSource::origin || p.source == ir::ParameterSource::range_size ||
                    p.source == ir::ParameterSource::index)
                    out.field("of", roots.at(p.param).name);
                if (p.source == ir::ParameterSource::address) out.field("of", pass.bindings.at(p.param).name);
            });
        });
    });
}

void Writer::binding(const ir::Pass& pass, std::size_t index, const std::vector<Root>& roots) {
    const ir::PassBinding& b = pass.bindings[index];
    const auto memory = [&]() -> std::string {
        if (b.is_workspace) return "partial sums";
        const ir::Structure& structure = program.structures[structure_at(program, roots, b.place)];
        return place_text(program, roots, b.place) + "." + name(structure.memories[b.memory].name);
    };
    out.object([&] {
        out.field("binding", index + 1);
        out.field("name", b.name);
        out.field("memory", memory());
        out.field("kind", word(b.shape));
        out.field("element", type(b.element));
        out.field("access", word(b.access));
        if (b.shape != ir::MemoryShape::buffer) {
            out.field("format", word(b.format));
            out.field("sampled", b.sampled);
            if (b.compare) out.field("compare", ir::spelling(*b.compare));
            if (b.ordered) out.field("as_bits", true);
        }
    });
}

void Writer::form(const ir::Pass& pass, const std::vector<Root>& roots) {
    out.object([&] {
        list("group", pass.group, [&](std::uint32_t extent) { out.value(extent); });
        list("items", variant_for(pass, ir::Devices::shaders).assumes.elements,
             [&](std::uint32_t count) { out.value(count); });
        out.key("parameters");
        parameters(pass, roots);
        out.key("bindings");
        out.array([&] {
            for (std::size_t i = 0; i < pass.bindings.size(); ++i) binding(pass, i, roots);
        });
        out.key("loop_rounds");
        if (pass.loop_rounds == UINT64_MAX) out.null();
        else out.value(pass.loop_rounds);
        out.field("exact", pass.exact);
        if (pass.shared_bytes) out.field("shared_bytes", pass.shared_bytes);
        if (pass.has_status()) out.field("status_binding", pass.bindings.size() + 1);
        if (!pass.messages.empty()) out.field("messages_binding", pass.bindings.size() + 2);
    });
}

void Writer::kernel_param(const ir::KernelParam& p) {
    out.object([&] {
        out.field("name", name(p.name));
        out.field("pattern", word(p.pattern));
        if (p.pattern == ir::Pattern::value) {
            out.field("type", type(program.locals[p.local].type));
        } else if (p.pattern == ir::Pattern::argument) {
            out.field("type", type(program.locals[p.local].type));
        } else {
            out.field("direction", word(p.direction));
            out.field("structure", structure_name(p.structure));
        }
        if (p.pattern == ir::Pattern::near) out.field("radius", p.radius.largest());
        if (p.pattern == ir::Pattern::scatter) out.field("combine", word(p.combine));
    });
}

/// The value of the entry "draw", which only kernels that draw have. The workgroup size ("group") in their forms has no
/// meaning.
void Writer::draw(const ir::Kernel& k) {
    const ir::Raster& raster = *k.raster;
    out.object([&] {
        out.field("primitives", ir::spelling(raster.topology));
        out.field("cull", ir::spelling(raster.cull));
        list("varyings", raster.varyings, [&](const ir::Varying& varying) {
            out.object([&] {
                out.field("name", name(varying.name));
                out.field("type", type(varying.type));
                out.field("interpolation", ir::spelling(varying.interpolation));
            });
        });
        list("colours", raster.colours, [&](const ir::ColourTarget& target) {
            out.object([&] {
                out.field("param", name(k.params[target.param].name));
                out.field("blend", ir::spelling(target.blend));
            });
        });
        if (raster.depth) {
            out.key("depth");
            out.object([&] {
                out.field("param", name(k.params[raster.depth->param].name));
                out.field("test", ir::spelling(raster.depth->test));
                out.field("written", raster.depth->is_written);
            });
        }
        out.field("clip_distances", raster.clip_distances.size());
        out.field("fragment", raster.has_fragment);
    });
}

void Writer::kernel(ir::KernelId index) {
    const ir::Kernel& k = program.kernels[index];
    std::vector<Root> roots;
    for (const ir::KernelParam& p : k.params) roots.push_back({name(p.name), p.structure});
    out.object([&] {
        out.field("name", k.display.empty() ? name(k.name) : k.display);
        out.field("line", line(k.span));
        out.field("public", k.is_pub);
        out.field("domain", type(k.domain_type));
        if (k.space) out.field("blocks_of", name(k.params[*k.space].name));
        if (k.grouped()) list("group", k.group, [&](std::uint32_t extent) { out.value(extent); });
        list("params", k.params, [&](const ir::KernelParam& p) { kernel_param(p); });
        if (k.raster) {
            out.key("draw");
            draw(k);
        }
        if (lowered.passes.contains(index)) {
            const ir::Lowered::Forms& forms = lowered.passes[index];
            out.key("forms");
            out.object([&] {
                out.key("direct");
                form(forms.direct, roots);
                out.key("general");
                form(forms.general, roots);
            });
        }
        document(k.doc);
    });
}

void Writer::pipeline_param(const ir::PipelineParam& p) {
    out.object([&] {
        out.field("name", name(p.name));
        out.field("pattern", word(p.pattern));
        if (p.pattern == ir::HostPattern::value) {
            out.field("type", type(program.locals[p.local].type));
        } else {
            out.field("direction", word(p.direction));
            out.field("structure", structure_name(p.structure));
        }
    });
}

void Writer::pipeline(const ir::Pipeline& p) {
    out.object([&] {
        out.field("name", p.display.empty() ? name(p.name) : p.display);
        out.field("line", line(p.span));
        out.field("public", p.is_pub);
        if (p.owner) out.field("owner", structure_name(p.owner));
        list("params", p.params, [&](const ir::PipelineParam& param) { pipeline_param(param); });
        out.field("result", type(p.result));
        document(p.doc);
    });
}

std::string file_name(std::string_view path) { return std::string(path.substr(path.find_last_of('/') + 1)); }

/// The pipelines that tests consist of, which programs do not call.
std::set<ir::PipelineId> pipelines_of_tests(const ir::Program& program) {
    std::set<ir::PipelineId> found;
    for (const ir::Test& test : program.tests) found.insert(test.pipeline);
    return found;
}

}  // namespace

std::string reflection_of(const ir::Program& program, const ir::Lowered& lowered, const Sources& sources,
                          ir::ModuleId module) {
    Writer writer{program, lowered, sources, module, {}};
    Text& out = writer.out;
    const ir::Module& m = program.modules[module];
    const Reached reached = reach(program, module);
    const std::set<ir::PipelineId> of_tests = pipelines_of_tests(program);
    std::vector<ir::KernelId> kernels;
    std::vector<ir::PipelineId> pipelines;
    for (ir::KernelId i : program.kernels.ids())
        if (program.kernels[i].module == module) kernels.push_back(i);
    for (ir::PipelineId i : program.pipelines.ids())
        if (program.pipelines[i].module == module && !of_tests.contains(i)) pipelines.push_back(i);
    out.object([&] {
        out.field("schema", schema_version);
        out.field("module", writer.name(m.name));
        out.field("source", file_name(sources[m.file].path));
        writer.document(m.doc);
        writer.list("structs", reached.structs, [&](ir::StructId i) { writer.struct_(program.structs[i]); });
        writer.list("enums", reached.enums, [&](ir::EnumId i) { writer.enum_(program.enums[i]); });
        writer.list("structures", reached.structures, [&](ir::StructureId i) { writer.structure(i); });
        writer.list("kernels", kernels, [&](ir::KernelId i) { writer.kernel(i); });
        writer.list("pipelines", pipelines, [&](ir::PipelineId i) { writer.pipeline(program.pipelines[i]); });
        writer.list("tests", program.tests, [&](const ir::Test& test) {
            if (test.module != module) return;
            out.object([&] {
                out.field("title", test.title);
                out.field("line", writer.line(test.span));
            });
        });
    });
    return out.take() + "\n";
}

}  // namespace gliftc::json
