// How error messages write kernels, their forms, memories and sizes.
#pragma once

#include <glift/pass.h>

#include <string>

namespace glift::detail {

std::string size_text(std::uint64_t bytes);                     // `1.5 GiB (1610612736 bytes)`
std::string kernel_text(const Kernel& kernel);                  // `kernel blur (blur.glift:12)`
std::string memory_text(const MemoryDescription& description);  // `memory f.data (buffer, 4.0 KiB (4096 bytes))`
std::string shape_text(const MemoryDescription& description);   // `buffer, 4.0 KiB (4096 bytes)`
const char* kind_text(MemoryKind kind);
const char* form_text(FormName form);

}  // namespace glift::detail
