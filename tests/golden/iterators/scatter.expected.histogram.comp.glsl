#version 460
// histogram, scatter.glift:9: direct form: whole structures, of equal sizes where declared with one type.
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 256) in;

layout(push_constant, scalar) uniform Parameters {
    uint s_extent;
    uint bins_extent;
    uint bins_data_copied;
};

layout(scalar, set = 0, binding = 1) readonly buffer S_data { uint s_data[]; };
layout(scalar, set = 0, binding = 2) buffer Bins_data { uint bins_data[]; };

shared uint bins_data_copies[4128];

void main() {
    // scatter.glift:9
    uint address = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 32768u
        + gl_LocalInvocationID.x;
    // Each invocation takes several elements, and combines their updates before it makes them.
    uint bins_data_copied_1 = bins_data_copied;
    uint value = bins_data_copied_1 | 1u;
    uint bins_data_copy_count = 1u << (uint(min(findMSB(4128u / max(value, 1u)), 5)) & 31u);
    uint bins_data_copy = (gl_LocalInvocationIndex & (bins_data_copy_count - 1u)) * value;
    uint value_1 = bins_data_copy_count * value;
    uint turns = (value_1 + 255u) / 256u;
    for (uint turn = 0u, turn_end = turns; turn < turn_end; ++turn) {
        uint value_2 = turn * 256u + gl_LocalInvocationIndex;
        if (value_2 < value_1) {
            bins_data_copies[min(value_2, 4127u)] = 0u;
        }
    }
    barrier();
    uint remaining = address < s_extent ? s_extent - address : 0u;
    for (uint turn = 0u; turn < 16u; ++turn) {
        uint value_2 = turn * 8u * 256u;
        bool exists = value_2 < remaining;
        uint at = exists ? address + value_2 : 0u;
        uint bins_address = s_data[at] % 64u;
        uint value_3 = value_2 + 256u;
        bool exists_1 = value_3 < remaining;
        uint at_1 = exists_1 ? address + value_3 : 0u;
        uint bins_address_1 = s_data[at_1] % 64u;
        uint value_4 = value_2 + 512u;
        bool exists_2 = value_4 < remaining;
        uint at_2 = exists_2 ? address + value_4 : 0u;
        uint bins_address_2 = s_data[at_2] % 64u;
        uint value_5 = value_2 + 768u;
        bool exists_3 = value_5 < remaining;
        uint at_3 = exists_3 ? address + value_5 : 0u;
        uint bins_address_3 = s_data[at_3] % 64u;
        uint value_6 = value_2 + 1024u;
        bool exists_4 = value_6 < remaining;
        uint at_4 = exists_4 ? address + value_6 : 0u;
        uint bins_address_4 = s_data[at_4] % 64u;
        uint value_7 = value_2 + 1280u;
        bool exists_5 = value_7 < remaining;
        uint at_5 = exists_5 ? address + value_7 : 0u;
        uint bins_address_5 = s_data[at_5] % 64u;
        uint value_8 = value_2 + 1536u;
        bool exists_6 = value_8 < remaining;
        uint at_6 = exists_6 ? address + value_8 : 0u;
        uint bins_address_6 = s_data[at_6] % 64u;
        uint value_9 = value_2 + 1792u;
        bool exists_7 = value_9 < remaining;
        uint at_7 = exists_7 ? address + value_9 : 0u;
        uint bins_address_7 = s_data[at_7] % 64u;
        if (exists) {
            if (bins_address < bins_extent) {
                if (bins_address < bins_data_copied_1) {
                    atomicAdd(bins_data_copies[min(bins_data_copy + bins_address, 4127u)], 1u);
                } else {
                    atomicAdd(bins_data[bins_address], 1u);
                }
            }
        }
        if (exists_1) {
            if (bins_address_1 < bins_extent) {
                if (bins_address_1 < bins_data_copied_1) {
                    atomicAdd(bins_data_copies[min(bins_data_copy + bins_address_1, 4127u)], 1u);
                } else {
                    atomicAdd(bins_data[bins_address_1], 1u);
                }
            }
        }
        if (exists_2) {
            if (bins_address_2 < bins_extent) {
                if (bins_address_2 < bins_data_copied_1) {
                    atomicAdd(bins_data_copies[min(bins_data_copy + bins_address_2, 4127u)], 1u);
                } else {
                    atomicAdd(bins_data[bins_address_2], 1u);
                }
            }
        }
        if (exists_3) {
            if (bins_address_3 < bins_extent) {
                if (bins_address_3 < bins_data_copied_1) {
                    atomicAdd(bins_data_copies[min(bins_data_copy + bins_address_3, 4127u)], 1u);
                } else {
                    atomicAdd(bins_data[bins_address_3], 1u);
                }
            }
        }
        if (exists_4) {
            if (bins_address_4 < bins_extent) {
                if (bins_address_4 < bins_data_copied_1) {
                    atomicAdd(bins_data_copies[min(bins_data_copy + bins_address_4, 4127u)], 1u);
                } else {
                    atomicAdd(bins_data[bins_address_4], 1u);
                }
            }
        }
        if (exists_5) {
            if (bins_address_5 < bins_extent) {
                if (bins_address_5 < bins_data_copied_1) {
                    atomicAdd(bins_data_copies[min(bins_data_copy + bins_address_5, 4127u)], 1u);
                } else {
                    atomicAdd(bins_data[bins_address_5], 1u);
                }
            }
        }
        if (exists_6) {
            if (bins_address_6 < bins_extent) {
                if (bins_address_6 < bins_data_copied_1) {
                    atomicAdd(bins_data_copies[min(bins_data_copy + bins_address_6, 4127u)], 1u);
                } else {
                    atomicAdd(bins_data[bins_address_6], 1u);
                }
            }
        }
        if (exists_7) {
            if (bins_address_7 < bins_extent) {
                if (bins_address_7 < bins_data_copied_1) {
                    atomicAdd(bins_data_copies[min(bins_data_copy + bins_address_7, 4127u)], 1u);
                } else {
                    atomicAdd(bins_data[bins_address_7], 1u);
                }
            }
        }
    }
    barrier();
    uint turns_1 = (bins_data_copied_1 + 255u) / 256u;
    for (uint turn = 0u, turn_end = turns_1; turn < turn_end; ++turn) {
        uint value_2 = turn * 256u + gl_LocalInvocationIndex;
        if (value_2 < bins_data_copied_1) {
            uint sum = 0u;
            for (uint copy = 0u, copy_end = bins_data_copy_count; copy < copy_end; ++copy) {
                sum += bins_data_copies[min(copy * value + value_2, 4127u)];
            }
            if (sum != 0u) {
                atomicAdd(bins_data[value_2], sum);
            }
        }
    }
}
