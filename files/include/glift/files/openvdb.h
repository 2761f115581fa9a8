// Grids of OpenVDB out of structures of three axes, and into them. Functions are templates: a program that includes
// this header links OpenVDB itself (libopenvdb-dev), and libglift_files does not.
//
//     openvdb::io::File("smoke.vdb").write({glift::to_openvdb(smoke, 0.0f)});
//
// For .nvdb use NanoVDB's own converters, nanovdb::openToNanoVDB and nanovdb::nanoToOpenVDB.
#pragma once

#include <glift/structure.h>

#include <openvdb/openvdb.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace glift {

/// The resident elements of a structure of floats with three axes, as active voxels: voxel (x, y, z) + `origin` is
/// element (x, y, z). The transform is the identity. Reads the structure in slabs of 64 along z, and waits for the
/// device.
template <class S>
openvdb::FloatGrid::Ptr to_openvdb(const S& structure, float background, const openvdb::Coord& origin = {}) {
    static_assert(std::is_same_v<typename S::Address, uint3> && std::is_same_v<typename S::Element, float>,
                  "OpenVDB's float grids hold structures from uint3 to float");
    const openvdb::FloatGrid::Ptr grid = openvdb::FloatGrid::create(background);
    auto voxels = grid->getAccessor();
    const uint3 extent = structure.domain();
    for (uint z = 0; z < extent.z; z += 64) {
        const auto resident =
            structure.read_resident(uint3(0, 0, z), uint3(extent.x, extent.y, std::min(64u, extent.z - z)));
        for (const auto& [at, value] : resident)
            voxels.setValue(origin.offsetBy(static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(at.z)),
                            value);
    }
    return grid;
}

namespace detail {

/// Calls see(address, value) for each active voxel at an address of a domain; active tiles are taken apart.
template <class See>
void for_active(const openvdb::FloatGrid& grid, const openvdb::Coord& origin, const uint3& extent, See see) {
    const openvdb::CoordBBox domain(origin,
                                    origin.offsetBy(static_cast<int>(extent.x) - 1, static_cast<int>(extent.y) - 1,
                                                    static_cast<int>(extent.z) - 1));
    for (auto it = grid.cbeginValueOn(); it; ++it) {
        openvdb::CoordBBox box = it.getBoundingBox();
        box.intersect(domain);
        if (box.empty()) continue;
        for (auto at = box.begin(); at; ++at) {
            const openvdb::Coord from = *at - origin;
            see(uint3(static_cast<uint>(from.x()), static_cast<uint>(from.y()), static_cast<uint>(from.z())), *it);
        }
    }
}

}  // namespace detail

/// The addresses, rounded down to multiples of `page`, at which a grid has active voxels, each once: to request pages
/// of a sparse structure of that extent before from_openvdb().
inline std::vector<uint3> openvdb_pages(const openvdb::FloatGrid& grid, const uint3& extent, const uint3& page,
                                        const openvdb::Coord& origin = {}) {
    std::vector<uint3> pages;
    detail::for_active(grid, origin, extent, [&](const uint3& at, float) {
        const uint3 first(at.x / page.x * page.x, at.y / page.y * page.y, at.z / page.z * page.z);
        if (pages.empty() || pages.back() != first) pages.push_back(first);
    });
    const auto before = [](const uint3& a, const uint3& b) {
        return a.z != b.z ? a.z < b.z : a.y != b.y ? a.y < b.y : a.x < b.x;
    };
    std::ranges::sort(pages, before);
    pages.erase(std::unique(pages.begin(), pages.end()), pages.end());
    return pages;
}

/// Writes the active voxels of a grid to the elements at their addresses. Voxels outside of the domain are left out,
/// and those whose page is not resident are lost. Elements without an active voxel stay.
template <class S> void from_openvdb(S& structure, const openvdb::FloatGrid& grid, const openvdb::Coord& origin = {}) {
    static_assert(std::is_same_v<typename S::Address, uint3> && std::is_same_v<typename S::Element, float>,
                  "OpenVDB's float grids fit structures from uint3 to float");
    auto elements = structure.map();
    detail::for_active(grid, origin, structure.domain(), [&](const uint3& at, float value) { elements[at] = value; });
    elements.unmap();
}

}  // namespace glift
