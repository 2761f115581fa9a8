// What docs/language.md ("Accuracy") promises of each function, and over which arguments.
#pragma once

#include "accuracy.glift.hpp"

#include <cmath>
#include <span>

namespace accuracy {

using Kernel = void (*)(const glift::Commands&, const glift::Range<Numbers>& x, const glift::Range<Numbers>& y,
                        const glift::Range<Numbers>& r);

enum class Zero { signed_, either };  ///< either: which zero it is, is up to the device

/// A function whose bits are the same on every device.
struct Exact {
    const char* name;
    Kernel kernel;
    Zero zero = Zero::signed_;
};

/// A function that is near the true value: no further than `bound` units in the last place of what is larger, the value
/// or `least`.
struct Near {
    const char* name;
    Kernel kernel;
    double (*exact)(double x, double y);
    double from, to;  ///< arguments
    double least;
    double bound;
};

std::span<const Exact> exact_functions();
std::span<const Near> near_functions();

}  // namespace accuracy
