#include "verified_file.h"

#include "direct_reader.h"

#include <glift/error.h>

#include <algorithm>
#include <fcntl.h>

namespace glift::files {

namespace {

Id open_hdf5(const std::string& path) {
    const Id access(H5Pcreate(H5P_FILE_ACCESS), "H5Pcreate");
    check(H5Pset_file_locking(access, false, true), "H5Pset_file_locking");
    return Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), "H5Fopen");
}

herr_t add_name(hid_t, const char* name, const H5L_info_t*, void* names) {
    static_cast<std::vector<std::string>*>(names)->push_back(name);
    return 0;
}

}  // namespace

ByteSource source_of(const Descriptor& file) {
    const auto reader = std::make_shared<DirectReader>(file);
    return {file.path(), file.size(),
            [&file](std::uint64_t offset, std::span<std::byte> to) { return file.read(offset, to); },
            [reader](std::uint64_t offset, std::span<std::byte> to) { return reader->read(offset, to); }};
}

VerifiedFile::VerifiedFile(std::string path)
    : path_(std::move(path)), descriptor_(path_, O_RDONLY), pieces_(source_of(descriptor_)) {
    pieces_.verify_metadata();
    const Hdf5Lock lock;
    hdf5_ = open_hdf5(path_);
}

VerifiedFile::~VerifiedFile() {
    const Hdf5Lock lock;
    hdf5_.close();
}

std::vector<std::string> VerifiedFile::names() const {
    const Hdf5Lock lock;
    std::vector<std::string> names;
    check(H5Literate(hdf5_, H5_INDEX_NAME, H5_ITER_INC, nullptr, add_name, &names), "H5Literate");
    return names;
}

FiledPart VerifiedFile::schema(const std::string& name) const {
    const Hdf5Lock lock;
    const std::vector<std::string> all = names();
    if (std::ranges::find(all, name) == all.end()) {
        std::string list;
        for (const std::string& other : all) list += (list.empty() ? "" : ", ") + other;
        throw Error(ErrorCode::wrong_argument, "the file has no structure of this name", path_, "'" + name + "'",
                    "it has: " + (list.empty() ? "none" : list));
    }
    const Id group(H5Gopen2(hdf5_, name.c_str(), H5P_DEFAULT), "H5Gopen2");
    return parse_schema(read_text_attribute(group, "glift.schema"), path_);
}

}  // namespace glift::files
