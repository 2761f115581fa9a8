// Barriers must be recorded exactly where they are needed. The tests count them, since validation does not detect every
// missing one, nor one too many, and lavapipe works without any.
#include "test_device.h"

namespace {

using namespace kernels;

class Barriers : public testing::Test {
protected:
    Barriers() : device(glift::Device::open(vulkan_name())) {
        for (auto& memory : memories) memory = buffer(device, "m", 4096);
        device.wait();
    }
    ~Barriers() override {
        device.wait();
        for (const std::string& message : device.validation_messages()) ADD_FAILURE() << message;
    }

    /// The number of barriers that the action records; all earlier work is done before.
    template <class Action> std::uint64_t count(Action action) {
        device.wait();
        const std::uint64_t before = device.statistics().barriers;
        action();
        const std::uint64_t after = device.statistics().barriers;
        device.wait();
        return after - before;
    }

    void scale(int from, int to) { run_scale(device, memories[from], memories[to], 256, 1.0f); }
    void store(int to) { run_store(device, memories[to], 256, 3); }

    glift::Device device;
    glift::Memory memories[6];
};

TEST_F(Barriers, NoneBetweenIndependentPasses) {
    EXPECT_EQ(count([&] {
                  scale(0, 1);
                  scale(2, 3);
                  scale(4, 5);
              }),
              0u);
    EXPECT_EQ(count([&] {
                  scale(0, 1);
                  scale(0, 2);
                  scale(0, 3);
              }),
              0u);
}

TEST_F(Barriers, ReadAfterWrite) {
    EXPECT_EQ(count([&] {
                  scale(0, 1);
                  scale(1, 2);
              }),
              1u);
}

TEST_F(Barriers, WriteAfterRead) {
    EXPECT_EQ(count([&] {
                  scale(0, 1);
                  store(0);
              }),
              1u);
}

TEST_F(Barriers, WriteAfterWrite) {
    EXPECT_EQ(count([&] {
                  store(0);
                  store(0);
                  store(0);
              }),
              2u);
    EXPECT_EQ(count([&] {
                  for (int k = 0; k < 5; ++k) run_add(device, memories[0], 256, 1);
              }),
              4u);
}

TEST_F(Barriers, OneServesAllBeforeIt) {
    EXPECT_EQ(count([&] {
                  scale(0, 1);
                  scale(2, 3);
                  scale(1, 4);  // a barrier here
                  scale(3, 5);  // no further one: that barrier covers this, too
              }),
              1u);
}

TEST_F(Barriers, CopiesFillsAndUploadsCountAsWritesAndReads) {
    const std::uint32_t value = 5;
    EXPECT_EQ(count([&] {
                  device.commands().fill(memories[0], 0, 4096, 1);
                  device.commands().copy(memories[0], 0, memories[1], 0, 4096);  // reads what was filled
                  device.commands().upload(memories[0], 0, bytes_of(value));     // writes what was copied from
                  scale(0, 2);                                                   // reads what was uploaded
                  device.commands().upload(memories[1], 0, bytes_of(value));     // barriers after the copy cover this
              }),
              3u);
}

TEST_F(Barriers, DeviceValuesAreReads) {
    const ScaleParameters block = {256, 1.0f};
    const glift::Patch patch = {{memories[0], 0}, 0};
    EXPECT_EQ(count([&] {
                  store(0);
                  device.commands().dispatch(kernels::scale, {.form = glift::FormName::general,
                                                              .memories = {memories + 1, 2},
                                                              .parameters = bytes_of(block),
                                                              .size = {256, 1, 1, 1},
                                                              .patches = {&patch, 1}});
              }),
              2u);  // one before the parameters are made from the value, one after
}

TEST_F(Barriers, NothingWaitsForTheHost) {
    device.wait();
    const auto before = device.statistics();
    for (int k = 0; k < 3000; ++k) run_add(device, memories[0], 256, 1);
    EXPECT_EQ(device.statistics().waits, before.waits);
    EXPECT_LE(device.statistics().submissions, before.submissions + 6);
}

}  // namespace
