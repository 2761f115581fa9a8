#include "labels.h"

namespace glift::detail {

Labels::Labels(const Context& context) : context_(context) {
    if (context.has_labels) marks_.emplace();
}

void Labels::open(VkCommandBuffer commands, const char* name) {
    const VkDebugUtilsLabelEXT label = {.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT, .pLabelName = name};
    context_.instance->vk().vkCmdBeginDebugUtilsLabelEXT(commands, &label);
}

void Labels::begin(VkCommandBuffer commands, const char* pass) {
    if (!context_.has_labels) return;
    const auto marks = open_marks();
    std::size_t same = 0;
    while (same < open_.size() && same < marks.size() && open_[same] == marks[same]->serial()) ++same;
    for (; open_.size() > same; open_.pop_back()) end(commands);
    for (; open_.size() < marks.size(); open_.push_back(marks[open_.size()]->serial()))
        open(commands, marks[open_.size()]->name());
    open(commands, pass);
}

void Labels::end(VkCommandBuffer commands) {
    if (context_.has_labels) context_.instance->vk().vkCmdEndDebugUtilsLabelEXT(commands);
}

void Labels::close(VkCommandBuffer commands) {
    for (; !open_.empty(); open_.pop_back()) end(commands);
}

}  // namespace glift::detail
