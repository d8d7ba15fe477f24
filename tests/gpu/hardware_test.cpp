// Whether a graphics card may draw, decided from folders that stand for /dev.

#include "gpu/context/context.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "../support/new_folder.h"
#include "system/places.h"
#include "unset_variable.h"

namespace glibra::gpu {
namespace {

namespace fs = std::filesystem;

class Hardware : public testing::Test {
  protected:
    Hardware() {
        folder = glibra::test::newFolder("dev");
        fs::create_directory(folder / "dri");
    }
    ~Hardware() override { fs::remove_all(folder); }
    static void setSoftware(const char* value) {
        system::setVariable("LIBGL_ALWAYS_SOFTWARE", value, system::Replace::yes);
    }
    void add(const std::string& device) const { std::ofstream(folder / device) << ' '; }

    fs::path folder;
    test::UnsetVariable software{"LIBGL_ALWAYS_SOFTWARE"};
};

TEST_F(Hardware, IsNowhereWithoutADevice) {
    EXPECT_FALSE(mayUseHardware(Driver::automatic, folder));
    EXPECT_FALSE(mayUseHardware(Driver::automatic, folder / "none"));
    add("dri/card0");
    EXPECT_FALSE(mayUseHardware(Driver::egl, folder)) << "a card without a node for rendering";
}

TEST_F(Hardware, IsARenderNodeUnlessMesaIsToldOtherwise) {
    add("dri/renderD128");
    EXPECT_TRUE(mayUseHardware(Driver::automatic, folder));
    EXPECT_TRUE(mayUseHardware(Driver::eglDevice, folder));
    EXPECT_FALSE(mayUseHardware(Driver::osmesa, folder)) << "it always draws on the processor";
    setSoftware("True");
    EXPECT_FALSE(mayUseHardware(Driver::automatic, folder));
    setSoftware("0");
    EXPECT_TRUE(mayUseHardware(Driver::automatic, folder));
}

TEST_F(Hardware, OfNvidiaDoesNotListenToMesa) {
    add("nvidiactl");
    setSoftware("1");
    EXPECT_TRUE(mayUseHardware(Driver::automatic, folder));
}

TEST_F(Hardware, ThatTheProcessorsAreHasOneWorkerForEach) {
    for (const int processors : {1, 2, 16, 256})
        for (const std::size_t pieces : {0U, 1U, 4U, 131U, 5000U})
            EXPECT_EQ(usualWorkers(Driver::automatic, pieces, processors, folder), processors);
    EXPECT_EQ(usualWorkers(Driver::automatic, 9, 0, folder), 1);
    add("dri/renderD128");
    EXPECT_EQ(usualWorkers(Driver::osmesa, 131, 16, folder), 16);
    setSoftware("1");
    EXPECT_EQ(usualWorkers(Driver::automatic, 131, 16, folder), 16);
}

TEST_F(Hardware, HasFewWorkersBecauseEachPaysForAContext) {
    add("nvidiactl");
    const auto workers = [&](std::size_t pieces, int processors) {
        return usualWorkers(Driver::automatic, pieces, processors, folder);
    };
    EXPECT_EQ(workers(0, 16), 1);
    EXPECT_EQ(workers(1, 16), 1);
    EXPECT_EQ(workers(8, 16), 1);
    EXPECT_EQ(workers(16, 16), 2);
    EXPECT_EQ(workers(36, 16), 3);
    EXPECT_EQ(workers(131, 16), 4);
    EXPECT_EQ(workers(100000, 256), 4);
    EXPECT_EQ(workers(131, 2), 2);
    EXPECT_EQ(workers(131, 1), 1);
    // What the measured costs predict is at most a tenth above the best number of workers up to four.
    const auto seconds = [](std::size_t pieces, int count) {
        return .092 * count + .023 * static_cast<double>(pieces) / count;
    };
    for (std::size_t pieces = 1; pieces < 600; ++pieces)
        for (int count = 1; count <= 4; ++count)
            EXPECT_LT(seconds(pieces, workers(pieces, 16)), 1.1 * seconds(pieces, count)) << pieces;
}

}  // namespace
}  // namespace glibra::gpu
