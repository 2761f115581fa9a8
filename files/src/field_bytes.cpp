#include "field_bytes.h"

#include "hdf5_handle.h"

#include <cstring>

namespace glift::files {

namespace {

/// Calls move(element's field, packed numbers) for each element. The size is a constant where it is a common one, so
/// that copies are single instructions.
template <std::size_t size>
void copy_fields(std::byte* to, std::size_t to_step, const std::byte* from, std::size_t from_step, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i, to += to_step, from += from_step) std::memcpy(to, from, size);
}

void copy_fields(std::size_t size, std::byte* to, std::size_t to_step, const std::byte* from, std::size_t from_step,
                 std::size_t count) {
    if (to_step == size && from_step == size) {
        std::memcpy(to, from, size * count);
        return;
    }
    switch (size) {
    case 2: return copy_fields<2>(to, to_step, from, from_step, count);
    case 4: return copy_fields<4>(to, to_step, from, from_step, count);
    case 8: return copy_fields<8>(to, to_step, from, from_step, count);
    case 12: return copy_fields<12>(to, to_step, from, from_step, count);
    case 16: return copy_fields<16>(to, to_step, from, from_step, count);
    default:
        for (std::size_t i = 0; i < count; ++i) std::memcpy(to + i * to_step, from + i * from_step, size);
    }
}

}  // namespace

std::size_t packed_bytes(const Field& field) { return field.numbers() * file_bytes(field.scalar); }

void gather(const Field& field, std::uint32_t element_bytes, std::span<const std::byte> elements,
            std::span<std::byte> to) {
    const std::size_t count = elements.size() / element_bytes, numbers = field.numbers();
    if (field.scalar != Scalar::boolean)
        return copy_fields(packed_bytes(field), to.data(), packed_bytes(field), elements.data() + field.offset,
                           element_bytes, count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < numbers; ++k) {
            std::uint32_t bits;
            std::memcpy(&bits, elements.data() + i * element_bytes + field.offset + 4 * k, 4);
            to[i * numbers + k] = std::byte{bits != 0};
        }
    }
}

void scatter(const Field& field, std::uint32_t element_bytes, std::span<const std::byte> from,
             std::span<std::byte> elements) {
    const std::size_t count = elements.size() / element_bytes, numbers = field.numbers();
    if (field.scalar != Scalar::boolean)
        return copy_fields(packed_bytes(field), elements.data() + field.offset, element_bytes, from.data(),
                           packed_bytes(field), count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < numbers; ++k) {
            const std::uint32_t bits = from[i * numbers + k] != std::byte{0};
            std::memcpy(elements.data() + i * element_bytes + field.offset + 4 * k, &bits, 4);
        }
    }
}

bool is_all_zero(std::span<const std::byte> bytes) {
    return bytes.empty() ||
           (bytes[0] == std::byte{0} && std::memcmp(bytes.data(), bytes.data() + 1, bytes.size() - 1) == 0);
}

}  // namespace glift::files
