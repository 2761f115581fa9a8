#include "sparse_grid.h"

#include <glift/error.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace gliftinfo {

using namespace glift::files;

namespace {

const FiledPart* part_named(const FiledPart& part, const std::string& name) {
    const auto found = std::ranges::find(part.parts, name, &FiledPart::name);
    return found == part.parts.end() ? nullptr : &*found;
}

/// The memory of the elements is at the path, or is the group of its fields.
bool has_memory(const FiledPart* part, const std::string& path) {
    return part && std::ranges::any_of(part->memories, [&](const FiledMemory& memory) {
               return !memory.is_image && ("/" + path == memory.path || ("/" + path).starts_with(memory.path + "/"));
           });
}

/// A structure with the members `field` and `frames`, where the frames may be those of the field.
struct Found {
    const FiledPart* structure = nullptr;
    const FiledPart* field = nullptr;
    bool is_hashed = false;
};

Found find(const FiledPart& part, const std::string& path) {
    if (const FiledPart* const field = part_named(part, "field")) {
        if (field->type.starts_with("Paged<3, ") && has_memory(part_named(*field, "frames"), path))
            return {&part, field, false};
        if (field->type.starts_with("HashedField<3, ") && has_memory(part_named(part, "frames"), path))
            return {&part, field, true};
    }
    for (const FiledPart& inner : part.parts)
        if (const Found found = find(inner, path); found.structure) return found;
    return {};
}

/// Of `Paged<3, float, uint3(8, 8, 8), …>`: the first uint3 is the page.
std::array<std::uint32_t, 3> page_of(const FiledPart& field) {
    std::array<std::uint32_t, 3> page{};
    const std::size_t at = field.type.find("uint3(");
    if (at != std::string::npos)
        std::sscanf(field.type.c_str() + at, "uint3(%u, %u, %u)", &page[0], &page[1], &page[2]);
    return page;
}

/// All numbers of a small memory of uints.
std::vector<std::uint32_t> uints(VerifiedFile& file, const std::vector<Content>& contents, const FiledPart* part) {
    std::vector<std::uint32_t> numbers;
    if (!part || part->memories.empty()) return numbers;
    const auto content = std::ranges::find(contents, part->memories[0].path.substr(1), &Content::path);
    if (content == contents.end() || content->field.scalar != Scalar::uint32) return numbers;
    read(file, *content, [&](std::span<const std::byte> bytes) {
        const std::size_t before = numbers.size();
        numbers.resize(before + bytes.size() / 4);
        std::memcpy(numbers.data() + before, bytes.data(), bytes.size());
    });
    return numbers;
}

std::uint32_t number_of(const FiledValue& value, std::size_t at) {
    std::uint32_t number = 0;
    if (!value.bytes.empty() && value.bytes[0].size() >= 4 * at + 4)
        std::memcpy(&number, value.bytes[0].data() + 4 * at, 4);
    return number;
}

class Pages {
public:
    explicit Pages(SparseGrid& grid) : grid_(grid) {
        for (unsigned i = 0; i < 3; ++i) along_[i] = (grid.extent[i] + grid.page[i] - 1) / grid.page[i];
    }
    void place(std::uint64_t frame, std::uint64_t page) {
        if (frame >= grid_.origins.size() || page >= along_[0] * along_[1] * along_[2]) return;
        const std::array<std::uint64_t, 3> position = {page % along_[0], page / along_[0] % along_[1],
                                                       page / along_[0] / along_[1]};
        grid_.origins[frame] = {position[0] * grid_.page[0], position[1] * grid_.page[1], position[2] * grid_.page[2]};
    }

private:
    SparseGrid& grid_;
    std::array<std::uint64_t, 3> along_{};
};

void find_background(const FiledPart& field, const Content& frames, SparseGrid& grid) {
    const auto value = std::ranges::find(field.values, "background", &FiledValue::name);
    if (value == field.values.end()) return;
    for (std::size_t i = 0; i < value->fields.size(); ++i)
        if (value->fields[i].name == frames.field.name && value->bytes[i].size() == 4) {
            float number;
            std::memcpy(&number, value->bytes[i].data(), 4);
            grid.background = static_cast<double>(number);
        }
}

void find_pages(VerifiedFile& file, const Found& found, const std::vector<Content>& contents, SparseGrid& grid) {
    const FiledPart* const pages = part_named(*found.structure, "pages");
    if (found.is_hashed) {
        const FiledPart* const map = pages ? part_named(*pages, "map") : nullptr;
        const std::vector<std::uint32_t> keys = uints(file, contents, map ? part_named(*map, "keys") : nullptr);
        const std::vector<std::uint32_t> alive = uints(file, contents, map ? part_named(*map, "alive") : nullptr);
        for (std::size_t k = 0; k < std::min({grid.origins.size(), alive.size(), keys.size() / 3}); ++k)
            if (alive[k] != 0)
                grid.origins[k] = {std::uint64_t{keys[3 * k]} * grid.page[0],
                                   std::uint64_t{keys[3 * k + 1]} * grid.page[1],
                                   std::uint64_t{keys[3 * k + 2]} * grid.page[2]};
        return;
    }
    const auto extent = std::ranges::find(found.field->values, "extent", &FiledValue::name);
    if (extent != found.field->values.end())
        for (unsigned i = 0; i < 3; ++i) grid.extent[i] = number_of(*extent, i);
    Pages to(grid);
    const FiledPart* const owners = pages ? part_named(*pages, "owners") : nullptr;
    const FiledPart* const table = part_named(*found.structure, "table");
    const FiledPart* const entries = table && table->type == "OneLevel" ? part_named(*table, "entries") : nullptr;
    if (!owners && !entries)
        throw glift::Error(glift::ErrorCode::wrong_argument, "gliftinfo does not know this page table", file.path(),
                           table ? table->type : found.structure->type,
                           "load the structure in a program, and write it with to_openvdb of <glift/files/openvdb.h>");
    const std::vector<std::uint32_t> numbers = uints(file, contents, owners ? owners : entries);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (numbers[i] != 0) owners ? to.place(i, numbers[i] - 1) : to.place(numbers[i] - 1, i);
}

}  // namespace

std::optional<SparseGrid> sparse_grid_at(VerifiedFile& file, const FiledPart& structure, const Content& frames) {
    const Found found = find(structure, frames.path);
    if (!found.structure || frames.shape.size() != 2) return std::nullopt;
    SparseGrid grid;
    grid.page = page_of(*found.field);
    if (std::uint64_t{grid.page[0]} * grid.page[1] * grid.page[2] != frames.shape[1]) return std::nullopt;
    grid.extent.fill(std::uint64_t{1} << 32);
    grid.origins.resize(frames.shape[0]);
    find_background(*found.field, frames, grid);
    find_pages(file, found, contents_of(structure), grid);
    return grid;
}

}  // namespace gliftinfo
