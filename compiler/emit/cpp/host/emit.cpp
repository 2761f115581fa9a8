#include "emit/cpp/host/emit.h"

#include "emit/cpp/host/body.h"

namespace gliftc::host {

std::string kernel_of(cpp::Globals& globals, const ir::Pass& pass, const std::string& name) {
    if (globals.program.kernels[pass.kernel].raster) return draw_kernel(globals, pass, name);
    return globals.program.kernels[pass.kernel].grouped() ? group_kernel(globals, pass, name)
                                                          : row_kernel(globals, pass, name);
}

}  // namespace gliftc::host
