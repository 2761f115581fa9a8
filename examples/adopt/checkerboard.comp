// The program's own shader: draws into the memory of a Glift structure, an Array<2, float> over a buffer, row by row.
#version 460

layout(local_size_x = 8, local_size_y = 8) in;

layout(push_constant) uniform Parameters {
    uvec2 extent;
    uint square;
};

layout(set = 0, binding = 0) writeonly buffer Picture {
    float picture[];
};

void main() {
    uvec2 address = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(address, extent))) return;
    uvec2 place = address / square;
    picture[address.y * extent.x + address.x] = float((place.x + place.y) % 2u);
}
