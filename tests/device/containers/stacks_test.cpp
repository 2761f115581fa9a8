// Stacks of equal height: random pushes and pops, also of wrong lengths, of full and of empty ones, compared with
// a vector.
#include "property.h"

#include "stacks.glift.hpp"

namespace {

using property::Round;
using Number = std::uint32_t;

GLIFT_PROPERTY_SUITE(Stacks);

/// Whether the call is refused as a wrong argument.
template <class Call> bool is_refused(const Call& call) {
    try {
        call();
    } catch (const glift::Error& error) {
        EXPECT_EQ(error.code(), glift::ErrorCode::wrong_argument) << error.what();
        return true;
    }
    return false;
}

/// What is refused changes nothing, so that the next push or pop does what it would have done before.
TEST_P(Stacks, RefuseAndStayUsable) {
    for_all("stacks of equal height", [&](Round& round) {
        const Number n = 1 + round.below(300), depth = round.below(5);
        round.about(std::to_string(n) + " stacks of depth " + std::to_string(depth));
        stacks::Stacks found(device(), n, depth);
        std::vector<std::vector<Number>> model;
        for (int step = 0; step < 30 && !HasFailure(); ++step) {
            if (round.chance(2)) {
                const bool fits = !round.chance(5);
                std::vector<Number> values(fits ? n : n + 1);
                for (Number& value : values) value = round.below(1U << 31);
                stacks::Numbers given(device(), static_cast<Number>(values.size()));
                given.write(values);
                ASSERT_EQ(is_refused([&] { found.push(device(), given); }), !fits || model.size() == depth)
                    << round.wrong("push").message();
                if (fits && model.size() < depth) model.push_back(values);
            } else {
                std::vector<Number> popped;
                ASSERT_EQ(is_refused([&] { popped = found.pop(device()).read(); }), model.empty())
                    << round.wrong("pop").message();
                if (!model.empty()) {
                    ASSERT_TRUE(property::equal(round, model.back(), popped, "popped"));
                    model.pop_back();
                }
            }
            ASSERT_EQ(found.top(), n * model.size()) << round.wrong("top").message();
        }
    });
}

}  // namespace
