// Compiled pipelines kept between runs, one file a device and driver.
#pragma once

#include "context.h"

#include <filesystem>

namespace glift::detail {

class DiskCache {
public:
    /// Reads what is there; a file that is damaged or from another driver is as good as none.
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
