#include "emit/host/body.h"
namespace gliftc::host {
std::string group_kernel(cpp::Globals&, const ir::Pass&, const std::string&) { return ""; }
}
