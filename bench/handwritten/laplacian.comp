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

    // Always a load, never a branch: one outside reads the centre and counts as zero.
    bool xp = p.x + 1u < extent.x, yp = p.y + 1u < extent.y, zp = p.z + 1u < extent.z, wp = p.w + 1u < extent.w;
    bool xm = p.x > 0u, ym = p.y > 0u, zm = p.z > 0u, wm = p.w > 0u;
    float fxp = f[xp ? i + 1u : i], fxm = f[xm ? i - 1u : i];
    float fyp = f[yp ? i + row : i], fym = f[ym ? i - row : i];
    float fzp = f[zp ? i + plane : i], fzm = f[zm ? i - plane : i];
    float fwp = f[wp ? i + box : i], fwm = f[wm ? i - box : i];
    precise float sum = -8.0 * f[i];
    sum += xp ? fxp : 0.0;
    sum += xm ? fxm : 0.0;
    sum += yp ? fyp : 0.0;
    sum += ym ? fym : 0.0;
    sum += zp ? fzp : 0.0;
    sum += zm ? fzm : 0.0;
    sum += wp ? fwp : 0.0;
    sum += wm ? fwm : 0.0;
    g[i] = sum;
}
