// bench_files: saves and loads a sparse grid all of whose pages are resident, and prints the bytes and seconds of each.
// What the disk gives is measured in turn with it, since disks of virtual machines vary: the same bytes, written and
// read in blocks of 4 MiB without HDF5, through the page cache as dd does it, and past it as `dd oflag=direct`. Files
// are synchronised when they are written, and dropped from the cache before they are read.
//
//     bench_files FOLDER MiB [device] [rounds]
#include "files.glift.hpp"

#include <glift/files.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <random>
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

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

struct Rates {
    std::vector<double> of_write, of_direct_write, of_save, of_read, of_direct_read, of_load;  ///< MiB per second
};

/// Runs and prints: bytes, seconds, bytes per second; then seconds on the CPU, which other programs disturb less.
template <class Run> double measure(const char* what, std::uint64_t mebibytes, Run run) {
    const double cpu = cpu_seconds();
    const auto begin = Clock::now();
    run();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    std::printf("%-20s %8.0f MiB  %7.2f s  %7.0f MiB/s  %6.2f s on the CPU\n", what, static_cast<double>(mebibytes),
                seconds, static_cast<double>(mebibytes) / seconds, cpu_seconds() - cpu);
    std::fflush(stdout);
    return static_cast<double>(mebibytes) / seconds;
}

void drop_from_cache(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY);
    ::fdatasync(file);
    ::posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
    ::close(file);
}

struct Freed {
    void operator()(void* memory) const { std::free(memory); }
};

/// What dd does. `flag`: O_DIRECT, or 0. The file stays, for measure_read.
double measure_write(const char* what, const std::string& path, std::uint64_t mebibytes, int flag) {
    constexpr std::size_t bytes = 4 << 20;
    const std::unique_ptr<char, Freed> block(static_cast<char*>(std::aligned_alloc(4096, bytes)));
    std::mt19937 random(1);
    std::generate_n(block.get(), bytes, [&] { return static_cast<char>(random()); });
    return measure(what, mebibytes, [&] {
        const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | flag, 0666);
        for (std::uint64_t done = 0; done < mebibytes; done += 4)
            if (::write(file, block.get(), bytes) != static_cast<ssize_t>(bytes)) std::abort();
        ::fsync(file);
        ::close(file);
    });
}

double measure_read(const char* what, const std::string& path, std::uint64_t mebibytes, int flag) {
    constexpr std::size_t bytes = 4 << 20;
    const std::unique_ptr<char, Freed> block(static_cast<char*>(std::aligned_alloc(4096, bytes)));
    drop_from_cache(path);
    return measure(what, mebibytes, [&] {
        const int file = ::open(path.c_str(), O_RDONLY | flag);
        while (::read(file, block.get(), bytes) > 0) {}
        ::close(file);
    });
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

double median(std::vector<double> numbers) {
    std::ranges::sort(numbers);
    return numbers[numbers.size() / 2];
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 3) return std::fprintf(stderr, "bench_files FOLDER MiB [device] [rounds]\n"), 2;
    const std::string path = std::string(arguments[1]) + "/bench.h5", plain = path + ".plain";
    const auto mebibytes = static_cast<std::uint64_t>(std::atoll(arguments[2]));
    const glift::Device device = glift::Device::open(count > 3 ? arguments[3] : "host");
    const int rounds = count > 4 ? std::atoi(arguments[4]) : 1;
    files::Grid grid = full_grid(device, mebibytes);
    const long before = peak_mebibytes();
    Rates rates;
    for (int round = 0; round < rounds; ++round) {
        rates.of_write.push_back(measure_write("disk, write", plain, mebibytes, 0));
        ::unlink(plain.c_str());
        rates.of_save.push_back(measure("glift::save", mebibytes, [&] { glift::save(path, "grid", grid); }));
        rates.of_direct_write.push_back(measure_write("disk, direct write", plain, mebibytes, O_DIRECT));
        rates.of_read.push_back(measure_read("disk, read", plain, mebibytes, 0));
        drop_from_cache(path);
        rates.of_load.push_back(measure("glift::load", mebibytes, [&] {
            glift::load(path, "grid", grid);
            device.wait();
        }));
        rates.of_direct_read.push_back(measure_read("disk, direct read", plain, mebibytes, O_DIRECT));
        ::unlink(plain.c_str());
        ::unlink(path.c_str());
    }
    const double save = median(rates.of_save), load = median(rates.of_load);
    std::printf("medians: save %.0f MiB/s, disk %.0f and %.0f (direct): %.2f and %.2f of it\n", save,
                median(rates.of_write), median(rates.of_direct_write), save / median(rates.of_write),
                save / median(rates.of_direct_write));
    std::printf("medians: load %.0f MiB/s, disk %.0f and %.0f (direct): %.2f and %.2f of it\n", load,
                median(rates.of_read), median(rates.of_direct_read), load / median(rates.of_read),
                load / median(rates.of_direct_read));
    std::printf("peak memory: %ld MiB before, %ld MiB after\n", before, peak_mebibytes());
}
