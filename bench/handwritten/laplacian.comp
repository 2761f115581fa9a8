#version 460
// The Laplacian of a 4-D array, row-major in a buffer; zero outside.

layout(local_size_x = 32, local_size_y = 4, local_size_z = 2) in;

layout(push_constant) uniform Parameters { uvec4 extent; };

layout(set = 0, binding = 1) readonly buffer F { float f[]; };
layout(set = 0, binding = 2) writeonly buffer G { float g[]; };

void main() {
    uvec3 id = gl_GlobalInvocationID;
    uvec4 p = uvec4(id.xy, id.z % extent.z, id.z / extent.z);
    if (any(greaterThanEqual(p, extent))) return;

    uint row = extent.x, plane = row * extent.y, box = plane * extent.z;
    uint i = ((p.w * extent.z + p.z) * extent.y + p.y) * extent.x + p.x;

    float sum = -8.0 * f[i];
    sum += p.x + 1u < extent.x ? f[i + 1u] : 0.0;
    sum += p.x > 0u ? f[i - 1u] : 0.0;
    sum += p.y + 1u < extent.y ? f[i + row] : 0.0;
    sum += p.y > 0u ? f[i - row] : 0.0;
    sum += p.z + 1u < extent.z ? f[i + plane] : 0.0;
    sum += p.z > 0u ? f[i - plane] : 0.0;
    sum += p.w + 1u < extent.w ? f[i + box] : 0.0;
    sum += p.w > 0u ? f[i - box] : 0.0;
    g[i] = sum;
}
