// Timestamp queries, taken from pools. One Timestamp at a time uses a query.
#pragma once

#include "context.h"

#include <mutex>
#include <optional>
#include <vector>

namespace glift::detail {

struct Query {
    VkQueryPool pool = VK_NULL_HANDLE;
    std::uint32_t index = 0;
};

/// A pool of timestamp queries, which the caller destroys.
VkQueryPool make_timestamps(Context&, std::uint32_t count);

class Queries {
public:
    explicit Queries(Context& context) : context_(context) {}
    ~Queries();

    Query take();                 ///< the device's lock is held; the query is reset
    void give_back(Query query);  ///< from any thread, after the device is done with it
    double seconds(Query query);  ///< of a query that the device has written
    /// Nothing if the device has not written the query.
    std::optional<std::int64_t> nanoseconds(Query query);
    std::optional<std::int64_t> now();  ///< the device's clock; nothing if it cannot be read

private:
    std::optional<std::uint64_t> ticks(Query query, VkQueryResultFlags flags);
    std::uint64_t valid_part(std::uint64_t ticks) const;
    std::int64_t nanoseconds_of(std::uint64_t ticks) const;

    Context& context_;
    std::mutex mutex_;
    std::vector<VkQueryPool> pools_;
    std::vector<Query> idle_;
};

}  // namespace glift::detail
