// Property tests: compare an algorithm on a device with one of the C++ library or a plain loop, over random sizes,
// values and forms of input. The form is how the input is stored or computed (Form); algorithms take all of it or a
// part (Taken). A round is one such comparison.
//
// Environment: GLIFT_PROPERTY_ROUNDS, rounds for each property (15); GLIFT_PROPERTY_LIMIT, the largest number of
// elements (20000); GLIFT_PROPERTY_SEED, the seed of the first round (1), incremented for each round. Seed and limit
// determine a round: a failure made by Round::wrong() prints both. GLIFT_DEVICE names the device that is not the host
// (lavapipe).
#pragma once

#include <glift/glift.h>
#include <glift/structure.h>

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace property {

std::uint64_t rounds();
std::uint32_t limit();
std::uint64_t first_seed();

/// The device "host", or for another `which` the one that GLIFT_DEVICE names (lavapipe). Opened once for all tests of a
/// process. Empty if `which` is not "host" and GLIFT_DEVICE names the host: there is no other device to test then.
std::optional<glift::Device> device_of(const std::string& which);

/// How the input is stored: dense in a buffer, folded into an image, or in tiles; or by which view of forms.glift it is
/// computed from a dense structure: Strided (every step-th element) or Mapped (a function of every element).
enum class Form : std::uint32_t { dense, folded, tiled, strided, mapped };
/// What an algorithm takes: a whole structure, a part, or a part whose length is a value on the device.
enum class Taken : std::uint32_t { whole, part, counted };

/// The random parameters of one round of a test.
class Round {
public:
    Round(std::string algorithm, std::uint64_t seed);

    std::uint32_t below(std::uint64_t bound);  ///< from 0 to bound - 1; 0 if the bound is 0
    bool chance(std::uint32_t one_in) { return below(one_in) == 0; }
    /// A size up to `most`: logarithmically distributed, or close to 0, to a power of two or to one to three times a
    /// tile size; where such a size exceeds `most`, close to `most` or uniformly distributed.
    std::uint32_t size(std::uint32_t most = limit());
    double real();  ///< from -1 to less than 1
    std::mt19937_64& engine() { return engine_; }

    std::uint64_t seed() const { return seed_; }
    Form form() const { return form_; }
    Taken taken() const { return taken_; }
    void only(Form form) { form_ = form; }
    void only(Taken taken) { taken_ = taken; }
    void about(const std::string& what) { about_ += ", " + what; }  ///< adds to the message of a failure
    void has_size(std::uint64_t size) { about("size " + std::to_string(size)); }

    /// A failure, with everything needed to reproduce the round.
    testing::AssertionResult wrong(const std::string& what) const;

private:
    std::string algorithm_, about_;
    std::uint64_t seed_;
    std::mt19937_64 engine_;
    Form form_;
    Taken taken_;
};

class Property : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override;
    void TearDown() override;

    const glift::Device& device() const { return *device_; }
    /// Runs the body for each round, up to the first that fails.
    void for_all(const char* algorithm, const std::function<void(Round&)>& body);

private:
    std::optional<glift::Device> device_;
};

#define GLIFT_PROPERTY_SUITE(Suite)                                                                                    \
    class Suite : public property::Property {};                                                                        \
    INSTANTIATE_TEST_SUITE_P(, Suite, testing::Values("host", "vulkan"),                                               \
                             [](const testing::TestParamInfo<const char*>& which) { return which.param; })

/// Whether floats have the same bits; values of other types are compared by ==.
template <class T> bool same(const T& a, const T& b) {
    if constexpr (std::is_floating_point_v<T>) return std::memcmp(&a, &b, sizeof(T)) == 0;
    else return a == b;
}

template <class T> std::string text_of(const T& value) {
    std::ostringstream text;
    if constexpr (std::is_floating_point_v<T>) {
        text << value << " (" << std::hexfloat << value << ")";
    } else if constexpr (requires { text << value; }) {
        text << value;
    } else {
        text << std::hex;
        for (std::size_t i = 0; i < sizeof(T); ++i)
            text << int(reinterpret_cast<const unsigned char*>(&value)[i]) << " ";
    }
    return text.str();
}

/// Compares each element by `same`; a failure names the first difference.
template <class T> testing::AssertionResult equal(const Round& round, const std::vector<T>& expected,
                                                  const std::vector<T>& found, const char* which = "") {
    if (expected.size() != found.size())
        return round.wrong(which + (" size expected " + std::to_string(expected.size()) + ", found ") +
                           std::to_string(found.size()));
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (!same(expected[i], found[i]))
            return round.wrong(which + (" first wrong index " + std::to_string(i)) + ": expected " +
                               text_of(expected[i]) + ", found " + text_of(found[i]));
    return testing::AssertionSuccess();
}

/// Compares each value with the exact one; it must be within its bound. Where the exact value is finite, a bound of
/// infinity accepts all values but NaN; a bound that is NaN accepts none.
template <class T> testing::AssertionResult near(const Round& round, const std::vector<double>& exact,
                                                 const std::vector<double>& bounds, const std::vector<T>& found,
                                                 const char* which = "") {
    if (exact.size() != found.size()) return round.wrong("wrong size");
    for (std::size_t i = 0; i < exact.size(); ++i)
        if (!(std::abs(double(found[i]) - exact[i]) <= bounds[i]))
            return round.wrong(which + (" first wrong index " + std::to_string(i)) + ": expected " + text_of(exact[i]) +
                               " +- " + text_of(bounds[i]) + ", found " + text_of(found[i]));
    return testing::AssertionSuccess();
}

/// The result of `run`; runs it twice and expects equal results.
template <class Run> auto twice(const Round& round, Run run) {
    auto first = run();
    const testing::AssertionResult again = equal(round, first, run(), "run to run:");
    EXPECT_TRUE(again);
    return first;
}

}  // namespace property
