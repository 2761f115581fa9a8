// What programs of several ranks compute, and the same on one device.
#pragma once

#include <glift/ranks/world.h>

#include <functional>
#include <string>
#include <vector>

namespace ranks_test {

/// Distributes structures; on one device it does nothing.
class Spread {
public:
    explicit Spread(glift::ranks::World* world, std::uint32_t halo = 0) : world_(world), halo_(halo) {}

    template <class S> void operator()(const S& structure) const {
        if (world_) world_->distribute(structure, {.halo = halo_});
    }
    template <class S> void balance(const S& structure) const {
        if (world_) world_->balance(structure);
    }

private:
    glift::ranks::World* world_;
    std::uint32_t halo_;
};

using Bits = std::vector<std::uint32_t>;

struct Case {
    std::string name;
    std::function<Bits(const glift::Device& device, const Spread& spread)> run;
};

const std::vector<Case>& cases();

/// Runs the cases whose names begin with `which` on all ranks and on this rank's device alone, and prints how they
/// compare. Returns 1 if a bit differs.
int run_cases(glift::ranks::World& world, const std::string& which);

/// Counts what the heat example sends, and compares it with the definition of its halo. Returns 1 if it differs.
int check_bytes(glift::ranks::World& world);

/// One rank stops making calls: the others must get an error with its name within the limit. Returns 0 if this one did.
int check_hang(glift::ranks::World& world);

/// One rank kills itself.
int die(glift::ranks::World& world);

/// The test that the program's arguments name.
int run(glift::ranks::World& world, const std::string& test, const std::string& which);

}  // namespace ranks_test
