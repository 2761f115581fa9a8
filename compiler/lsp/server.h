// `gliftc lsp`: a language server over standard input and output.
#pragma once

#include "driver/options.h"

namespace gliftc {

/// Serves one session. Returns the exit code: 0 after `shutdown` and `exit`; else 1, as the protocol demands, also if
/// the input ends without `exit` or has a header that is not one of the protocol, which is reported on standard error.
int run_language_server(const Options& options);

}  // namespace gliftc
