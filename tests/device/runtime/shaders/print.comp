// Prints two messages of each element, in the form that gliftc generates: its number and bits of every type, and an
// assertion of elements from `limit` on.
#version 460
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
layout(set = 0, binding = 1, scalar) buffer G { uint g[]; };
layout(set = 0, binding = 3, scalar) volatile buffer Messages {
    uint used, lost, lost_high, capacity, words[];
} messages;
layout(push_constant, scalar) uniform Parameters { uint size; uint limit; };

uint begin_message(uint number, uint count) {
    if (messages.used < messages.capacity) {
        uint at = atomicAdd(messages.used, count + 1u);
        if (at < messages.capacity && count < messages.capacity - at) {
            messages.words[at] = number + 1u;
            return at + 1u;
        }
    }
    if (atomicAdd(messages.lost, 1u) == 0xffffffffu) atomicAdd(messages.lost_high, 1u);
    return 0u;
}

void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i >= size) return;
    {
        uint message_at = begin_message(0u, 2u);
        if (message_at != 0u) {
            messages.words[message_at] = i;
            messages.words[message_at + 1u] = g[i];
        }
    }
    if (!(i < limit)) {
        uint message_at = begin_message(1u, 13u);
        if (message_at != 0u) {
            messages.words[message_at] = i;
            messages.words[message_at + 1u] = uint(-int(i));
            messages.words[message_at + 2u] = floatBitsToUint(0.1);
            messages.words[message_at + 3u] = floatBitsToUint(0.0999755859375);
            messages.words[message_at + 4u] = 0u;
            messages.words[message_at + 5u] = 0x3fe00000u;
            messages.words[message_at + 6u] = 0xfffffffeu;
            messages.words[message_at + 7u] = 0xffffffffu;
            messages.words[message_at + 8u] = 1u;
            messages.words[message_at + 9u] = 1u;
            messages.words[message_at + 10u] = 1u;
            messages.words[message_at + 11u] = 4u;
            messages.words[message_at + 12u] = 5u;
        }
    }
    g[i] = g[i] + 1u;
}
