// A folder of its own for each test, and the devices.
#pragma once

#include <glift/glift.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace files_test {

class InFolder : public testing::Test {
protected:
    InFolder() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  (std::string("glift-") + test->test_suite_name() + "." + test->name() + std::to_string(::getpid()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~InFolder() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name = "saved.h5") const { return (folder_ / name).string(); }
    const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;
};

inline const glift::Device& device(const std::string& which) {
    static const glift::Device host = glift::Device::open("host"), other = glift::Device::open();
    return which == "host" ? host : other;
}

/// The names of the devices: `host`, and `other` for the one that GLIFT_DEVICE names.
inline const std::vector<std::string>& devices() {
    static const std::vector<std::string> names = {"host", "other"};
    return names;
}

}  // namespace files_test
