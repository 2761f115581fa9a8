// Writes that are combined (scatter<S, op>). Those of integers are one atomic operation, and so are sums of floats
// (GL_EXT_shader_atomic_float), but in buffers of devices that have none: there they are made by compare-and-swap in a
// loop. Minima and maxima of floats are atomic operations on integers with the same bits, without a loop.
#include "emit/glsl/printer.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace gliftc::glsl {

using ir::Combine;
using ir::MemoryShape;
using ir::PassBinding;
using ir::TypeKind;

namespace {

const char* atomic_name(Combine combine) {
    switch (combine) {
    case Combine::replace: return "Exchange";
    case Combine::min: return "Min";
    case Combine::max: return "Max";
    case Combine::add: return "Add";
    case Combine::bit_and: return "And";
    case Combine::bit_or: return "Or";
    case Combine::bit_xor: return "Xor";
    }
    return "";
}

std::string lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string float_atomic(Printer& p, std::uint32_t binding, Combine combine) {
    for (const AtomicUse& use : p.atomics)
        if (use.binding == binding && use.combine == combine) return use.name;
    const std::string wanted = p.pass.bindings[binding].name + "_" + lower_case(atomic_name(combine));
    p.atomics.push_back({binding, combine, p.names.declare_outermost(wanted)});
    return p.atomics.back().name;
}

/// The function that adds to a float in a buffer: by one atomic operation or, on devices that have none, by a
/// compare-and-swap that is repeated until no other invocation has changed the element in between. For these the
/// runtime takes the operation out of the module (vulkan/spirv/float_atomics.h).
std::string addition(Printer& p, const AtomicUse& use) {
    p.extensions.insert("GL_EXT_shader_atomic_float");
    const PassBinding& binding = p.pass.bindings[use.binding];
    const bool is_by_address = p.pass.form == ir::Form::general;
    const std::string floats = p.names.declare_outermost(binding.name + "_floats");
    const std::string block = p.names.declare_outermost(p.block_names[use.binding] + "_floats");
    const std::string layout = is_by_address
                                   ? "layout(buffer_reference, scalar, buffer_reference_align = 4) "
                                   : "layout(scalar, set = 0, binding = " + std::to_string(use.binding + 1) + ") ";
    const std::string member = is_by_address ? "at" : floats + "[]";
    const std::string element = element_text(p, use.binding, "index");
    const std::string as_float = is_by_address ? block + element.substr(element.find('(')) : floats + "[index]";
    const std::string adds = need(p, Helper::adds_floats, p.program.types.bool_);
    return layout + "buffer " + block + " { float " + member + "; };   // the same memory as " +
           p.block_names[use.binding] + "\nvoid " + use.name + "(" + (is_by_address ? "uint64_t" : "uint") +
           " index, float value) {\n" +  // zeros are common where what is added is a weight
           "    if (value == 0.0) return;\n"
           "    if (" +
           adds + ") {\n" + "        atomicAdd(" + as_float + ", value);\n" +
           "        return;\n"
           "    }\n"
           "    uint seen = " +
           element + ", expected;\n" +
           "    do {\n"
           "        expected = seen;\n"
           "        uint wanted = floatBitsToUint(uintBitsToFloat(seen) + value);\n"
           "        if (wanted == seen) return;\n"
           "        seen = atomicCompSwap(" +
           element + ", expected, wanted);\n" + "    } while (seen != expected);\n}\n\n";
}

/// How the function for minima and maxima accesses the float.
struct BitsPlace {
    std::string parameter;  ///< the function's parameter: the element's index, or the texel
    std::string load;
    std::string arguments;  ///< the first arguments of an atomic operation on it
    std::string prefix;     ///< of atomic operations: atomicMin, imageAtomicMin
};

BitsPlace bits_place(const Printer& p, std::uint32_t slot) {
    const PassBinding& binding = p.pass.bindings[slot];
    const std::string& name = p.binding_names[slot];
    if (binding.shape == MemoryShape::buffer) {
        const std::string element = element_text(p, slot, "index");
        return {p.pass.form == ir::Form::general ? "uint64_t index" : "uint index", element, element, "atomic"};
    }
    const bool is_line = binding.shape == MemoryShape::image1d, is_flat = binding.shape == MemoryShape::image2d;
    return {is_line   ? "int at"
            : is_flat ? "ivec2 at"
                      : "ivec3 at",
            "imageLoad(" + name + ", at).x", name + ", at", "imageAtomic"};
}

/// The function for minima and maxima. The bits of floats that are not negative have the order of ints, those of
/// negative ones (-0.0 is one) the reverse order. So one signed operation is enough for a value that is not negative. A
/// negative value may overwrite a better one, which is put back at once; since nothing else in this pass reads the
/// element, only the final value counts. A NaN is not written; a NaN in memory is replaced by the first value. If the
/// value read first (`there`) makes a write needless, it need not be the newest value: the final value is at least as
/// good.
std::string extremum(const Printer& p, const AtomicUse& use) {
    const BitsPlace place = bits_place(p, use.binding);
    const auto call = [&](const std::string& operation, const std::string& value) {
        return place.prefix + operation + "(" + place.arguments + ", " + value + ")";
    };
    const bool is_max = use.combine == Combine::max;
    const std::string negative = is_max ? "    if (there >= 0 || there <= bits) return;\n"
                                          "    int before = " +
                                              call("Min", "bits") +
                                              ";\n"
                                              "    if (before >= 0) " +
                                              call("Max", "before") + ";\n"
                                        : "    if (there < 0 && there >= bits) return;\n"
                                          "    int before = there < 0 ? there : " +
                                              call("Min", "bits") +
                                              ";\n"
                                              "    if (before < 0) " +
                                              call("Max", "max(before, bits)") + ";\n";
    return "void " + use.name + "(" + place.parameter +
           ", float value) {\n"
           "    const int bits = floatBitsToInt(value);\n"
           "    if ((bits & 0x7fffffff) > 0x7f800000) return;\n"
           "    int there = " +
           place.load +
           ";\n"
           "    if ((there & 0x7fffffff) > 0x7f800000) there = " +
           call("CompSwap", "there, bits") +
           ";\n"
           "    if (bits >= 0) {\n"
           "        if (there " +
           (is_max ? "< bits) " : "> bits) ") + call(atomic_name(use.combine), "bits") +
           ";\n"
           "        return;\n    }\n" +
           negative + "}\n\n";
}

}  // namespace

std::string atomic_text(Printer& p, const ir::Stmt& stmt) {
    const PassBinding& binding = p.pass.bindings.at(stmt.slot);
    const std::string value = print_any(p, stmt.value);
    const TypeKind kind = p.program.types.kind(p.program.types.scalar_of(binding.element));
    const bool is_buffer = binding.shape == MemoryShape::buffer;
    if (stored_as_bits(p, binding)) {
        const std::string place = is_buffer ? print_any(p, stmt.target) : texel_text(p, stmt.target);
        return float_atomic(p, stmt.slot, stmt.combine) + "(" + place + ", " + value + ");";
    }
    if (!is_buffer) {
        if (kind == TypeKind::float_) p.extensions.insert("GL_EXT_shader_atomic_float");
        return std::string("imageAtomic") + atomic_name(stmt.combine) + "(" + p.binding_names[stmt.slot] + ", " +
               texel_text(p, stmt.target) + ", " + value + ");";
    }
    if (kind == TypeKind::int64 || kind == TypeKind::uint64) p.extensions.insert("GL_EXT_shader_atomic_int64");
    return std::string("atomic") + atomic_name(stmt.combine) + "(" + element_text(p, stmt.slot, stmt.target) + ", " +
           value + ");";
}

std::string atomic_definitions(Printer& p) {
    std::string text;
    for (const AtomicUse& use : p.atomics) text += use.combine == Combine::add ? addition(p, use) : extremum(p, use);
    return text;
}

}  // namespace gliftc::glsl
