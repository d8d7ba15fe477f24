// The cache of large noise textures: what is stored comes back, and nothing damaged ever does.

#include "noise/cache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "noise/checksum.h"
#include "noise/noise.h"

namespace glibra::noise {
namespace {

namespace fs = std::filesystem;

/// A threshold that leaves textures in the cache which a test makes quickly: 512 x 512 texels.
constexpr std::size_t kSmall = std::size_t{1} << 20;

TexelBytes asTexelBytes(const std::vector<std::uint8_t>& texels) {
    return {texels.begin(), texels.end()};
}
TexelBytes computed2(int n) {
    return asTexelBytes(noise2Texels(n));
}
TexelBytes computed3(int n) {
    return asTexelBytes(noise3Texels(n));
}

class NoiseCache : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "glibra-cache-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = name;
    }
    void TearDown() override { fs::remove_all(folder); }

    [[nodiscard]] fs::path onlyFile() const {
        fs::path found;
        for (const auto& entry : fs::directory_iterator(folder)) {
            EXPECT_TRUE(found.empty()) << "more than one file";
            found = entry.path();
        }
        return found;
    }

    fs::path folder;
};

void overwriteByte(const fs::path& path, std::streamoff at, char by) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(at, at < 0 ? std::ios::end : std::ios::beg);
    file.put(by);
}

TEST_F(NoiseCache, GivesBackWhatWasStored) {
    const auto texels = computed3(20);
    EXPECT_FALSE(loadTexels(folder, 3, 20));
    ASSERT_TRUE(storeTexels(folder, 3, 20, texels));
    EXPECT_EQ(loadTexels(folder, 3, 20), texels);
    EXPECT_FALSE(loadTexels(folder, 3, 21));
    EXPECT_FALSE(loadTexels(folder, 2, 20));
}

TEST_F(NoiseCache, LeavesOneFileAndNoTemporaryName) {
    ASSERT_TRUE(storeTexels(folder, 2, 30, computed2(30)));
    ASSERT_TRUE(storeTexels(folder, 2, 30, computed2(30)));
    EXPECT_EQ(onlyFile().extension(), ".texels");
}

TEST_F(NoiseCache, MakesItsFolder) {
    const auto texels = computed2(8);
    ASSERT_TRUE(storeTexels(folder / "a" / "b", 2, 8, texels));
    EXPECT_EQ(loadTexels(folder / "a" / "b", 2, 8), texels);
}

TEST_F(NoiseCache, RefusesAFileWithOneChangedByteAnywhere) {
    const auto texels = computed2(16);
    for (const std::streamoff at : {0, 9, 16, 21, 26, 40, 500, -1}) {
        ASSERT_TRUE(storeTexels(folder, 2, 16, texels));
        overwriteByte(onlyFile(), at, '\x01');
        EXPECT_FALSE(loadTexels(folder, 2, 16)) << at;
    }
}

TEST_F(NoiseCache, RefusesAFileOfAnotherLength) {
    ASSERT_TRUE(storeTexels(folder, 2, 16, computed2(16)));
    const fs::path file = onlyFile();
    const auto length = fs::file_size(file);
    fs::resize_file(file, length - 1);
    EXPECT_FALSE(loadTexels(folder, 2, 16));
    fs::resize_file(file, length + 1);
    EXPECT_FALSE(loadTexels(folder, 2, 16));
    fs::resize_file(file, 0);
    EXPECT_FALSE(loadTexels(folder, 2, 16));
}

TEST_F(NoiseCache, RefusesToStoreTexelsOfAnotherSize) {
    EXPECT_FALSE(storeTexels(folder, 3, 16, computed2(16)));
    EXPECT_FALSE(storeTexels(folder, 4, 16, computed2(16)));
    EXPECT_FALSE(storeTexels(folder, 2, 0, {}));
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(NoiseCache, AnUnusableFolderChangesNothing) {
    std::ofstream(folder / "file") << "not a folder";
    EXPECT_FALSE(storeTexels(folder / "file", 2, 8, computed2(8)));
    EXPECT_FALSE(loadTexels(folder / "file", 2, 8));
    EXPECT_EQ(cachedTexels(2, 512, folder / "file", kSmall), computed2(512));
    EXPECT_EQ(cachedTexels(2, 512, fs::path(), kSmall), computed2(512));
}

TEST_F(NoiseCache, SomethingElseUnderTheNameIsNotRead) {
    ASSERT_TRUE(storeTexels(folder, 2, 16, computed2(16)));
    const fs::path name = onlyFile();
    fs::remove(name);
    fs::create_directory(name);
    EXPECT_FALSE(loadTexels(folder, 2, 16));
    EXPECT_FALSE(storeTexels(folder, 2, 16, computed2(16)));
    EXPECT_EQ(onlyFile(), name);
}

TEST_F(NoiseCache, ReplacesADamagedFile) {
    const auto texels = cachedTexels(2, 512, folder, kSmall);
    const fs::path file = onlyFile();
    overwriteByte(file, 5000, '\x01');
    EXPECT_FALSE(loadTexels(folder, 2, 512));
    EXPECT_EQ(cachedTexels(2, 512, folder, kSmall), texels);
    EXPECT_EQ(loadTexels(folder, 2, 512), texels);
}

TEST_F(NoiseCache, IsUsedWhenWhole) {
    // A file that is consistent but holds other texels shows where they came from.
    TexelBytes marked = computed2(512);
    marked[0] = 3;
    ASSERT_TRUE(storeTexels(folder, 2, 512, marked));
    EXPECT_EQ(cachedTexels(2, 512, folder, kSmall), marked);
}

TEST_F(NoiseCache, SmallTexturesAreNotStored) {
    EXPECT_EQ(cachedTexels(3, 64, folder), computed3(64));
    EXPECT_EQ(cachedTexels(2, 511, folder, kSmall), computed2(511));
    EXPECT_TRUE(fs::is_empty(folder));
    EXPECT_TRUE(cachedTexels(3, 401, folder).empty());
    EXPECT_TRUE(cachedTexels(5, 64, folder).empty());
}

TEST_F(NoiseCache, FolderFollowsTheEnvironment) {
    ::setenv("XDG_CACHE_HOME", "/some/where", 1);
    EXPECT_EQ(cacheFolder(), "/some/where/glibra");
    ::setenv("XDG_CACHE_HOME", "relative", 1);
    ::setenv("HOME", "/home/reader", 1);
    EXPECT_EQ(cacheFolder(), "/home/reader/.cache/glibra");
    ::unsetenv("XDG_CACHE_HOME");
    ::unsetenv("HOME");
    EXPECT_TRUE(cacheFolder().empty());
}

TEST(NoiseChecksum, SeesEverySingleChangedBit) {
    std::vector<std::uint8_t> bytes(77);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 37);
    const auto whole = checksum(bytes);
    EXPECT_NE(whole, checksum(bytes, 1));
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ (1 << bit % 8));
        EXPECT_NE(checksum(bytes), whole) << bit;
        bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ (1 << bit % 8));
    }
    bytes.push_back(0);
    EXPECT_NE(checksum(bytes), whole);
}

}  // namespace
}  // namespace glibra::noise
