// mpirun -n RANKS ranks_mpi [--one-thread] TEST [CASE]: the tests of cases.h in processes of an MPI job. GLIFT_DEVICE
// chooses the device. --one-thread: MPI is called by the main thread alone.
#include "cases.h"

#include <glift/mpi/world.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <thread>

namespace {

int run(int argc, char** argv) {
    try {
        glift::mpi::World world(MPI_COMM_WORLD);
        return ranks_test::run(world, argv[1], argc > 2 ? argv[2] : "");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ranks_mpi: %s\n", error.what());
        return 1;
    }
}

}  // namespace

int main(int argc, char** argv) {
    const bool is_single = argc > 1 && std::string(argv[1]) == "--one-thread";
    int level = MPI_THREAD_SINGLE;
    MPI_Init_thread(&argc, &argv, is_single ? MPI_THREAD_SINGLE : MPI_THREAD_MULTIPLE, &level);
    if (is_single) --argc, ++argv;
    if (argc < 2) {
        std::fputs("usage: mpirun -n RANKS ranks_mpi [--one-thread] bits|bytes|balance|refusals|save|load|hang|die "
                   "[CASE|FILE]\n",
                   stderr);
        MPI_Abort(MPI_COMM_WORLD, 2);
    }
    const int result = run(argc, argv);
    if (result != 0 || std::string(argv[1]) == "hang") {
        std::fflush(stdout);
        std::this_thread::sleep_for(std::chrono::milliseconds(500));  // until all ranks have printed
        MPI_Abort(MPI_COMM_WORLD, result);
    }
    MPI_Finalize();
    return 0;
}
