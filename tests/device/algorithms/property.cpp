#include "property.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace property {

namespace {

std::uint64_t number(const char* name, std::uint64_t otherwise) {
    const char* text = std::getenv(name);
    return text && *text ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// Closes the devices after the tests rather than at exit: a driver that is loaded after the first static object is
/// made is unloaded before that object is destroyed.
class OpenDevices : public testing::Environment {
public:
    static std::map<std::string, glift::Device>& all() {
        static std::map<std::string, glift::Device> devices;
        return devices;
    }
    void TearDown() override { all().clear(); }
};
const auto* const open_devices = testing::AddGlobalTestEnvironment(new OpenDevices);

const char* name_of(Form form) {
    switch (form) {
    case Form::dense: return "dense";
    case Form::folded: return "folded";
    case Form::tiled: return "tiled";
    case Form::strided: return "strided view";
    case Form::mapped: return "mapped view";
    }
    return "";
}

const char* name_of(Taken taken) {
    switch (taken) {
    case Taken::whole: return "whole";
    case Taken::part: return "a part";
    case Taken::counted: return "a part whose length is on the device";
    }
    return "";
}

}  // namespace

std::uint64_t rounds() {
    static const std::uint64_t value = number("GLIFT_PROPERTY_ROUNDS", 15);
    return value;
}

std::uint32_t limit() {
    static const auto value = static_cast<std::uint32_t>(number("GLIFT_PROPERTY_LIMIT", 20000));
    return value;
}

std::uint64_t first_seed() {
    static const std::uint64_t value = number("GLIFT_PROPERTY_SEED", 1);
    return value;
}

std::optional<glift::Device> device_of(const std::string& which) {
    std::map<std::string, glift::Device>& devices = OpenDevices::all();
    std::string name = which;
    if (which != "host") {
        const char* given = std::getenv("GLIFT_DEVICE");
        name = given && *given ? given : "lavapipe";
        if (name == "host") return std::nullopt;
    }
    auto at = devices.find(name);
    if (at == devices.end()) at = devices.emplace(name, glift::Device::open(name)).first;
    return at->second;
}

Round::Round(std::string algorithm, std::uint64_t seed)
    : algorithm_(std::move(algorithm)), seed_(seed), engine_(seed * 0x9e3779b97f4a7c15u + 1),
      // Fifteen consecutive rounds cover every form with every kind of part.
      form_(static_cast<Form>(seed % 5)), taken_(static_cast<Taken>(seed / 5 % 3)) {}

std::uint32_t Round::below(std::uint64_t bound) {
    return bound == 0 ? 0 : static_cast<std::uint32_t>((engine_() >> 32) * bound >> 32);
}

std::uint32_t Round::size(std::uint32_t most) {
    // How many elements a workgroup of an algorithm takes on some device, and lengths at which algorithms choose other
    // kernels.
    static constexpr std::uint32_t tiles[] = {768, 1024, 2048, 3840, 4096, 8192, 16384, 20000, 65536};
    std::uint64_t size = most;
    switch (below(4)) {
    case 0: size = below(3); break;
    case 1: size = (std::uint64_t{1} << below(std::bit_width(most) + 1)) + below(3) - 1; break;
    case 2: size = std::uint64_t{tiles[below(std::size(tiles))]} * (1 + below(3)) + below(3) - 1; break;
    default: size = static_cast<std::uint64_t>(std::exp(std::log(most + 1.0) * (real() + 1) / 2)) - 1;
    }
    if (size <= most) return static_cast<std::uint32_t>(size);
    return chance(2) ? most - std::min(below(3), most) : below(std::uint64_t{most} + 1);
}

double Round::real() { return static_cast<double>(engine_() >> 11) * 0x1p-52 - 1; }

testing::AssertionResult Round::wrong(const std::string& what) const {
    return testing::AssertionFailure() << algorithm_ << ", form " << name_of(form_) << ", " << name_of(taken_) << about_
                                       << ", seed " << seed_ << ": " << what
                                       << "\nAgain: GLIFT_PROPERTY_ROUNDS=1 GLIFT_PROPERTY_SEED=" << seed_
                                       << " GLIFT_PROPERTY_LIMIT=" << limit();
}

void Property::SetUp() {
    device_ = device_of(GetParam());
    if (!device_) GTEST_SKIP() << "GLIFT_DEVICE is the host";
}

void Property::TearDown() {
    if (!device_) return;
    for (const std::string& message : device_->validation_messages()) ADD_FAILURE() << message;
}

void Property::for_all(const char* algorithm, const std::function<void(Round&)>& body) {
    for (std::uint64_t i = 0; i < rounds() && !HasFailure(); ++i) {
        Round round(algorithm, first_seed() + i);
        try {
            body(round);
        } catch (const glift::Error& error) {
            ADD_FAILURE() << round.wrong(error.what()).message();
        }
    }
}

}  // namespace property
