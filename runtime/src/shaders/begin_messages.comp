// Runs before a pass that prints: appends the word that names its kernel to the buffer of messages (message_format.h).
#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 1) in;

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Messages {
    uint used, lost, lost_high, capacity, words[];
};

layout(push_constant, scalar) uniform Push {
    Messages messages;
    uint mark;
};

void main() {
    uint at = messages.used;
    if (at >= messages.capacity) return;
    messages.words[at] = mark;
    messages.used = at + 1u;
}
