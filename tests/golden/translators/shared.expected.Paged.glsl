// Paged, shared.glift:27.
// Define PAGED_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at PAGED_BINDING + 1 + k.
// Optional: PAGED_SET (the descriptor set, else 0), PAGED_STATE (see below), PAGED_READONLY (nothing is written).
#ifndef GLIFT_PAGED
#define GLIFT_PAGED 1335873461
#extension GL_EXT_scalar_block_layout : require

#ifndef PAGED_SET
#define PAGED_SET 0
#endif
#ifndef PAGED_BINDING
#error define PAGED_BINDING before this file is included
#endif
#ifdef PAGED_READONLY
#define PAGED_ACCESS readonly
#else
#define PAGED_ACCESS
#endif

#ifndef PAGED_STATE  // define it if you declare the members below in a block yourself
layout(scalar, set = PAGED_SET, binding = PAGED_BINDING) readonly buffer Paged_state {
    uint Paged_extent;
    uint Paged_table_extent;
    uvec2 Paged_frames_extent;
};
#endif

layout(scalar, set = PAGED_SET, binding = PAGED_BINDING + 1) PAGED_ACCESS buffer Paged_table_data_memory { uint Paged_table_data[]; };
layout(scalar, set = PAGED_SET, binding = PAGED_BINDING + 2) PAGED_ACCESS buffer Paged_frames_data_memory { float Paged_frames_data[]; };

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

bool Paged_is_mapped(uint address) {
    bool Paged_either = address >= Paged_extent;
    if (!Paged_either) {
        uint Paged_table_address = address / 16u;
        bool Paged_table_value_inside = Paged_table_address < Paged_table_extent;
        uint Paged_table_value = Paged_table_data[Paged_table_value_inside ? Paged_table_address : 0u];
        Paged_either = (Paged_table_value_inside ? Paged_table_value : 0u) == 0u;
    }
    uvec2 Paged_result = uvec2(0u);
    bool Paged_found = false;
    if (Paged_either) {
        Paged_result = uvec2(0u);
        Paged_found = false;
    } else {
        uint Paged_table_address = address / 16u;
        bool Paged_table_value_inside = Paged_table_address < Paged_table_extent;
        uint Paged_table_value = Paged_table_data[Paged_table_value_inside ? Paged_table_address : 0u];
        Paged_result = uvec2(address % 16u, (Paged_table_value_inside ? Paged_table_value : 0u) - 1u);
        Paged_found = true;
    }
    uvec2 Paged_place = Paged_result;
    return Paged_found && Paged_place.y < Paged_frames_extent.y;
}

uvec2 Paged_translate(uint address) {
    bool Paged_either = address >= Paged_extent;
    if (!Paged_either) {
        uint Paged_table_address = address / 16u;
        bool Paged_table_value_inside = Paged_table_address < Paged_table_extent;
        uint Paged_table_value = Paged_table_data[Paged_table_value_inside ? Paged_table_address : 0u];
        Paged_either = (Paged_table_value_inside ? Paged_table_value : 0u) == 0u;
    }
    uvec2 Paged_result = uvec2(0u);
    if (Paged_either) {
        Paged_result = uvec2(0u);
    } else {
        uint Paged_table_address = address / 16u;
        bool Paged_table_value_inside = Paged_table_address < Paged_table_extent;
        uint Paged_table_value = Paged_table_data[Paged_table_value_inside ? Paged_table_address : 0u];
        Paged_result = uvec2(address % 16u, (Paged_table_value_inside ? Paged_table_value : 0u) - 1u);
    }
    return Paged_result;
}

float Paged_read(uint address) {
    bool Paged_either = address >= Paged_extent;
    if (!Paged_either) {
        uint Paged_table_address = address / 16u;
        bool Paged_table_value_inside = Paged_table_address < Paged_table_extent;
        uint Paged_table_value = Paged_table_data[Paged_table_value_inside ? Paged_table_address : 0u];
        Paged_either = (Paged_table_value_inside ? Paged_table_value : 0u) == 0u;
    }
    uvec2 Paged_result = uvec2(0u);
    bool Paged_found = false;
    if (Paged_either) {
        Paged_result = uvec2(0u);
        Paged_found = false;
    } else {
        uint Paged_table_address = address / 16u;
        bool Paged_table_value_inside = Paged_table_address < Paged_table_extent;
        uint Paged_table_value = Paged_table_data[Paged_table_value_inside ? Paged_table_address : 0u];
        Paged_result = uvec2(address % 16u, (Paged_table_value_inside ? Paged_table_value : 0u) - 1u);
        Paged_found = true;
    }
    uvec2 Paged_place = Paged_result;
    bool Paged_value_inside = Paged_found && Paged_place.y < Paged_frames_extent.y;
    uint Paged_value_at = Paged_place.y * Paged_frames_extent.x + Paged_place.x;
    float Paged_value = Paged_frames_data[Paged_value_inside ? Paged_value_at : 0u];
    return Paged_value_inside ? Paged_value : -1.0;
}

float Paged_sample(float point) {
    float Paged_lower = point - 0.5;
    float Paged_corner = floor(Paged_lower);
    float Paged_weight = Paged_lower - Paged_corner;
    uint Paged_base = uint(to_int(Paged_corner));
    bool Paged_corner0_either = Paged_base >= Paged_extent;
    if (!Paged_corner0_either) {
        uint Paged_table_address = Paged_base / 16u;
        bool Paged_table_value_inside = Paged_table_address < Paged_table_extent;
        uint Paged_table_value = Paged_table_data[Paged_table_value_inside ? Paged_table_address : 0u];
        Paged_corner0_either = (Paged_table_value_inside ? Paged_table_value : 0u) == 0u;
    }
    uvec2 Paged_corner0_result = uvec2(0u);
    bool Paged_corner0_found = false;
    if (Paged_corner0_either) {
        Paged_corner0_result = uvec2(0u);
        Paged_corner0_found = false;
    } else {
        uint Paged_table_address = Paged_base / 16u;
        bool Paged_table_value_inside = Paged_table_address < Paged_table_extent;
        uint Paged_table_value = Paged_table_data[Paged_table_value_inside ? Paged_table_address : 0u];
        Paged_corner0_result = uvec2(Paged_base % 16u, (Paged_table_value_inside ? Paged_table_value : 0u)
            - 1u);
        Paged_corner0_found = true;
    }
    uvec2 Paged_corner0_place = Paged_corner0_result;
    bool Paged_corner0_value_inside = Paged_corner0_found && Paged_corner0_place.y < Paged_frames_extent.y;
    uint Paged_corner0_value_at = Paged_corner0_place.y * Paged_frames_extent.x + Paged_corner0_place.x;
    float Paged_corner0_value = Paged_frames_data[Paged_corner0_value_inside ? Paged_corner0_value_at : 0u];
    uint Paged_corner1_address = Paged_base + 1u;
    bool Paged_corner1_either = Paged_corner1_address >= Paged_extent;
    if (!Paged_corner1_either) {
        uint Paged_table_address = Paged_corner1_address / 16u;
        bool Paged_table_value_inside = Paged_table_address < Paged_table_extent;
        uint Paged_table_value = Paged_table_data[Paged_table_value_inside ? Paged_table_address : 0u];
        Paged_corner1_either = (Paged_table_value_inside ? Paged_table_value : 0u) == 0u;
    }
    uvec2 Paged_corner1_result = uvec2(0u);
    bool Paged_corner1_found = false;
    if (Paged_corner1_either) {
        Paged_corner1_result = uvec2(0u);
        Paged_corner1_found = false;
    } else {
        uint Paged_table_address = Paged_corner1_address / 16u;
        bool Paged_table_value_inside = Paged_table_address < Paged_table_extent;
        uint Paged_table_value = Paged_table_data[Paged_table_value_inside ? Paged_table_address : 0u];
        Paged_corner1_result = uvec2(Paged_corner1_address % 16u,
            (Paged_table_value_inside ? Paged_table_value : 0u) - 1u);
        Paged_corner1_found = true;
    }
    uvec2 Paged_corner1_place = Paged_corner1_result;
    bool Paged_corner1_value_inside = Paged_corner1_found && Paged_corner1_place.y < Paged_frames_extent.y;
    uint Paged_corner1_value_at = Paged_corner1_place.y * Paged_frames_extent.x + Paged_corner1_place.x;
    float Paged_corner1_value = Paged_frames_data[Paged_corner1_value_inside ? Paged_corner1_value_at : 0u];
    return blend(Paged_corner0_value_inside ? Paged_corner0_value : -1.0, Paged_corner1_value_inside
        ? Paged_corner1_value : -1.0, Paged_weight);
}

#ifndef PAGED_READONLY
void Paged_write(uint address, float value) {
    bool Paged_either = address >= Paged_extent;
    if (!Paged_either) {
        uint Paged_table_address = address / 16u;
        bool Paged_table_value_inside = Paged_table_address < Paged_table_extent;
        uint Paged_table_value = Paged_table_data[Paged_table_value_inside ? Paged_table_address : 0u];
        Paged_either = (Paged_table_value_inside ? Paged_table_value : 0u) == 0u;
    }
    uvec2 Paged_result = uvec2(0u);
    bool Paged_found = false;
    if (Paged_either) {
        Paged_result = uvec2(0u);
        Paged_found = false;
    } else {
        uint Paged_table_address = address / 16u;
        bool Paged_table_value_inside = Paged_table_address < Paged_table_extent;
        uint Paged_table_value = Paged_table_data[Paged_table_value_inside ? Paged_table_address : 0u];
        Paged_result = uvec2(address % 16u, (Paged_table_value_inside ? Paged_table_value : 0u) - 1u);
        Paged_found = true;
    }
    uvec2 Paged_place = Paged_result;
    if (address < Paged_extent && (Paged_found && all(lessThan(Paged_place, Paged_frames_extent)))) {
        Paged_frames_data[Paged_place.y * Paged_frames_extent.x + Paged_place.x] = value;
    }
}
#endif
#elif GLIFT_PAGED != 1335873461
#error the functions of another structure called Paged are included already
#endif
