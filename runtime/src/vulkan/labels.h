// Debug labels (VK_EXT_debug_utils) of a command buffer: a label for each pass, inside of one for each pipeline.
#pragma once

#include "../profile/marks.h"
#include "context.h"

#include <optional>
#include <vector>

namespace glift::detail {

/// Does nothing unless Context::has_labels.
class Labels {
public:
    explicit Labels(const Context& context);

    /// Opens the pass's label. Labels of pipelines that have ended since the last pass are closed before, those of
    /// pipelines that have begun are opened.
    void begin(VkCommandBuffer commands, const char* pass);
    void end(VkCommandBuffer commands);
    /// Closes the labels of pipelines: called before the command buffer ends.
    void close(VkCommandBuffer commands);

private:
    void open(VkCommandBuffer commands, const char* name);

    const Context& context_;
    std::optional<MarkUser> marks_;
    std::vector<std::uint64_t> open_;  ///< serials of the pipelines' marks
};

}  // namespace glift::detail
