// The pipeline cache on disk, one file for each device and driver.
#pragma once

#include "context.h"

#include <filesystem>

namespace glift::detail {

class DiskCache {
public:
    /// Reads the file; one that is damaged or from another driver is ignored.
    explicit DiskCache(Context& context);
    ~DiskCache();
    DiskCache(const DiskCache&) = delete;

    VkPipelineCache handle() const { return handle_; }
    void save();  ///< never throws: a cache that cannot be written is no error

private:
    Context& context_;
    std::filesystem::path file_;  ///< empty: nothing is kept
    VkPipelineCache handle_ = VK_NULL_HANDLE;
};

}  // namespace glift::detail
