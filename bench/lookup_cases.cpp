#include "lookup_cases.h"

#include "lookups.glift.hpp"
#include "read_any_pages.h"
#include "read_pages.h"
#include "read_stream.h"
#include "sample_tree.h"

#include <bit>
#include <memory>
#include <random>

namespace bench {

namespace {

using glift::Access;
using glift::MemoryKind;
using Number = std::uint32_t;

constexpr glift::Binding buffer(const char* name, Access access = Access::read) {
    return {.name = name, .kind = MemoryKind::buffer, .access = access};
}
constexpr glift::Binding image(const char* name, MemoryKind kind, glift::Filter filter = glift::Filter::nearest) {
    return {.name = name, .kind = kind, .access = Access::read, .sampled = true, .sampler = {.filter = filter}};
}
constexpr glift::Binding written = buffer("g", Access::write);

struct StreamBlock {
    Number count, size, width;
};
struct PagesBlock {
    Number count;
    glift::uint3 extent;
    glift::uint2 pages, bits;
    float background;
};
struct AnyPagesBlock {
    Number count;
    glift::uint3 extent, size;
    glift::uint2 pages, bits;
};
struct TreeBlock {
    Number count, along, first, bits;
    float width, height;
};

constexpr glift::Binding of_stream[] = {buffer("p"), image("f", MemoryKind::image2d), written};
constexpr glift::Binding of_pages[] = {buffer("p"), buffer("table"), image("frames", MemoryKind::image3d), written};
constexpr glift::Binding of_tree[] = {buffer("x"), buffer("best"), buffer("unused"),
                                      image("frames", MemoryKind::image2d, glift::Filter::linear), written};

/// The parameters of a hand-written kernel ("twin") as one parameter, `block`, so that a specialised call can fix all
/// of them.
template <class Block> constexpr glift::Parameter whole[] = {{"block", 0, sizeof(Block)}};

template <class Block, std::size_t words> glift::Kernel twin(const char* name, std::span<const glift::Binding> bindings,
                                                             const std::uint32_t (&spirv)[words], Number items) {
    return {.name = name,
            .file = name,
            .line = 1,
            .rank = 1,
            .group = {256, 1, 1},
            .loop_rounds = 0,
            .bindings = bindings,
            .direct = {.spirv = spirv, .parameter_bytes = sizeof(Block), .push_constants = true},
            .parameters = whole<Block>,
            .items = {items, 1, 1}};
}

const glift::Kernel stream_twin = twin<StreamBlock>("read_stream.comp", of_stream, read_stream, 2);
const glift::Kernel pages_twin = twin<PagesBlock>("read_pages.comp", of_pages, read_pages, 1);
const glift::Kernel any_pages_twin = twin<AnyPagesBlock>("read_any_pages.comp", of_pages, read_any_pages, 1);
const glift::Kernel tree_twin = twin<TreeBlock>("sample_tree.comp", of_tree, sample_tree, 1);

template <class Block, std::size_t n> void dispatch(const glift::Commands& commands, const glift::Kernel& kernel,
                                                    const Block& block, const glift::Memory (&memories)[n]) {
    commands.dispatch(kernel, {.form = glift::FormName::direct,
                               .memories = memories,
                               .parameters = std::as_bytes(std::span(&block, 1)),
                               .size = {block.count, 1, 1, 1}});
}

/// Makes a case with what all cases have alike: name, number of elements, how the output `g` is read and cleared.
template <class S> Case begin(const char* name, std::shared_ptr<S> g) {
    Case one{.name = name, .elements = g->domain()};
    one.result = [g] {
        const auto values = g->read();
        const auto bytes = std::as_bytes(std::span(values));
        return std::vector<std::byte>(bytes.begin(), bytes.end());
    };
    one.clear = [g] { g->fill({}); };
    return one;
}

Case stream_case(const glift::Device& device, Number count) {
    auto f = std::make_shared<lookups::Stream>(device, count);
    auto p = std::make_shared<lookups::Numbers>(device, count);
    auto g = std::make_shared<lookups::Values>(device, count);
    std::mt19937 engine(3);
    std::vector<float> values(count);
    std::vector<Number> places(count);
    for (float& value : values) value = static_cast<float>(engine() % 1000) / 8.0f;
    for (Number& place : places) place = engine() % (count + 100);  // some lie outside
    f->write(values);
    p->write(places);
    Case one = begin("stream, 1-D to 2-D", g);
    one.generated = [=](const glift::Commands& commands) { lookups::read_stream(commands, *f, *p, *g); };
    one.handwritten = [=](const glift::Commands& commands) {
        const StreamBlock block = {count, count, f->data().extent()[0]};
        dispatch(commands, stream_twin, block, {p->data(), f->data(), g->data()});
    };
    return one;
}

/// A page table seven in eight of whose pages are resident, an image of frames for them, and addresses to read.
struct Paged {
    Paged(const glift::Device& device, Number side, Number count)
        : extent(side, side, side), pages(side / 8, side / 8), capacity(pages.x * pages.x * pages.x),
          bits((std::countr_zero(capacity) + 2) / 3, (std::countr_zero(capacity) + 1) / 3), table(device, capacity),
          frames(device, capacity), places(device, count), g(std::make_shared<lookups::Values>(device, count)) {
        std::mt19937 engine(11);
        const auto below = [&](Number limit) { return engine() % limit; };
        std::vector<Number> entries(capacity);
        for (Number i = 0; i < capacity; ++i) entries[i] = i + 1;
        for (Number i = capacity; i-- > 1;) std::swap(entries[i], entries[below(i + 1)]);
        for (Number& entry : entries)
            if (entry > capacity / 8 * 7) entry = 0;
        table.write(entries);
        lookups::fill_pool(device, frames);
        std::vector<glift::uint3> to_read(count);
        for (glift::uint3& place : to_read)
            place = {static_cast<Number>(below(side)), static_cast<Number>(below(side)),
                     static_cast<Number>(below(side + 1))};
        places.write(to_read);
    }

    glift::uint3 extent;
    glift::uint2 pages;
    Number capacity;
    glift::uint2 bits;
    lookups::Numbers table;
    lookups::Frames frames;
    lookups::Places places;
    std::shared_ptr<lookups::Values> g;
};

Case pages_case(const std::shared_ptr<Paged>& paged) {
    auto f =
        std::make_shared<lookups::Field>(paged->places.device(), paged->table, paged->frames, paged->extent, -1.0f);
    Case one = begin("page table, 3-D to 3-D", paged->g);
    one.generated = [=](const glift::Commands& commands) {
        lookups::read_field(commands, *f, paged->places, *paged->g);
    };
    one.handwritten = [=](const glift::Commands& commands) {
        const PagesBlock block = {paged->places.domain(), paged->extent, paged->pages, paged->bits, -1.0f};
        dispatch(commands, pages_twin, block,
                 {paged->places.data(), paged->table.data(), paged->frames.texels().data(), paged->g->data()});
    };
    return one;
}

Case any_pages_case(const std::shared_ptr<Paged>& paged) {
    const glift::uint3 size(8, 8, 8);
    auto f =
        std::make_shared<lookups::AnyField>(paged->places.device(), paged->table, paged->frames, paged->extent, size);
    Case one = begin("the same, its pages' size a parameter", paged->g);
    one.generated = [=](const glift::Commands& commands) {
        lookups::read_any_field(commands, *f, paged->places, *paged->g);
    };
    one.handwritten = [=](const glift::Commands& commands) {
        const AnyPagesBlock block = {paged->places.domain(), paged->extent, size, paged->pages, paged->bits};
        dispatch(commands, any_pages_twin, block,
                 {paged->places.data(), paged->table.data(), paged->frames.texels().data(), paged->g->data()});
    };
    return one;
}

Case tree_case(const glift::Device& device, Number levels, Number count) {
    const Number along = 1u << (levels - 1), capacity = along * along;
    auto tree = std::make_shared<lookups::Tree>(device, levels, capacity);
    auto x = std::make_shared<lookups::Points>(device, count);
    auto g = std::make_shared<lookups::Pairs>(device, count);
    std::mt19937 engine(5);
    const auto points = [&](Number n) {
        std::vector<glift::float2> all(n);
        const auto inside = [&] { return 0.5f + static_cast<float>(engine() % (along * 16 * 16)) / 16.0f; };
        for (glift::float2& point : all) point = {inside(), inside()};
        return all;
    };
    lookups::Points asked(device, capacity);
    asked.write(points(capacity));
    lookups::make_tree(device, asked, levels, *tree);
    x->write(points(count));
    Case one = begin("adaptive lookup and offset", g);
    one.generated = [=](const glift::Commands& commands) { lookups::lookup(commands, *tree, *x, *g); };
    one.handwritten = [=](const glift::Commands& commands) {
        const glift::Memory frames = tree->frames().texels().data();
        const TreeBlock block = {count,
                                 along,
                                 (capacity - 1) / 3,
                                 static_cast<Number>(std::bit_width(capacity - 1) + 1) / 2,
                                 static_cast<float>(frames.extent()[0]),
                                 static_cast<float>(frames.extent()[1])};
        dispatch(commands, tree_twin, block, {x->data(), tree->best().data(), tree->best().data(), frames, g->data()});
    };
    return one;
}

}  // namespace

std::vector<Case> make_lookups(const glift::Device& device, std::uint32_t scale) {
    const Number count = (1u << 19) * scale;
    const auto paged = std::make_shared<Paged>(device, scale > 1 ? 256 : 128, count);
    return {stream_case(device, count), pages_case(paged), any_pages_case(paged),
            tree_case(device, scale > 1 ? 8 : 6, count)};
}

Case specialised(Case one) {
    one.generated = [run = one.generated](const glift::Commands& commands) { run(commands.specialised()); };
    one.handwritten = [run = one.handwritten](const glift::Commands& commands) { run(commands.specialised()); };
    return one;
}

}  // namespace bench
