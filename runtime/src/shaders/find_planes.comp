// For each plane of pages, the index in an ascending list of page numbers at which that plane begins: ranks/page_kernels.h.
#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Words { uint word[]; };

layout(set = 0, binding = 0, scalar) readonly buffer Parameters {
    uint size;
    uint pages_of_plane;
    uint count_word;
    uint capacity;
    Words list, count, result, seen;
};

void main() {
    const uint plane = gl_GlobalInvocationID.x;
    if (plane >= size) return;
    uint low = 0u, high = min(count.word[count_word], capacity);
    const uint page = plane * pages_of_plane;
    while (low < high) {
        const uint middle = (low + high) / 2u;
        if (list.word[middle] < page) low = middle + 1u;
        else high = middle;
    }
    result.word[plane] = seen.word[plane] = low;
}
