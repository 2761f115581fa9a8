#include "disk_cache.h"

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <unistd.h>

namespace glift::detail {

namespace {

namespace fs = std::filesystem;

struct FileHeader {
    char magic[8];
    std::uint64_t bytes;
    std::uint64_t checksum;
};

constexpr std::uintmax_t largest_file = std::uintmax_t(1) << 30;
constexpr char magic[8] = {'G', 'L', 'I', 'F', 'T', 'P', 'C', '1'};

std::uint64_t fnv1a(const std::vector<char>& bytes) {
    std::uint64_t hash = 14695981039346656037u;
    for (unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211u;
    return hash;
}

fs::path folder() {
    if (const char* named = std::getenv("GLIFT_CACHE_DIR")) return named;
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg) return fs::path(xdg) / "glift";
    if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache" / "glift";
    return {};
}

std::string file_name(const VkPhysicalDeviceProperties& core) {
    char text[96];
    int length = std::snprintf(text, sizeof text, "%04x-%04x-", core.vendorID, core.deviceID);
    for (const std::uint8_t byte : core.pipelineCacheUUID) {
        length += std::snprintf(text + length, sizeof text - static_cast<std::size_t>(length), "%02x", byte);
    }
    return std::string(text) + ".pipelines";
}

// The file's contents after its header; empty unless the file is complete and from this device and driver. Checked
// here, since not all drivers check the data well.
std::vector<char> read_valid(const fs::path& file, const VkPhysicalDeviceProperties& core) {
    std::error_code error;
    const std::uintmax_t bytes = fs::is_regular_file(file, error) ? fs::file_size(file, error) : 0;
    std::ifstream in(file, std::ios::binary);
    FileHeader header;
    if (error || !in.read(reinterpret_cast<char*>(&header), sizeof header)) return {};
    if (std::memcmp(header.magic, magic, sizeof magic) != 0 || bytes > largest_file) return {};
    if (header.bytes != bytes - sizeof header) return {};  // the file was cut short, or is longer
    std::vector<char> data(header.bytes);
    if (!in.read(data.data(), static_cast<std::streamsize>(data.size()))) return {};
    VkPipelineCacheHeaderVersionOne inner;
    if (fnv1a(data) != header.checksum || data.size() < sizeof inner) return {};
    std::memcpy(&inner, data.data(), sizeof inner);
    const bool same = inner.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE && inner.vendorID == core.vendorID &&
                      inner.deviceID == core.deviceID &&
                      std::memcmp(inner.pipelineCacheUUID, core.pipelineCacheUUID, VK_UUID_SIZE) == 0;
    return same ? data : std::vector<char>();
}

}  // namespace

DiskCache::DiskCache(Context& context) : context_(context) {
    std::vector<char> data;
    if (const fs::path at = folder(); !at.empty()) {
        file_ = at / file_name(context.core);
        data = read_valid(file_, context.core);
    }
    VkPipelineCacheCreateInfo info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO,
                                      .initialDataSize = data.size(),
                                      .pInitialData = data.data()};
    const VkResult result = context.vk.vkCreatePipelineCache(context.device, &info, nullptr, &handle_);
    if (result >= 0) return;
    if (data.empty()) context.fail(result, "vkCreatePipelineCache");
    info.initialDataSize = 0;  // the driver refused the data: start with an empty cache
    context.check(context.vk.vkCreatePipelineCache(context.device, &info, nullptr, &handle_), "vkCreatePipelineCache");
}

DiskCache::~DiskCache() { context_.vk.vkDestroyPipelineCache(context_.device, handle_, nullptr); }

void DiskCache::save() {
    if (file_.empty()) return;
    std::size_t size = 0;
    if (context_.vk.vkGetPipelineCacheData(context_.device, handle_, &size, nullptr) != VK_SUCCESS) return;
    std::vector<char> data(size);
    if (context_.vk.vkGetPipelineCacheData(context_.device, handle_, &size, data.data()) != VK_SUCCESS) return;
    data.resize(size);
    FileHeader header = {{}, data.size(), fnv1a(data)};
    std::memcpy(header.magic, magic, sizeof magic);

    std::error_code error;
    fs::create_directories(file_.parent_path(), error);
    // Written under a temporary name and renamed: readers see the old file or the new one, never a partial one.
    // Each save has a name of its own, since several devices of a process may save at once.
    static std::atomic<unsigned> saves{0};
    const fs::path partial =
        file_.string() + "." + std::to_string(getpid()) + "." + std::to_string(saves.fetch_add(1)) + ".part";
    {
        std::ofstream out(partial, std::ios::binary);
        out.write(reinterpret_cast<const char*>(&header), sizeof header);
        out.write(data.data(), static_cast<std::streamsize>(data.size()));
        if (!out.flush()) {
            out.close();
            fs::remove(partial, error);
            return;
        }
    }
    fs::rename(partial, file_, error);
    if (error) fs::remove(partial, error);
}

}  // namespace glift::detail
