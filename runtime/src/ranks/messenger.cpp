#include "messenger.h"

#include "page_kernels.h"

#include <glift/iteration.h>

#include <algorithm>

namespace glift::detail {

namespace {

std::uint64_t bytes_of(std::span<const Piece> pieces) {
    std::uint64_t bytes = 0;
    for (const Piece& piece : pieces) bytes += piece.bytes();
    return bytes;
}

/// Calls use(rank, first byte, bytes) for each rank with which the pieces, which are ordered by `rank_of`, are
/// exchanged.
template <class RankOf, class Use> void each_rank(std::span<const Piece> pieces, RankOf rank_of, Use use) {
    std::uint64_t first = 0;
    for (std::size_t i = 0; i < pieces.size();) {
        std::uint64_t bytes = 0;
        const unsigned rank = rank_of(pieces[i]);
        for (; i < pieces.size() && rank_of(pieces[i]) == rank; ++i) bytes += pieces[i].bytes();
        use(rank, first, bytes);
        first += bytes;
    }
}

std::uint32_t words(std::uint64_t bytes) { return static_cast<std::uint32_t>(bytes / 4); }

}  // namespace

Messenger::Messenger(std::shared_ptr<ranks::Transport> transport, std::shared_ptr<DeviceObject> local, double limit)
    : transport_(std::move(transport)), local_(std::move(local)), limit_(limit) {}

Memory Messenger::staging(Memory& memory, std::uint64_t bytes) {
    if (!memory || memory.description().bytes < bytes)
        memory = stream().allocate(
            {.name = "messages of ranks", .bytes = (bytes + bytes / 4 + 255) / 4 * 4, .zeroed = false});
    return memory;
}

void Messenger::move(const Piece& piece, const Memory& packed, std::uint64_t at, bool packs) {
    if (!piece.paging) {
        const CopyRegion region =
            packs ? CopyRegion{piece.offset, at, piece.run} : CopyRegion{at, piece.offset, piece.run};
        return packs ? stream().copy(piece.memory, packed, {&region, 1})
                     : stream().copy(packed, piece.memory, {&region, 1});
    }
    const MovePages parameters = {words(piece.bytes()),
                                  piece.first,
                                  words(piece.run),
                                  words(piece.offset),
                                  words(piece.frame_bytes),
                                  words(at),
                                  {}};
    const Memory memories[] = {piece.paging->list, piece.paging->table, piece.memory, packed};
    stream().dispatch(packs ? pack_pages_kernel : unpack_pages_kernel, {.form = FormName::general,
                                                                        .memories = memories,
                                                                        .parameters = glift::bytes_of(parameters),
                                                                        .size = {parameters.size, 1, 1, 1}});
}

Messenger::Started Messenger::start(const std::vector<Piece>& pieces) {
    Started started;
    for (const Piece& piece : pieces) {
        if (piece.from == rank()) started.sent.push_back(piece);
        if (piece.to == rank()) started.received.push_back(piece);
    }
    std::ranges::stable_sort(started.sent, {}, &Piece::to);
    std::ranges::stable_sort(started.received, {}, &Piece::from);
    const std::uint64_t bytes = bytes_of(started.sent);
    if (bytes == 0) return started;
    const Memory packed = staging(send_, bytes);
    std::uint64_t at = 0;
    for (const Piece& piece : started.sent) {
        move(piece, packed, at, true);
        at += piece.bytes();
    }
    const CopyRegion region = {0, 0, bytes};
    started.download = stream().download(packed, {&region, 1}, bytes);
    stream().flush();
    return started;
}

std::uint64_t Messenger::finish(const Started& started) {
    std::vector<ranks::Send> sends;
    std::uint64_t sent = 0;
    if (started.download) {
        const std::span<const std::byte> bytes = started.download->get();
        each_rank(
            started.sent, [](const Piece& piece) { return piece.to; },
            [&](unsigned to, std::uint64_t first, std::uint64_t count) {
                sends.push_back({to, bytes.subspan(first, count)});
                sent += count;
            });
    }
    const auto exchange = [&](std::span<std::byte> arrived) {
        std::vector<ranks::Receive> receives;
        each_rank(
            started.received, [](const Piece& piece) { return piece.from; },
            [&](unsigned from, std::uint64_t first, std::uint64_t count) {
                receives.push_back({from, arrived.subspan(first, count)});
            });
        if (!sends.empty() || !receives.empty()) transport_->exchange(sends, receives, limit_);
    };
    const std::uint64_t expected = bytes_of(started.received);
    if (expected == 0) {
        exchange({});
        return sent;
    }
    const Memory packed = staging(receive_, expected);
    stream().upload_filled(packed, expected, exchange);
    std::uint64_t at = 0;
    for (const Piece& piece : started.received) {
        move(piece, packed, at, false);
        at += piece.bytes();
    }
    return sent;
}

std::vector<std::vector<std::byte>> Messenger::all_gather(std::span<const std::byte> mine) {
    std::vector<std::vector<std::byte>> all(size(), std::vector<std::byte>(mine.size()));
    std::vector<ranks::Send> sends;
    std::vector<ranks::Receive> receives;
    for (unsigned other = 0; other < size(); ++other) {
        if (other == rank()) continue;
        sends.push_back({other, mine});
        receives.push_back({other, all[other]});
    }
    all[rank()].assign(mine.begin(), mine.end());
    if (size() > 1 && !mine.empty()) transport_->exchange(sends, receives, limit_);
    return all;
}

void Messenger::barrier() {
    const std::byte nothing[1] = {};
    all_gather(nothing);
}

}  // namespace glift::detail
