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

/// Seconds that all threads of the process spent on CPUs.
double cpu_seconds() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Runs and prints: bytes, seconds, bytes per second; then seconds on the CPU, which other programs disturb less.
template <class Run> void measure(const char* what, std::uint64_t mebibytes, Run run) {
    const double cpu = cpu_seconds();
    const auto begin = Clock::now();
    run();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    std::printf("%-12s %8.0f MiB  %7.2f s  %7.0f MiB/s  %6.2f s on the CPU\n", what, static_cast<double>(mebibytes),
                seconds, static_cast<double>(mebibytes) / seconds, cpu_seconds() - cpu);
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
    measure("disk, write", mebibytes, [&] {
        const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        for (std::uint64_t done = 0; done < mebibytes; done += 4)
            if (::write(file, block.data(), block.size()) != static_cast<ssize_t>(block.size())) std::abort();
        ::fsync(file);
        ::close(file);
    });
    drop_from_cache(path);
    measure("disk, read", mebibytes, [&] {
        const int file = ::open(path.c_str(), O_RDONLY);
        while (::read(file, block.data(), block.size()) > 0) {}
        ::close(file);
    });
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
    files::Grid grid = full_grid(device, mebibytes);
    const long before = peak_mebibytes();
    measure("glift::save", mebibytes, [&] { glift::save(path, "grid", grid); });
    drop_from_cache(path);
    measure("glift::load", mebibytes, [&] {
        glift::load(path, "grid", grid);
        device.wait();
    });
    std::printf("peak memory: %ld MiB before, %ld MiB after\n", before, peak_mebibytes());
    measure_disk(path, mebibytes);
}
