// Several devices as one, by MPI: glift/ranks/world.h says what a World is. Link glift::mpi.
#pragma once

#include <glift/ranks/world.h>

#include <mpi.h>

#include <memory>

namespace glift::mpi {

/// Messages over a communicator, a duplicate of the given one. Throws wrong_argument before MPI_Init. An error of MPI
/// ends the job, as MPI does by default.
std::shared_ptr<ranks::Transport> transport(MPI_Comm communicator);

/// The device of this process: what GLIFT_DEVICE says if that is neither empty nor `gpu`; else, of the processes of the
/// communicator on one host, the k-th has its k-th GPU. Without a GPU, what Device::open returns.
Device device_of(MPI_Comm communicator);

/// The processes of a communicator, of which each has a device. It must end before MPI_Finalize.
class World : public ranks::World {
public:
    explicit World(MPI_Comm communicator, const ranks::Options& options = {})
        : World(communicator, device_of(communicator), options) {}
    World(MPI_Comm communicator, const Device& local, const ranks::Options& options = {})
        : ranks::World(transport(communicator), local, options) {}
};

}  // namespace glift::mpi
