#version 460
// roots, messages.glift:17: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

const uint Kind_solid = 0u;
const uint Kind_liquid = 1u;

layout(push_constant, scalar) uniform Parameters {
    uint f_extent;
};

layout(scalar, set = 0, binding = 1) buffer F_data { float f_data[]; };

layout(scalar, set = 0, binding = 3) volatile buffer Messages {
    uint used, lost, lost_high, capacity, words[];
} messages;

// Begins a message with so many words after its number. Returns where these begin; 0: the buffer is full.
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
    // messages.glift:17
    uint address = gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * 256u) + gl_GlobalInvocationID.x;
    if (address >= f_extent) return;
    // messages.glift:18
    float f_value = f_data[address];
    uint kind = f_value > 1.0 ? Kind_liquid : Kind_solid;
    // messages.glift:19
    vec2 printed = vec2(f_value, -f_value);
    {
        uint message_at = begin_message(0u, 4u);
        if (message_at != 0u) {
            messages.words[message_at] = address;
            messages.words[message_at + 1u] = uint(kind);
            messages.words[message_at + 2u] = floatBitsToUint(printed.x);
            messages.words[message_at + 3u] = floatBitsToUint(printed.y);
        }
    }
    // messages.glift:13
    if (!(f_value >= 0.0)) {
        uint value = floatBitsToUint(f_value);
        {
            uint message_at = begin_message(1u, 3u);
            if (message_at != 0u) {
                messages.words[message_at] = address;
                messages.words[message_at + 1u] = value;
                messages.words[message_at + 2u] = value;
            }
        }
    }
    // messages.glift:20
    float checked = sqrt(f_value);
    f_data[address] = checked;
}
