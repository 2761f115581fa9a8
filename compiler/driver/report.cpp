#include "driver/command_line.h"
#include "driver/commands.h"
#include "driver/compile.h"

#include "diag/render.h"

#include <cstdio>
#include <cstdlib>
#include <unistd.h>

namespace gliftc {

namespace {

Colour chosen_colour(ColourChoice choice) {
    switch (choice) {
    case ColourChoice::always: return Colour::coloured;
    case ColourChoice::never: return Colour::plain;
    case ColourChoice::automatic: break;
    }
    // https://no-color.org
    if (const char* refused = std::getenv("NO_COLOR"); refused && *refused) return Colour::plain;
    return isatty(STDERR_FILENO) ? Colour::coloured : Colour::plain;
}

}  // namespace

void configure(Diagnostics& diagnostics, const Options& options) {
    diagnostics.warnings_are_errors = options.warnings_are_errors;
    diagnostics.silenced = options.silenced;
    diagnostics.promoted = options.promoted;
    diagnostics.error_limit = options.error_limit;
}

int report(const Compilation& compilation, const Options& options) {
    const Diagnostics& diagnostics = compilation.diagnostics;
    bool as_json = options.diagnostics_format == DiagnosticsFormat::json;
    std::string text = as_json ? render_json(diagnostics, compilation.sources)
                               : render_text(diagnostics, compilation.sources, chosen_colour(options.colour));
    std::fwrite(text.data(), 1, text.size(), stderr);
    return static_cast<int>(diagnostics.has_errors() ? ExitCode::source_errors : ExitCode::done);
}

}  // namespace gliftc
