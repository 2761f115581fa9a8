// Instances of pipelines and tests: host code that runs passes in sequence.
#include "ir/changes.h"
#include "sema/structures/components.h"
#include "sema/structures/constructors.h"
#include "sema/structures/replace.h"
#include "sema/types/generics.h"
#include "sema/types/instances.h"

#include <algorithm>
#include <utility>

namespace gliftc::sema {

namespace {

/// The address type for `range<N, T>`: such parameters and results are slices of any structure with that address type
/// and elements of type T (check_range).
ir::TypeId range_domain(Context& c, const Env& env, ast::ExprId dimensions) {
    auto n = count_of(c, env, dimensions);
    if (!n || *n < 1 || *n > 4) {
        if (n) c.error(Diag::vector_size, c[dimensions].span, {std::to_string(*n)});
        return c.types().error;
    }
    return c.types().vector(c.types().uint, *n);
}

/// Whether the structure has addresses of type `domain` and elements of type `element`; reports an error at `span` if
/// not.
bool check_range(Context& c, ir::StructureId structure, ir::TypeId domain, ir::TypeId element, Span span) {
    if (domain == c.types().error || element == c.types().error) return true;  // reported before
    const ir::Structure& instance = c.program.structures[structure];
    if (instance.domain_type == domain && instance.element == element) return true;
    c.error(Diag::range_argument, span, {instance.display, c.text(domain), c.text(element)});
    return false;
}

void add_param(Body& body, const ast::Param& param, const Passed& passed, ir::Pipeline& pipeline) {
    Context& c = body.context;
    ir::PipelineParam made;
    made.name = param.name.name;
    made.span = param.name.span;
    made.direction = param.direction == ast::Direction::out     ? ir::Direction::out
                     : param.direction == ast::Direction::inout ? ir::Direction::inout
                                                                : ir::Direction::in;
    ir::TypeId type = c.types().error;
    if (param.pattern == ast::Pattern::range) {
        made.pattern = ir::HostPattern::range;
        made.structure = passed.structure;
        type = c.types().slice(c.types().of_structure(passed.structure));
        if (param.extra.size() != 1) c.error(Diag::range_form, param.pattern_span);
        else {
            ir::TypeId domain = range_domain(c, body.env, param.type), element = type_of(c, body.env, param.extra[0]);
            check_range(c, passed.structure, domain, element,
                        c.requests.empty() ? param.name.span : c.requests.back().span);
        }
    } else if (param.pattern != ast::Pattern::none) {
        c.error(Diag::pattern_in_pipeline, param.pattern_span);
    } else {
        type = type_of(c, body.env, param);
        if (c.types().kind(type) == ir::TypeKind::structure) {
            made.pattern = ir::HostPattern::structure;
            made.structure = c.types()[type].structure;
        } else if (param.direction == ast::Direction::out || param.direction == ast::Direction::inout) {
            if (type != c.types().error) c.error(Diag::function_out, param.direction_span);
        } else if (passed.on_device) {
            type = c.types().device(type);
        }
    }
    made.local = declare_local(body, param.name, type, false, false);
    if (made.direction == ir::Direction::in && made.structure && c.program.structures[made.structure].is_container)
        body.constants.push_back(made.local);
    pipeline.params.push_back(std::move(made));
}

/// The declared type of the result. That of a range is not known before the first `return`: void stands in for it.
ir::TypeId declared_result(Body& body, const ast::Pipeline& written) {
    Context& c = body.context;
    if (written.result_pattern == ast::Pattern::range) {
        body.range_result = RangeResult{.domain = range_domain(c, body.env, written.result),
                                        .element = type_of(c, body.env, written.result_extra)};
        return c.types().void_;
    }
    return written.result ? type_of(c, body.env, written.result) : c.types().void_;
}

/// Checks the body, again from the beginning as long as an assignment shows that one more variable must lie on the
/// device (check_variable): the variable must lie there from its declaration on.
void check_pipeline_body(Body& body, const std::vector<ast::StmtId>& statements, ir::Pipeline& pipeline) {
    const Body fresh = body;
    const Diagnostics::Mark mark = body.context.diagnostics.mark();
    check_block(body, statements);
    while (body.device_variables.size() > fresh.device_variables.size()) {
        Body again = fresh;
        again.device_variables = body.device_variables;
        const std::size_t known = again.device_variables.size();
        body.context.diagnostics.back_to(mark);
        pipeline.body.clear();
        check_block(again, statements);
        const bool is_settled = again.device_variables.size() == known;
        std::swap(body.scopes, again.scopes);
        body.device_variables = again.device_variables;
        body.returns = again.returns;
        body.range_result = again.range_result;
        body.host_needed = again.host_needed;
        if (is_settled) break;
    }
    pipeline.host_needed = body.host_needed;
}

}  // namespace

// The type of a range result is that of the returned slices, which must all be of one structure type.
void check_range_return(Body& body, const ast::Stmt& stmt) {
    Context& c = body.context;
    ir::StmtId id = add(body.program(), ir::StmtOp::return_, stmt.span);
    if (!stmt.value) {
        c.error(Diag::return_nothing, stmt.span, {"a range"});
        return;
    }
    ir::ExprId value = check_value(body, stmt.value);
    ir::TypeId type = body.program().exprs[value].type;
    if (is_error(body, value)) return;
    RangeResult& result = *body.range_result;
    if (body.types().kind(type) != ir::TypeKind::slice || (result.slice && result.slice != type)) {
        c.error(Diag::type_mismatch, c[stmt.value].span,
                {result.slice ? c.text(result.slice) : "a range", c.text(type)});
        return;
    }
    const ir::StructureId structure = c.types()[c.types()[type].element].structure;
    if (!check_range(c, structure, result.domain, result.element, c[stmt.value].span)) return;
    result.slice = type;
    body.program().stmts[id].value = value;
    emit(body, id);
}

/// All declarations with the name of the pipeline, in its container or in its module.
static std::vector<ast::DeclId> overloads_of(Context& c, ast::DeclId id, ir::StructureId owner) {
    std::vector<ast::DeclId> all;
    if (!owner) {
        const auto& names = c.scopes[c.module_of.at(id)].names;
        const auto found = names.find(c[id].name.name);
        return found == names.end() ? all : found->second;
    }
    for (const ast::Item* item : items_of(c, owner))
        if (item->decl && c[item->decl].name.name == c[id].name.name) all.push_back(item->decl);
    return all;
}

/// The name of the declaration with its module and its container, the same for all instances; then, unless it is the
/// first of its overloads, its number among them.
static std::string name_of_declaration(Context& c, ast::DeclId id, ir::StructureId owner) {
    const std::vector<ast::DeclId> all = overloads_of(c, id, owner);
    const auto place = std::ranges::find(all, id) - all.begin();
    return ir::module_text(c.program, c.module_of.at(id)) +
           (owner ? c.text(c.program.structures[owner].name) + "." : "") + c.text(c[id].name.name) +
           (place == 0 ? "" : "<overload " + std::to_string(place + 1) + ">");
}

// If the declared result is T, the instance's result is T or T on the device, depending on the returned values.
ir::PipelineId instantiate_pipeline(Context& c, ast::DeclId id, const Env& env, const std::vector<Passed>& passed,
                                    ir::StructureId owner, Span use) {
    const ast::Decl& decl = c[id];
    const auto& written = std::get<ast::Pipeline>(decl.body);
    std::string key = key_of(c, id, env) + (owner ? "!" + std::to_string(owner.index) : "");
    for (const Passed& each : passed) key += "@" + (each.on_device ? "device" : std::to_string(each.structure.index));
    if (auto found = c.instances.find(key); found != c.instances.end()) {
        if (found->second.state == Instance::State::in_progress)
            c.error(Diag::recursion, use, {c.text(decl.name.name)});
        return {found->second.index};
    }
    InstantiationScope scope(c, display_of(c, decl, env), use);
    if (scope.too_deep()) return {};
    c.instances[key] = {};
    std::size_t errors = c.diagnostics.own_error_count();
    ir::Pipeline pipeline;
    pipeline.name = decl.name.name;
    pipeline.display = display_of(c, decl, env);
    pipeline.key = qualified_display_of(c, id, env);
    pipeline.span = decl.name.span;
    pipeline.module = c.module_of.at(id);
    pipeline.is_pub = decl.is_pub && std::ranges::none_of(passed, &Passed::on_device);
    pipeline.owner = owner;
    pipeline.doc = decl.doc;
    Body body{.context = c,
              .env = env,
              .kind = BodyKind::pipeline,
              .block = &pipeline.body,
              .key = name_of_declaration(c, id, owner)};
    if (owner) bring_members_into_scope(body, owner);
    open_scope(body);
    for (std::size_t i = 0; i < written.params.size(); ++i)
        add_param(body, written.params[i], i < passed.size() ? passed[i] : Passed{}, pipeline);
    pipeline.result = declared_result(body, written);
    body.result = pipeline.result;
    open_scope(body);
    check_pipeline_body(body, written.body, pipeline);
    check_replaced_together(body);
    close_scope(body);
    close_scope(body);
    if (body.range_result) pipeline.result = body.range_result->slice ? body.range_result->slice : c.types().error;
    if (body.returns == Body::Returns::device) pipeline.result = c.types().device(pipeline.result);
    bool returns = pipeline.result == c.types().void_ || always_returns(c.program, pipeline.body);
    if (!returns && c.diagnostics.own_error_count() == errors)
        c.error(Diag::missing_return, decl.name.span,
                {c.text(decl.name.name), body.range_result ? "a range" : c.text(pipeline.result)});
    pipeline.changes_owner = ir::changes_owner(c.program, pipeline);
    Instance& instance = c.instances[key];
    instance.state = c.diagnostics.own_error_count() == errors ? Instance::State::done : Instance::State::failed;
    if (instance.state == Instance::State::failed) return {};
    const ir::PipelineId made = c.program.pipelines.add(std::move(pipeline));
    instance.index = made.index;
    if (owner) c.program.structures[owner].pipelines.push_back(made);
    return made;
}

void instantiate_test(Context& c, ast::DeclId id) {
    const ast::Decl& decl = c[id];
    const auto& written = std::get<ast::Test>(decl.body);
    std::size_t errors = c.diagnostics.own_error_count();
    ir::Pipeline pipeline;
    pipeline.name = c.names.intern("test_" + std::to_string(c.program.tests.size()));
    pipeline.display = written.title;
    pipeline.span = decl.span;
    pipeline.module = c.module_of.at(id);
    pipeline.result = c.types().void_;
    Env& env = c.new_env(pipeline.module);
    Body body{.context = c,
              .env = env,
              .kind = BodyKind::pipeline,
              .block = &pipeline.body,
              .result = pipeline.result,
              .in_test = true,
              .key = ir::module_text(c.program, pipeline.module) + "test " + written.title};
    open_scope(body);
    check_pipeline_body(body, written.body, pipeline);
    close_scope(body);
    if (c.diagnostics.own_error_count() != errors) return;
    c.program.tests.push_back(
        {written.title, decl.span, c.module_of.at(id), c.program.pipelines.add(std::move(pipeline))});
}

}  // namespace gliftc::sema
