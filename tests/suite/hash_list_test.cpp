#include "suite/golden/hash_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "folder.h"

namespace glibra::suite {
namespace {

AcceptedHash line(const std::string& shot, std::uint64_t golden, std::uint64_t pixels,
                  const std::string& key = "llvmpipe; 4.5", const std::string& variant = "") {
    return {shot, variant, {golden, 1}, {pixels, 2}, key};
}

TEST(HashList, LinesComeBack) {
    const AcceptedHash before = line("a/b@t=1", 7, 8, "llvmpipe (LLVM 15, 256 bits); 4.5  x", "llvmpipe");
    const Result<AcceptedHash> after = parseLine(toLine(before), {});
    ASSERT_TRUE(after);
    EXPECT_EQ(after->shot, before.shot);
    EXPECT_EQ(after->variant, before.variant);
    EXPECT_EQ(after->golden, before.golden);
    EXPECT_EQ(after->pixels, before.pixels);
    EXPECT_EQ(after->key, before.key);
}

TEST(HashList, AMissingFileIsEmpty) {
    const Folder folder;
    const Result<HashList> list = HashList::read(folder / "none.hashes");
    ASSERT_TRUE(list);
    EXPECT_TRUE(list.diagnostics.empty());
    EXPECT_EQ(list->find("a", "", {1, 1}, "k"), nullptr);
}

TEST(HashList, IsFoundOnlyWithItsGoldenVariantAndDriver) {
    HashList list;
    list.accept(std::vector{line("a", 1, 5, "k"), line("a", 1, 6, "other"), line("a", 2, 7, "k", "nvidia")});
    const Hash* found = list.find("a", "", {1, 1}, "k");
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->high, 5U);
    EXPECT_EQ(list.find("a", "", {9, 1}, "k"), nullptr) << "another golden stands there now";
    EXPECT_EQ(list.find("a", "", {1, 1}, "unknown"), nullptr);
    EXPECT_EQ(list.find("a", "nvidia", {1, 1}, "k"), nullptr);
    EXPECT_EQ(list.find("b", "", {1, 1}, "k"), nullptr);
}

TEST(HashList, ANewGoldenVoidsTheLinesOfTheOldOne) {
    HashList list;
    list.accept(std::vector{line("a", 1, 5, "k1"), line("a", 1, 6, "k2"), line("a", 1, 6, "k2", "nvidia")});
    list.accept(std::vector{line("a", 2, 9, "k1")});
    const std::string text = list.toText();
    EXPECT_EQ(list.find("a", "", {1, 1}, "k2"), nullptr);
    EXPECT_NE(list.find("a", "", {2, 1}, "k1"), nullptr);
    EXPECT_NE(list.find("a", "nvidia", {1, 1}, "k2"), nullptr) << "other variants stay";
    EXPECT_EQ(std::ranges::count(text, '\n'), 2 + 2) << text;
}

TEST(HashList, BrokenLinesAreReportedWithTheirNumberAndLeftOut) {
    const Folder folder;
    writeText(folder / "s.hashes", "# heading\n" + toLine(line("a", 1, 5)) +
                                       "\r\n<<<<<<< HEAD\nb - 00 00 k\n" + toLine(line("c", 1, 5)) + "\n" +
                                       toLine(line("a", 1, 5, "k", "x/../b")));
    const Result<HashList> list = HashList::read(folder / "s.hashes");
    ASSERT_TRUE(list);
    ASSERT_EQ(list.diagnostics.size(), 3U);
    EXPECT_EQ(list.diagnostics[2].place.line, 6) << "no golden has such a variant";
    EXPECT_EQ(list.diagnostics[0].id, "suite-W01");
    EXPECT_EQ(list.diagnostics[0].place.line, 3);
    EXPECT_EQ(list.diagnostics[1].place.line, 4);
    EXPECT_NE(list->find("a", "", {1, 1}, "llvmpipe; 4.5"), nullptr);
    EXPECT_NE(list->find("c", "", {1, 1}, "llvmpipe; 4.5"), nullptr);
}

TEST(HashList, WritersAtTheSameTimeLoseNothing) {
    const Folder folder;
    const std::filesystem::path file = folder / "s.hashes";
    constexpr int kWriters = 8;
    constexpr int kRounds = 12;
    std::vector<std::thread> writers;
    for (int w = 0; w < kWriters; ++w)
        writers.emplace_back([&, w] {
            for (int i = 0; i < kRounds; ++i) {
                const std::vector<AcceptedHash> one{
                    line("s" + std::to_string(w) + "." + std::to_string(i), 1, 5)};
                EXPECT_TRUE(acceptHashes(file, one).empty());
            }
        });
    for (std::thread& each : writers) each.join();
    const Result<HashList> list = HashList::read(file);
    for (int w = 0; w < kWriters; ++w)
        for (int i = 0; i < kRounds; ++i)
            EXPECT_NE(
                list->find("s" + std::to_string(w) + "." + std::to_string(i), "", {1, 1}, "llvmpipe; 4.5"),
                nullptr);
}

TEST(HashList, NothingNewLeavesTheFileAlone) {
    const Folder folder;
    const std::filesystem::path file = folder / "s.hashes";
    ASSERT_TRUE(acceptHashes(file, std::vector{line("a", 1, 5)}).empty());
    const auto before = std::filesystem::last_write_time(file);
    ASSERT_TRUE(acceptHashes(file, std::vector{line("a", 1, 5)}).empty());
    EXPECT_EQ(std::filesystem::last_write_time(file), before);
}

}  // namespace
}  // namespace glibra::suite
