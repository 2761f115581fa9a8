#include <glift/mpi/world.h>

#include <glift/error.h>
#include <glift/ranks/lost_ranks.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

namespace glift::mpi {

namespace {

constexpr int message_tag = 1, waiting_tag = 2;
constexpr std::size_t most_bytes = std::size_t{1} << 30;  // of one message of MPI, which counts in ints

class MpiTransport final : public ranks::Transport {
public:
    explicit MpiTransport(MPI_Comm communicator) {
        MPI_Comm_dup(communicator, &communicator_);
        MPI_Comm_rank(communicator_, &rank_);
        MPI_Comm_size(communicator_, &size_);
        char name[MPI_MAX_PROCESSOR_NAME] = {};
        int length = 0;
        MPI_Get_processor_name(name, &length);
        names_.resize(static_cast<std::size_t>(size_) * sizeof name);
        MPI_Allgather(name, sizeof name, MPI_CHAR, names_.data(), sizeof name, MPI_CHAR, communicator_);
    }
    ~MpiTransport() override {
        int is_over = 0;
        MPI_Finalized(&is_over);
        if (!is_over) MPI_Comm_free(&communicator_);
    }

    unsigned rank() const override { return static_cast<unsigned>(rank_); }
    unsigned size() const override { return static_cast<unsigned>(size_); }
    bool allows_threads() const override {
        int level = MPI_THREAD_SINGLE;
        MPI_Query_thread(&level);
        return level == MPI_THREAD_MULTIPLE;
    }
    std::string name_of(unsigned rank) const override {
        return std::string("on ") + (names_.data() + std::size_t{rank} * MPI_MAX_PROCESSOR_NAME);
    }

    void exchange(std::span<const ranks::Send> sends, std::span<const ranks::Receive> receives,
                  Seconds limit) override {
        std::vector<MPI_Request> requests;
        std::vector<unsigned> peers;
        for (const ranks::Receive& receive : receives)
            for (std::size_t at = 0; at < receive.bytes.size(); at += most_bytes) {
                const std::size_t count = std::min(most_bytes, receive.bytes.size() - at);
                peers.push_back(receive.from);
                MPI_Irecv(receive.bytes.data() + at, static_cast<int>(count), MPI_BYTE, static_cast<int>(receive.from),
                          message_tag, communicator_, &requests.emplace_back());
            }
        for (const ranks::Send& send : sends)
            for (std::size_t at = 0; at < send.bytes.size(); at += most_bytes) {
                const std::size_t count = std::min(most_bytes, send.bytes.size() - at);
                peers.push_back(send.to);
                MPI_Isend(send.bytes.data() + at, static_cast<int>(count), MPI_BYTE, static_cast<int>(send.to),
                          message_tag, communicator_, &requests.emplace_back());
            }
        wait(requests, peers, limit);
    }

private:
    void wait(std::vector<MPI_Request>& requests, const std::vector<unsigned>& peers, Seconds limit) {
        auto last = std::chrono::steady_clock::now();
        std::vector<int> done(requests.size());
        bool has_told = false;
        for (unsigned idle = 0;;) {
            int count = 0;
            MPI_Testsome(static_cast<int>(requests.size()), requests.data(), &count, done.data(), MPI_STATUSES_IGNORE);
            if (count == MPI_UNDEFINED) return;
            if (count > 0) {
                idle = 0;
                last = std::chrono::steady_clock::now();
                continue;
            }
            if (++idle < 256) continue;
            std::this_thread::yield();
            if (idle < 4096) continue;
            std::this_thread::sleep_for(std::chrono::microseconds(50));
            const Seconds waited = std::chrono::steady_clock::now() - last;
            if (waited > limit / 2 && !has_told) tell_waiting(open_peers(requests, peers).front());
            has_told = has_told || waited > limit / 2;
            if (waited > limit) throw_lost(open_peers(requests, peers), limit);
        }
    }

    static std::vector<unsigned> open_peers(const std::vector<MPI_Request>& requests,
                                            const std::vector<unsigned>& peers) {
        std::vector<unsigned> open;
        for (std::size_t i = 0; i < requests.size(); ++i)
            if (requests[i] != MPI_REQUEST_NULL) open.push_back(peers[i]);
        return open;
    }

    /// Tells all ranks for whom this one waits, so that they do not take it for one that hangs.
    void tell_waiting(unsigned peer) {
        waits_for_ = static_cast<int>(peer);
        for (int other = 0; other < size_; ++other) {
            MPI_Request request;
            if (other == rank_) continue;
            MPI_Isend(&waits_for_, 1, MPI_INT, other, waiting_tag, communicator_, &request);
            MPI_Request_free(&request);
        }
    }

    [[noreturn]] void throw_lost(std::vector<unsigned> open, Seconds limit) {
        std::vector<int> waits(static_cast<std::size_t>(size_), -1);
        for (int is_there = 1; is_there;) {
            MPI_Status status;
            MPI_Iprobe(MPI_ANY_SOURCE, waiting_tag, communicator_, &is_there, &status);
            if (is_there)
                MPI_Recv(&waits[static_cast<std::size_t>(status.MPI_SOURCE)], 1, MPI_INT, status.MPI_SOURCE,
                         waiting_tag, communicator_, MPI_STATUS_IGNORE);
        }
        detail::throw_lost_ranks(
            *this, std::move(open), [&](unsigned rank) { return waits[rank]; }, limit);
    }

    MPI_Comm communicator_ = MPI_COMM_NULL;
    int rank_ = 0, size_ = 1;
    int waits_for_ = -1;
    std::vector<char> names_;
};

}  // namespace

std::shared_ptr<ranks::Transport> transport(MPI_Comm communicator) {
    int is_there = 0;
    MPI_Initialized(&is_there);
    if (!is_there)
        throw Error(ErrorCode::wrong_argument, "MPI is not initialised", "glift::mpi::World", {},
                    "call MPI_Init before, and MPI_Finalize after the world is gone");
    return std::make_shared<MpiTransport>(communicator);
}

}  // namespace glift::mpi
