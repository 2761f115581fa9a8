// Same, shared.glift:34.
// Define SAME_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at SAME_BINDING + 1 + k.
// Optional: SAME_SET (the descriptor set, else 0), SAME_STATE (see below), SAME_READONLY (nothing is written).
#ifndef GLIFT_SAME
#define GLIFT_SAME 1777365880
#extension GL_EXT_scalar_block_layout : require

#ifndef SAME_SET
#define SAME_SET 0
#endif
#ifndef SAME_BINDING
#error define SAME_BINDING before this file is included
#endif
#ifdef SAME_READONLY
#define SAME_ACCESS readonly
#else
#define SAME_ACCESS
#endif

#ifndef SAME_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = SAME_SET, binding = SAME_BINDING) readonly buffer Same_state {
    uint Same_field_extent;
    uint Same_field_table_extent;
    uvec2 Same_field_frames_extent;
};
#endif

layout(scalar, set = SAME_SET, binding = SAME_BINDING + 1) SAME_ACCESS buffer Same_field_table_data_memory { uint Same_field_table_data[]; };
layout(scalar, set = SAME_SET, binding = SAME_BINDING + 2) SAME_ACCESS buffer Same_field_frames_data_memory { float Same_field_frames_data[]; };

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

bool Same_is_mapped(uint address) {
    bool Same_field_either = address >= Same_field_extent;
    if (!Same_field_either) {
        uint Same_field_table_address = address / 16u;
        bool Same_field_table_value_inside = Same_field_table_address < Same_field_table_extent;
        uint Same_field_table_value = Same_field_table_data[Same_field_table_value_inside
            ? Same_field_table_address : 0u];
        Same_field_either = (Same_field_table_value_inside ? Same_field_table_value : 0u) == 0u;
    }
    uvec2 Same_field_result = uvec2(0u);
    bool Same_field_found = false;
    if (Same_field_either) {
        Same_field_result = uvec2(0u);
        Same_field_found = false;
    } else {
        uint Same_field_table_address = address / 16u;
        bool Same_field_table_value_inside = Same_field_table_address < Same_field_table_extent;
        uint Same_field_table_value = Same_field_table_data[Same_field_table_value_inside
            ? Same_field_table_address : 0u];
        Same_field_result = uvec2(address % 16u,
            (Same_field_table_value_inside ? Same_field_table_value : 0u) - 1u);
        Same_field_found = true;
    }
    uvec2 Same_field_place = Same_field_result;
    return Same_field_found && Same_field_place.y < Same_field_frames_extent.y;
}

uint Same_translate(uint address) {
    return address;
}

float Same_read(uint address) {
    bool Same_field_either = address >= Same_field_extent;
    if (!Same_field_either) {
        uint Same_field_table_address = address / 16u;
        bool Same_field_table_value_inside = Same_field_table_address < Same_field_table_extent;
        uint Same_field_table_value = Same_field_table_data[Same_field_table_value_inside
            ? Same_field_table_address : 0u];
        Same_field_either = (Same_field_table_value_inside ? Same_field_table_value : 0u) == 0u;
    }
    uvec2 Same_field_result = uvec2(0u);
    bool Same_field_found = false;
    if (Same_field_either) {
        Same_field_result = uvec2(0u);
        Same_field_found = false;
    } else {
        uint Same_field_table_address = address / 16u;
        bool Same_field_table_value_inside = Same_field_table_address < Same_field_table_extent;
        uint Same_field_table_value = Same_field_table_data[Same_field_table_value_inside
            ? Same_field_table_address : 0u];
        Same_field_result = uvec2(address % 16u,
            (Same_field_table_value_inside ? Same_field_table_value : 0u) - 1u);
        Same_field_found = true;
    }
    uvec2 Same_field_place = Same_field_result;
    bool Same_value_inside = Same_field_found && Same_field_place.y < Same_field_frames_extent.y;
    uint Same_value_at = Same_field_place.y * Same_field_frames_extent.x + Same_field_place.x;
    float Same_value = Same_field_frames_data[Same_value_inside ? Same_value_at : 0u];
    return Same_value_inside ? Same_value : -1.0;
}

float Same_sample(float point) {
    float Same_lower = point - 0.5;
    float Same_corner = floor(Same_lower);
    float Same_weight = Same_lower - Same_corner;
    uint Same_base = uint(to_int(Same_corner));
    bool Same_corner0_field_either = Same_base >= Same_field_extent;
    if (!Same_corner0_field_either) {
        uint Same_field_table_address = Same_base / 16u;
        bool Same_field_table_value_inside = Same_field_table_address < Same_field_table_extent;
        uint Same_field_table_value = Same_field_table_data[Same_field_table_value_inside
            ? Same_field_table_address : 0u];
        Same_corner0_field_either = (Same_field_table_value_inside ? Same_field_table_value : 0u) == 0u;
    }
    uvec2 Same_corner0_field_result = uvec2(0u);
    bool Same_corner0_field_found = false;
    if (Same_corner0_field_either) {
        Same_corner0_field_result = uvec2(0u);
        Same_corner0_field_found = false;
    } else {
        uint Same_field_table_address = Same_base / 16u;
        bool Same_field_table_value_inside = Same_field_table_address < Same_field_table_extent;
        uint Same_field_table_value = Same_field_table_data[Same_field_table_value_inside
            ? Same_field_table_address : 0u];
        Same_corner0_field_result = uvec2(Same_base % 16u,
            (Same_field_table_value_inside ? Same_field_table_value : 0u) - 1u);
        Same_corner0_field_found = true;
    }
    uvec2 Same_corner0_field_place = Same_corner0_field_result;
    bool Same_corner0_value_inside = Same_corner0_field_found && Same_corner0_field_place.y
        < Same_field_frames_extent.y;
    uint Same_corner0_value_at = Same_corner0_field_place.y * Same_field_frames_extent.x
        + Same_corner0_field_place.x;
    float Same_corner0_value = Same_field_frames_data[Same_corner0_value_inside ? Same_corner0_value_at : 0u];
    uint Same_corner1_address = Same_base + 1u;
    bool Same_corner1_field_either = Same_corner1_address >= Same_field_extent;
    if (!Same_corner1_field_either) {
        uint Same_field_table_address = Same_corner1_address / 16u;
        bool Same_field_table_value_inside = Same_field_table_address < Same_field_table_extent;
        uint Same_field_table_value = Same_field_table_data[Same_field_table_value_inside
            ? Same_field_table_address : 0u];
        Same_corner1_field_either = (Same_field_table_value_inside ? Same_field_table_value : 0u) == 0u;
    }
    uvec2 Same_corner1_field_result = uvec2(0u);
    bool Same_corner1_field_found = false;
    if (Same_corner1_field_either) {
        Same_corner1_field_result = uvec2(0u);
        Same_corner1_field_found = false;
    } else {
        uint Same_field_table_address = Same_corner1_address / 16u;
        bool Same_field_table_value_inside = Same_field_table_address < Same_field_table_extent;
        uint Same_field_table_value = Same_field_table_data[Same_field_table_value_inside
            ? Same_field_table_address : 0u];
        Same_corner1_field_result = uvec2(Same_corner1_address % 16u,
            (Same_field_table_value_inside ? Same_field_table_value : 0u) - 1u);
        Same_corner1_field_found = true;
    }
    uvec2 Same_corner1_field_place = Same_corner1_field_result;
    bool Same_corner1_value_inside = Same_corner1_field_found && Same_corner1_field_place.y
        < Same_field_frames_extent.y;
    uint Same_corner1_value_at = Same_corner1_field_place.y * Same_field_frames_extent.x
        + Same_corner1_field_place.x;
    float Same_corner1_value = Same_field_frames_data[Same_corner1_value_inside ? Same_corner1_value_at : 0u];
    return blend(Same_corner0_value_inside ? Same_corner0_value : -1.0, Same_corner1_value_inside
        ? Same_corner1_value : -1.0, Same_weight);
}

#ifndef SAME_READONLY
void Same_write(uint address, float value) {
    bool Same_field_either = address >= Same_field_extent;
    if (!Same_field_either) {
        uint Same_field_table_address = address / 16u;
        bool Same_field_table_value_inside = Same_field_table_address < Same_field_table_extent;
        uint Same_field_table_value = Same_field_table_data[Same_field_table_value_inside
            ? Same_field_table_address : 0u];
        Same_field_either = (Same_field_table_value_inside ? Same_field_table_value : 0u) == 0u;
    }
    uvec2 Same_field_result = uvec2(0u);
    bool Same_field_found = false;
    if (Same_field_either) {
        Same_field_result = uvec2(0u);
        Same_field_found = false;
    } else {
        uint Same_field_table_address = address / 16u;
        bool Same_field_table_value_inside = Same_field_table_address < Same_field_table_extent;
        uint Same_field_table_value = Same_field_table_data[Same_field_table_value_inside
            ? Same_field_table_address : 0u];
        Same_field_result = uvec2(address % 16u,
            (Same_field_table_value_inside ? Same_field_table_value : 0u) - 1u);
        Same_field_found = true;
    }
    uvec2 Same_field_place = Same_field_result;
    if (address < Same_field_extent
        && (Same_field_found && all(lessThan(Same_field_place, Same_field_frames_extent)))) {
        Same_field_frames_data[Same_field_place.y * Same_field_frames_extent.x + Same_field_place.x] = value;
    }
}
#endif
#elif GLIFT_SAME != 1777365880
#error the functions of another structure called Same are included already
#endif
