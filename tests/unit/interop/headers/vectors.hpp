#pragma once

struct float3 {
    float x, y, z;
};

template <int N, class T> struct vec {
    T at[N];
};
