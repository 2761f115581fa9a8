#include <glift/ranks/processes.h>

#include "../profile/process_profile.h"

#include <glift/error.h>
#include <glift/ranks/lost_ranks.h>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace glift::ranks {

namespace {

/// A ring of bytes from one rank to another one.
struct Channel {
    static constexpr std::uint64_t capacity = std::uint64_t{4} << 20;
    static constexpr std::uint64_t most_at_once = std::uint64_t{1} << 17;  // so that both sides copy at the same time

    alignas(64) std::atomic<std::uint64_t> written{0};
    alignas(64) std::atomic<std::uint64_t> read{0};
    alignas(64) std::byte bytes[capacity];

    /// Copies as many bytes as fit; returns their number.
    std::size_t put(std::span<const std::byte> from) {
        const std::uint64_t at = written.load(std::memory_order_relaxed);
        const std::uint64_t room = capacity - (at - read.load(std::memory_order_acquire));
        const std::size_t count = std::min({room, std::uint64_t{from.size()}, most_at_once});
        const std::size_t first = std::min<std::uint64_t>(count, capacity - at % capacity);
        std::memcpy(bytes + at % capacity, from.data(), first);
        std::memcpy(bytes, from.data() + first, count - first);
        written.store(at + count, std::memory_order_release);
        return count;
    }
    /// Copies as many bytes as there are; returns their number.
    std::size_t take(std::span<std::byte> to) {
        const std::uint64_t at = read.load(std::memory_order_relaxed);
        const std::uint64_t available = written.load(std::memory_order_acquire) - at;
        const std::size_t count = std::min<std::uint64_t>(available, to.size());
        const std::size_t first = std::min<std::uint64_t>(count, capacity - at % capacity);
        std::memcpy(to.data(), bytes + at % capacity, first);
        std::memcpy(to.data() + first, bytes, count - first);
        read.store(at + count, std::memory_order_release);
        return count;
    }
};

/// What the others know of a process.
struct Process {
    std::atomic<int> id{0};
    std::atomic<int> waits_for{-1};  ///< the rank of which it has waited for a while; -1: none
};

/// Of a rank, whose elements the others read there. Pages that nobody touches take no memory.
constexpr std::size_t area_bytes = std::size_t{1} << 30;

void* map_shared(std::size_t bytes) {
    return mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
}

/// Memory that the processes share: a channel for each ordered pair of ranks, an area for each rank, and their process
/// ids.
class SharedChannels {
public:
    explicit SharedChannels(unsigned ranks) : ranks_(ranks), bytes_(sizeof(Channel) * ranks * ranks + 4096) {
        if (sizeof(Process) * ranks > 4096) throw std::runtime_error("run_processes: too many processes");
        void* memory = map_shared(bytes_);
        if (memory == MAP_FAILED) throw std::bad_alloc();
        void* areas = map_shared(area_bytes * ranks);
        if (areas != MAP_FAILED) areas_ = static_cast<std::byte*>(areas);
        processes_ = static_cast<Process*>(memory);
        channels_ = reinterpret_cast<Channel*>(static_cast<std::byte*>(memory) + 4096);
        for (unsigned i = 0; i < ranks; ++i) new (processes_ + i) Process();
        for (unsigned i = 0; i < ranks * ranks; ++i) {
            new (&channels_[i].written) std::atomic<std::uint64_t>(0);
            new (&channels_[i].read) std::atomic<std::uint64_t>(0);
        }
    }
    SharedChannels(const SharedChannels&) = delete;
    ~SharedChannels() {
        munmap(processes_, bytes_);
        if (areas_) munmap(areas_, area_bytes * ranks_);
    }

    unsigned ranks() const { return ranks_; }
    Channel& between(unsigned from, unsigned to) { return channels_[from * ranks_ + to]; }
    Process& process(unsigned rank) { return processes_[rank]; }
    std::span<std::byte> area(unsigned rank) const {
        if (!areas_) return {};
        return {areas_ + area_bytes * rank, area_bytes};
    }

private:
    unsigned ranks_;
    std::size_t bytes_;
    Process* processes_;
    Channel* channels_;
    std::byte* areas_ = nullptr;  ///< null where there is no room for them
};

/// A message of which `done` bytes have gone, after its length, of which `length_done` bytes have.
template <class Message> struct Started {
    Message message;
    std::uint64_t length;
    std::size_t done = 0, length_done = 0;

    bool is_over() const { return length_done == sizeof length && done == message.bytes.size(); }
};

class ProcessTransport final : public Transport {
public:
    ProcessTransport(std::shared_ptr<SharedChannels> channels, unsigned rank)
        : channels_(std::move(channels)), rank_(rank) {}

    unsigned rank() const override { return rank_; }
    unsigned size() const override { return channels_->ranks(); }
    bool allows_threads() const override { return true; }
    std::span<std::byte> area(unsigned rank) const override { return channels_->area(rank); }
    std::string name_of(unsigned rank) const override {
        return "process " + std::to_string(channels_->process(rank).id.load());
    }

    void exchange(std::span<const Send> sends, std::span<const Receive> receives, Seconds limit) override {
        std::vector<Started<Send>> out;
        std::vector<Started<Receive>> in;
        for (const Send& send : sends) out.push_back({send, send.bytes.size()});
        for (const Receive& receive : receives) in.push_back({receive, 0});
        auto last = std::chrono::steady_clock::now();
        for (unsigned idle = 0; !out.empty() || !in.empty();) {
            const bool progress = send_some(out) | receive_some(in);
            if (progress) {
                if (idle >= 4096) channels_->process(rank_).waits_for = -1;
                idle = 0;
                last = std::chrono::steady_clock::now();
                continue;
            }
            if (++idle < 64) continue;
            std::this_thread::yield();
            if (idle < 4096) continue;
            if (idle == 4096)
                channels_->process(rank_).waits_for =
                    static_cast<int>(in.empty() ? out.front().message.to : in.front().message.from);
            std::this_thread::sleep_for(std::chrono::microseconds(50));
            if (std::chrono::steady_clock::now() - last > limit) throw_silent(out, in, limit);
        }
    }

private:
    bool send_some(std::vector<Started<Send>>& out) {
        bool progress = false;
        std::vector<bool> is_busy(size());
        for (Started<Send>& one : out) {
            if (is_busy[one.message.to]) continue;
            Channel& channel = channels_->between(rank_, one.message.to);
            const std::size_t before = one.length_done + one.done;
            one.length_done += channel.put(std::as_bytes(std::span(&one.length, 1)).subspan(one.length_done));
            if (one.length_done == sizeof one.length) one.done += channel.put(one.message.bytes.subspan(one.done));
            progress = progress || one.length_done + one.done != before;
            is_busy[one.message.to] = !one.is_over();
        }
        std::erase_if(out, [](const auto& one) { return one.is_over(); });
        return progress;
    }

    bool receive_some(std::vector<Started<Receive>>& in) {
        bool progress = false;
        std::vector<bool> is_busy(size());
        for (Started<Receive>& one : in) {
            if (is_busy[one.message.from]) continue;
            Channel& channel = channels_->between(one.message.from, rank_);
            const std::size_t before = one.length_done + one.done;
            one.length_done += channel.take(std::as_writable_bytes(std::span(&one.length, 1)).subspan(one.length_done));
            if (one.length_done == sizeof one.length) {
                if (one.length != one.message.bytes.size()) throw_other_length(one);
                one.done += channel.take(one.message.bytes.subspan(one.done));
            }
            progress = progress || one.length_done + one.done != before;
            is_busy[one.message.from] = !one.is_over();
        }
        std::erase_if(in, [](const auto& one) { return one.is_over(); });
        return progress;
    }

    [[noreturn]] void throw_other_length(const Started<Receive>& one) {
        throw Error(ErrorCode::lost_rank, "ranks make different calls",
                    "rank " + std::to_string(rank_) + " and rank " + std::to_string(one.message.from),
                    "one sent " + std::to_string(one.length) + " bytes where the other expects " +
                        std::to_string(one.message.bytes.size()),
                    "make the same calls with the same arguments, in the same order, on every rank");
    }

    [[noreturn]] void throw_silent(const std::vector<Started<Send>>& out, const std::vector<Started<Receive>>& in,
                                   Seconds limit) {
        std::vector<unsigned> silent;
        for (const auto& one : in) silent.push_back(one.message.from);
        for (const auto& one : out) silent.push_back(one.message.to);
        detail::throw_lost_ranks(
            *this, std::move(silent), [&](unsigned rank) { return channels_->process(rank).waits_for.load(); }, limit);
    }

    std::shared_ptr<SharedChannels> channels_;
    unsigned rank_;
};

/// Gives each rank a trace of its own: trace.json becomes trace.0.json.
void name_trace(unsigned rank) {
    const char* const target = std::getenv("GLIFT_PROFILE");
    const std::string_view name = target ? target : "", ending = ".json";
    if (!name.ends_with(ending)) return;
    const std::string stem(name.substr(0, name.size() - ending.size()));
    setenv("GLIFT_PROFILE", (stem + "." + std::to_string(rank) + ".json").c_str(), 1);
}

/// Runs the body in this process, which is a rank, and ends the process.
[[noreturn]] void run_rank(const std::shared_ptr<SharedChannels>& channels, unsigned rank,
                           const std::function<int(std::shared_ptr<Transport>)>& body) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    channels->process(rank).id = getpid();
    name_trace(rank);
    int status = 1;
    try {
        status = body(std::make_shared<ProcessTransport>(channels, rank));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rank %u: %s\n", rank, error.what());
    }
    detail::report_profile();
    std::fflush(stdout);
    std::fflush(stderr);
    _exit(status);
}

/// Waits for the processes for two seconds at most, then kills those that are left. 0 stands for none.
void end(std::vector<pid_t> processes) {
    for (int tries = 0; tries < 200; ++tries) {
        std::erase_if(processes, [](pid_t process) { return process == 0 || waitpid(process, nullptr, WNOHANG) != 0; });
        if (processes.empty()) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    for (pid_t process : processes) {
        kill(process, SIGKILL);
        waitpid(process, nullptr, 0);
    }
}

int status_of(int state, unsigned rank) {
    if (WIFSIGNALED(state)) {
        std::fprintf(stderr, "run_processes: rank %u was ended by signal %d (%s)\n", rank, WTERMSIG(state),
                     strsignal(WTERMSIG(state)));
        return 128 + WTERMSIG(state);
    }
    if (WEXITSTATUS(state) != 0)
        std::fprintf(stderr, "run_processes: rank %u ended with status %d\n", rank, WEXITSTATUS(state));
    return WEXITSTATUS(state);
}

}  // namespace

Device device_of(const Transport& transport) {
    const char* wanted = std::getenv("GLIFT_DEVICE");
    const bool has_wish = wanted && *wanted;
    if (has_wish && std::string(wanted) != "gpu") return Device::open();
    try {
        return Device::open("gpu:" + std::to_string(transport.rank()));
    } catch (const Error& error) {
        if (error.code() != ErrorCode::no_device || has_wish) throw;
        return Device::open();
    }
}

int run_processes(unsigned count, const std::function<int(std::shared_ptr<Transport>)>& body) {
    const auto channels = std::make_shared<SharedChannels>(count);
    std::fflush(stdout);
    std::fflush(stderr);
    std::vector<pid_t> running;
    for (unsigned rank = 0; rank < count; ++rank) {
        const pid_t process = fork();
        if (process < 0) throw std::runtime_error("run_processes: fork failed");
        if (process == 0) run_rank(channels, rank, body);
        running.push_back(process);
    }
    int worst = 0;
    for (unsigned left = count; left > 0;) {
        bool has_ended = false;
        for (unsigned rank = 0; rank < count; ++rank) {
            int state = 0;
            if (running[rank] == 0 || waitpid(running[rank], &state, WNOHANG) != running[rank]) continue;
            running[rank] = 0;
            --left;
            has_ended = true;
            worst = std::max(worst, status_of(state, rank));
        }
        if (worst != 0) {
            end(running);
            return worst;
        }
        if (!has_ended) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return worst;
}

}  // namespace glift::ranks
