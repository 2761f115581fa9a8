// Runs before passes whose parameters, sizes or conditions come from the device: copies the values into their parameter
// blocks, clamps the iteration sizes, and writes the indirect commands. Sizes are mapped to workgroups as in kernel.h
// and groups.h. Each invocation prepares one pass, so that several passes share one dispatch and one barrier.
#version 460
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 32) in;

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Words { uint word[]; };

struct PatchSource {
    Words value;
    uint word;         // index of a word in the parameter block; the other fields are those of Patch (pass.h)
    uint limit;
    uint before;
    uint joins;
};

layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer Patches { PatchSource each[]; };

struct ConditionSource {
    Words value;
    uint wanted;
    uint unused;
};

layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer Conditions { ConditionSource each[]; };

layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer Arguments {
    Words block;
    Words command;
    Patches patches;
    Conditions conditions;
    uint size[4];      // iteration size before patches: upper bounds
    uint per_group[3]; // elements that a workgroup covers
    uint limit_x;      // most workgroups along x, beyond which an iteration of rank 1 is folded into x and y
    uint rank;
    uint size_word;    // index of the size in the parameter block
    uint patch_count;
    uint condition_count;
    uint draws;        // not 0: the command is a draw of size[0] corners and size[1] instances
    uint limit_y;      // kernels over blocks: most workgroups along y, beyond which y is folded; others: 2^32 - 1
};

layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer List {
    uint count;
    uint unused;
    Arguments each[];
};

layout(push_constant, scalar) uniform Push { List list; };

uint div_ceil(uint a, uint b) { return a / b + (a % b != 0u ? 1u : 0u); }

bool runs(Arguments arguments) {
    bool all = true;
    for (uint k = 0u; k < arguments.condition_count; ++k) {
        const bool holds = arguments.conditions.each[k].value.word[0] != 0u;
        all = all && holds == (arguments.conditions.each[k].wanted != 0u);
    }
    return all;
}

void main() {
    if (gl_LocalInvocationIndex >= list.count) return;
    Arguments arguments = list.each[gl_LocalInvocationIndex];
    uint size[4] = arguments.size;
    uint last = 0u;
    for (uint k = 0u; k < arguments.patch_count; ++k) {
        PatchSource patch_source = arguments.patches.each[k];
        const uint word = patch_source.word;
        const uint stored = patch_source.value.word[0];
        uint value = min(stored - min(stored, patch_source.before), patch_source.limit);
        if (patch_source.joins != 0u) value = min(value, last);
        const uint axis = word - arguments.size_word;
        if (axis < arguments.rank) {
            value = min(value, size[axis]);
            size[axis] = value;
        }
        arguments.block.word[word] = value;
        last = value;
    }
    const bool is_run = runs(arguments);
    if (arguments.draws != 0u) {
        arguments.command.word[0] = is_run ? size[0] : 0u;
        arguments.command.word[1] = is_run ? size[1] : 0u;
        arguments.command.word[2] = 0u;
        arguments.command.word[3] = 0u;
        return;
    }
    uint x = div_ceil(size[0], arguments.per_group[0]);
    uint y = div_ceil(size[1], arguments.per_group[1]);
    uint z = div_ceil(size[2] * size[3], arguments.per_group[2]);
    if (y > arguments.limit_y) {
        z = div_ceil(y, arguments.limit_y);
        y = div_ceil(y, z);
    }
    if (arguments.rank == 1u && x > arguments.limit_x) {
        y = 1u << (findMSB(div_ceil(x, arguments.limit_x) * 2u - 1u));
        x = div_ceil(x, y);
    }
    const bool none = !is_run || x == 0u || y == 0u || z == 0u;
    arguments.command.word[0] = none ? 0u : x;
    arguments.command.word[1] = none ? 0u : y;
    arguments.command.word[2] = none ? 0u : z;
}
