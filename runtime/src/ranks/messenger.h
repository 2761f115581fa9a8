// Moves bytes of devices' memories between ranks, through the hosts.
#pragma once

#include "pieces.h"

#include "../objects.h"

#include <glift/ranks/world.h>

#include <map>
#include <optional>

namespace glift::detail {

class Messenger {
public:
    Messenger(std::shared_ptr<ranks::Transport> transport, std::shared_ptr<DeviceObject> local, double limit);

    unsigned rank() const { return transport_->rank(); }
    unsigned size() const { return transport_->size(); }

    /// Messages on their way from the device to the host.
    struct Started {
        std::vector<Piece> sent, received;  ///< ordered by the other rank
        std::shared_ptr<DownloadObject> download;
    };
    /// Puts copies of the pieces that this rank sends into the device's stream, and submits them.
    Started start(const std::vector<Piece>& pieces);
    /// Sends them, receives the others', and puts copies to their places into the stream. Returns the bytes sent.
    std::uint64_t finish(const Started& started);

    /// What each rank gives, in the order of the ranks; all give as many bytes.
    std::vector<std::vector<std::byte>> all_gather(std::span<const std::byte> mine);
    void barrier();

private:
    Memory staging(Memory& memory, std::uint64_t bytes);
    void move(const Piece& piece, const Memory& packed, std::uint64_t at, bool packs);
    Stream& stream() { return local_->stream(); }

    std::shared_ptr<ranks::Transport> transport_;
    std::shared_ptr<DeviceObject> local_;
    ranks::Transport::Seconds limit_;
    Memory send_, receive_;
};

}  // namespace glift::detail
