// Moves bytes of devices' memories between ranks, through memory that the hosts see.
#pragma once

#include "job_thread.h"
#include "pieces.h"

#include "../objects.h"

#include <glift/ranks/world.h>

#include <atomic>

namespace glift::detail {

/// What messages of one kind have taken so far.
struct Traffic {
    std::atomic<std::uint64_t> bytes{0};  ///< that this rank sent
    std::atomic<double> seconds{0};  ///< from the last byte of this rank in its host's memory to the last that arrived
};

class Messenger {
public:
    Messenger(std::shared_ptr<ranks::Transport> transport, std::shared_ptr<DeviceObject> local, double limit);

    unsigned rank() const { return transport_->rank(); }
    unsigned size() const { return transport_->size(); }

    /// A piece, and where it lies in the memory for messages.
    struct Message {
        Piece piece;
        std::uint64_t at;
    };
    /// Messages on their way. The host may give commands meanwhile.
    struct Started {
        std::vector<Message> sent, received;
        VisibleMemory outgoing, incoming;
        std::shared_ptr<PointObject> packed;  ///< null: it has happened
        Traffic* traffic;

        bool is_empty() const { return sent.empty() && received.empty(); }
    };
    /// Puts copies of the pieces that this rank sends into the device's stream, and submits them.
    Started start(const std::vector<Piece>& pieces, Traffic& traffic);
    /// Puts copies of what the other ranks send to their places into the stream. Waits only where the device cannot be
    /// held back, or the transport is bound to this thread.
    void receive(const Started& started);

    /// What each rank gives, in the order of the ranks; all give as many bytes.
    std::vector<std::vector<std::byte>> all_gather(std::span<const std::byte> mine);
    void barrier();
    /// Returns when all messages have arrived; throws lost_rank.
    void finish() { thread_.finish(); }
    /// Throws lost_rank if a rank is known to be lost.
    void check() { thread_.check(); }

private:
    const VisibleMemory& room(VisibleMemory& memory, std::uint64_t bytes);
    void move(const Message& message, const Memory& packed, bool packs);
    void deliver(const Started& started);
    Stream& stream() { return local_->stream(); }

    std::shared_ptr<ranks::Transport> transport_;
    std::shared_ptr<DeviceObject> local_;
    ranks::Transport::Seconds limit_;
    bool holds_back_;  ///< commands that need messages are given before these have arrived
    VisibleMemory outgoing_, incoming_;
    JobThread thread_;  ///< the last member: its jobs use the others
};

}  // namespace glift::detail
