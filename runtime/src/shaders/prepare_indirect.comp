// Before a pass whose parameters come from the device: copies the values into its parameter block, clamps the iteration
// size, and writes the indirect command. The mapping from size to workgroups is that of pass.h and groups.h.
#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 1) in;

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Words { uint word[]; };

struct PatchSource {
    Words value;
    uint word;         // index in the block
    uint limit;
    uint before;
    uint joins;
};

layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer Arguments {
    Words block;
    Words command;
    uint size[4];      // upper bounds
    uint per_group[3]; // elements
    uint limit_x;      // workgroups
    uint rank;
    uint size_word;    // index in the block
    uint patch_count;
    uint draws;        // the command is a draw of size[0] corners and size[1] instances
    PatchSource patches[];
};

layout(push_constant, scalar) uniform Push { Arguments arguments; };

uint div_ceil(uint a, uint b) { return a / b + (a % b != 0u ? 1u : 0u); }

void main() {
    uint size[4] = arguments.size;
    uint last = 0u;
    for (uint k = 0u; k < arguments.patch_count; ++k) {
        const uint word = arguments.patches[k].word;
        const uint stored = arguments.patches[k].value.word[0], before = arguments.patches[k].before;
        uint value = min(stored - min(stored, before), arguments.patches[k].limit);
        if (arguments.patches[k].joins != 0u) value = min(value, last);
        const uint axis = word - arguments.size_word;
        if (axis < arguments.rank) {
            value = min(value, size[axis]);
            size[axis] = value;
        }
        arguments.block.word[word] = value;
        last = value;
    }
    if (arguments.draws != 0u) {
        arguments.command.word[0] = size[0];
        arguments.command.word[1] = size[1];
        arguments.command.word[2] = 0u;
        arguments.command.word[3] = 0u;
        return;
    }
    uint x = div_ceil(size[0], arguments.per_group[0]);
    uint y = div_ceil(size[1], arguments.per_group[1]);
    const uint z = div_ceil(size[2] * size[3], arguments.per_group[2]);
    if (arguments.rank == 1u && x > arguments.limit_x) {
        y = 1u << (findMSB(div_ceil(x, arguments.limit_x) * 2u - 1u));
        x = div_ceil(x, y);
    }
    const bool none = x == 0u || y == 0u || z == 0u;
    arguments.command.word[0] = none ? 0u : x;
    arguments.command.word[1] = none ? 0u : y;
    arguments.command.word[2] = none ? 0u : z;
}
