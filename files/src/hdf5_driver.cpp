#include "hdf5_driver.h"

#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

#include <algorithm>

namespace glift::files {

namespace {

/// What HDF5 knows as a file. Offsets count the user block.
struct DriverFile {
    H5FD_t common{};  // HDF5's own, which must come first
    std::shared_ptr<DataMap> data;
    haddr_t end_of_allocations = 0, end = 0;
};

DriverFile& of(H5FD_t* file) { return *reinterpret_cast<DriverFile*>(file); }
const DriverFile& of(const H5FD_t* file) { return *reinterpret_cast<const DriverFile*>(file); }

H5FD_t* open(const char*, unsigned, hid_t access, haddr_t) {
    const void* const info = H5Pget_driver_info(access);
    if (!info) return nullptr;
    auto* const file = new DriverFile;
    file->data = (*static_cast<DataMap* const*>(info))->shared_from_this();
    return &file->common;
}

herr_t close(H5FD_t* file) {
    delete &of(file);
    return 0;
}

int compare(const H5FD_t* a, const H5FD_t* b) { return a < b ? -1 : a > b; }

herr_t query(const H5FD_t*, unsigned long* flags) {
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA;
    return 0;
}

haddr_t end_of_allocations(const H5FD_t* file, H5FD_mem_t) { return of(file).end_of_allocations; }
herr_t set_end_of_allocations(H5FD_t* file, H5FD_mem_t, haddr_t end) {
    of(file).end_of_allocations = end;
    return 0;
}
haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) { return of(file).end; }

herr_t read(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t offset, std::size_t bytes, void* to) {
    of(file).data->read(offset, {static_cast<std::byte*>(to), bytes});
    return 0;
}

herr_t write(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t offset, std::size_t bytes, const void* from) {
    of(file).end = std::max<haddr_t>(of(file).end, offset + bytes);
    of(file).data->write(offset, {static_cast<const std::byte*>(from), bytes});
    return 0;
}

herr_t truncate(H5FD_t* file, hid_t, hbool_t) {
    of(file).end = of(file).end_of_allocations;
    of(file).data->resize(of(file).end);
    return 0;
}

// The names of these members are the same in all versions of HDF5, their number is not.
constexpr H5FD_class_t driver = {
#if H5_VERSION_GE(1, 13, 0)
    .version = H5FD_CLASS_VERSION,
    .value = static_cast<H5FD_class_value_t>(600),
#endif
    .name = "glift",
    .maxaddr = (haddr_t{1} << 62) - 1,
    .fc_degree = H5F_CLOSE_WEAK,
    .fapl_size = sizeof(DataMap*),
    .open = open,
    .close = close,
    .cmp = compare,
    .query = query,
    .get_eoa = end_of_allocations,
    .set_eoa = set_end_of_allocations,
    .get_eof = end_of_file,
    .read = read,
    .write = write,
    .truncate = truncate,
    .fl_map = H5FD_FLMAP_DICHOTOMY,
};

}  // namespace

Id create_hdf5(DataMap& data) {
    static const hid_t registered = H5FDregister(&driver);
    const Id creation(H5Pcreate(H5P_FILE_CREATE), "H5Pcreate");
    check(H5Pset_userblock(creation, user_block_bytes), "H5Pset_userblock");
    const Id access(H5Pcreate(H5P_FILE_ACCESS), "H5Pcreate");
    check(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110), "H5Pset_libver_bounds");
    check(H5Pset_meta_block_size(access, 8192), "H5Pset_meta_block_size");
    DataMap* const pointer = &data;
    check(H5Pset_driver(access, registered, &pointer), "H5Pset_driver");
    return Id(H5Fcreate("glift", H5F_ACC_TRUNC, creation, access), "H5Fcreate");
}

}  // namespace glift::files
