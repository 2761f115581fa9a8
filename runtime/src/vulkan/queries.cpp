#include "queries.h"

#include <glift/error.h>

#include <cmath>

namespace glift::detail {

namespace {

constexpr std::uint32_t pool_size = 256;

}  // namespace

VkQueryPool make_timestamps(Context& context, std::uint32_t count) {
    const VkQueryPoolCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO, .queryType = VK_QUERY_TYPE_TIMESTAMP, .queryCount = count};
    VkQueryPool pool = VK_NULL_HANDLE;
    context.check(context.vk.vkCreateQueryPool(context.device, &info, nullptr, &pool), "vkCreateQueryPool");
    return pool;
}

Queries::~Queries() {
    for (VkQueryPool pool : pools_) context_.vk.vkDestroyQueryPool(context_.device, pool, nullptr);
}

Query Queries::take() {
    if (!context_.timestamp_bits) {
        throw Error(ErrorCode::missing_feature, "the device's queue has no timestamps", context_.properties.name);
    }
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) {
        VkQueryPool pool = make_timestamps(context_, pool_size);
        pools_.push_back(pool);
        for (std::uint32_t k = 0; k < pool_size; ++k) idle_.push_back({pool, k});
    }
    const Query query = idle_.back();
    idle_.pop_back();
    context_.vk.vkResetQueryPool(context_.device, query.pool, query.index, 1);
    return query;
}

void Queries::give_back(Query query) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(query);
}

std::optional<std::uint64_t> Queries::ticks(Query query, VkQueryResultFlags flags) {
    std::uint64_t ticks = 0;
    const VkResult result = context_.vk.vkGetQueryPoolResults(context_.device, query.pool, query.index, 1, sizeof ticks,
                                                              &ticks, sizeof ticks, VK_QUERY_RESULT_64_BIT | flags);
    context_.check(result, "vkGetQueryPoolResults");
    if (result == VK_NOT_READY) return std::nullopt;
    return valid_part(ticks);
}

std::uint64_t Queries::valid_part(std::uint64_t ticks) const {
    if (context_.timestamp_bits < 64) ticks &= (std::uint64_t(1) << context_.timestamp_bits) - 1;
    return ticks;
}

double Queries::seconds(Query query) {
    return static_cast<double>(ticks(query, VK_QUERY_RESULT_WAIT_BIT).value_or(0)) *
           context_.properties.timestamp_seconds;
}

// Clocks may count from 1970: doubles, of 53 bits, would round nanoseconds to hundreds.
std::int64_t Queries::nanoseconds_of(std::uint64_t ticks) const {
    const double tick = context_.properties.timestamp_seconds * 1e9;
    if (std::abs(tick - 1) < 1e-6) return static_cast<std::int64_t>(ticks);
    return static_cast<std::int64_t>(static_cast<long double>(ticks) * tick);
}

std::optional<std::int64_t> Queries::nanoseconds(Query query) {
    const std::optional<std::uint64_t> count = ticks(query, 0);
    if (!count) return std::nullopt;
    return nanoseconds_of(*count);
}

std::optional<std::int64_t> Queries::now() {
    if (!context_.vk.vkGetCalibratedTimestampsEXT || !context_.timestamp_bits) return std::nullopt;
    const VkCalibratedTimestampInfoEXT info = {.sType = VK_STRUCTURE_TYPE_CALIBRATED_TIMESTAMP_INFO_EXT,
                                               .timeDomain = VK_TIME_DOMAIN_DEVICE_EXT};
    std::uint64_t ticks = 0, deviation = 0;
    context_.check(context_.vk.vkGetCalibratedTimestampsEXT(context_.device, 1, &info, &ticks, &deviation),
                   "vkGetCalibratedTimestampsEXT");
    return nanoseconds_of(valid_part(ticks));
}

}  // namespace glift::detail
