// Runs an example as a process: caches in the build tree, one thread of lavapipe (tests run side by side), no leak
// reports (the Vulkan loader and drivers keep memory until exit). `environment`, NAME=VALUE…, overrides the variables
// that are set for this. The device is lavapipe unless that or an option in `arguments` names another.
#pragma once

#include "support/process.h"

#include <string>
#include <utility>
#include <vector>

inline glift::test::ProcessResult run_example(const std::string& program, const std::vector<std::string>& arguments,
                                              const std::vector<std::string>& environment = {}) {
    std::vector<std::string> words = {"env",
                                      "GLIFT_DEVICE=lavapipe",
                                      "LP_NUM_THREADS=1",
                                      "MESA_SHADER_CACHE_DIR=" GLIFT_CACHES "/mesa",
                                      "GLIFT_CACHE_DIR=" GLIFT_CACHES "/pipelines",
                                      "ASAN_OPTIONS=detect_leaks=0"};
    words.insert(words.end(), environment.begin(), environment.end());
    words.push_back(program);
    words.insert(words.end(), arguments.begin(), arguments.end());
    return glift::test::run_process(words);
}
