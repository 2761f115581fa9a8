#version 460
// The Laplacian of a 4-D array, row-major in a buffer; zero outside. An invocation takes two elements that are
// neighbours along y, which share the tests along the other axes.

layout(local_size_x = 32, local_size_y = 4, local_size_z = 2) in;

layout(push_constant) uniform Parameters { uvec4 extent; };

layout(set = 0, binding = 1) readonly buffer F { float f[]; };
layout(set = 0, binding = 2) writeonly buffer G { float g[]; };

void main() {
    uvec3 id = gl_GlobalInvocationID;
    uvec4 p = uvec4(id.x, 2u * id.y, id.z % extent.z, id.z / extent.z);
    if (any(greaterThanEqual(p, extent))) return;

    uint row = extent.x, plane = row * extent.y, box = plane * extent.z;
    bool xp = p.x + 1u < extent.x, zp = p.z + 1u < extent.z, wp = p.w + 1u < extent.w;
    bool xm = p.x > 0u, ym = p.y > 0u, zm = p.z > 0u, wm = p.w > 0u;
    bool has_next = p.y + 1u < extent.y, yp = p.y + 2u < extent.y;
    // Offsets to neighbours outside are zero, so that each load is unconditional; neighbours outside count as zero.
    uint to_xp = xp ? 1u : 0u, to_xm = xm ? 1u : 0u, to_zp = zp ? plane : 0u, to_zm = zm ? plane : 0u;
    uint to_wp = wp ? box : 0u, to_wm = wm ? box : 0u;

    uint i = ((p.w * extent.z + p.z) * extent.y + p.y) * extent.x + p.x;
    uint j = i + (has_next ? row : 0u);
    float fi = f[i], fj = f[j];  // two elements, each of which is a neighbour of the other
    float fxp = f[i + to_xp], fxm = f[i - to_xm], fym = f[i - (ym ? row : 0u)];
    float fzp = f[i + to_zp], fzm = f[i - to_zm], fwp = f[i + to_wp], fwm = f[i - to_wm];
    precise float sum = -8.0 * fi;
    sum += xp ? fxp : 0.0;
    sum += xm ? fxm : 0.0;
    sum += has_next ? fj : 0.0;
    sum += ym ? fym : 0.0;
    sum += zp ? fzp : 0.0;
    sum += zm ? fzm : 0.0;
    sum += wp ? fwp : 0.0;
    sum += wm ? fwm : 0.0;

    fxp = f[j + to_xp];
    fxm = f[j - to_xm];
    float fyp = f[j + (yp ? row : 0u)];
    fzp = f[j + to_zp];
    fzm = f[j - to_zm];
    fwp = f[j + to_wp];
    fwm = f[j - to_wm];
    precise float next = -8.0 * fj;
    next += xp ? fxp : 0.0;
    next += xm ? fxm : 0.0;
    next += yp ? fyp : 0.0;
    next += fi;
    next += zp ? fzp : 0.0;
    next += zm ? fzm : 0.0;
    next += wp ? fwp : 0.0;
    next += wm ? fwm : 0.0;

    g[i] = sum;
    if (has_next) g[j] = next;
}
