// What modules call structures: each its own, whatever is compiled beside it.
#include "driver/compile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace gliftc {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::map<std::string, std::string> texts = {
    {"one.glift", "module one;\nuse std.array;\npub structure Line = Array<1, uint>;\n"
                  "pub pipeline first(x: in range<1, uint>) -> uint { return x[0]; }\n"},
    {"two.glift", "module two;\nuse std.array;\nuse one;\npub structure Counts = Sums;\n"
                  "pub structure Sums = Array<1, uint>;\npub structure Other = Array<1, uint, clamp>;\n"
                  "pub kernel add(x: in each<Counts>, y: inout each<Sums>) { y += x; }\n"},
    {"three.glift", "module three;\nuse one;\npub kernel clear(x: out each<Line>) { x = 0u; }\n"},
};

/// Outputs by their names, without SPIR-V; the library is the one of the sources.
std::map<std::string, std::string> outputs_of(std::vector<std::string> files) {
    Options options;
    options.files = std::move(files);
    options.library_folder = std::string(GLIFT_SOURCE_DIR) + "/stdlib";
    options.targets = {Target::glsl, Target::cpp, Target::host, Target::json};
    options.host_only = true;
    FileSystem both = disk();
    both.read = [](const std::string& path) {
        const auto found = texts.find(path);
        return found == texts.end() ? disk().read(path) : ReadResult{found->second, {}};
    };
    both.exists = [](const std::string& path) { return texts.contains(path) || disk().exists(path); };
    both.identity = [](const std::string& path) { return texts.contains(path) ? path : disk().identity(path); };
    Compilation compilation;
    const Result result = compile(options, both, compilation);
    for (const Diagnostic& diagnostic : compilation.diagnostics.all()) ADD_FAILURE() << diagnostic.text;
    std::map<std::string, std::string> outputs;
    for (const Output& output : result.outputs) outputs[output.name] = output.bytes;
    return outputs;
}

TEST(Aliases, AreAllThere) {
    auto outputs = outputs_of({"two.glift"});
    EXPECT_THAT(outputs["two.glift.hpp"], HasSubstr("\nclass Sums : "));
    EXPECT_THAT(outputs["two.glift.hpp"], HasSubstr("\nusing Counts = Sums;\n"));
    EXPECT_THAT(outputs["two.glift.json"], HasSubstr("\"other_names\": [\n        \"Counts\"\n      ]"));
    EXPECT_THAT(outputs["two.Sums.glsl"], HasSubstr("Sums_translate"));
    EXPECT_THAT(outputs["two.Counts.glsl"], HasSubstr("Counts_translate"));
}

TEST(Aliases, OfWhatIsImportedAreTakenOver) {
    EXPECT_THAT(outputs_of({"three.glift"})["three.glift.hpp"], HasSubstr("\nclass Line : "));
}

/// What programs see of a module: its header and its functions for their shaders.
std::map<std::string, std::string> seen_of(std::vector<std::string> files) {
    auto outputs = outputs_of(std::move(files));
    std::erase_if(outputs, [](const auto& output) {
        return !output.first.ends_with(".hpp") && !output.first.ends_with(".glsl");
    });
    return outputs;
}

TEST(Aliases, DoNotDependOnWhatIsCompiledBeside) {
    std::map<std::string, std::string> alone;
    for (const char* file : {"one.glift", "two.glift", "three.glift"}) alone.merge(seen_of({file}));
    EXPECT_EQ(seen_of({"one.glift", "two.glift", "three.glift"}), alone);
    EXPECT_EQ(seen_of({"three.glift", "two.glift", "one.glift"}), alone);
    EXPECT_THAT(alone["one.glift.hpp"], Not(HasSubstr("Other")));
}

}  // namespace
}  // namespace gliftc
