// Guards that hold in all rounds of an invocation's loops where they hold for all that the loops reach: one test before
// the loops stands for them, and the C++ compiler gets loops without branches, which it can turn into vectors.
#pragma once

#include "emit/cpp/printer.h"
#include "ir/pass.h"

#include <set>
#include <string>
#include <vector>

namespace gliftc::host {

struct Guards {
    std::vector<std::string> tests;   ///< as C++; empty: no guard depends on a loop in a way that is known
    std::set<ir::ExprId> conditions;  ///< that hold where all tests do
    std::set<ir::LocalId> unread;     ///< lets of which only they, and what they leave out, make use
};

/// Of what an invocation does. The tests name its address, parameters and constants alone.
Guards find_guards(cpp::Printer& p, const ir::Pass& pass, const std::vector<ir::StmtId>& statements);

}  // namespace gliftc::host
