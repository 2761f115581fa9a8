// gliftinfo: shows, checks, compares and converts files of glift::save.
#include "commands.h"

#include <glift/version.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

int main(int count, char** arguments) {
    CLI::App app("Shows, checks, compares and converts files that glift::save wrote.");
    app.require_subcommand(0, 1);
    std::string file, second, path, to;
    std::vector<std::string> files;
    unsigned element_axes = 0;
    app.add_option("file", file, "A file to print");
    CLI::App* const print = app.add_subcommand("print", "Print the structures of a file: types, arguments, memories");
    print->add_option("file", file)->required();
    CLI::App* const check = app.add_subcommand("check", "Verify every byte of files; exit status 1: one is damaged");
    check->add_option("files", files)->required();
    CLI::App* const diff = app.add_subcommand("diff", "Compare two files; exit status 1: they differ");
    diff->add_option("first", file)->required();
    diff->add_option("second", second)->required();
    CLI::App* const convert = app.add_subcommand(
        "convert", "Write the numbers at a path, which print shows, to a .npy, .vti or .nvdb file; or save a .npy "
                   "file as a structure");
    convert->add_option("file", file, "The file, or a NumPy array: .npy")->required();
    convert->add_option("path", path, "The path of the numbers; for an array the structure's name")->required();
    convert->add_option("to", to, "The file to be written; for an array .h5")->required();
    convert->add_option("--element-axes", element_axes,
                        "For an array: how many of its last axes are those of an element; 1 for vectors");
    CLI11_PARSE(app, count, arguments);
    try {
        if (app.get_subcommands().empty() && file.empty()) return std::fputs(app.help().c_str(), stdout), 2;
        if (*print || app.get_subcommands().empty()) return gliftinfo::print(file);
        if (*check) return gliftinfo::check(files);
        if (*diff) return gliftinfo::diff(file, second);
        if (file.ends_with(".npy")) return gliftinfo::convert_npy(file, path, to, element_axes);
        return gliftinfo::convert(file, path, to);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "gliftinfo: %s\n", error.what());
        return 2;
    }
}
