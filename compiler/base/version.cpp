#include "base/version.h"

namespace gliftc {

std::string_view version() { return GLIFT_VERSION; }

std::string_view major_version() { return version().substr(0, version().find('.')); }

std::string_view minor_version() {
    const std::string_view rest = version().substr(version().find('.') + 1);
    return rest.substr(0, rest.find('.'));
}

}  // namespace gliftc
