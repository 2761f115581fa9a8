// The objects through which tasks of the host device update bindings (glift/host/updates.h, glift/host/sums.h).
#pragma once

#include "emit/cpp/host/rows.h"

#include <string>
#include <vector>

namespace gliftc::host {

/// What the code of a kernel has for its updates; all are empty if it has none.
struct UpdateTexts {
    std::string loop;                 ///< the begin of the call that loops over the parts of ordered sums
    std::vector<std::string> before;  ///< lines before the loop over tasks: objects that they share
    std::string parameters;           ///< of the function of a task, for these
    std::string arguments;
    std::string objects;             ///< at the begin of that function: objects of the task
    std::vector<std::string> after;  ///< lines after the loop
};

/// `rows` has printed the body.
UpdateTexts update_texts(const Rows& rows);

}  // namespace gliftc::host
