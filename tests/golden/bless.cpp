// Writes the golden files of all cases, or of those whose path contains the first argument. tools/bless runs it.

#include "golden.h"

#include "support/process.h"

#include <cstdio>

using namespace glift::test;

int main(int argc, char** argv) {
    const std::string only = argc > 1 ? argv[1] : "";
    int failed = 0;
    for (const std::filesystem::path& source : golden_cases()) {
        if (source.string().find(only) == std::string::npos) continue;
        const TemporaryFolder folder;
        const GoldenOutputs outputs = compile_golden(source, folder.path());
        if (!outputs.error.empty()) {
            std::fprintf(stderr, "bless: %s does not compile; its goldens stay as they are\n%s", source.c_str(),
                         outputs.error.c_str());
            failed = 1;
            continue;
        }
        for (const auto& [name, text] : stored_goldens(source)) {
            if (!outputs.files.contains(name)) std::filesystem::remove(source.parent_path() / name);
        }
        for (const auto& [name, text] : outputs.files) write_file(source.parent_path() / name, text);
    }
    return failed;
}
