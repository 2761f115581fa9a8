#pragma once

namespace shop {
struct Item {
    float price;
};
}  // namespace shop

namespace store {
struct Item {
    int shelf, row;
};
}  // namespace store

struct Order {
    shop::Item first;
    store::Item second;
};

struct Place {
    store::Item item;
};
