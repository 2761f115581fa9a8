// Numbers as text: what inspections and errors write, whatever the program's locale.
#include <glift/inspected_values.h>

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>

namespace {

using glift::detail::number_text;
using glift::detail::text_of_value;

TEST(Text, NumbersAreThoseOfPrintf) {
    for (const double value :
         {0.0, -0.0, 1.0, -0.5, 1e30, 1.0 / 3.0, 123456789.0, 1e-7, 0.0001, 1.0 / 0.0, -1.0 / 0.0}) {
        char expected[40];
        std::snprintf(expected, sizeof expected, "%.7g", value);
        EXPECT_EQ(number_text(value, 7), expected);
    }
    EXPECT_EQ(number_text(0.0 / 0.0, 7).find("nan") != std::string::npos, true);
}

TEST(Text, LocalesWithADecimalCommaChangeNothing) {
    const auto folder = std::filesystem::temp_directory_path() / "glift_text_test";
    std::filesystem::create_directories(folder);
    const std::string make = "localedef -i de_DE -f UTF-8 '" + (folder / "de_DE.UTF-8").string() + "' 2>/dev/null";
    [[maybe_unused]] const int made = std::system(make.c_str());
    setenv("LOCPATH", folder.c_str(), 1);
    const bool is_set = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
    char comma[40];
    std::snprintf(comma, sizeof comma, "%g", -0.5);
    const std::string text = text_of_value(-0.5f);
    std::setlocale(LC_ALL, "C");
    unsetenv("LOCPATH");
    std::filesystem::remove_all(folder);
    if (!is_set) GTEST_SKIP() << "no locale de_DE here";
    EXPECT_STREQ(comma, "-0,5");
    EXPECT_EQ(text, "-0.5");
}

}  // namespace
