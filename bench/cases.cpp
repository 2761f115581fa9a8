#include "cases.h"

#include "instructions.h"

#include "cases.glift.hpp"
#include "gather_places.h"
#include "laplacian.h"
#include "stencil.h"
#include "stream.h"

#include <memory>
#include <random>

namespace bench {

namespace {

using glift::Access;
using glift::MemoryKind;

constexpr glift::Binding buffer(const char* name, Access access) {
    return {.name = name, .kind = MemoryKind::buffer, .access = access};
}

constexpr glift::Binding f_and_g[] = {buffer("f", Access::read), buffer("g", Access::write)};
constexpr glift::Binding images[] = {
    {.name = "f", .kind = MemoryKind::image2d, .access = Access::read, .sampled = true},
    {.name = "g", .kind = MemoryKind::image2d, .access = Access::write}};
constexpr glift::Binding p_f_and_g[] = {buffer("p", Access::read), buffer("f", Access::read),
                                        buffer("g", Access::write)};

const glift::Kernel laplacian_twin = {.name = "laplacian by hand",
                                      .file = "laplacian.comp",
                                      .line = 1,
                                      .rank = 4,
                                      .group = {32, 4, 2},
                                      .loop_rounds = 0,
                                      .bindings = f_and_g,
                                      .direct = {.spirv = laplacian, .parameter_bytes = 16, .push_constants = true},
                                      .items = {1, 2, 1}};
const glift::Kernel stream_twin = {.name = "stream by hand",
                                   .file = "stream.comp",
                                   .line = 1,
                                   .rank = 1,
                                   .group = {256, 1, 1},
                                   .loop_rounds = 0,
                                   .bindings = images,
                                   .direct = {.spirv = stream, .parameter_bytes = 8, .push_constants = true},
                                   .items = {2, 1, 1}};
const glift::Kernel stencil_twin = {.name = "stencil by hand",
                                    .file = "stencil.comp",
                                    .line = 1,
                                    .rank = 2,
                                    .group = {32, 8, 1},
                                    .loop_rounds = 0,
                                    .bindings = f_and_g,
                                    .direct = {.spirv = stencil, .parameter_bytes = 12, .push_constants = true},
                                    .items = {1, 2, 1}};
const glift::Kernel gather_twin = {.name = "gather by hand",
                                   .file = "gather_places.comp",
                                   .line = 1,
                                   .rank = 1,
                                   .group = {256, 1, 1},
                                   .loop_rounds = 0,
                                   .bindings = p_f_and_g,
                                   .direct = {.spirv = gather_places, .parameter_bytes = 16, .push_constants = true},
                                   .items = {2, 1, 1}};

/// Dispatches a hand-written kernel (the "twin" of a generated one) once.
template <class Block, std::size_t n> void dispatch(const glift::Commands& commands, const glift::Kernel& kernel,
                                                    const Block& block, const glift::Memory (&memories)[n],
                                                    glift::Extent size) {
    commands.dispatch(kernel, {.form = glift::FormName::direct,
                               .memories = memories,
                               .parameters = std::as_bytes(std::span(&block, 1)),
                               .size = size});
}

std::vector<float> random_floats(std::uint64_t count) {
    std::mt19937 engine(7);
    std::vector<float> values(count);
    for (float& value : values) value = static_cast<float>(engine() % 1000) / 8.0f;
    return values;
}

template <class S> std::function<std::vector<std::byte>()> reader(std::shared_ptr<S> s) {
    return [s] {
        const auto values = s->read({}, s->domain());
        const auto bytes = std::as_bytes(std::span(values));
        return std::vector<std::byte>(bytes.begin(), bytes.end());
    };
}

/// Makes a case with everything but its two passes: name, number of elements, how `g` is read and cleared, and the
/// SPIR-V of the generated and of the hand-written shader (`twin`).
template <class S>
Case begin(const char* name, std::uint64_t elements, std::shared_ptr<S> g, std::span<const std::uint32_t> twin) {
    Case one{.name = name, .elements = elements};
    one.result = reader(g);
    one.clear = [g] { g->fill(-1.0f); };
    one.generated_spirv = read_spirv(std::string(GLIFT_BENCH_SPIRV) + "/cases." + name + ".comp.spv");
    one.handwritten_spirv.assign(twin.begin(), twin.end());
    return one;
}

Case laplacian_case(const glift::Device& device, std::uint32_t scale) {
    const glift::uint4 extent{32, 32, 32, 32 * scale};
    const std::uint64_t count = std::uint64_t{32} * 32 * 32 * 32 * scale;
    auto f = std::make_shared<cases::Field>(device, extent), g = std::make_shared<cases::Field>(device, extent);
    f->write({}, extent, random_floats(count));
    Case one = begin("laplacian", count, g, laplacian);
    one.generated = [=](const glift::Commands& commands) { cases::laplacian(commands, *f, *g); };
    one.handwritten = [=](const glift::Commands& commands) {
        dispatch(commands, laplacian_twin, extent, {f->data(), g->data()}, {extent.x, extent.y, extent.z, extent.w});
    };
    return one;
}

Case stream_case(const glift::Device& device, std::uint32_t scale) {
    const std::uint32_t count = (1u << 20) * scale;
    auto f = std::make_shared<cases::Stream>(device, count), g = std::make_shared<cases::Stream>(device, count);
    f->write({}, count, random_floats(count));
    Case one = begin("stream", count, g, stream);
    one.generated = [=](const glift::Commands& commands) { cases::stream(commands, *f, *g); };
    one.handwritten = [=](const glift::Commands& commands) {
        const std::uint32_t block[] = {count, f->data().extent()[0]};
        dispatch(commands, stream_twin, block, {f->data(), g->data()}, {count, 1, 1, 1});
    };
    return one;
}

Case stencil_case(const glift::Device& device, std::uint32_t scale) {
    const glift::uint2 extent{1024, 1024 * scale};
    const std::uint64_t count = std::uint64_t{1024} * 1024 * scale;
    auto f = std::make_shared<cases::Plane>(device, extent), g = std::make_shared<cases::Plane>(device, extent);
    f->write({}, extent, random_floats(count));
    Case one = begin("stencil", count, g, stencil);
    one.generated = [=](const glift::Commands& commands) { cases::stencil(commands, *f, *g); };
    one.handwritten = [=](const glift::Commands& commands) {
        const std::uint32_t block[] = {extent.x, extent.y, (extent.x + 7) / 8};
        dispatch(commands, stencil_twin, block, {f->data(), g->data()}, {extent.x, extent.y, 1, 1});
    };
    return one;
}

Case gather_case(const glift::Device& device, std::uint32_t scale) {
    const std::uint32_t side = scale > 1 ? 256 : 128, count = (1u << 19) * scale;
    const glift::uint3 extent{side, side, side};
    auto f = std::make_shared<cases::Cloud>(device, extent);
    auto p = std::make_shared<cases::Places>(device, count);
    auto g = std::make_shared<cases::Values>(device, count);
    f->write({}, extent, random_floats(std::uint64_t{side} * side * side));
    std::mt19937 engine(11);
    const auto below = [&](std::uint32_t limit) { return static_cast<std::uint32_t>(engine() % limit); };
    std::vector<glift::uint3> places(count);
    for (glift::uint3& place : places) place = {below(side), below(side), below(side + 1)};  // some lie outside
    p->write({}, count, places);
    Case one = begin("gather_places", count, g, gather_places);
    one.generated = [=](const glift::Commands& commands) { cases::gather_places(commands, *f, *p, *g); };
    one.handwritten = [=](const glift::Commands& commands) {
        const std::uint32_t block[] = {count, side, side, side};
        dispatch(commands, gather_twin, block, {p->data(), f->data(), g->data()}, {count, 1, 1, 1});
    };
    return one;
}

}  // namespace

std::vector<Case> make_cases(const glift::Device& device, std::uint32_t scale) {
    return {laplacian_case(device, scale), stream_case(device, scale), stencil_case(device, scale),
            gather_case(device, scale)};
}

}  // namespace bench
