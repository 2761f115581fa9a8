#include "commands.h"
#include "progress_line.h"
#include "verified_file.h"

#include <glift/error.h>

#include <cstdio>
#include <fcntl.h>

namespace gliftinfo {

using namespace glift::files;

namespace {

bool is_whole(const std::string& name) {
    const Descriptor file(name, O_RDONLY);
    Pieces pieces(source_of(file));
    const std::vector<std::uint64_t> damaged = [&] {
        ProgressLine line("check", pieces.count() * piece_bytes);
        return pieces.damaged([&](std::uint64_t bytes) { line.add(bytes); });
    }();
    for (const std::uint64_t piece : damaged)
        std::printf("%s: bytes %llu to %llu are damaged\n", name.c_str(),
                    static_cast<unsigned long long>(user_block_bytes + piece * piece_bytes),
                    static_cast<unsigned long long>(user_block_bytes + (piece + 1) * piece_bytes - 1));
    if (damaged.empty())
        std::printf("%s: whole, %llu pieces\n", name.c_str(), static_cast<unsigned long long>(pieces.count()));
    return damaged.empty();
}

}  // namespace

int check(const std::vector<std::string>& files) {
    int status = 0;
    for (const std::string& file : files) {
        try {
            if (!is_whole(file)) status = 1;
        } catch (const glift::Error& error) {
            std::printf("%s: %s: %s\n", file.c_str(), error.problem().c_str(), error.why().c_str());
            status = 1;
        }
    }
    return status;
}

}  // namespace gliftinfo
