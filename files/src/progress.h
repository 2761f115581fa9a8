// The bytes that a save or a load moves, and how many of them it has moved.
#pragma once

#include <glift/files.h>

#include <set>

namespace glift::files {

class ProgressCount {
public:
    ProgressCount(const Part& part, const FileProgress& progress) : progress_(progress) {
        if (progress_) count(part);
    }
    void add(std::uint64_t bytes) {
        done_ += bytes;
        if (progress_) progress_(done_, total_);
    }

private:
    void count(const Part& part) {
        for (const StoredMemory& memory : part.memories)
            for (const Plane& plane : memory.planes)
                if (seen_.insert(plane.memory->object()).second) total_ += plane.memory->description().bytes;
        for (const Part& inner : part.parts) count(inner);
    }

    const FileProgress& progress_;
    std::set<const void*> seen_;
    std::uint64_t done_ = 0, total_ = 0;
};

}  // namespace glift::files
