// Whether a graphics card may draw, decided from folders that stand for /dev.

#include "gpu/context/hardware.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>

namespace glibra::gpu {
namespace {

namespace fs = std::filesystem;

class Hardware : public testing::Test {
  protected:
    Hardware() {
        char name[] = "/tmp/glibra-dev-XXXXXX";
        folder = ::mkdtemp(name);
        fs::create_directory(folder / "dri");
        ::unsetenv("LIBGL_ALWAYS_SOFTWARE");
    }
    ~Hardware() override {
        ::unsetenv("LIBGL_ALWAYS_SOFTWARE");
        fs::remove_all(folder);
    }
    void add(const std::string& device) const { std::ofstream(folder / device) << ' '; }

    fs::path folder;
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
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "True", 1);
    EXPECT_FALSE(mayUseHardware(Driver::automatic, folder));
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "0", 1);
    EXPECT_TRUE(mayUseHardware(Driver::automatic, folder));
}

TEST_F(Hardware, OfNvidiaDoesNotListenToMesa) {
    add("nvidiactl");
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    EXPECT_TRUE(mayUseHardware(Driver::automatic, folder));
}

}  // namespace
}  // namespace glibra::gpu
