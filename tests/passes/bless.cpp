// Writes the expected output of the tests of passes; tools/bless runs it.
#include "passes.h"

#include <cstdio>
#include <exception>

int main() {
    using namespace gliftc::test;
    int failed = 0;
    for (const auto& path : pass_cases()) {
        try {
            PassCase pass_case = read_pass_case(path);
            pass_case.after = run_pass(path, pass_case.before);
            write_pass_case(path, pass_case);
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s: %s\n", path.c_str(), error.what());
            failed = 1;
        }
    }
    return failed;
}
