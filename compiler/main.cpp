// gliftc: reads the command line, runs the command.
#include "base/allocation.h"
#include "driver/command_line.h"
#include "driver/commands.h"
#include "driver/environment.h"
#include "lsp/server.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>

namespace {

int run(const gliftc::Options& options) {
    switch (options.command) {
    case gliftc::Command::compile: return gliftc::run_compile(options);
    case gliftc::Command::test: return gliftc::run_tests(options);
    case gliftc::Command::watch: return gliftc::run_watch(options);
    case gliftc::Command::explain: return gliftc::run_explain(options);
    case gliftc::Command::fmt: return gliftc::run_format(options);
    case gliftc::Command::lsp: return gliftc::run_language_server(options);
    case gliftc::Command::make_project: return gliftc::make_project(options);
    }
    return 0;
}

int internal_error(const char* what) {
    std::fprintf(
        stderr,
        "gliftc: internal error: %s\n"
        "This is a bug in gliftc, not in your program. Please report it with the .glift file and this message.\n",
        what);
    return static_cast<int>(gliftc::ExitCode::internal_error);
}

/// Flushes standard output. Returns `code`, or ExitCode::environment if any of the output was not written.
int finish_output(int code) {
    const bool lost = std::ferror(stdout) != 0;
    errno = 0;
    if (std::fflush(stdout) == 0 && !lost) return code;
    std::fprintf(stderr, "gliftc: cannot write standard output: %s\n",
                 errno != 0 ? std::strerror(errno) : "some of it was not written");
    return static_cast<int>(gliftc::ExitCode::environment);
}

}  // namespace

int main(int argc, char** argv) {
    gliftc::grow_heap_in_large_steps();
    int code = 0;
    try {
        auto read = gliftc::read_command_line(argc, argv);
        const auto* options = std::get_if<gliftc::Options>(&read);
        code = options ? run(*options) : static_cast<int>(std::get<gliftc::ExitCode>(read));
    } catch (const gliftc::EnvironmentError& error) {
        std::fprintf(stderr, "gliftc: %s\n", error.what());
        code = static_cast<int>(gliftc::ExitCode::environment);
    } catch (const std::filesystem::filesystem_error& error) {
        std::fprintf(stderr, "gliftc: %s\n", error.what());
        code = static_cast<int>(gliftc::ExitCode::environment);
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "gliftc: out of memory\n");
        code = static_cast<int>(gliftc::ExitCode::environment);
    } catch (const std::exception& error) {
        code = internal_error(error.what());
    } catch (...) {
        code = internal_error("an exception of unknown type");
    }
    // Exit without destroying static objects, which takes time.
    code = finish_output(code);
    std::fflush(nullptr);
    std::_Exit(code);
}
