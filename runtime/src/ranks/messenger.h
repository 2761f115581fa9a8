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
    std::atomic<double> seconds{0};       ///< from when the device had packed them until what is received had arrived
};

/// Devices that have a link (objects.h) copy to and from the host's memory by it, beside their passes; the passes of
/// others read and write that memory. If the transport has areas, ranks read each other's; else messages are sent.
class Messenger {
public:
    Messenger(std::shared_ptr<ranks::Transport> transport, std::shared_ptr<DeviceObject> local, double limit);

    unsigned rank() const { return transport_->rank(); }
    unsigned size() const { return transport_->size(); }

    /// A piece, and where it lies among the sender's, and among those that the receiver has received.
    struct Message {
        Piece piece;
        std::uint64_t sent_at = 0, received_at = 0;
    };
    /// Bytes of the host, which the link can copy.
    struct HostRoom {
        std::shared_ptr<std::byte> own;  ///< null: an area of the transport
        std::span<std::byte> bytes;
        std::shared_ptr<AttachedObject> attached;  ///< after `own`, which has to outlive it
    };
    /// Messages on their way. The host may give commands meanwhile.
    struct Started {
        std::vector<Message> sent, received;
        Memory packed, arrived;                            ///< where passes leave and find the pieces
        std::span<std::byte> outgoing, incoming;           ///< of the host
        HostRoom to, from;                                 ///< with a link, where messages are sent
        std::vector<std::pair<unsigned, HostRoom>> areas;  ///< of this rank and of those from which it receives
        std::vector<unsigned> others;                      ///< with which it has messages in common
        std::shared_ptr<PointObject> packing;              ///< its end; null: it has happened
        Traffic* traffic = nullptr;

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
    struct Staging {
        Memory memory;
        std::span<std::byte> bytes;  ///< empty: the host does not see it
    };
    const Staging& staging(Staging& staging, std::uint64_t bytes);
    const HostRoom& room(HostRoom& room, std::uint64_t bytes);
    const HostRoom& area(unsigned rank, std::uint64_t bytes);
    void move_pieces(const Message& message, const Memory& staging, bool packs);
    void deliver(const Started& started, GateObject* gate);
    void deliver_by_areas(const Started& started, GateObject* gate);
    void deliver_by_messages(const Started& started, GateObject* gate);
    void shake_hands(const Started& started);
    Stream& stream() { return local_->stream(); }

    std::shared_ptr<ranks::Transport> transport_;
    std::shared_ptr<DeviceObject> local_;
    LinkObject* link_;  ///< null: the host sees what the passes use
    ranks::Transport::Seconds limit_;
    bool holds_back_;  ///< commands that need messages are given before these have arrived
    Staging packed_, arrived_;
    HostRoom to_, from_;
    std::vector<HostRoom> areas_;  ///< by rank
    JobThread thread_;             ///< the last member: its jobs use the others
};

}  // namespace glift::detail
