#include "ir/reader.h"
#include "ir/spelling.h"

namespace gliftc::ir {

std::array<std::uint32_t, 3> Reader::three() {
    std::array<std::uint32_t, 3> found;
    for (std::uint32_t& each : found) each = static_cast<std::uint32_t>(number());
    return found;
}

void Reader::dispatch() {
    Pass& pass = current();
    pass.group = three();
    expect(",");
    expect("rank");
    pass.rank = static_cast<std::uint32_t>(number());
    while (accept(",")) {
        if (accept("items")) {
            pass.items = static_cast<std::uint32_t>(number());
        } else {
            expect("declared");
            kernel().group = pass.group;
        }
    }
}

StructureId Reader::new_structure(const std::string& called) {
    Structure made;
    made.name = p.names->intern(called);
    made.display = called;
    made.element = made.domain_type = p.types.void_;
    return p.structures.add(std::move(made));
}

void Reader::kernel_parameter(bool is_value) {
    KernelParam made;
    const std::string called = name();
    made.name = p.names->intern(called);
    if (is_value) {
        expect(":");
        made.local = declared(called, {.type = type()});
    } else {
        made.pattern = Pattern::any;
        made.structure = new_structure(called);
        roots_[called] = static_cast<std::uint32_t>(kernel().params.size());
        made.alike = roots_[called];
    }
    kernel().params.push_back(std::move(made));
}

std::uint32_t Reader::kernel_parameter_index() {
    const auto found = roots_.find(word());
    if (found == roots_.end()) fail("no such structure before this");
    return found->second;
}

std::uint32_t Reader::earlier_binding() {
    const auto found = bindings_.find(name());
    if (found == bindings_.end()) fail("no such binding before this");
    return found->second;
}

Compare Reader::compare() {
    const auto found = spelled(word(), Compare::greater_equal);
    if (!found) fail("expected a comparison before this");
    return *found;
}

void Reader::binding() {
    PassBinding made;
    made.name = name();
    expect(":");
    const auto shape = spelled(word(), MemoryShape::image2darray);
    if (!shape) fail("expected a kind of memory before this");
    made.shape = *shape;
    expect("<");
    made.element = type();
    expect(">");
    const auto access = spelled(word(), Access::read_write);
    if (!access) fail("expected an access before this");
    made.access = *access;
    made.one_place = static_cast<std::uint32_t>(current().bindings.size());
    while (!accept("of")) {
        if (accept("sampled")) made.sampled = true;
        else if (accept("linear")) made.linear = true;
        else if (accept("atomic")) made.atomic = true;
        else if (accept("ordered")) made.ordered = true;
        else if (accept("coherent")) made.coherent = true;
        else if (accept("in_rows")) made.in_rows = true;
        else if (accept("one_place")) made.one_place = earlier_binding();
        else if (accept("compare")) made.compare = compare();
        else if (const auto format = spelled(word(), Format::d32)) made.format = *format;
        else fail("expected a property of a binding before this");
    }
    made.is_workspace = accept("workspace");
    if (!made.is_workspace) {
        made.place = place();
        made.memory = static_cast<std::uint32_t>(number());
    }
    if (accept("at")) {
        expect("$");
        name();  // the address parameter is declared later, and names this binding
    }
    bindings_[made.name] = static_cast<std::uint32_t>(current().bindings.size());
    current().bindings.push_back(std::move(made));
}

void Reader::pass_parameter() {
    PassParameter made;
    made.name = name();
    expect(":");
    made.type = type();
    expect("=");
    if (accept("origin")) {
        made.source = ParameterSource::origin;
        made.param = kernel_parameter_index();
    } else if (accept("size")) {
        made.source = ParameterSource::size;
    } else if (accept("range_size")) {
        made.source = ParameterSource::range_size;
        made.param = kernel_parameter_index();
    } else if (accept("index")) {
        made.source = ParameterSource::index;
        made.param = kernel_parameter_index();
    } else if (accept("base")) {
        made.source = ParameterSource::base;
    } else if (accept("address")) {
        made.source = ParameterSource::address;
        made.param = bindings_.at(name());
        current().bindings[made.param].address_parameter = static_cast<std::uint32_t>(current().parameters.size());
    } else {
        made.value = expr();
    }
    parameters_[made.name] = static_cast<std::uint32_t>(current().parameters.size());
    current().parameters.push_back(std::move(made));
}

void Reader::function() {
    expect("@");
    const std::string called = name();
    Function made;
    made.name = p.names->intern(called.substr(0, called.find('.')));
    expect("(");
    while (!accept(")")) {
        const std::string param = name();
        expect(":");
        made.params.push_back(declared(param, {.type = type()}));
        accept(",");
    }
    expect("->");
    made.result = type();
    const FunctionId id = p.functions.add(std::move(made));
    functions_[called] = id;
    p.functions[id].body = block();
    current().functions.push_back(id);
}

/// Reads the rest of: given name: type. It is a local that a part of a draw exchanges with the rasteriser (raster.h).
void Reader::given() {
    const std::string called = name();
    expect(":");
    Varying made;
    made.read = declared(called, {.type = type()});
    std::optional<Raster>& raster = p.kernels[current().kernel].raster;
    if (!raster) raster.emplace();
    raster->varyings.push_back(made);
}

bool Reader::header() {
    Pass& pass = current();
    if (accept("group")) dispatch();
    else if (accept("loops")) pass.loop_rounds = accept("unbounded") ? ~0ull : number();
    else if (accept("reports")) pass.has_reports = true;
    else if (accept("inexact")) pass.exact = false;
    else if (accept("struct")) declare_struct();
    else if (accept("enum")) declare_enum();
    else if (accept("value")) kernel_parameter(true);
    else if (accept("structure")) kernel_parameter(false);
    else if (accept("given")) given();
    else if (accept("binding")) binding();
    else if (accept("parameter")) pass_parameter();
    else if (accept("fact")) read_.facts.push_back(expr());
    else if (accept("fn")) function();
    else if (accept("shared")) {
        const std::string called = name();
        expect(":");
        pass.shared.push_back(declared(called, {.type = type(), .is_mutable = true, .storage = Storage::shared}));
    } else if (accept("address")) {
        const std::string called = name();
        expect(":");
        pass.address = declared(called, {.type = type()});
    } else if (accept("in_range")) {
        pass.in_range = declared(name(), {.type = p.types.bool_});
    } else {
        return false;
    }
    return true;
}

bool Reader::section() {
    if (accept("prologue")) {
        current().prologue = statements();
        return true;
    }
    std::optional<std::vector<StmtId>> block;
    if (accept("block")) block = statements();
    if (accept("body")) current().variants.push_back(variant(Part::whole));
    else if (accept("vertex")) current().variants.push_back(variant(Part::vertex));
    else if (accept("fragment")) current().variants.push_back(variant(Part::fragment));
    else return false;
    current().variants.back().block = std::move(block);
    return true;
}

Variant Reader::variant(Part part) {
    Variant made;
    made.part = part;
    made.assumes.elements = {current().items, 1, 1};
    while (accept(",")) {
        if (accept("on shaders")) {
            made.devices = Devices::shaders;
        } else if (accept("on host")) {
            made.devices = Devices::host;
        } else if (accept("takes")) {
            made.assumes.elements = three();
        } else if (accept("rows of")) {
            made.assumes.row = static_cast<std::uint32_t>(number());
        } else if (accept("any order")) {
            made.order = RowOrder::any;
        } else if (accept("in blocks")) {
            made.order = RowOrder::in_blocks;
        } else if (accept("bounds")) {
            made.assumes.bounds.push_back(bounds());
        } else {
            made.assumes.interior = interior();
        }
    }
    made.body = statements();
    return made;
}

/// Reads (value, low, high), where `any` may stand for `low` or `high`: that side is not limited.
Bounds Reader::bounds() {
    const auto limit = [&] {
        expect(",");
        return accept("any") ? ExprId{} : expr();
    };
    Bounds made;
    expect("(");
    made.value = expr();
    made.low = limit();
    made.high = limit();
    expect(")");
    return made;
}

/// Reads: inside radius of $domain [from $origin].
Interior Reader::interior() {
    const auto parameter = [&] {
        expect("$");
        return parameter_slot();
    };
    Interior made;
    expect("inside");
    made.radius = static_cast<std::uint32_t>(number());
    expect("of");
    made.domain = parameter();
    if (accept("from")) made.origin = parameter();
    return made;
}

ReadPass Reader::pass() {
    read_ = {};
    locals_.clear();
    functions_.clear();
    bindings_.clear();
    parameters_.clear();
    roots_.clear();
    types_.clear();
    expect("pass");
    Kernel made;
    made.name = p.names->intern(word());
    const auto form = spelled(word(), Form::general);
    if (!form) fail("expected a form before this");
    current().form = *form;
    current().is_wide = accept("wide");
    current().kernel = p.kernels.add(std::move(made));
    expect("{");
    while (header()) {}
    current().variants.clear();
    while (section()) {}
    expect("}");
    if (current().variants.empty()) current().variants.resize(1);
    return std::move(read_);
}

std::vector<ReadPass> read_passes(Program& program, std::string_view text) {
    Reader reader(program, text);
    std::vector<ReadPass> passes;
    while (!reader.at_end()) passes.push_back(reader.pass());
    return passes;
}

}  // namespace gliftc::ir
