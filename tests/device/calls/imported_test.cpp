// A program makes, writes and fills a structure for a pipeline. The structure's type is declared in another module than
// the pipeline.
#include "imported.glift.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Imported, is_written_by_the_program) {
    for (const glift::Device& device : {glift::Device::open("host"), glift::Device::open()}) {
        shapes::Folded folded(device, 3);
        folded.write(std::vector<glift::uint>{5, 7, 11});
        EXPECT_EQ(imported::total(device, folded).await(device), 23u);
        folded.fill(2);
        EXPECT_EQ(folded.read(), (std::vector<glift::uint>{2, 2, 2}));
    }
}

}  // namespace
