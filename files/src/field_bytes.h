// Moves one field of elements between elements as they lie in memory and the packed numbers of a file.
#pragma once

#include <glift/files/element_type.h>

#include <cstddef>
#include <span>

namespace glift::files {

/// Packs the field of each element into `to`, which has room for as many.
void gather(const Field& field, std::uint32_t element_bytes, std::span<const std::byte> elements,
            std::span<std::byte> to);
/// Puts packed numbers into the field of each element; other bytes stay.
void scatter(const Field& field, std::uint32_t element_bytes, std::span<const std::byte> from,
             std::span<std::byte> elements);
/// The bytes of the field of one element in a file.
std::size_t packed_bytes(const Field& field);
bool is_all_zero(std::span<const std::byte> bytes);

}  // namespace glift::files
