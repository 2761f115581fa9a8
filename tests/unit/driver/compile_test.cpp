// The compiler as a function: which modules it loads, with files in memory; dependency files, outputs, command lines.
#include "driver/command_line.h"
#include "driver/compile.h"

#include "diag/render.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>

namespace gliftc {
namespace {

FileSystem in_memory(std::map<std::string, std::string> texts) {
    FileSystem files;
    files.read = [texts](const std::string& path) {
        auto found = texts.find(path);
        return found == texts.end() ? ReadResult{{}, "no such file"} : ReadResult{found->second, {}};
    };
    files.exists = [texts](const std::string& path) { return texts.contains(path); };
    files.identity = [](const std::string& path) { return path; };
    files.list = [texts](const std::string& folder) {
        std::vector<std::string> names;
        std::string prefix = folder == "." ? "" : folder + "/";
        for (const auto& [path, text] : texts) {
            bool inside = path.starts_with(prefix) && path.find('/', prefix.size()) == std::string::npos;
            if (inside) names.push_back(path.substr(prefix.size()));
        }
        return names;
    };
    return files;
}

struct Loaded {
    Compilation compilation;
    Loaded(std::map<std::string, std::string> texts, std::vector<std::string> roots,
           std::vector<std::string> folders = {}) {
        Options options;
        options.files = std::move(roots);
        options.import_folders = std::move(folders);
        options.library_folder = "lib";
        options.stop_after = Stage::syntax;
        compile(options, in_memory(std::move(texts)), compilation);
    }
    std::string errors() const { return render_text(compilation.diagnostics, compilation.sources, Colour::plain); }
    std::string order() const {
        std::string names;
        for (const auto& module : compilation.loaded.modules) names += compilation.names[module.tree->name.name] + " ";
        return names;
    }
};

TEST(Load, puts_imports_before_importers_and_each_once) {
    Loaded loaded({{"a.glift", "module a; use ./b; use c.d; use std.array;"},
                   {"b.glift", "module b; use std.array;"},
                   {"dir/c/d.glift", "module c.d; use ./e;"},
                   {"dir/c/e.glift", "module c.e;"},
                   {"lib/structures/array.glift", "module std.array; use std.fold;"},
                   {"lib/translators/fold.glift", "module std.fold;"}},
                  {"a.glift"}, {"dir"});
    EXPECT_EQ(loaded.errors(), "");
    EXPECT_EQ(loaded.order(), "std.fold std.array b c.e c.d a ");
    EXPECT_TRUE(loaded.compilation.loaded.modules.back().is_root);
    EXPECT_EQ(loaded.compilation.loaded.modules.back().uses, (std::vector<ir::ModuleId>{{2}, {4}, {1}}));
}

TEST(Load, finds_a_module_beside_its_user_first) {
    Loaded loaded({{"x/a.glift", "module a; use b;"}, {"x/b.glift", "module b;"}, {"dir/b.glift", "module b;"}},
                  {"x/a.glift"}, {"dir"});
    EXPECT_EQ(loaded.errors(), "");
    EXPECT_EQ(loaded.compilation.sources[1].path, "x/b.glift");
}

TEST(Load, reports_cycles_with_the_way_round) {
    Loaded loaded({{"a.glift", "module a; use b;"}, {"b.glift", "module b; use a;"}}, {"a.glift"});
    EXPECT_EQ(
        loaded.errors(),
        "b.glift:1:15: error: module 'a' imports itself [import-cycle]\n    module b; use a;\n                  ^\n"
        "a.glift:1:15: note: by way of this\n    module a; use b;\n                  ^\n");
}

TEST(Load, suggests_modules_that_are_there) {
    Loaded loaded({{"a.glift", "module a; use std.aray;"}, {"lib/structures/array.glift", "module std.array;"}},
                  {"a.glift"});
    EXPECT_NE(loaded.errors().find("did you mean 'std.array'?"), std::string::npos) << loaded.errors();
}

TEST(Load, takes_a_file_named_twice_once) {
    Loaded loaded({{"a.glift", "module a;"}}, {"a.glift", "./a.glift"});
    EXPECT_EQ(loaded.errors(), "");
    EXPECT_EQ(loaded.compilation.loaded.modules.size(), 1u);
}

TEST(CheckText, reads_no_file) {
    EXPECT_TRUE(check_text("module m; use std.array;").has_errors());
    EXPECT_TRUE(check_text("\xff\x00 {{{").has_errors());
    EXPECT_FALSE(check_text("module input; pub fn f(a: float) -> float { return a * 2.0; }").has_errors());
}

TEST(Depfile, escapes_what_make_would_read) {
    Options options;
    options.output_folder = "out dir";
    Result result;
    result.outputs.push_back({"a.glift.hpp", ""});
    Compilation compilation;
    compilation.sources.add("a$b.glift", "");
    compilation.read_files = {"x y.hpp"};
    EXPECT_EQ(make_depfile(options, result, compilation), "out\\ dir/a.glift.hpp: \\\n  a$$b.glift \\\n  x\\ y.hpp\n");
}

TEST(WriteIfChanged, leaves_a_file_with_the_same_bytes) {
    std::filesystem::path path = std::filesystem::temp_directory_path() / "glift_write_test" / "deep" / "file";
    std::filesystem::remove_all(path.parent_path());
    ASSERT_EQ(write_if_changed(path.string(), "one"), std::nullopt);
    auto past = std::filesystem::last_write_time(path) - std::chrono::hours(1);
    std::filesystem::last_write_time(path, past);
    ASSERT_EQ(write_if_changed(path.string(), "one"), std::nullopt);
    EXPECT_EQ(std::filesystem::last_write_time(path), past);
    ASSERT_EQ(write_if_changed(path.string(), "two"), std::nullopt);
    EXPECT_NE(std::filesystem::last_write_time(path), past);
    std::filesystem::remove_all(path.parent_path().parent_path());
}

std::variant<Options, ExitCode> read(std::vector<std::string> words) {
    words.insert(words.begin(), "gliftc");
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    return read_command_line(static_cast<int>(words.size()), argv.data());
}

TEST(CommandLine, reads_options_before_and_after_files) {
    auto result = read({"-Idir", "-I", "other", "a.glift", "-D", "n=3", "--target=cpp", "--target=host", "-o", "out",
                        "-Werror", "-Wno-unused-variable", "b.glift", "--error-limit", "5", "--stop-after=lower"});
    const auto* options = std::get_if<Options>(&result);
    ASSERT_TRUE(options);
    EXPECT_EQ(options->files, (std::vector<std::string>{"a.glift", "b.glift"}));
    EXPECT_EQ(options->import_folders, (std::vector<std::string>{"dir", "other"}));
    EXPECT_EQ(options->defines.at(0).second, "3");
    EXPECT_TRUE(options->wants(Target::host) && !options->wants(Target::glsl));
    EXPECT_TRUE(options->warnings_are_errors);
    EXPECT_EQ(options->silenced, std::vector<Diag>{Diag::unused_variable});
    EXPECT_EQ(options->error_limit, 5u);
    EXPECT_TRUE(options->stops_after(Stage::lower) && !options->stops_after(Stage::sema));
}

TEST(CommandLine, has_commands) {
    auto result = read({"fmt", "--check", "a.glift", "-"});
    const auto* options = std::get_if<Options>(&result);
    ASSERT_TRUE(options);
    EXPECT_EQ(options->command, Command::fmt);
    EXPECT_TRUE(options->check_only);
    EXPECT_EQ(options->files.size(), 2u);
}

TEST(CommandLine, refuses_wrong_usage) {
    for (std::vector<std::string> words : {std::vector<std::string>{},
                                           {"--target=cuda", "a.glift"},
                                           {"-Wno-such", "a.glift"},
                                           {"--no-such", "a.glift"},
                                           {"-D", "n", "a.glift"},
                                           {"--stop-after=x", "a.glift"}}) {
        auto result = read(words);
        ASSERT_TRUE(std::holds_alternative<ExitCode>(result));
        EXPECT_EQ(std::get<ExitCode>(result), ExitCode::wrong_usage);
    }
    EXPECT_EQ(std::get<ExitCode>(read({"--version"})), ExitCode::done);
}

TEST(CommandLine, lists_the_passes_that_there_are) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(std::get<ExitCode>(read({"--dump-after=x", "a.glift"})), ExitCode::wrong_usage);
    const std::string said = testing::internal::GetCapturedStderr();
    for (const char* pass : {"expand", "share", "version_loops"}) EXPECT_NE(said.find(pass), std::string::npos) << said;
}

}  // namespace
}  // namespace gliftc
