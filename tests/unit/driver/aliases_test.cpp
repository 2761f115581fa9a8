// Names that modules give to structures: neither these names, nor the functions that headers declare, nor those for
// shaders depend on which other modules are compiled in the same run. Also which headers a header includes, and which
// output has what several modules share.
#include "driver/compile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

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

/// The outputs of a compilation by their names, without SPIR-V. Files are those of `texts`, else of the disk; the
/// standard library is that of the source tree.
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
    EXPECT_THAT(outputs["two.glift.hpp"], HasSubstr("\nclass Array_1_uint : "));
    EXPECT_THAT(outputs["two.glift.hpp"], HasSubstr("\nusing Counts = ::std_array::Array_1_uint;\n"));
    EXPECT_THAT(outputs["two.glift.hpp"], HasSubstr("\nusing Sums = ::std_array::Array_1_uint;\n"));
    EXPECT_THAT(outputs["two.glift.json"], HasSubstr("\"other_names\": [\n        \"Counts\"\n      ]"));
    EXPECT_THAT(outputs["two.Sums.glsl"], HasSubstr("Sums_translate"));
    EXPECT_THAT(outputs["two.Counts.glsl"], HasSubstr("Counts_translate"));
}

TEST(Aliases, OfWhatIsImportedAreTakenOver) {
    auto outputs = outputs_of({"three.glift"});
    EXPECT_THAT(outputs["three.glift.hpp"],
                HasSubstr("\nnamespace one {\n\nusing Line = ::std_array::Array_1_uint;\n"));
    EXPECT_THAT(outputs["three.glift.hpp"], HasSubstr("const glift::Range<::one::Line>& x);"));
}

/// The outputs of a compilation that are included elsewhere, headers and functions for shaders, and the GLSL of
/// kernels.
std::map<std::string, std::string> seen_of(std::vector<std::string> files) {
    auto outputs = outputs_of(std::move(files));
    std::erase_if(outputs, [](const auto& output) {
        return !output.first.ends_with(".hpp") && !output.first.ends_with(".glsl");
    });
    return outputs;
}

/// The lines of a header that declare the function `first`, or one that returns void.
std::string functions_of(const std::string& header) {
    std::string functions;
    std::istringstream lines(header);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("void ") || line.find(" first(") != std::string::npos) functions += line + "\n";
    return functions;
}

TEST(Aliases, DoNotDependOnWhatIsCompiledBeside) {
    std::map<std::string, std::string> alone;
    for (const char* file : {"one.glift", "two.glift", "three.glift"}) alone.merge(seen_of({file}));
    auto together = seen_of({"one.glift", "two.glift", "three.glift"});
    EXPECT_EQ(seen_of({"three.glift", "two.glift", "one.glift"}), together);
    EXPECT_EQ(together["one.glift.hpp"], alone["one.glift.hpp"]);
    for (const auto& [name, text] : alone) {
        if (!name.ends_with(".hpp")) {
            EXPECT_EQ(together[name], text);
        }
        EXPECT_EQ(functions_of(together[name]), functions_of(text)) << name;
    }
    EXPECT_THAT(alone["one.glift.hpp"], Not(HasSubstr("Other")));
}

TEST(Modules, IncludeTheHeadersOfThoseTheyUse) {
    auto outputs = outputs_of({"three.glift", "one.glift"});
    EXPECT_THAT(outputs["three.glift.hpp"], HasSubstr("\n#include \"one.glift.hpp\"\n"));
    EXPECT_THAT(outputs["three.glift.hpp"], Not(HasSubstr("class ")));
}

// The code of a structure that two modules use is in the output of the first module alone.
TEST(Modules, CompileWhatTheyShareOnce) {
    auto outputs = outputs_of({"one.glift", "three.glift"});
    EXPECT_THAT(outputs["one.glift.library.cpp"], HasSubstr("Array_1_uint::domain() const"));
    EXPECT_THAT(outputs["three.glift.library.cpp"], Not(HasSubstr("domain() const")));
}

}  // namespace
}  // namespace gliftc
