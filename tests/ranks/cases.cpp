#include "cases.h"

#include "fields.glift.hpp"
#include "front.glift.hpp"
#include "heat.glift.hpp"
#include "moving_shell.glift.hpp"
#include "smoke.glift.hpp"

#include <glift/error.h>
#if defined(GLIFT_WITH_FILES)
#include <glift/files.h>
#endif

#include <bit>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>
#include <type_traits>

namespace ranks_test {

namespace {

template <class T> void add(Bits& bits, const std::vector<T>& values) {
    const std::size_t at = bits.size();
    bits.resize(at + values.size() * sizeof(T) / 4);
    if (!values.empty()) std::memcpy(bits.data() + at, values.data(), values.size() * sizeof(T));
}

/// The addresses and the elements of the resident pages.
template <class S> void add_resident(Bits& bits, const S& structure) {
    const auto found = structure.read_resident();
    add(bits, found.addresses);
    add(bits, found.values);
}

std::vector<float> noise(std::size_t count) {
    std::vector<float> values(count);
    std::uint32_t random = 12345;
    for (float& value : values) {
        random = random * 1664525u + 1013904223u;
        value = static_cast<float>(random >> 8) * 0x1p-20f;
    }
    return values;
}

Bits heat_case(const glift::Device& device, const Spread& spread) {
    Bits bits;
    for (const glift::uint3 extent : {glift::uint3{40, 36, 64}, glift::uint3{33, 17, 21}, glift::uint3{16, 16, 130}}) {
        heat::Volume u(device, extent);
        spread(u);
        u.write(noise(std::size_t{extent.x} * extent.y * extent.z));
        heat::diffuse(device, u, 0.125f, 7);
        heat::diffuse(device, u, 0.125f, 4);
        add(bits, u.read());
        heat::diffuse(device, u, 0.125f, 2);
        add(bits, u.read({3, 4, 5}, {10, 9, 12}));
    }
    return bits;
}

Bits edges_case(const glift::Device& device, const Spread& spread) {
    const glift::uint2 extent{70, 96};
    fields::Plain x(device, extent);
    fields::Ring ring(device, extent);
    fields::Mirror mirror(device, extent);
    spread(x);
    spread(ring);
    spread(mirror);
    fields::prepare(device, x);
    ring.write(noise(extent.x * extent.y));
    mirror.write(noise(extent.x * extent.y));
    fields::edges(device, x, ring, mirror, 3);
    Bits bits;
    add(bits, x.read());
    add(bits, ring.read());
    add(bits, mirror.read());
    return bits;
}

Bits leave_case(const glift::Device& device, const Spread& spread) {
    fields::Plain x(device, {70, 96});
    spread(x);
    fields::prepare(device, x);
    fields::leave(device, x, 9);
    Bits bits;
    add(bits, x.read());
    return bits;
}

Bits updates_case(const glift::Device& device, const Spread& spread) {
    const glift::uint2 extent{70, 96};
    fields::Plain x(device, extent);
    fields::Line counts(device, 4), bit_set(device, 300);
    spread(x);
    fields::prepare(device, x);
    fields::updates(device, x, counts, bit_set);
    Bits bits;
    add(bits, counts.read());
    add(bits, x.read());
    add(bits, bit_set.read());
    return bits;
}

Bits anywhere_case(const glift::Device& device, const Spread& spread) {
    const glift::uint2 extent{64, 64};
    fields::Plain x(device, extent);
    spread(x);
    fields::prepare(device, x);
    fields::anywhere(device, x);
    Bits bits;
    add(bits, x.read());
    return bits;
}

Bits algorithms_case(const glift::Device& device, const Spread& spread) {
    constexpr std::uint32_t count = 20000;
    fields::Flat x(device, count), results(device, 2);
    fields::Line keys(device, count);
    spread(x);
    x.write(noise(count));
    fields::algorithms(device, x, keys, results);
    Bits bits;
    add(bits, results.read());
    add(bits, keys.read());
    return bits;
}

Bits pairs_case(const glift::Device& device, const Spread& spread) {
    const glift::uint3 extent{20, 19, 48};
    fields::Pairs apart(device, extent);
    fields::Together together(device, extent);
    spread(apart);
    spread(together);
    fields::pairs(device, apart, 3);
    fields::pairs_together(device, together, 3);
    Bits bits;
    add(bits, apart.read());
    add(bits, together.read());
    return bits;
}

Bits shell_case(const glift::Device& device, const Spread& spread) {
    band::Band band(device, {96, 80, 112}, 900);
    moving_shell::Clock clock(device, 1);
    spread(band);
    moving_shell::begin(device, band, clock, 20);
    for (int step = 0; step < 5; ++step) moving_shell::step(device, band, clock, 20);
    Bits bits;
    add(bits, std::vector{band.pages().state().read()[0].resident});
    spread.balance(band);
    for (int step = 0; step < 5; ++step) moving_shell::step(device, band, clock, 20);
    add_resident(bits, band);
    return bits;
}

Bits front_case(const glift::Device& device, const Spread& spread) {
    band::Band band(device, {64, 64, 96}, 1200, {8, 8});
    const front::Ball ball{{30, 32, 40}, 12};
    front::Balls balls(device, 1);
    balls.write(std::vector{ball});
    spread(band);
    front::ask_near(device, band, ball);
    front::begin(device, band, balls);
    const front::Motion motion{{32, 32, 48}, 30, 0.35f, 0.15f};
    for (int step = 0; step < 6; ++step) {
        front::step(device, band, motion);
        if (step == 2) spread.balance(band);
    }
    Bits bits;
    add_resident(bits, band);
    return bits;
}

Bits smoke_case(const glift::Device& device, const Spread& spread) {
    smoke::Smoke grid(device, {256, 192}, 200);
    spread(grid);
    smoke::Picture picture(device, {256, 192});
    for (int step = 0; step < 8; ++step) {
        smoke::step(device, grid, {120, 150}, 12, 1, 5);
        if (step == 3) spread.balance(grid);
    }
    smoke::draw(device, grid.now().density(), picture);
    Bits bits;
    add_resident(bits, grid);
    add(bits, picture.read());
    return bits;
}

}  // namespace

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {"heat", heat_case},         {"edges", edges_case},           {"leave", leave_case}, {"updates", updates_case},
        {"anywhere", anywhere_case}, {"algorithms", algorithms_case}, {"pairs", pairs_case}, {"shell", shell_case},
        {"front", front_case},       {"smoke", smoke_case},
    };
    return all;
}

namespace {

/// Prints how the results compare, on the first rank and where they differ.
bool compare(glift::ranks::World& world, const std::string& what, const Bits& many, const Bits& alone,
             const glift::ranks::Statistics& before) {
    std::size_t differing = many.size() != alone.size();
    for (std::size_t i = 0; i < many.size() && i < alone.size(); ++i) differing += many[i] != alone[i];
    if (world.rank() != 0 && differing == 0) return true;
    const glift::ranks::Statistics after = world.statistics();
    const auto since = [](std::uint64_t now, std::uint64_t then) {
        return static_cast<unsigned long long>(now - then);
    };
    std::printf("%s: %s: rank %u of %u: %s, %zu of %zu words differ; %llu exchanges, %llu bytes; %llu gathers, %llu "
                "bytes; %llu combinations; %llu passes distributed, %llu whole\n",
                differing ? "FAIL" : "pass", what.c_str(), world.rank(), world.size(),
                world.local_device().properties().name.c_str(), differing, alone.size(),
                since(after.exchanges, before.exchanges), since(after.exchanged_bytes, before.exchanged_bytes),
                since(after.gathers, before.gathers), since(after.gathered_bytes, before.gathered_bytes),
                since(after.combinations, before.combinations),
                since(after.distributed_passes, before.distributed_passes),
                since(after.whole_passes, before.whole_passes));
    std::fflush(stdout);
    return differing == 0;
}

}  // namespace

int run_cases(glift::ranks::World& world, const std::string& which) {
    int result = 0;
    for (const Case& one : cases()) {
        if (!one.name.starts_with(which)) continue;
        const Bits alone = one.run(world.local_device(), Spread(nullptr));
        for (const std::uint32_t halo : {0u, 2u, 7u}) {
            const glift::ranks::Statistics before = world.statistics();
            const Bits many = one.run(world.device(), Spread(&world, halo));
            const std::string what = one.name + (halo ? ", halo " + std::to_string(halo) : "");
            if (!compare(world, what, many, alone, before)) result = 1;
        }
    }
    for (const std::string& message : world.device().validation_messages()) {
        std::printf("FAIL: rank %u: %s\n", world.rank(), message.c_str());
        result = 1;
    }
    return result;
}

int check_bytes(glift::ranks::World& world) {
    constexpr std::uint32_t steps = 6, x = 24, y = 20, z = 128;
    heat::Volume u(world.device(), {x, y, z});
    world.distribute(u);
    u.write(noise(x * y * z));
    heat::diffuse(world.device(), u, 0.125f, steps);
    // Each step reads one plane of each neighbour, and sends as many.
    const std::uint64_t neighbours = (world.rank() > 0) + (world.rank() + 1 < world.size());
    const std::uint64_t expected = steps * neighbours * x * y * sizeof(float);
    const glift::ranks::Statistics sent = world.statistics();
    const bool is_right = sent.exchanged_bytes == expected && sent.gathered_bytes == 0 && sent.combined_bytes == 0;
    std::printf("%s: rank %u of %u sent %llu bytes, the halo has %llu\n", is_right ? "pass" : "FAIL", world.rank(),
                world.size(), static_cast<unsigned long long>(sent.exchanged_bytes),
                static_cast<unsigned long long>(expected));
    return is_right ? 0 : 1;
}

int check_balance(glift::ranks::World& world) {
    double before = 1, after = 1;
    const auto corner = [&](const glift::Device& device, glift::ranks::World* balanced) {
        band::Band band(device, {256, 256, 256}, 9000, {8, 8});
        front::Balls balls(device, 1);
        if (balanced) balanced->distribute(band);
        for (int step = 0; step < 4; ++step) {
            const float middle = 150 - 20 * static_cast<float>(step);
            const front::Ball ball{{middle, middle, middle}, 80};
            balls.write(std::vector{ball});
            front::ask_near(device, band, ball);
            front::begin(device, band, balls);
            front::step(device, band, {{128, 128, 128}, 100, 0.35f, 0.15f});
            if (balanced) before = std::max(before, balanced->imbalance(band));
            if (balanced) after = std::max(after, balanced->balance(band));
            front::step(device, band, {{128, 128, 128}, 100, 0.35f, 0.15f});
        }
        Bits bits;
        add_resident(bits, band);
        return bits;
    };
    const glift::ranks::Statistics start = world.statistics();
    const Bits many = corner(world.device(), &world);
    bool is_good = compare(world, "corner", many, corner(world.local_device(), nullptr), start) && after < 1.15;
    if (world.rank() == 0)
        std::printf("%s: %u ranks: imbalance %.3f at most before balance(), %.3f after; rank 0 sent %llu bytes to new "
                    "owners\n",
                    is_good ? "pass" : "FAIL", world.size(), before, after,
                    static_cast<unsigned long long>(world.statistics().migrated_bytes));
    return is_good ? 0 : 1;
}

int check_refusals(glift::ranks::World& world) {
    int missing = 0;
    const auto refuses = [&](const char* what, const std::function<void()>& call) {
        try {
            call();
        } catch (const glift::Error& error) {
            if (world.rank() == 0) std::printf("pass: %s: %s\n", what, error.what());
            return;
        }
        std::printf("FAIL: %s was not refused\n", what);
        missing = 1;
    };
    heat::Volume u(world.device(), {8, 8, 8}), flat(world.device(), {8, 8, 1});
    refuses("a recording", [&] { world.device().record([](const glift::Commands&) {}); });
    refuses("a structure of one plane", [&] { world.distribute(flat); });
    refuses("a wide halo", [&] { world.distribute(u, {.halo = 9}); });
    band::Band band(world.device(), {16, 16, 16}, 4);
    refuses("balance() before distribute()", [&] { world.balance(band); });
    return missing;
}

#if defined(GLIFT_WITH_FILES)

namespace {

constexpr glift::uint3 saved_extent{24, 20, 96};
constexpr front::Motion saved_motion{{32, 32, 32}, 30, 0.35f, 0.15f};

heat::Volume begun_heat(const glift::Device& device, glift::ranks::World* world) {
    heat::Volume u(device, saved_extent);
    if (world) world->distribute(u);
    u.write(noise(std::size_t{saved_extent.x} * saved_extent.y * saved_extent.z));
    heat::diffuse(device, u, 0.125f, 5);
    return u;
}

band::Band begun_band(const glift::Device& device, glift::ranks::World* world) {
    band::Band band(device, {64, 64, 64}, 512, {8, 8});
    if (world) world->distribute(band);
    front::Balls balls(device, 1);
    const front::Ball ball{{30, 28, 33}, 14};
    balls.write(std::vector{ball});
    front::ask_near(device, band, ball);
    front::begin(device, band, balls);
    for (int step = 0; step < 2; ++step) front::step(device, band, saved_motion);
    return band;
}

Bits finished(const glift::Device& device, heat::Volume u, band::Band band) {
    heat::diffuse(device, u, 0.125f, 5);
    for (int step = 0; step < 2; ++step) front::step(device, band, saved_motion);
    Bits bits;
    add(bits, u.read());
    add_resident(bits, band);
    return bits;
}

/// 1: the call does not throw an error of this code on this rank.
int misses(glift::ranks::World& world, const char* what, glift::ErrorCode code, const std::function<void()>& call) {
    try {
        call();
        std::printf("FAIL: rank %u: %s: no error\n", world.rank(), what);
    } catch (const glift::Error& error) {
        if (error.code() == code) return 0;
        std::printf("FAIL: rank %u: %s: %s\n", world.rank(), what, error.what());
    }
    return 1;
}

}  // namespace

int save_half(glift::ranks::World& world, const std::string& file) {
    const heat::Volume u = begun_heat(world.device(), &world);
    const band::Band band = begun_band(world.device(), &world);
    glift::NewFile saved(file, world.device());
    saved.save("heat", u);
    saved.save("band", band);
    saved.commit();
    int missing = misses(world, "a folder that does not exist", glift::ErrorCode::wrong_argument,
                         [&] { glift::save(file + "/nowhere/x.h5", "heat", u); });
    missing += misses(world, "a file of each rank for itself", glift::ErrorCode::wrong_argument,
                      [&] { glift::NewFile(file + std::to_string(world.rank())).save("heat", u); });
    missing += misses(world, "a name twice", glift::ErrorCode::wrong_argument, [&] {
        glift::NewFile twice(file + ".twice", world.device());
        twice.save("heat", u);
        twice.save("heat", u);
    });
    return missing > 0;
}

int load_half(glift::ranks::World& world, const std::string& file) {
    const glift::ranks::Statistics start = world.statistics();
    const auto u = glift::load<heat::Volume>(file, "heat", world.device());
    world.distribute(u);
    band::Band band(world.device(), {64, 64, 64}, 512, {8, 8});  // this one is distributed before it is loaded
    world.distribute(band);
    glift::load(file, "band", band);
    const Bits many = finished(world.device(), u, band);
    const Bits one = finished(world.local_device(), begun_heat(world.local_device(), nullptr),
                              begun_band(world.local_device(), nullptr));
    int missing = !compare(world, "restart", many, one, start);

    missing += misses(world, "no such structure", glift::ErrorCode::wrong_argument,
                      [&] { glift::load<heat::Volume>(file, "cold", world.device()); });
    const bool is_last = world.rank() + 1 == world.size();
    missing += misses(world, "a rank without the file", glift::ErrorCode::wrong_argument,
                      [&] { glift::load<heat::Volume>(file + (is_last ? "x" : ""), "heat", world.device()); });
    // The last rank has a damaged copy, then another file.
    const std::string own = file + "." + std::to_string(world.size()) + "." + std::to_string(world.rank());
    std::filesystem::copy_file(file, own, std::filesystem::copy_options::overwrite_existing);
    if (is_last) std::fstream(own, std::ios::in | std::ios::out | std::ios::binary).seekp(90000).put('x');
    missing += misses(world, "a damaged file of one rank", glift::ErrorCode::bad_file,
                      [&] { glift::load<heat::Volume>(own, "heat", world.device()); });
    if (is_last) glift::save(own, "heat", heat::Volume(world.local_device(), saved_extent));
    if (world.size() > 1)
        missing += misses(world, "different files", glift::ErrorCode::bad_file,
                          [&] { glift::load<heat::Volume>(own, "heat", world.device()); });
    std::filesystem::remove(own);
    return missing > 0;
}

#else

int save_half(glift::ranks::World&, const std::string&) { return 0; }
int load_half(glift::ranks::World&, const std::string&) { return 0; }

#endif

int check_hang(glift::ranks::World& world) {
    heat::Volume u(world.device(), {16, 16, 64});
    world.distribute(u);
    heat::diffuse(world.device(), u, 0.125f, 2);
    if (world.rank() + 1 == world.size()) {
        std::this_thread::sleep_for(std::chrono::seconds(8));
        return 0;
    }
    const auto begin = std::chrono::steady_clock::now();
    try {
        heat::diffuse(world.device(), u, 0.125f, 50);
        u.read();
    } catch (const glift::Error& error) {
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        std::printf("rank %u, after %.1f s: %s\n", world.rank(), seconds, error.what());
        const bool names_it =
            std::string(error.what()).find("rank " + std::to_string(world.size() - 1) + " (") != std::string::npos;
        return error.code() == glift::ErrorCode::lost_rank && names_it && seconds < 6 ? 0 : 1;
    }
    return 1;
}

int die(glift::ranks::World& world) {
    heat::Volume u(world.device(), {16, 16, 64});
    world.distribute(u);
    heat::diffuse(world.device(), u, 0.125f, 2);
    if (world.rank() == 1) std::raise(SIGKILL);
    heat::diffuse(world.device(), u, 0.125f, 50);
    u.read();
    return 0;
}

int run(glift::ranks::World& world, const std::string& test, const std::string& which) {
    if (test == "bytes") return check_bytes(world);
    if (test == "balance") return check_balance(world);
    if (test == "refusals") return check_refusals(world);
    if (test == "save") return save_half(world, which);
    if (test == "load") return load_half(world, which);
    if (test == "hang") return check_hang(world);
    if (test == "die") return die(world);
    return run_cases(world, which);
}

}  // namespace ranks_test
