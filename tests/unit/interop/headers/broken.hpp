#pragma once

struct Broken {
    flota x;
};
