// The pipeline of a kernel that draws. Viewport and scissor are dynamic; formats, blending and tests are the kernel's.
#pragma once

#include "pipelines.h"

namespace glift::detail {

VkPipeline make_graphics_pipeline(Context& context, const Pipeline& pipeline, VkPipelineCache cache);

}  // namespace glift::detail
