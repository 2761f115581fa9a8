#include <glift/mpi/world.h>

#include <glift/error.h>

#include <cstdlib>
#include <string>

namespace glift::mpi {

Device device_of(MPI_Comm communicator) {
    const char* wanted = std::getenv("GLIFT_DEVICE");
    if (wanted && *wanted && std::string(wanted) != "gpu") return Device::open();
    MPI_Comm host;
    int number = 0;
    MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &host);
    MPI_Comm_rank(host, &number);
    MPI_Comm_free(&host);
    try {
        return Device::open("gpu:" + std::to_string(number));
    } catch (const Error& error) {
        if (error.code() != ErrorCode::no_device || (wanted && *wanted)) throw;
        return Device::open();
    }
}

}  // namespace glift::mpi
