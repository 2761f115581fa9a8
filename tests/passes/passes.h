// A test case of a compiler pass, in tests/passes/<pass>. Either <case>.ir has the text of one lowered kernel before
// the pass and, below a line "---", after it. Or <case>.glift has the source of kernels, and <case>.after what gliftc
// --dump-after=<pass> prints for it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gliftc::test {

struct PassCase {
    std::string before, after;
};

std::vector<std::filesystem::path> pass_cases();
PassCase read_pass_case(const std::filesystem::path& path);

void write_pass_case(const std::filesystem::path& path, const PassCase& pass_case);

/// Runs the pass with the name of the folder on the case. Throws if there is no such pass, the text
/// or source has errors, or the result is invalid.
std::string run_pass(const std::filesystem::path& path, const std::string& before);

}  // namespace gliftc::test
