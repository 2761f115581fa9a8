// The functions to test, with their error bounds as in docs/reference/language.md ("Accuracy") and the ranges of their
// arguments.
#pragma once

#include "accuracy.glift.hpp"

#include <cmath>
#include <span>

namespace accuracy {

using Kernel = void (*)(const glift::Commands&, const glift::Range<Numbers>& x, const glift::Range<Numbers>& y,
                        const glift::Range<Numbers>& r);

enum class Zero { signed_, either };  ///< how zeros are compared; either: the sign of a zero is unspecified

/// A function whose results have the same bits on every device, but for those of NaNs and, with Zero::either, the signs
/// of zeros.
struct Exact {
    const char* name;
    Kernel kernel;
    Zero zero = Zero::signed_;
};

/// An inexact function: its error is at most `bound` units in the last place of the larger of the value and `least`.
struct Near {
    const char* name;
    Kernel kernel;
    double (*exact)(double x, double y);
    double from, to;  ///< range of the arguments that are tested
    double least;
    double bound;
};

std::span<const Exact> exact_functions();
std::span<const Near> near_functions();

}  // namespace accuracy
