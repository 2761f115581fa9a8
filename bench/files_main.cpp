// bench_files: saves and loads a sparse grid all of whose pages are resident, and prints the bytes and seconds of each.
// What the disk gives is measured beside it: the same bytes, written and read in blocks of 4 MiB without HDF5, once
// before and once after. The page cache is left out: files are synchronised when they are written, and dropped from the
// cache before they are read.
//
//     bench_files FOLDER MiB [device]
#include "files.glift.hpp"

#include <glift/files.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <random>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

void print(const char* what, double mebibytes, double seconds) {
    std::printf("%-20s %8.0f MiB  %7.2f s  %7.0f MiB/s\n", what, mebibytes, seconds, mebibytes / seconds);
}

void drop_from_cache(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY);
    ::fdatasync(file);
    ::posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
    ::close(file);
}

/// What dd does.
void measure_disk(const std::string& path, std::uint64_t mebibytes) {
    std::vector<char> block(4 << 20);
    std::mt19937 random(1);
    for (char& byte : block) byte = static_cast<char>(random());
    auto begin = Clock::now();
    int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    for (std::uint64_t done = 0; done < mebibytes; done += 4)
        if (::write(file, block.data(), block.size()) != static_cast<ssize_t>(block.size())) std::abort();
    ::fsync(file);
    ::close(file);
    print("disk, write", static_cast<double>(mebibytes), seconds_since(begin));
    drop_from_cache(path);
    begin = Clock::now();
    file = ::open(path.c_str(), O_RDONLY);
    while (::read(file, block.data(), block.size()) > 0) {}
    ::close(file);
    print("disk, read", static_cast<double>(mebibytes), seconds_since(begin));
    ::unlink(path.c_str());
}

/// A cube of pages of 2 KiB, with random numbers in all frames.
files::Grid full_grid(const glift::Device& device, std::uint64_t mebibytes) {
    const auto layers = static_cast<glift::uint>(mebibytes / 2);  // of 32 x 32 pages: 2 MiB
    files::Grid grid(device, glift::uint3(256, 256, 8 * layers), 1024 * layers);
    grid.request_box(device, glift::uint3(0, 0, 0), glift::uint3(256, 256, 8 * layers));
    grid.allocate(device);
    std::vector<float> numbers(std::size_t{1} << 20);
    std::mt19937 random(2);
    for (glift::uint layer = 0; layer < layers; layer += 2) {
        for (float& number : numbers) number = static_cast<float>(random());
        const glift::uint2 frames(512, std::min(2048u, 1024 * (layers - layer)));
        grid.field().frames().write(glift::uint2(0, 1024 * layer), frames,
                                    std::span(numbers).first(std::size_t{512} * frames.y));
    }
    device.wait();
    return grid;
}

long peak_mebibytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 3) return std::fprintf(stderr, "bench_files FOLDER MiB [device]\n"), 2;
    const std::string path = std::string(arguments[1]) + "/bench.h5";
    const auto mebibytes = static_cast<std::uint64_t>(std::atoll(arguments[2]));
    const glift::Device device = glift::Device::open(count > 3 ? arguments[3] : "host");
    measure_disk(path, mebibytes);
    {
        const files::Grid grid = full_grid(device, mebibytes);
        const long before = peak_mebibytes();
        const auto begin = Clock::now();
        glift::save(path, "grid", grid);
        print("glift::save", static_cast<double>(mebibytes), seconds_since(begin));
        std::printf("peak memory: %ld MiB before, %ld MiB after\n", before, peak_mebibytes());
    }
    drop_from_cache(path);
    const auto begin = Clock::now();
    const files::Grid grid = glift::load<files::Grid>(path, "grid", device);
    device.wait();
    print("glift::load", static_cast<double>(mebibytes), seconds_since(begin));
    measure_disk(path, mebibytes);
}
