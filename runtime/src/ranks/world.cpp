#include <glift/ranks/world.h>

#include "rank_device.h"

#include <glift/error.h>

#include <cstdlib>
#include <string>

namespace glift::ranks {

namespace {

Options with_limit(Options options) {
    if (options.limit.count() > 0) return options;
    options.limit = std::chrono::seconds(60);
    const char* text = std::getenv("GLIFT_RANKS_TIMEOUT");
    if (!text || !*text) return options;
    char* end = nullptr;
    const double seconds = std::strtod(text, &end);
    if (*end || !(seconds > 0))
        throw Error(ErrorCode::wrong_argument, "an environment variable has an invalid value",
                    std::string("GLIFT_RANKS_TIMEOUT=") + text, "it takes a number of seconds larger than 0",
                    "set it to 10, for example, or leave it out: 60");
    options.limit = std::chrono::duration<double>(seconds);
    return options;
}

}  // namespace

World::World(std::shared_ptr<Transport> transport, const Device& local, const Options& options)
    : object_(std::make_shared<detail::RankDevice>(std::move(transport), detail::shared_device(local, "World"),
                                                   with_limit(options))),
      device_(object_), local_(local) {}

World::~World() = default;

unsigned World::rank() const { return object_->ranks().messenger().rank(); }
unsigned World::size() const { return object_->ranks().messenger().size(); }
const Device& World::device() const { return device_; }
const Device& World::local_device() const { return local_; }
Statistics World::statistics() const { return object_->ranks().statistics(); }
void World::barrier() { object_->ranks().messenger().barrier(); }

void World::distribute(const char* type_name, const detail::RangeShape& shape, const std::vector<Memory>& memories,
                       const Distribution& how) {
    object_->ranks().distribute(type_name, shape, memories, how);
}
void World::distribute(const detail::PagedShape& shape, const Distribution& how) {
    object_->ranks().distribute(shape, how);
}
double World::imbalance(const detail::PagedShape& shape) { return object_->ranks().imbalance(shape); }
double World::balance(const detail::PagedShape& shape) { return object_->ranks().balance(shape); }

}  // namespace glift::ranks
