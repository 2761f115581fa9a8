#include "emit/cpp/unit.h"
namespace gliftc::cpp {
std::string pipeline_signature(Unit&, std::uint32_t, bool, bool) { return ""; }
void print_pipeline(Unit&, Writer&, std::uint32_t) {}
}
