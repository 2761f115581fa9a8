#include "passes.h"

#include "lower/passes.h"

#include <gtest/gtest.h>

#include <set>

namespace gliftc::test {
namespace {

class Passes : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Passes, DoWhatTheyDid) {
    const PassCase expected = read_pass_case(GetParam());
    EXPECT_EQ(run_pass(GetParam(), expected.before), expected.after);
}

/// share/texels.ir becomes share_texels.
std::string case_name(const testing::TestParamInfo<std::filesystem::path>& info) {
    return info.param.parent_path().filename().string() + "_" + info.param.stem().string();
}

INSTANTIATE_TEST_SUITE_P(Text, Passes, testing::ValuesIn(pass_cases()), case_name);

TEST(PassTable, EveryPassHasACase) {
    std::set<std::string> tried;
    for (const auto& path : pass_cases()) tried.insert(path.parent_path().filename().string());
    for (const lower::BodyPass& pass : lower::body_passes())
        EXPECT_TRUE(tried.contains(std::string(pass.name))) << pass.name;
    for (const lower::BodyPass& pass : lower::host_passes())
        EXPECT_TRUE(tried.contains(std::string(pass.name))) << pass.name;
    for (const lower::KernelPass& pass : lower::kernel_passes())
        EXPECT_TRUE(tried.contains(std::string(pass.name))) << pass.name;
}

}  // namespace
}  // namespace gliftc::test
