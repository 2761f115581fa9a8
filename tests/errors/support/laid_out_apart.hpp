#pragma once

struct Flags {
    bool first;
    float second;
};

struct Apart {
    float first;
    alignas(16) float second;
};
