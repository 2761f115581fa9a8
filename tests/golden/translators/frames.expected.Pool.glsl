// Pool, frames.glift:27.
// Define POOL_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at POOL_BINDING + 1 + k.
// Optional: POOL_SET (the descriptor set, else 0), POOL_STATE (see below), POOL_READONLY (nothing is written).
#ifndef GLIFT_POOL
#define GLIFT_POOL 380867509
#extension GL_EXT_scalar_block_layout : require

#ifndef POOL_SET
#define POOL_SET 0
#endif
#ifndef POOL_BINDING
#error define POOL_BINDING before this file is included
#endif
#ifdef POOL_READONLY
#define POOL_ACCESS readonly
#else
#define POOL_ACCESS
#endif

#ifndef POOL_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = POOL_SET, binding = POOL_BINDING) readonly buffer Pool_state {
    uint Pool_frames_n;
    uint Pool_data_extent;
};
#endif

layout(scalar, set = POOL_SET, binding = POOL_BINDING + 1) POOL_ACCESS buffer Pool_frames_data_memory { uint Pool_frames_data[]; };
layout(scalar, set = POOL_SET, binding = POOL_BINDING + 2) POOL_ACCESS buffer Pool_data_memory { float Pool_data[]; };

#ifndef GLIFT_HELPER_722867247
#define GLIFT_HELPER_722867247
// Saturates; not-a-number gives 0.
int to_int(float x) {
    float safe = x >= -2147483648.0 && x < 2147483648.0 ? x : 0.0;
    return x >= 2147483648.0 ? 2147483647 : x < -2147483648.0 ? int(0x80000000u) : int(safe);
}
#endif

#ifndef GLIFT_HELPER_204653774
#define GLIFT_HELPER_204653774
float blend(float x, float y, float a) {
    return x * (float(1.0) - a) + y * a;
}
#endif

bool Pool_is_mapped(uint address) {
    uint Pool_frames_address = address / 4u;
    bool Pool_frames_value_inside = Pool_frames_address < Pool_frames_n;
    uint Pool_frames_value = Pool_frames_data[Pool_frames_value_inside ? Pool_frames_address : 0u];
    uint Pool_frame = Pool_frames_value_inside ? Pool_frames_value : 0u;
    uint Pool_place = (Pool_frame - 1u) * 4u + address % 4u;
    return !(Pool_frame == 0u) && Pool_place < Pool_data_extent;
}

uint Pool_translate(uint address) {
    uint Pool_frames_address = address / 4u;
    bool Pool_frames_value_inside = Pool_frames_address < Pool_frames_n;
    uint Pool_frames_value = Pool_frames_data[Pool_frames_value_inside ? Pool_frames_address : 0u];
    uint Pool_place = ((Pool_frames_value_inside ? Pool_frames_value : 0u) - 1u) * 4u + address % 4u;
    return Pool_place;
}

float Pool_read(uint address) {
    uint Pool_frames_address = address / 4u;
    bool Pool_frames_value_inside = Pool_frames_address < Pool_frames_n;
    uint Pool_frames_value = Pool_frames_data[Pool_frames_value_inside ? Pool_frames_address : 0u];
    uint Pool_frame = Pool_frames_value_inside ? Pool_frames_value : 0u;
    uint Pool_place = (Pool_frame - 1u) * 4u + address % 4u;
    bool Pool_value_inside = !(Pool_frame == 0u) && Pool_place < Pool_data_extent;
    float Pool_value = Pool_data[Pool_value_inside ? Pool_place : 0u];
    return Pool_value_inside ? Pool_value : -1.0;
}

float Pool_sample(float point) {
    float Pool_lower = point - 0.5;
    float Pool_corner = floor(Pool_lower);
    float Pool_weight = Pool_lower - Pool_corner;
    uint Pool_base = uint(to_int(Pool_corner));
    uint Pool_frames_address = Pool_base / 4u;
    bool Pool_frames_value_inside = Pool_frames_address < Pool_frames_n;
    uint Pool_frames_value = Pool_frames_data[Pool_frames_value_inside ? Pool_frames_address : 0u];
    uint Pool_corner0_frame = Pool_frames_value_inside ? Pool_frames_value : 0u;
    uint Pool_corner0_place = (Pool_corner0_frame - 1u) * 4u + Pool_base % 4u;
    bool Pool_corner0_value_inside = !(Pool_corner0_frame == 0u) && Pool_corner0_place < Pool_data_extent;
    float Pool_corner0_value = Pool_data[Pool_corner0_value_inside ? Pool_corner0_place : 0u];
    uint Pool_corner1_address = Pool_base + 1u;
    uint Pool_frames_address_1 = Pool_corner1_address / 4u;
    bool Pool_frames_value_inside_1 = Pool_frames_address_1 < Pool_frames_n;
    uint Pool_frames_value_1 = Pool_frames_data[Pool_frames_value_inside_1 ? Pool_frames_address_1 : 0u];
    uint Pool_corner1_frame = Pool_frames_value_inside_1 ? Pool_frames_value_1 : 0u;
    uint Pool_corner1_place = (Pool_corner1_frame - 1u) * 4u + Pool_corner1_address % 4u;
    bool Pool_corner1_value_inside = !(Pool_corner1_frame == 0u) && Pool_corner1_place < Pool_data_extent;
    float Pool_corner1_value = Pool_data[Pool_corner1_value_inside ? Pool_corner1_place : 0u];
    return blend(Pool_corner0_value_inside ? Pool_corner0_value : -1.0, Pool_corner1_value_inside
        ? Pool_corner1_value : -1.0, Pool_weight);
}

#ifndef POOL_READONLY
void Pool_write(uint address, float value) {
    uint Pool_frames_address = address / 4u;
    bool Pool_frames_value_inside = Pool_frames_address < Pool_frames_n;
    uint Pool_frames_value = Pool_frames_data[Pool_frames_value_inside ? Pool_frames_address : 0u];
    uint Pool_frame = Pool_frames_value_inside ? Pool_frames_value : 0u;
    uint Pool_place = (Pool_frame - 1u) * 4u + address % 4u;
    if (address < Pool_frames_n * 4u && (!(Pool_frame == 0u) && Pool_place < Pool_data_extent)) {
        Pool_data[Pool_place] = value;
    }
}
#endif
#elif GLIFT_POOL != 380867509
#error the functions of another structure called Pool are included already
#endif
