// Depth of field by heat diffusion: compares dof.glift with direct solutions (direct.h). Also tests that what is in
// focus stays sharp, that the sum of the light is kept, how wide a blur is, and that the time does not depend on its
// width.
#include "direct.h"
#include "tests/device/guards/on_every_device.h"

#include "dof.glift.hpp"
#include "photograph.glift.hpp"

#include "examples/common/camera.h"
#include "examples/common/scenes/scenes.h"

#include <glift/host/math.h>

#include <chrono>
#include <cmath>
#include <random>

namespace {

using direct::Plane;
using glift::float4;
using glift::uint2;

/// A lens that is focused at distance 1; the circle of confusion of infinitely distant points is `largest` pixels.
dof::Lens lens_with(float largest) { return {0.5f, 1.0f, 1.0f, largest}; }

/// The distance, beyond the focus of that lens, at which the circle of confusion is `circle` pixels.
float distance_of(float circle, float largest) { return 1 / (1 - circle / largest); }

struct Input {
    uint2 size;
    std::vector<float4> colours;
    std::vector<float> distances;
    dof::Lens lens;

    Input(uint2 size, float largest) : size(size), lens(lens_with(largest)) {
        colours.assign(std::size_t{size.x} * size.y, float4(0, 0, 0, 1));
        distances.assign(colours.size(), 1.0f);
    }
    std::size_t place(std::uint32_t x, std::uint32_t y) const { return std::size_t{y} * size.x + x; }

    /// The circles of confusion by the formula of dof.glift, in double precision. The focus is at distance 1.
    Plane circles() const {
        Plane made{size.x, size.y, {}};
        const double largest = static_cast<double>(lens.pixels) * lens.aperture * lens.focal /
                               (static_cast<double>(lens.focus) - static_cast<double>(lens.focal));
        for (float z : distances) made.values.push_back(largest * std::abs(1 / static_cast<double>(z) - 1));
        return made;
    }
    Plane channel(unsigned k) const {
        Plane made{size.x, size.y, {}};
        for (const float4& c : colours) made.values.push_back(c[k]);
        return made;
    }
};

/// A picture of random colours; circles of confusion from 0 to `circle`, some pixels in focus.
Input random_input(uint2 size, float circle, unsigned seed) {
    Input made(size, 2 * circle);
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    for (std::size_t i = 0; i < made.colours.size(); ++i) {
        made.colours[i] = float4(number(), number(), number(), 1);
        // Runs of equal circles, as in pictures: colour diffuses far only where neighbours are alike.
        if (i % 97 == 0 || number() < 0.02f) made.distances[i] = distance_of(circle * number(), 2 * circle);
        else made.distances[i] = made.distances[i - 1];
        if (number() < 0.005f) made.distances[i] = 1;
    }
    return made;
}

/// The scene "fence", drawn on the device.
Input drawn_input(const glift::Device& device, uint2 size, float circle) {
    const scenes::Scene scene = scenes::fence(0);
    photograph::Corners corners(device, static_cast<std::uint32_t>(scene.mesh.corners.size()));
    const auto points = static_cast<std::uint32_t>(scene.mesh.points.size());
    photograph::Points places(device, points), own(device, points);
    corners.write(scene.mesh.corners);
    places.write(scene.mesh.points);
    own.write(scene.mesh.colours);
    const dof::Picture colour(device, size);
    const dof::Distances z(device, size);
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    photograph::pinhole(device, corners, places, own,
                        {camera::projection_of(scene.view, aspect), scene.view.eye,
                         glift::normalize(scene.light.eye - scene.light.target), scene.sky, scene.view.far},
                        colour, z);
    Input made(size, circle);
    made.colours = colour.read();
    made.distances = z.read();
    for (float& distance : made.distances) distance /= 5;  // five metres are in focus
    return made;
}

class Diffusion : public OnEveryDevice {
protected:
    enum class Layers { one, two };

    struct Images {
        dof::Picture colour, result;
        dof::Distances z;
        dof::Lens lens;

        Images(const glift::Device& device, const Input& input)
            : colour(device, input.size), result(device, input.size), z(device, input.size), lens(input.lens) {
            colour.write(input.colours);
            z.write(input.distances);
        }
    };
    void blur(const Images& images, Layers layers) const {
        if (layers == Layers::one) dof::one_layer(device, images.colour, images.z, images.lens, images.result);
        else dof::two_layers(device, images.colour, images.z, images.lens, 0.5f, dof::Holes::raised, images.result);
    }
    std::vector<float4> blurred(const Input& input, Layers layers = Layers::one) const {
        const Images images(device, input);
        blur(images, layers);
        return images.result.read();
    }
    /// The largest difference between one layer on the device and the direct solution.
    double error_of(const Input& input) const {
        const std::vector<float4> result = blurred(input);
        const Plane circles = input.circles(),
                    ones{input.size.x, input.size.y, std::vector<double>(result.size(), 1.0)};
        double worst = 0;
        for (unsigned k = 0; k < 3; ++k) {
            const Plane exact = direct::spread(input.channel(k), ones, circles, 0.001);
            for (std::size_t i = 0; i < result.size(); ++i)
                worst = std::max(worst, std::abs(exact.values[i] - static_cast<double>(result[i][k])));
        }
        return worst;
    }
    /// The same for two layers. Circles of the background are raised to at least half of that of infinitely distant
    /// points, and at least one pixel, as two_layers does with what blur() passes: `cut` 0.5, Holes::raised.
    double error_of_two(const Input& input) const {
        const std::vector<float4> result = blurred(input, Layers::two);
        const Plane circles = input.circles();
        const double full = std::max(1.0, 0.5 * static_cast<double>(input.lens.pixels));
        Plane raised = circles, weights = circles, ones = circles, part = circles;
        for (std::size_t i = 0; i < circles.values.size(); ++i) {
            const double t = std::clamp((circles.values[i] - 0.5 * full) / (0.5 * full), 0.0, 1.0);
            part.values[i] = t * t * (3 - 2 * t);
            raised.values[i] = std::max(circles.values[i], full);
            weights.values[i] = std::max(0.001, part.values[i]);
            ones.values[i] = 1;
        }
        double worst = 0;
        for (unsigned k = 0; k < 3; ++k) {
            const Plane middle = direct::spread(input.channel(k), ones, circles, 0.001),
                        back = direct::spread(input.channel(k), weights, raised, 0.001);
            for (std::size_t i = 0; i < result.size(); ++i) {
                const double exact = middle.values[i] + part.values[i] * (back.values[i] - middle.values[i]);
                worst = std::max(worst, std::abs(exact - static_cast<double>(result[i][k])));
            }
        }
        return worst;
    }
};
GLIFT_ON_EVERY_DEVICE(Diffusion);

const uint2 sizes[] = {{1, 1}, {1, 77}, {77, 1}, {2, 3}, {33, 17}, {129, 65}, {251, 130}, {8192, 3}, {2, 8192}};

TEST_P(Diffusion, IsTheDirectSolution) {
    double worst_50 = 0, worst_200 = 0;
    for (const uint2 size : sizes) {
        for (const float circle : {2.0f, 10.0f, 50.0f}) {
            const double error = error_of(random_input(size, circle, size.x + size.y));
            EXPECT_LT(error, 1e-4) << size.x << " x " << size.y << ", circles up to " << circle;
            worst_50 = std::max(worst_50, error);
        }
        for (const float circle : {120.0f, 200.0f}) {
            const double error = error_of(random_input(size, circle, size.x + size.y));
            EXPECT_LT(error, 1e-3) << size.x << " x " << size.y << ", circles up to " << circle;
            worst_200 = std::max(worst_200, error);
        }
    }
    RecordProperty("worst_50", std::to_string(worst_50));
    RecordProperty("worst_200", std::to_string(worst_200));
    std::printf("largest error %.2g up to 50 pixels, %.2g up to 200\n", worst_50, worst_200);
}

TEST_P(Diffusion, IsTheDirectSolutionForConstantCircles) {
    for (const float circle : {50.0f, 200.0f}) {
        Input input = random_input({1024, 5}, circle, 3);
        std::fill(input.distances.begin(), input.distances.end(), distance_of(circle, 2 * circle));
        EXPECT_LT(error_of(input), circle > 50 ? 1e-3 : 1e-4) << circle;
    }
}

TEST_P(Diffusion, IsTheDirectSolutionForADrawnPicture) {
    for (const float circle : {50.0f, 200.0f}) {
        const Input input = drawn_input(device, {301, 201}, circle);
        const double one = error_of(input), two = error_of_two(input);
        EXPECT_LT(one, circle > 50 ? 1e-3 : 1e-4) << circle;
        EXPECT_LT(two, circle > 50 ? 1e-3 : 1e-4) << circle;
        std::printf("drawn, largest circle %g: %.2g with one layer, %.2g with two\n", static_cast<double>(circle), one,
                    two);
    }
}

TEST_P(Diffusion, LeavesWhatIsInFocus) {
    for (const uint2 size : sizes) {
        const Input input = random_input(size, 60, size.x);
        const std::vector<float4> result = blurred(input);
        const Plane circles = input.circles();
        for (std::size_t i = 0; i < result.size(); ++i)
            if (circles.values[i] == 0) {
                ASSERT_EQ(result[i], input.colours[i]) << size.x << " x " << size.y << ", pixel " << i;
            }
    }
}

TEST_P(Diffusion, DoesNotBleedAcrossAStep) {
    Input input({200, 31}, 200);
    for (std::uint32_t y = 0; y < 31; ++y)
        for (std::uint32_t x = 100; x < 200; ++x) {
            input.colours[input.place(x, y)] = float4(0.75f, 0.5f, 0.25f, 1);
            input.distances[input.place(x, y)] = distance_of(80, 200);
        }
    const std::vector<float4> result = blurred(input);
    for (std::uint32_t y = 0; y < 31; ++y)
        for (std::uint32_t x = 0; x < 200; ++x) {
            const float4 &is = result[input.place(x, y)], &was = input.colours[input.place(x, y)];
            if (x < 100) {
                ASSERT_EQ(is, was) << "the sharp side";
            }
            for (unsigned k = 0; k < 3; ++k) ASSERT_NEAR(is[k], was[k], 1e-6f) << "the blurred side at " << x;
        }
}

/// A single bright pixel in the middle; all circles of confusion have one size.
Input point_of_light(std::uint32_t side, float circle) {
    Input input({side, side}, 2 * circle);
    std::fill(input.distances.begin(), input.distances.end(), distance_of(circle, 2 * circle));
    input.colours[input.place(side / 2, side / 2)] = float4(1, 1, 1, 1);
    return input;
}

TEST_P(Diffusion, KeepsTheEnergyOfAPoint) {
    for (const float circle : {2.0f, 10.0f, 50.0f, 200.0f}) {
        Input input = point_of_light(257, circle);
        double sum = 0;
        for (const float4& c : blurred(input)) sum += static_cast<double>(c.y);
        EXPECT_NEAR(sum, 1, 1e-3) << circle;
        // The sum is kept for circles of different sizes, too: conduction between pixels moves colour and keeps its
        // sum.
        const Input other = random_input(input.size, circle, 5);
        input.distances = other.distances;
        sum = 0;
        for (const float4& c : blurred(input)) sum += static_cast<double>(c.y);
        EXPECT_NEAR(sum, 1, 1e-3) << circle << ", circles of all sizes";
    }
}

/// The blur of a point has the variance of its circle: an evenly lit disc of diameter d has d * d / 16 along each axis.
TEST_P(Diffusion, SpreadsAPointAsWideAsItsCircle) {
    for (const float circle : {8.0f, 20.0f, 40.0f}) {
        const Input input = point_of_light(513, circle);
        const std::vector<float4> result = blurred(input);
        double across = 0, down = 0, inside = 0, sum = 0;
        for (std::uint32_t y = 0; y < 513; ++y)
            for (std::uint32_t x = 0; x < 513; ++x) {
                const double h = static_cast<double>(result[input.place(x, y)].x), u = x - 256.0, v = y - 256.0;
                across += h * u * u;
                down += h * v * v;
                sum += h;
                if (u * u + v * v <= 0.25 * static_cast<double>(circle * circle)) inside += h;
            }
        const double expected = static_cast<double>(circle * circle) / 16;
        EXPECT_NEAR(across / sum / expected, 1, 0.01) << circle;
        EXPECT_NEAR(down / sum / expected, 1, 0.01) << circle;
        std::printf("circle %g: %.3f of the light lies within it\n", static_cast<double>(circle), inside / sum);
        EXPECT_GT(inside / sum, 0.6) << circle;
    }
}

/// Times a narrow and a wide blur alternately, 8 to 60 times, until the shortest times of both agree, since other
/// programs use this machine, too.
TEST_P(Diffusion, TakesAsLongForEveryBlur) {
    const Images narrow(device, random_input({256, 256}, 2, 1)), wide(device, random_input({256, 256}, 200, 1));
    const auto seconds = [&](const Images& images) {
        const auto start = std::chrono::steady_clock::now();
        blur(images, Layers::two);
        device.wait();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    double narrow_best = 1e30, wide_best = 1e30;
    const auto apart = [&] { return std::abs(wide_best / narrow_best - 1); };
    for (int round = 0; round < 60 && (round < 8 || apart() > 0.05); ++round) {
        narrow_best = std::min(narrow_best, seconds(narrow));
        wide_best = std::min(wide_best, seconds(wide));
    }
    std::printf("2 pixels: %.2f ms, 200 pixels: %.2f ms\n", 1e3 * narrow_best, 1e3 * wide_best);
    EXPECT_LT(apart(), 0.05);
}

}  // namespace
