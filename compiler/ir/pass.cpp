#include "ir/pass.h"

namespace gliftc::ir {

const PassUpdate* Pass::ordered_sum(std::uint32_t binding) const {
    for (const PassUpdate& update : updates)
        if (update.order && update.binding == binding) return &update;
    return nullptr;
}

std::vector<SumOrder> Pass::sum_orders() const {
    std::vector<SumOrder> orders;
    for (const PassUpdate& update : updates)
        if (update.order) orders.push_back(*update.order);
    return orders;
}

}  // namespace gliftc::ir
