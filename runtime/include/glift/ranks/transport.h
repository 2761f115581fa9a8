// Messages between the ranks of a program. A rank is a process with a device of its own; ranks have numbers from 0 on.
#pragma once

#include <glift/api.h>

#include <chrono>
#include <cstddef>
#include <span>
#include <string>

namespace glift::ranks {

/// Bytes for another rank.
struct Send {
    unsigned to;
    std::span<const std::byte> bytes;
};

/// Room for the bytes that another rank sends, which are as many.
struct Receive {
    unsigned from;
    std::span<std::byte> bytes;
};

/// How ranks reach each other: MPI (glift/mpi/world.h), or memory that processes of one host share (processes.h).
class GLIFT_API Transport {
public:
    using Seconds = std::chrono::duration<double>;

    virtual ~Transport() = default;
    virtual unsigned rank() const = 0;  ///< of this process
    virtual unsigned size() const = 0;  ///< how many ranks there are
    /// The rank's host and process, for errors.
    virtual std::string name_of(unsigned rank) const = 0;

    /// Sends and receives, and returns when all of it is done. Messages between two ranks arrive in the order in which
    /// they were sent. Throws lost_rank, with the names of the ranks that did not answer, where nothing arrives or
    /// leaves for `limit`.
    virtual void exchange(std::span<const Send> sends, std::span<const Receive> receives, Seconds limit) = 0;
    /// Whether another thread than the one that made the transport may call exchange, one thread at a time. If so,
    /// messages travel while the program gives the next commands.
    virtual bool allows_threads() const = 0;
    /// Memory of a rank that this one sees, too, from the beginning of a page on; as long for every rank. If there is
    /// some, elements travel through it, and `exchange` only says that they are there. Empty: there is none.
    virtual std::span<std::byte> area([[maybe_unused]] unsigned rank) const { return {}; }
};

}  // namespace glift::ranks
