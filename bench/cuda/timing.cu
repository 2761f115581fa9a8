#include "rivals.cuh"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace rivals {

namespace {

constexpr int warm_up_runs = 5;
constexpr long long hold_cycles = 200000;  // some 100 microseconds: longer than the host takes to launch any run

__global__ void hold(long long cycles) {
    const long long start = clock64();
    while (clock64() - start < cycles) {}
}

class Event {
public:
    Event() { RIVALS_CUDA(cudaEventCreate(&event_)); }
    ~Event() { cudaEventDestroy(event_); }
    Event(const Event&) = delete;
    Event& operator=(const Event&) = delete;

    void record() const { RIVALS_CUDA(cudaEventRecord(event_)); }
    double seconds_since(const Event& earlier) const {
        RIVALS_CUDA(cudaEventSynchronize(event_));
        float milliseconds = 0;
        RIVALS_CUDA(cudaEventElapsedTime(&milliseconds, earlier.event_, event_));
        return milliseconds * 1e-3;
    }

private:
    cudaEvent_t event_ = nullptr;
};

double seconds_of(const Work& run, const Work& refill) {
    const Event before, after;
    refill();
    hold<<<1, 1>>>(hold_cycles);
    RIVALS_CUDA(cudaGetLastError());
    before.record();
    run();
    after.record();
    return after.seconds_since(before);
}

double median_seconds(const Work& run, const Work& refill, int runs) {
    for (int i = 0; i < warm_up_runs; ++i) seconds_of(run, refill);
    std::vector<double> seconds;
    for (int i = 0; i < runs; ++i) seconds.push_back(seconds_of(run, refill));
    std::sort(seconds.begin(), seconds.end());
    const std::size_t half = seconds.size() / 2;
    return seconds.size() % 2 ? seconds[half] : (seconds[half - 1] + seconds[half]) / 2;
}

}  // namespace

void require(cudaError_t error, const char* call, const char* file, int line) {
    if (error == cudaSuccess) return;
    std::fprintf(stderr, "%s:%d: %s: %s\n", file, line, call, cudaGetErrorString(error));
    std::exit(1);
}

void fail(const std::string& what) {
    std::fprintf(stderr, "%s\n", what.c_str());
    std::exit(1);
}

void Bench::time(const std::string& algorithm, const std::string& variant, std::uint64_t elements,
                 std::uint64_t bytes_moved, const Work& run, const Work& refill) {
    const double seconds = median_seconds(run, refill, runs_);
    rows_.push_back({algorithm, variant, elements, seconds, bytes_moved, runs_});
    std::fprintf(stderr, "%-12s %-18s %10llu  %10.2f us  %8.2f G elements/s  %7.0f GB/s\n", algorithm.c_str(),
                 variant.c_str(), static_cast<unsigned long long>(elements), seconds * 1e6, elements / seconds * 1e-9,
                 bytes_moved / seconds * 1e-9);
}

void Bench::note_error(double error) {
    rows_.back().error = error;
    std::fprintf(stderr, "%-12s %-18s error %.1e\n", rows_.back().algorithm.c_str(), rows_.back().variant.c_str(),
                 error);
}

}  // namespace rivals
