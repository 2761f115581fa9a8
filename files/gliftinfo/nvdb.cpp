// Grids of floats with three axes as NanoVDB's files, without OpenVDB.
#include "output.h"
#include "sparse_grid.h"

#include <glift/error.h>

#if defined(GLIFT_WITH_NANOVDB)
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/IO.h>
#endif

#include <cstring>
#include <unistd.h>

namespace gliftinfo {

using namespace glift::files;

#if defined(GLIFT_WITH_NANOVDB)

namespace {

using Voxels = decltype(std::declval<nanovdb::GridBuilder<float>&>().getAccessor());

[[noreturn]] void throw_refused(const VerifiedFile& file, const Content& content, const std::string& why) {
    throw glift::Error(glift::ErrorCode::wrong_argument, "only grids of floats with three axes can be NanoVDB grids",
                       file.path() + ", " + content.path, why, "write it as .npy");
}

/// Calls see(index, number) for each float of a dataset, in row-major order.
template <class See> void for_each(VerifiedFile& file, const Content& content, const Progress& progress, See see) {
    std::uint64_t index = 0;
    read(file, content, [&](std::span<const std::byte> part) {
        for (std::size_t at = 0; at < part.size(); at += 4, ++index) {
            float number;
            std::memcpy(&number, part.data() + at, 4);
            see(index, number);
        }
        progress(part.size());
    });
}

void put_dense(VerifiedFile& file, const Content& content, const Progress& progress, Voxels& voxels) {
    const std::uint64_t width = content.shape[2], height = content.shape[1];
    for_each(file, content, progress, [&](std::uint64_t i, float number) {
        voxels.setValue(nanovdb::Coord(static_cast<int>(i % width), static_cast<int>(i / width % height),
                                       static_cast<int>(i / width / height)),
                        number);
    });
}

void put_sparse(VerifiedFile& file, const Content& content, const SparseGrid& grid, const Progress& progress,
                Voxels& voxels) {
    const std::uint64_t volume = content.shape[1];
    for_each(file, content, progress, [&](std::uint64_t i, float number) {
        const auto& origin = grid.origins[i / volume];
        if (!origin) return;
        const std::uint64_t in_page = i % volume;
        const std::uint64_t at[3] = {(*origin)[0] + in_page % grid.page[0],
                                     (*origin)[1] + in_page / grid.page[0] % grid.page[1],
                                     (*origin)[2] + in_page / grid.page[0] / grid.page[1]};
        for (unsigned axis = 0; axis < 3; ++axis) {
            if (at[axis] >= grid.extent[axis]) return;
            if (at[axis] > INT32_MAX) throw_refused(file, content, "it has elements beyond 2^31 - 1 of an axis");
        }
        voxels.setValue(nanovdb::Coord(static_cast<int>(at[0]), static_cast<int>(at[1]), static_cast<int>(at[2])),
                        number);
    });
}

}  // namespace

void write_nvdb(VerifiedFile& file, const Content& content, const std::string& to, const Progress& progress) {
    if (content.field.scalar != Scalar::float32 || !content.field.shape.empty())
        throw_refused(file, content, "its elements are " + type_text(content.field));
    const std::string name = content.path.substr(0, content.path.find('/'));
    const std::optional<SparseGrid> sparse = sparse_grid_at(file, file.schema(name), content);
    if (!sparse && (!content.is_by_address || content.shape.size() != 3))
        throw_refused(file, content, "it is memory of " + std::to_string(content.axes().size()) + " axes");
    nanovdb::GridBuilder<float> builder(sparse ? static_cast<float>(sparse->background) : 0.0f);
    Voxels voxels = builder.getAccessor();
    if (sparse) put_sparse(file, content, *sparse, progress, voxels);
    else put_dense(file, content, progress, voxels);
    const auto handle = builder.getHandle<>(1.0, nanovdb::Vec3d(0), name);
    Output output(to);
    output.close();  // says what is wrong where it cannot be written
    try {
        nanovdb::io::writeGrid(to, handle);
    } catch (const std::exception& error) {
        throw glift::Error(glift::ErrorCode::wrong_argument, "NanoVDB could not write the file", to, error.what(),
                           "check the room on the disk");
    }
}

#else

void write_nvdb(VerifiedFile&, const Content&, const std::string& to, const Progress&) {
    throw glift::Error(glift::ErrorCode::wrong_argument, "this gliftinfo was built without NanoVDB", to, "",
                       "install libnanovdb-dev, and build gliftinfo again");
}

#endif

}  // namespace gliftinfo
