// A case of a pass over the IR: tests/passes/<pass>/<case>.ir holds the text before and, below a line "---", after it.
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
std::string text_of(const PassCase& pass_case);

/// What the pass that the folder is named after makes of the text. Throws where the text is not that of a pass, or what
/// is made of it is not valid.
std::string run_pass(const std::filesystem::path& path, const std::string& before);

}  // namespace gliftc::test
