#include "ir/pass.h"

#include <algorithm>

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

std::uint32_t Pass::message_of(const Stmt& print) const {
    return static_cast<std::uint32_t>(std::ranges::find(messages, print.slot) - messages.begin());
}

}  // namespace gliftc::ir
