// How documentation comments are printed into C++.
#include "emit/cpp/writer.h"

#include <gtest/gtest.h>

using namespace gliftc;

static std::string printed(std::string_view doc) {
    cpp::Writer writer;
    cpp::write_doc(writer, doc);
    return writer.take();
}

TEST(Doc, LinesOfAParagraphAreBrokenAnew) {
    const std::string words(70, 'a'), more(60, 'b');
    EXPECT_EQ(printed(""), "");
    EXPECT_EQ(printed("One line."), "/// One line.\n");
    EXPECT_EQ(printed("" + words + " " + more + "\nend."), "/// " + words + "\n/// " + more + " end.\n");
    EXPECT_EQ(printed("One.\n\nTwo\nlines.\n"), "/// One.\n///\n/// Two lines.\n");
}

TEST(Doc, OtherLinesStayLines) {
    const std::string words(70, 'a'), more(60, 'b');
    EXPECT_EQ(printed("Items:\n- one,\n  " + words + "\n  " + more + "\n- two.\nThen 1\n2. three"),
              "/// Items:\n/// - one, " + words + "\n///   " + more + "\n/// - two. Then 1\n/// 2. three\n");
    EXPECT_EQ(printed("A formula:\n    x[i] = 1,\nwhere\n```\na\nb\n```\nc"),
              "/// A formula:\n///     x[i] = 1,\n/// where\n/// ```\n/// a\n/// b\n/// ```\n/// c\n");
    EXPECT_EQ(printed("@param a first\n@param b second"), "/// @param a first\n/// @param b second\n");
}

/// After a `//` comment that ends with a backslash, the next line would be part of it.
TEST(Doc, NoLineEndsWithABackslash) {
    const std::string words(110, 'a');
    EXPECT_EQ(printed("Ends with \\\n\nnext"), "/// Ends with \\ .\n///\n/// next\n");
    EXPECT_EQ(printed("" + words + " \\ next"), "/// " + words + " \\ .\n/// next\n");
}
