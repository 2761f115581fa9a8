// Paged, shared.glift:27.
// Define PAGED_BINDING before including. The structure's state (the members declared below) is at that binding, memory k at PAGED_BINDING + 1 + k.
// Optional: PAGED_SET (the descriptor set, else 0), PAGED_STATE (see below), PAGED_READONLY (nothing is written).
#ifndef GLIFT_PAGED
#define GLIFT_PAGED 124841848
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
#elif GLIFT_PAGED != 124841848
#error the functions of another structure called Paged are included already
#endif
