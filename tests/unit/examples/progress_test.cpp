#include "examples/common/progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/ioctl.h>
#include <unistd.h>

namespace {

using progress::text_of;

TEST(Progress, SaysHowFarItIs) {
    EXPECT_EQ(text_of("step", 0, 240, 0, "", 80), "step 0 of 240 [>                   ]");
    EXPECT_EQ(text_of("step", 60, 240, 1, "812 pages", 80),
              "step 60 of 240 [=====>              ] 3 s left: 812 pages");
    EXPECT_EQ(text_of("step", 240, 240, 4, "812 pages", 80), "step 240 of 240 [====================]: 812 pages");
    EXPECT_EQ(text_of("step", 1, 1000, 1, "", 80), "step 1 of 1000 [>                   ] 16 min left");
    EXPECT_EQ(text_of("step", 1, 100000, 1, "", 80), "step 1 of 100000 [>                   ] 27 h left");
    EXPECT_EQ(text_of("step", 0, 0, 0, "", 80), "step 0 of 0 [====================]");
    EXPECT_EQ(text_of("step", 60, 240, 1, "812 pages", 14), "step 60 of 240");
}

TEST(Progress, SaysNothingWhereThereIsNoTerminal) {
    std::FILE* file = std::tmpfile();
    ASSERT_TRUE(file);
    {
        progress::Line line("step", file);
        line.show(1, 2);
        line.show(2, 2);
    }
    EXPECT_EQ(std::ftell(file), 0);
    std::fclose(file);
}

/// What was written to a terminal up to `end`, read from the other end of it. One read gives what has arrived, which
/// may be less than what was written.
std::string read_until(int other_end, char end) {
    std::string text;
    char c = 0;
    while (read(other_end, &c, 1) == 1 && c != end) text += c;
    return text;
}

/// Writes to a pseudo-terminal of 30 columns, and reads what was written from its other end.
TEST(Progress, KeepsOneLineOfATerminal) {
    const int other_end = posix_openpt(O_RDWR | O_NOCTTY);
    if (other_end < 0 || grantpt(other_end) != 0 || unlockpt(other_end) != 0)
        GTEST_SKIP() << "no pseudo-terminals here";
    std::FILE* terminal = std::fopen(ptsname(other_end), "w");
    ASSERT_TRUE(terminal);
    winsize size{};
    size.ws_col = 30;
    ASSERT_EQ(ioctl(fileno(terminal), TIOCSWINSZ, &size), 0);
    const auto start = std::chrono::steady_clock::now();
    {
        progress::Line line("step", terminal);
        line.show(0, 4, "begin");
        line.show(1, 4, "not shown: it comes at once");
        line.show(4, 4, "end");
    }
    const bool at_once = std::chrono::steady_clock::now() - start < std::chrono::milliseconds(100);
    std::fputc('|', terminal);
    std::fflush(terminal);
    const std::string text = read_until(other_end, '|');
    std::fclose(terminal);
    close(other_end);
    if (!at_once) GTEST_SKIP() << "the machine was busy: what comes 100 ms later is shown";
    EXPECT_EQ(text, "\r\x1b[Kstep 0 of 4 [>               "
                    "\r\x1b[Kstep 4 of 4 [================"
                    "\r\x1b[K");
}

}  // namespace
