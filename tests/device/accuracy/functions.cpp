#include "functions.h"

namespace accuracy {

namespace {

const Exact exact[] = {
    {"x + y", sums},
    {"x - y", differences},
    {"x * y", products},
    {"x / y", quotients},
    {"x / 3", thirds},
    {"x / -17", seventeenths},
    {"x / 0.1", by_a_tenth},
    {"x / 4.6e18", by_large},
    {"x / 2.2e-19", by_small},
    {"x / 1e37", by_larger},
    {"x / (2 - 2^-23)", by_all_ones},
    {"vector / 7", vectors_by_seven},
    {"sqrt(x)", roots},
    {"x * y + x", products_and_sums},
    {"min(x, y)", smaller, Zero::either},
    {"max(x, y)", larger, Zero::either},
    {"floor(x)", floors},
    {"fract(x)", fractions},
    {"round(x)", rounded},
    {"mix(x, y, 0.25)", mixed},
    {"dot", of_dot},
    {"length", of_length},
    {"distance", of_distance},
    {"normalize", of_normalize},
    {"float(int(x))", through_int},
    {"float(uint(x))", through_uint},
};

const Near near[] = {
    {"exp", of_exp, [](double x, double) { return std::exp(x); }, -80, 80, 0, 64},
    {"exp2", of_exp2, [](double x, double) { return std::exp2(x); }, -120, 120, 0, 4},
    {"log", of_log, [](double x, double) { return std::log(x); }, 1e-30, 1e30, 1, 4},
    {"log2", of_log2, [](double x, double) { return std::log2(x); }, 1e-30, 1e30, 1, 4},
    {"pow", of_pow, [](double x, double y) { return std::pow(x, y); }, 0.01, 10, 0, 128},
    {"sin", of_sin, [](double x, double) { return std::sin(x); }, -100, 100, 1, 96},
    {"cos", of_cos, [](double x, double) { return std::cos(x); }, -100, 100, 1, 96},
    {"tan", of_tan, [](double x, double) { return std::tan(x); }, -1.5, 1.5, 1, 64},
    {"asin", of_asin, [](double x, double) { return std::asin(x); }, -1, 1, 1, 4096},
    {"acos", of_acos, [](double x, double) { return std::acos(x); }, -1, 1, 1, 2048},
    {"atan", of_atan, [](double x, double) { return std::atan(x); }, -1e6, 1e6, 1, 16},
    {"atan2", of_atan2, [](double x, double y) { return std::atan2(y, x); }, -100, 100, 1, 32},
    {"sinh", of_sinh, [](double x, double) { return std::sinh(x); }, -80, 80, 1, 64},
    {"cosh", of_cosh, [](double x, double) { return std::cosh(x); }, -80, 80, 1, 64},
    {"tanh", of_tanh, [](double x, double) { return std::tanh(x); }, -80, 80, 1, 2},
    {"inversesqrt", of_inversesqrt, [](double x, double) { return 1 / std::sqrt(x); }, 1e-30, 1e30, 0, 2},
    {"fma", of_fma, [](double x, double y) { return x * y + 1; }, -100, 100, 1e4, 1},
    {"determinant", of_determinant, [](double x, double y) { return x * y - 6; }, -100, 100, 1e4, 1},
    {"inverse", of_inverse, [](double x, double y) { return y / (x * y + 1); }, 1, 100, 0, 4},
};

}  // namespace

std::span<const Exact> exact_functions() { return exact; }
std::span<const Near> near_functions() { return near; }

}  // namespace accuracy
