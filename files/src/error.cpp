#include "error.h"

#include <glift/error.h>

#include <cerrno>
#include <cstring>

namespace glift::files {

void throw_bad(const std::string& path, const std::string& why) {
    throw Error(ErrorCode::bad_file, "the file cannot be read", path, why,
                "take another copy of the file; `gliftinfo check` says which of its parts are whole");
}

void throw_system(const std::string& call, const std::string& path) {
    throw Error(ErrorCode::wrong_argument, "a file could not be opened, read or written", path,
                call + ": " + std::strerror(errno), "check the path, the permissions and the room on the disk");
}

}  // namespace glift::files
