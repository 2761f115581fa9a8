// Glift inside a program that has its own Vulkan device, its own shader, its own image and its own command buffer: the
// program's compute shader writes a picture into a Glift structure, Glift's passes blur it in the same command buffer,
// and Glift draws it into the program's image, which the program has cleared before and copies afterwards.
#include "../common/plain_vulkan.h"
#include "../common/png.h"
#include "adopt.glift.hpp"
#include "checkerboard.h"

#include <glift/vulkan.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

namespace {

constexpr glift::uint2 extent = {203, 117};
constexpr std::uint32_t square = 20, rounds = 4;

/// The film (the program's image, cleared to `paper`) is larger than the picture by a margin on each side. It keeps its
/// colour where the picture is darker than `least`.
constexpr std::uint32_t margin = 12;
constexpr glift::uint2 film_extent = {extent.x + 2 * margin, extent.y + 2 * margin};
constexpr float paper = 0.75f, least = 0.25f;

/// The results that the program copies to the host: the picture in row-major order, and the film.
struct Pictures {
    std::vector<float> rows, film;
    bool operator==(const Pictures&) const = default;
};

/// The expected picture, computed on the CPU. Pixels outside it count as black.
std::vector<float> expected_picture() {
    std::vector<float> picture(extent.x * extent.y), other(picture.size());
    const auto at = [&](std::uint32_t x, std::uint32_t y) {
        return x < extent.x && y < extent.y ? picture[y * extent.x + x] : 0.0f;
    };
    for (std::uint32_t y = 0; y < extent.y; ++y)
        for (std::uint32_t x = 0; x < extent.x; ++x)
            picture[y * extent.x + x] = static_cast<float>((x / square + y / square) % 2);
    for (std::uint32_t round = 0; round < 2 * rounds; ++round) {
        for (std::uint32_t y = 0; y < extent.y; ++y)
            for (std::uint32_t x = 0; x < extent.x; ++x) {
                const float around = at(x + 1, y) + at(x - 1, y) + (at(x, y + 1) + at(x, y - 1));
                other[y * extent.x + x] = 0.5f * at(x, y) + 0.125f * around;
            }
        std::swap(picture, other);
    }
    return picture;
}

Pictures expected() {
    Pictures result{expected_picture(), std::vector<float>(film_extent.x * film_extent.y, paper)};
    for (std::uint32_t y = 0; y < extent.y; ++y)
        for (std::uint32_t x = 0; x < extent.x; ++x)
            if (const float value = result.rows[y * extent.x + x]; value >= least)
                result.film[(y + margin) * film_extent.x + x + margin] = value;
    return result;
}

std::vector<float> values_of(const void* data, glift::uint2 size) {
    std::vector<float> values(std::size_t{size.x} * size.y);
    std::memcpy(values.data(), data, sizeof(float) * values.size());
    return values;
}

glift::Memory adopted(const glift::Device& device, const ColourImage& image) {
    return glift::vulkan::adopt_image(device, {.image = image.image,
                                               .format = VK_FORMAT_R32_SFLOAT,
                                               .extent = film_extent,
                                               .usage = image.usage,
                                               .name = "film"});
}

/// Writes the picture with the program's shader, blurs it, draws it to the film and copies both to the host, in one
/// command buffer of the program.
Pictures draw(const PlainVulkan& vulkan) {
    const glift::Device device = glift::vulkan::adopt({.instance = vulkan.instance,
                                                       .physical = vulkan.physical,
                                                       .device = vulkan.device,
                                                       .queue = vulkan.queue,
                                                       .queue_family = vulkan.queue_family,
                                                       .extensions = vulkan.extensions});
    const adopt::Picture picture(device, extent);
    const adopt::Rows rows(device, extent);
    const glift::vulkan::BufferHandle drawn = glift::vulkan::buffer(picture.data()),
                                      memory = glift::vulkan::buffer(rows.data());
    const VkDeviceSize bytes = sizeof(float) * extent.x * extent.y;

    const ComputeShader shader(vulkan, checkerboard, sizeof(glift::uint2) + sizeof square);
    shader.bind({drawn.buffer, drawn.offset, drawn.bytes});
    const ReadbackBuffer result(vulkan, bytes), shown(vulkan, sizeof(float) * film_extent.x * film_extent.y);

    const ColourImage image(vulkan, VK_FORMAT_R32_SFLOAT, {film_extent.x, film_extent.y});
    const adopt::Film film(device, film_extent, adopted(device, image));
    // Submits the clearing of new structures, so that it comes before the program's own commands.
    device.commands().flush();

    const VkCommandBuffer commands = vulkan.begin();
    struct {
        glift::uint2 extent;
        std::uint32_t square;
    } const parameters = {extent, square};
    shader.dispatch(commands, &parameters, (extent.x + 7) / 8, (extent.y + 7) / 8);
    image.clear(commands, paper);

    const glift::Commands into = glift::vulkan::record_into(device, commands);
    adopt::soften(into, picture, rounds);
    adopt::lay_out(into, picture, rows);
    adopt::show(into, adopt::Everything{3}, picture, film.range({margin, margin}, extent), least);
    glift::vulkan::finish(into);

    const VkBufferCopy region = {memory.offset, 0, bytes};
    vkCmdCopyBuffer(commands, memory.buffer, result.buffer, 1, &region);
    image.copy_to(commands, shown.buffer);
    const VkMemoryBarrier visible = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                     .srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT,
                                     .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &visible, 0,
                         nullptr, 0, nullptr);
    vulkan.run(commands);

    return {values_of(result.data, extent), values_of(shown.data, film_extent)};
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc > 2 || (argc == 2 && argv[1][0] == '-')) {
            std::fprintf(stderr, "usage: adopt [picture.png]\n");
            return 2;
        }
        const PlainVulkan vulkan;
        std::printf("device: %s, made by this program\n", vulkan.name.c_str());
        const Pictures pictures = draw(vulkan);
        if (argc == 2) {
            png::write(argv[1], {film_extent.x, film_extent.y, pictures.film});
            std::printf("picture: %s\n", argv[1]);
        }
        const bool right = pictures == expected();
        std::printf("the picture is %s\n", right ? "as expected, to the bit" : "WRONG");
        return right ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "adopt: %s\n", error.what());
        return 1;
    }
}
