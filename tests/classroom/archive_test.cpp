// Zip files of strangers: what is unpacked, and what is not.

#include "classroom/unpack.h"

#include <gtest/gtest.h>
#include <minizip/zip.h>

#include <algorithm>
#include <map>
#include <vector>

#include "../suite/folder.h"
#include "classroom/submissions.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

/// Adds an entry; `attributes` are those of Unix in the upper half.
void addEntry(zipFile file, const std::string& name, std::string_view text, unsigned long attributes = 0,
              unsigned long flags = 0) {
    zip_fileinfo info{};
    info.external_fa = attributes;
    constexpr unsigned long kMadeByUnix = 3UL << 8U;
    ASSERT_EQ(
        zipOpenNewFileInZip4(file, name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED, 9, 0,
                             -MAX_WBITS, DEF_MEM_LEVEL, Z_DEFAULT_STRATEGY, nullptr, 0, kMadeByUnix, flags),
        ZIP_OK);
    ASSERT_EQ(zipWriteInFileInZip(file, text.data(), static_cast<unsigned>(text.size())), ZIP_OK);
    ASSERT_EQ(zipCloseFileInZip(file), ZIP_OK);
}

void writeZip(const fs::path& path, const std::map<std::string, std::string>& files) {
    fs::create_directories(path.parent_path());
    zipFile file = zipOpen64(path.c_str(), APPEND_STATUS_CREATE);
    ASSERT_TRUE(file);
    for (const auto& [name, text] : files) addEntry(file, name, text);
    ASSERT_EQ(zipClose(file, nullptr), ZIP_OK);
}

class ArchiveTest : public testing::Test {
  protected:
    void SetUp() override { fs::create_directories(to); }
    [[nodiscard]] std::string unpacked(UnpackLimits limits = {}) const {
        return unpackArchive(made / "a.zip", to, limits);
    }
    suite::Folder made;
    const fs::path to = made / "below/to";
};

TEST_F(ArchiveTest, FilesAndFoldersComeOut) {
    writeZip(made / "a.zip",
             {{"p/a.glib", "Sphere\n"}, {"p\\shaders\\a.frag", "void main() {}\n"}, {"empty.txt", ""}});
    EXPECT_EQ(unpacked(), "");
    EXPECT_EQ(suite::textOf(to / "p/a.glib"), "Sphere\n");
    EXPECT_EQ(suite::textOf(to / "p/shaders/a.frag"), "void main() {}\n");
    EXPECT_TRUE(fs::exists(to / "empty.txt"));
}

TEST_F(ArchiveTest, NamesAreOfTheCodePageOfZipFilesUnlessTheyAreUtf8) {
    writeZip(made / "a.zip", {{"\x9a"
                               "bung.frag",
                               "of code page 437"},
                              {"\xe1\xff/a.frag", "its last characters"},
                              {"\xC3\x84.frag", "UTF-8 without the flag for it"}});
    EXPECT_EQ(unpacked(), "");
    EXPECT_EQ(suite::textOf(to / "\xC3\x9C"
                                 "bung.frag"),
              "of code page 437");
    EXPECT_EQ(suite::textOf(to / "\xC3\x9F\xC2\xA0/a.frag"), "its last characters");
    EXPECT_EQ(suite::textOf(to / "\xC3\x84.frag"), "UTF-8 without the flag for it");
}

TEST_F(ArchiveTest, NothingComesOutBesideTheFolder) {
    zipFile file = zipOpen64((made / "a.zip").c_str(), APPEND_STATUS_CREATE);
    for (const char* each : {"../out.txt", "x/../../out.txt", "/tmp/glibra-out.txt", "..\\out.txt",
                             ".hidden/out.txt", "__MACOSX/out.txt", "x/.ssh/out.txt"})
        addEntry(file, each, "out");
    addEntry(file, "link", "../../secret", 0120777UL << 16U);
    addEntry(file, "link/in.txt", "in");
    addEntry(file, "good.glib", "Sphere\n");
    ASSERT_EQ(zipClose(file, nullptr), ZIP_OK);
    EXPECT_EQ(unpacked(), "");
    std::vector<std::string> all;
    for (const fs::directory_entry& each : fs::recursive_directory_iterator(made / "below"))
        if (!each.is_directory()) all.push_back(each.path().lexically_relative(to).string());
    std::ranges::sort(all);
    EXPECT_EQ(all, (std::vector<std::string>{"good.glib", "link/in.txt"}));
    EXPECT_FALSE(fs::exists(made / "out.txt"));
}

TEST_F(ArchiveTest, BombsEndAtTheLimits) {
    writeZip(made / "a.zip", {{"a.glib", std::string(std::size_t{5} << 20U, ' ')}});
    EXPECT_LT(fs::file_size(made / "a.zip"), 20'000U);
    EXPECT_EQ(unpacked({.bytes = 1U << 20U}), "the zip file unpacks to more than 1 MB");
    EXPECT_LE(fs::file_size(to / "a.glib"), 1U << 20U);
    fs::remove(made / "a.zip");
    std::map<std::string, std::string> many;
    for (int i = 0; i < 30; ++i) many[std::to_string(i)] = "x";
    writeZip(made / "a.zip", many);
    EXPECT_EQ(unpacked({.entries = 20}), "the zip file has more than 20 files and folders");
    EXPECT_EQ(unpacked({.entries = 30}), "");
    // Few files may make many folders.
    many.clear();
    for (int i = 0; i < 10; ++i) {
        std::string path;
        for (int depth = 0; depth < 20; ++depth) path += std::to_string(i) + "/";
        many[path + "a"] = "";
    }
    fs::remove(made / "a.zip");
    writeZip(made / "a.zip", many);
    EXPECT_EQ(unpacked({.entries = 100}), "the zip file has more than 100 files and folders");
    EXPECT_EQ(unpacked({.entries = 210}), "");
}

TEST_F(ArchiveTest, OneFolderOfManyFilesCountsOnce) {
    std::map<std::string, std::string> many;
    for (int i = 0; i < 30; ++i) many["a/b/" + std::to_string(i)] = "x";
    writeZip(made / "a.zip", many);
    EXPECT_EQ(unpacked({.entries = 32}), "");
    EXPECT_NE(unpacked({.entries = 31}), "");
}

TEST_F(ArchiveTest, DamagedFilesAreNamed) {
    suite::writeText(made / "a.zip", "no zip file");
    EXPECT_EQ(unpacked(), "'a.zip' is no zip file");
    fs::remove(made / "a.zip");
    std::string noise;
    for (unsigned i = 0, x = 1; i < 4000; ++i)
        noise += static_cast<char>((x = x * 1664525 + 1013904223) >> 24);
    writeZip(made / "a.zip", {{"a.glib", noise}});
    const std::string whole = suite::textOf(made / "a.zip");
    std::string damaged = whole;
    damaged[2000] = static_cast<char>(damaged[2000] ^ 0x55);
    suite::writeText(made / "a.zip", damaged);
    EXPECT_NE(unpacked().find("damaged"), std::string::npos);
    // Every truncated or changed file ends in a message or in files, never in a crash.
    for (std::size_t i = 0; i < whole.size(); i += 97) {
        suite::writeText(made / "a.zip", whole.substr(0, i));
        EXPECT_NE(unpacked(), "");
        damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 0xFF);
        suite::writeText(made / "a.zip", damaged);
        (void)unpacked();
    }
}

TEST_F(ArchiveTest, FilesThatArePackedInAnotherWayAreNamed) {
    writeZip(made / "a.zip", {{"p/a.glib", "Sphere\nSphere\n"}});
    const std::string whole = suite::textOf(made / "a.zip");
    const std::size_t central = whole.find("PK\1\2");
    ASSERT_NE(central, std::string::npos);
    // shrunk, reduced, imploded, deflate64, bzip2, LZMA, Zstandard, xz, ...; 0 and 8 are read
    for (int method = 1; method < 100; ++method) {
        if (method == Z_DEFLATED) continue;
        std::string other = whole;
        other[8] = other[central + 10] = static_cast<char>(method);
        suite::writeText(made / "a.zip", other);
        EXPECT_EQ(unpacked(), "'a.glib' in the zip file is packed in a way that is not known") << method;
        EXPECT_FALSE(fs::exists(to / "p/a.glib")) << method;
    }
}

class UnpackTest : public testing::Test {
  protected:
    Submissions find(const std::string& rule = {}) {
        options = {};
        if (!rule.empty()) options.names = *NameRule::of(rule);
        Result<Submissions> found = findSubmissions(made / "all", options);
        EXPECT_TRUE(found);
        if (!found) return {};
        EXPECT_TRUE(unpackSubmissions(*found, options, {.site = made / "site", .ofClass = ofClass}).empty());
        return std::move(*found);
    }
    suite::Folder made;
    SubmissionOptions options;
    UnpackLimits ofClass = UnpackOptions{}.ofClass;
};

TEST_F(UnpackTest, AClassHasItsSumAndOneSubmissionItsOwnLimit) {
    std::string large;
    large.resize(90'000'000, ' ');
    for (int i = 0; i < 60; ++i)
        writeZip(made / "all" / (std::to_string(i) + ".zip"), {{"a.glib", i == 7 ? large : "Sphere\n"}});
    for (const Submission& each : find().all) EXPECT_EQ(each.problem, "") << each.name;
    // In the order of the names; one that does not fit takes nothing from those after it.
    fs::remove_all(made / "all");
    const char* const kText[] = {"Sphere # 17 bytes", "Sphere", "Sphere # 17 bytes", "Cone"};
    for (int i = 0; i < 4; ++i) writeZip(made / "all" / (std::to_string(i) + ".zip"), {{"a.glib", kText[i]}});
    for (const UnpackLimits& each : {UnpackLimits{30, 100}, UnpackLimits{100, 2}}) {
        ofClass = each;
        const Submissions found = find();
        ASSERT_EQ(found.all.size(), 4U);
        const bool isFull = each.entries < 4;
        for (std::size_t i = 0; i < 4; ++i) {
            const bool fits = isFull ? i < 2 : i != 2;
            EXPECT_EQ(found.all[i].problem.empty(), fits) << i << found.all[i].problem;
            EXPECT_EQ(fs::is_empty(made / "site/unpacked" / std::to_string(i)), !fits);
        }
    }
}

TEST_F(UnpackTest, NothingStaysOfOneThatReachesALimit) {
    zipFile file = zipOpen64((made / "ana.zip").c_str(), APPEND_STATUS_CREATE);
    for (int i = 0; i < 1'500; ++i) {
        std::string path;
        for (int depth = 0; depth < 20; ++depth) path += std::to_string(i) + "/";
        addEntry(file, (path + "a").c_str(), "");
    }
    ASSERT_EQ(zipClose(file, nullptr), ZIP_OK);
    fs::create_directory(made / "all");
    fs::rename(made / "ana.zip", made / "all/ana.zip");
    const Submissions found = find();
    ASSERT_EQ(found.all.size(), 1U);
    EXPECT_EQ(found.all[0].problem, "the zip file has more than 20000 files and folders");
    EXPECT_TRUE(fs::is_empty(made / "site/unpacked/ana"));
}

TEST_F(UnpackTest, AZipFileIsASubmissionAndSoIsTheOnlyOneOfAFolder) {
    writeZip(made / "all/ana.zip", {{"p/a.glib", "Sphere\n"}, {"p/a.frag", ""}});
    writeZip(made / "all/bob/hand-in.zip", {{"b.glib", "Sphere\n"}});
    writeZip(made / "all/cem.zip", {{"inner.zip", "PK"}, {"c.glib.txt", ""}});
    suite::writeText(made / "all/dora.zip", "nothing");
    const Submissions all = find();
    ASSERT_EQ(all.all.size(), 4U);
    EXPECT_EQ(all.all[0].scene, made / "site/unpacked/ana/p/a.glib");
    EXPECT_EQ(all.all[0].folder, made / "site/unpacked/ana");
    EXPECT_EQ(all.all[1].scene, made / "site/unpacked/bob/b.glib");
    EXPECT_NE(all.all[2].problem.find("'inner.zip', which is not unpacked"), std::string::npos)
        << all.all[2].problem;
    EXPECT_NE(all.all[2].problem.find("'c.glib.txt', which has another ending"), std::string::npos);
    EXPECT_EQ(all.all[3].problem, "'dora.zip' is no zip file");
    // A later run does not see what an earlier one has unpacked.
    fs::remove(made / "all/ana.zip");
    EXPECT_EQ(find().all.size(), 3U);
    EXPECT_FALSE(fs::exists(made / "site/unpacked/ana"));
}

TEST_F(UnpackTest, FilesOfOneStudentAreOneSubmission) {
    suite::writeText(made / "all/leeana_12_34_oval.glib", "Sphere\n");
    suite::writeText(made / "all/leeana_12_35_oval.frag", "f");
    suite::writeText(made / "all/raybob_LATE_13_36_b.glib", "Sphere\n");
    writeZip(made / "all/zoe_14_37_z.zip", {{"z.glib", "Sphere\n"}});
    const Submissions all = find("canvas");
    ASSERT_EQ(all.all.size(), 3U);
    EXPECT_EQ(all.all[0].name, "leeana");
    EXPECT_EQ(all.all[0].number, "12");
    EXPECT_EQ(all.all[0].scene, made / "site/unpacked/leeana/oval.glib");
    EXPECT_EQ(suite::textOf(made / "site/unpacked/leeana/oval.frag"), "f");
    EXPECT_TRUE(all.all[1].isLate);
    EXPECT_EQ(all.all[2].scene, made / "site/unpacked/zoe/z.glib");
}

TEST_F(UnpackTest, StudentsOfOneNameHaveTheirNumbersBesideIt) {
    suite::writeText(made / "all/Ana Lee_1_assignsubmission_file_/a.glib", "Sphere\n");
    suite::writeText(made / "all/Ana Lee_2_assignsubmission_file_/a.glib", "Sphere\n");
    suite::writeText(made / "all/Bob_3_assignsubmission_file_b.glib", "Sphere\n");
    const Submissions all = find("moodle");
    ASSERT_EQ(all.all.size(), 3U);
    EXPECT_EQ(all.all[0].name, "Ana Lee (1)");
    EXPECT_EQ(all.all[1].name, "Ana Lee (2)");
    EXPECT_EQ(all.all[2].name, "Bob");
    EXPECT_EQ(all.all[2].scene, made / "site/unpacked/Bob/b.glib");
}

TEST_F(UnpackTest, AFolderOfTheUserIsNotReplaced) {
    writeZip(made / "all/ana.zip", {{"a.glib", "Sphere\n"}});
    suite::writeText(made / "site/unpacked/mine.txt", "mine");
    Result<Submissions> found = findSubmissions(made / "all", {});
    ASSERT_TRUE(found);
    const Diagnostics problems = unpackSubmissions(*found, {}, {.site = made / "site"});
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].id, "file-E10");
    EXPECT_EQ(suite::textOf(made / "site/unpacked/mine.txt"), "mine");
}

}  // namespace
}  // namespace glibra::classroom
