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

/// A front that moves into one corner: with World::balance no rank has more than 1.15 of the mean. Returns 1 if one
/// has, or if a bit differs.
int check_balance(glift::ranks::World& world);

/// What a device of several ranks refuses, with an error that says so. Returns 1 if it does not.
int check_refusals(glift::ranks::World& world);

/// Computes half of a diffusion and of a front's motion, and saves them with glift::save; or loads that file and
/// computes the rest, which is compared with all of it computed on one device. Also checks that what fails on one rank
/// is an error on all. Returns 1 if something differs. They do nothing where glift::files was not built.
int save_half(glift::ranks::World& world, const std::string& file);
int load_half(glift::ranks::World& world, const std::string& file);

/// One rank stops making calls: the others must get an error with its name within the limit. Returns 0 if this one did.
int check_hang(glift::ranks::World& world);

/// One rank kills itself.
int die(glift::ranks::World& world);

/// The test that the program's arguments name.
int run(glift::ranks::World& world, const std::string& test, const std::string& which);

}  // namespace ranks_test
