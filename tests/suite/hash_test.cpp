#include "suite/golden/hash_list.h"

#include <gtest/gtest.h>

#include "pictures.h"
#include "system/places.h"

namespace glibra::suite {
namespace {

// The value for no bytes and seed 0 in the self-test of xxHash (tests/sanity_test_vectors.h of 0.8).
TEST(Hash, IsThePublishedXxh3OfNoBytes) {
    EXPECT_EQ(toText(hashOf(std::span<const std::byte>{})), "99aa06d3014798d86001c324468d497f");
}

TEST(Hash, TextComesBack) {
    const Hash hash = hashOf(gradient());
    EXPECT_EQ(parseHash(toText(hash)), hash);
    for (const char* bad : {"", "0", "99aa06d3014798d86001c324468d497", "99aa06d3014798d86001c324468d497g",
                            "99aa06d3014798d8 6001c324468d497", "99aa06d3014798d86001c324468d497f0"})
        EXPECT_FALSE(parseHash(bad)) << bad;
}

TEST(Hash, EveryBitOfEveryPixelCounts) {
    const image::Image before = gradient();
    for (std::size_t i = 0; i < before.data.size(); i += 97) {
        image::Image after = before;
        after.data[i] ^= std::byte{1};
        EXPECT_NE(hashOf(after), hashOf(before)) << i;
    }
}

TEST(Hash, SameBytesInAnotherShapeAreAnotherPicture) {
    const image::Image wide{6, 2, 1, image::Component::u8, std::vector<std::byte>(12)};
    const image::Image tall{2, 6, 1, image::Component::u8, wide.data};
    const image::Image colored{2, 2, 3, image::Component::u8, wide.data};
    const image::Image deep{3, 2, 1, image::Component::u16, wide.data};
    EXPECT_NE(hashOf(wide), hashOf(tall));
    EXPECT_NE(hashOf(wide), hashOf(colored));
    EXPECT_NE(hashOf(wide), hashOf(deep));
}

TEST(DriverKey, HoldsWhatCanChangeABitAndNothingElse) {
    gpu::Capabilities software;
    software.family = "llvmpipe";
    software.isSoftware = true;
    software.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
    software.version = "4.5 Mesa 22.3.6";
    const std::string key = driverKey(software);
    EXPECT_TRUE(key.starts_with("llvmpipe (LLVM 15.0.6, 256 bits); 4.5 Mesa 22.3.6; ")) << key;
    system::setVariable("LP_NATIVE_VECTOR_WIDTH", "128", system::Replace::yes);
    EXPECT_NE(driverKey(software).find("; LP_NATIVE_VECTOR_WIDTH=128"), std::string::npos);
    system::removeVariable("LP_NATIVE_VECTOR_WIDTH");
    EXPECT_EQ(driverKey(software), key);

    gpu::Capabilities card = software;
    card.family = "nvidia";
    card.isSoftware = false;
    card.renderer = "NVIDIA H100";
    card.version = "4.6.0 NVIDIA 550\n";
    EXPECT_EQ(driverKey(card), "NVIDIA H100; 4.6.0 NVIDIA 550 ");
}

TEST(DriverKey, OsmesaTakesTheGoldensOfItsRasteriser) {
    EXPECT_EQ(variantsFor("osmesa-llvmpipe"), (std::vector<std::string>{"osmesa-llvmpipe", "llvmpipe"}));
    EXPECT_EQ(variantsFor("nvidia"), std::vector<std::string>{"nvidia"});
}

}  // namespace
}  // namespace glibra::suite
