// A golden case: a .glift file and, next to it, the expected outputs of the compiler for its own declarations: C++, GLSL
// and lowered passes. A line `// golden: json` in the file adds the reflection, `// golden: host` the code for the host
// device.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace glift::test {

/// All cases: tests/golden/**/<name>.glift, except files in folders named "support", which cases import.
std::vector<std::filesystem::path> golden_cases();

/// The outputs of gliftc for a case.
struct GoldenOutputs {
    /// {name of the golden file (fold.expected.hpp, fold.expected.ir …): contents}
    std::map<std::string, std::string> files;
    std::string error;  ///< empty: gliftc succeeded
};

/// Runs gliftc, writing into `folder`.
GoldenOutputs compile_golden(const std::filesystem::path& source, const std::filesystem::path& folder);

/// The golden files that are stored next to a case.
std::map<std::string, std::string> stored_goldens(const std::filesystem::path& source);

}  // namespace glift::test
