#include "dataset.h"

#include "error.h"
#include "field_bytes.h"

#include <algorithm>
#include <cstring>

namespace glift::files {

namespace {

std::vector<std::uint64_t> shown(const std::vector<std::uint64_t>& grid, const std::vector<bool>& is_shown) {
    std::vector<std::uint64_t> axes;
    for (std::size_t i = 0; i < grid.size(); ++i)
        if (is_shown[i]) axes.push_back(grid[i]);
    return axes;
}

/// Where a chunk begins, as HDF5 counts: also along the axes of the field.
std::vector<hsize_t> chunk_offset(const Batch& batch, const std::vector<bool>& is_shown, const Field& field) {
    std::vector<hsize_t> offset;
    for (std::uint64_t at : shown(batch.origin, is_shown)) offset.push_back(at);
    offset.resize(offset.size() + field.shape.size(), 0);
    return offset;
}

/// Where HDF5 says that a chunk lies; none: it was left out.
std::optional<std::uint64_t> address_of(hid_t dataset, const std::vector<hsize_t>& offset) {
    unsigned filters = 0;
    haddr_t address = HADDR_UNDEF;
    hsize_t bytes = 0;
    check(H5Dget_chunk_info_by_coord(dataset, offset.data(), &filters, &address, &bytes), "H5Dget_chunk_info_by_coord");
    if (address == HADDR_UNDEF || bytes == 0) return std::nullopt;
    return address;
}

/// The chunks of a dataset as a Tiling; throws bad_file where they are no runs in row-major order.
Tiling tiling_of(const std::vector<std::uint64_t>& shape, const std::vector<std::uint64_t>& chunk,
                 const std::string& path, const std::string& file_name) {
    Tiling tiling;
    tiling.shape = shape;
    while (tiling.axis + 1 < shape.size() && chunk[tiling.axis] == 1) ++tiling.axis;
    tiling.length = chunk[tiling.axis];
    if (tiling.length == 0 || tiling.chunk() != chunk)
        throw_bad(file_name, "the dataset " + path + " is cut in a way that glift::save does not use");
    return tiling;
}

}  // namespace

std::vector<hsize_t> with_field(const std::vector<std::uint64_t>& grid, const Field& field) {
    std::vector<hsize_t> extent(grid.begin(), grid.end());
    extent.insert(extent.end(), field.shape.begin(), field.shape.end());
    return extent;
}

template <class Run> void DataMap::attempt(Run run) {
    if (failure_ || is_discarded_) return;
    try {
        run();
    } catch (...) {
        failure_ = std::current_exception();
    }
}

void DataMap::write(std::uint64_t offset, std::span<const std::byte> bytes) {
    attempt([&] {
        if (bytes.data() != expected_.data() || bytes.size() != expected_.size()) return file_.write(offset, bytes);
        writer_->write(offset, bytes);
        hasher_.add(offset, bytes);
        ranges_.push_back({offset, offset + bytes.size()});
    });
}

void DataMap::read(std::uint64_t offset, std::span<std::byte> to) {
    attempt([&] { std::ranges::fill(to.subspan(file_.read(offset, to)), std::byte{0}); });
}

void DataMap::resize(std::uint64_t bytes) {
    attempt([&] { file_.resize(bytes); });
}

NewDataset::NewDataset(hid_t file, const std::string& path, const Field& field, const Tiling& tiling,
                       const std::vector<bool>& is_shown)
    : field_(field), is_shown_(is_shown), chunk_bytes_(tiling.chunk_elements() * packed_bytes(field)) {
    const Id links(H5Pcreate(H5P_LINK_CREATE), "H5Pcreate");
    check(H5Pset_create_intermediate_group(links, 1), "H5Pset_create_intermediate_group");
    const Id creation(H5Pcreate(H5P_DATASET_CREATE), "H5Pcreate");
    check(H5Pset_obj_track_times(creation, false), "H5Pset_obj_track_times");
    if (tiling.elements() > 0) {
        const std::vector<hsize_t> chunk = with_field(shown(tiling.chunk(), is_shown), field);
        check(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()), "H5Pset_chunk");
    }
    const Id space = simple_space(with_field(shown(tiling.shape, is_shown), field));
    const Id type = file_type(field.scalar);
    dataset_ = Id(H5Dcreate2(file, path.c_str(), type, space, links, creation, H5P_DEFAULT), "H5Dcreate2");
}

void NewDataset::write(const Batch& batch, std::span<const std::byte> packed, DataMap& map) {
    if (is_all_zero(packed)) return;
    const std::byte* bytes = packed.data();
    if (packed.size() < chunk_bytes_) {
        padded_.assign(chunk_bytes_, std::byte{0});
        std::memcpy(padded_.data(), packed.data(), packed.size());
        bytes = padded_.data();
    }
    const std::vector<hsize_t> offset = chunk_offset(batch, is_shown_, field_);
    map.expect({bytes, chunk_bytes_});
    const herr_t result = H5Dwrite_chunk(dataset_, H5P_DEFAULT, 0, offset.data(), chunk_bytes_, bytes);
    map.expect({});
    map.rethrow();
    check(result, "H5Dwrite_chunk");
}

StoredDataset::StoredDataset(hid_t file, const std::string& path, const Field& field,
                             const std::vector<std::uint64_t>& shape, const std::vector<bool>& is_shown,
                             const std::string& file_name)
    : field_(field), is_shown_(is_shown), dataset_(H5Dopen2(file, path.c_str(), H5P_DEFAULT), "H5Dopen2") {
    const Id space(H5Dget_space(dataset_), "H5Dget_space");
    std::vector<hsize_t> extent(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space), 0)));
    check(H5Sget_simple_extent_dims(space, extent.data(), nullptr), "H5Sget_simple_extent_dims");
    const Id type(H5Dget_type(dataset_), "H5Dget_type");
    if (extent != with_field(shown(shape, is_shown), field) || H5Tget_size(type) != file_bytes(field.scalar))
        throw_bad(file_name, "the dataset " + path + " has another type or extent than the schema says");
    tiling_.shape = shape;
    if (tiling_.elements() == 0) return;
    const Id creation(H5Dget_create_plist(dataset_), "H5Dget_create_plist");
    std::vector<hsize_t> chunk(extent.size());
    if (H5Pget_layout(creation) != H5D_CHUNKED ||
        H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data()) != static_cast<int>(chunk.size()))
        throw_bad(file_name, "the dataset " + path + " is not in chunks");
    std::vector<std::uint64_t> grid_chunk(shape.size(), 1);
    for (std::size_t i = 0, at = 0; i < shape.size(); ++i)
        if (is_shown[i]) grid_chunk[i] = chunk[at++];
    tiling_ = tiling_of(shape, grid_chunk, path, file_name);
    chunk_bytes_ = tiling_.chunk_elements() * packed_bytes(field);
}

void AddressShift::learn(std::uint64_t address, std::span<const std::byte> chunk, Pieces& pieces) {
    const auto lies_at = [&](std::uint64_t offset) {
        std::vector<std::byte> there(chunk.size());
        if (offset < user_block_bytes || offset + there.size() > pieces.end()) return false;
        pieces.read(offset, there);
        return std::ranges::equal(there, chunk);
    };
    const bool is_plain = lies_at(address), is_shifted = lies_at(address + user_block_bytes);
    if (is_plain != is_shifted) known = is_shifted ? user_block_bytes : 0;
}

void StoredDataset::read(const Batch& batch, std::span<std::byte> packed, Pieces& pieces, AddressShift& shift) {
    const std::vector<hsize_t> offset = chunk_offset(batch, is_shown_, field_);
    const auto address = address_of(dataset_, offset);
    if (!address) {
        std::ranges::fill(packed, std::byte{0});
        return;
    }
    if (shift.known) return pieces.read(*address + *shift.known, packed);
    // Whether the address counts the user block or not, the chunk lies in these bytes.
    const std::uint64_t begin = std::max(*address, user_block_bytes);
    pieces.verify(begin, std::min(*address + chunk_bytes_ + user_block_bytes, pieces.end()) - begin);
    padded_.resize(chunk_bytes_);
    std::uint32_t filters = 0;
    check(H5Dread_chunk(dataset_, H5P_DEFAULT, offset.data(), &filters, padded_.data()), "H5Dread_chunk");
    shift.learn(*address, padded_, pieces);
    std::memcpy(packed.data(), padded_.data(), packed.size());
}

}  // namespace glift::files
