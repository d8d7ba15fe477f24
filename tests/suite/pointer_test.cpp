// Goldens whose files are pointers: their texts, where their pictures are found, and verdicts by their
// hashes.

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "base/files.h"
#include "base/hash.h"
#include "folder.h"
#include "image/read.h"
#include "pictures.h"
#include "suite/file/shot_name.h"
#include "suite/file/suite_file.h"
#include "suite/golden/golden_store.h"
#include "suite/golden/orphans.h"
#include "suite/golden/picture_store.h"
#include "suite/run/verdict.h"
#include "system/places.h"

namespace glibra::suite {
namespace {

std::optional<Pointer> parsed(const std::string& text) {
    return parsePointer(std::as_bytes(std::span(text)));
}

const std::string kHash(64, 'a');
const std::string kHead = "version https://git-lfs.github.com/spec/v1\n";

TEST(Pointer, IsReadAsGitLfsWritesIt) {
    // The example of the specification of Git LFS.
    const auto pointer = parsed(
        kHead + "oid sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393\nsize 12345\n");
    ASSERT_TRUE(pointer);
    EXPECT_EQ(pointer->sha256, "4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393");
    EXPECT_EQ(pointer->size, 12345U);
    EXPECT_EQ(parsed(toText(*pointer)), pointer);
    EXPECT_TRUE(parsed(kHead + "ext-0-foo sha256:" + kHash + "\noid sha256:" + kHash + "\nsize 1\n"));
    EXPECT_TRUE(
        parsed("version https://git-lfs.github.com/spec/v1\r\noid sha256:" + kHash + "\r\nsize 1\r\n"));
}

TEST(Pointer, IsNothingElse) {
    for (const std::string& text :
         {std::string(), kHead, kHead + "size 1\n", kHead + "oid sha256:" + kHash + "\n",
          kHead + "oid sha256:" + std::string(63, 'a') + "\nsize 1\n",
          kHead + "oid sha256:" + std::string(64, 'G') + "\nsize 1\n",
          kHead + "oid sha256:../../../../etc/passwd\nsize 1\n",
          kHead + "oid sha256:" + kHash + "\nsize -1\n", kHead + "oid sha256:" + kHash + "\nsize 1x\n",
          kHead + "oid sha256:" + kHash + "\nsize 0\n",
          kHead + "oid sha256:" + kHash + "\nsize 99999999999999999999\n",
          kHead + "oid sha256:" + kHash + "\nsize 1\n" + std::string(2000, '\n'), png(3)})
        EXPECT_FALSE(parsed(text)) << text.substr(0, 200);
}

TEST(StoreName, IsAFolderOrAnAddressOfOneFilePerHash) {
    for (const char* good :
         {"../pictures", "/mnt/pictures", "pictures", "https://a.example/{hash}.png",
          "http://127.0.0.1:8000/b/c/{hash}", "https://a.example/api/v4/x%20y/g-{hash}.png"})
        EXPECT_EQ(whyNoStore(good), "") << good;
    for (const char* bad :
         {"https://a.example/goldens", "https://a.example/{hash}/picture.png",
          "https://a.example/{hash}{hash}", "https://{hash}.example", "s3://bucket/{hash}.png",
          "file:///etc/{hash}", "ftp://a.example/{hash}", "oci://a.example/{hash}", "pictures/{hash}.png",
          "https://a.example/{hash}.png?x=1", "https://user:word@a.example/{hash}",
          "https://a.example/[1-9]{hash}", "https://a.example/{a,b}/{hash}", "https://a.example/{hash} -o x",
          "https://a.example/{hash}\n", "gopher://a/{hash}", "://{hash}"})
        EXPECT_NE(whyNoStore(bad), "") << bad;
}

class Pointers : public testing::Test {
  protected:
    Pointers() {
        suite.name = "s";
        suite.file = folder / "s.toml";
        suite.goldens = folder / "goldens";
        for (const char* each : kCaches) {
            if (const char* value = std::getenv(each)) before_[each] = value;
            system::setVariable(each, (folder / "cache").generic_string(), system::Replace::yes);
        }
    }
    ~Pointers() override {
        for (const char* each : kCaches)
            if (before_.contains(each))
                system::setVariable(each, before_[each], system::Replace::yes);
            else
                system::removeVariable(each);
    }
    Judged decide(const image::Image& image, JudgeOptions options = {}) {
        options.results = folder / "results";
        store = *GoldenStore::open(suite, {}, false, folder / "results/upload");
        const ShotJudge judge(suite, store, "llvmpipe", "key", options);
        const Attempt attempt = attemptAt(shot, image);
        if (std::optional<Judged> first = judge.first(attempt)) return *first;
        return judge.second(attempt, attempt);
    }
    ShotResult update(const image::Image& image, JudgeOptions options = {}) {
        options.update = true;
        const Judged judged = decide(image, options);
        if (judged.accepted) {
            EXPECT_TRUE(acceptHashes(store.hashFile(), std::vector{*judged.accepted}).empty());
        }
        return judged.result;
    }
    /// Makes the golden's file a pointer to its picture, and returns the bytes of the picture.
    std::string point(const std::string& file = "goldens/a.png") const {
        const std::string bytes = textOf(folder / file);
        writeText(folder / file, toText(pointerTo(std::as_bytes(std::span(bytes)))));
        return bytes;
    }

    Folder folder;
    Suite suite;
    GoldenStore store = *GoldenStore::open(suite);
    Shot shot = shotNamed("a");

  private:
    static constexpr const char* kCaches[] = {"XDG_CACHE_HOME", "LOCALAPPDATA"};
    std::map<std::string, std::string> before_;
};

TEST_F(Pointers, PassExactlyThePictureWhoseHashTheyState) {
    update(gradient());
    const std::string picture = point();
    const ShotResult passed = decide(gradient()).result;
    EXPECT_EQ(passed.verdict, Verdict::passed) << passed.reason;
    EXPECT_TRUE(passed.exact);
    EXPECT_TRUE(passed.expected.empty()) << "a pointer is nothing to show";
    EXPECT_TRUE(passed.awaits.empty());
    // A difference that the tolerance passes cannot be seen without the picture.
    image::Image other = gradient();
    other.data[40] ^= std::byte{1};
    const ShotResult asked = decide(other).result;
    EXPECT_EQ(asked.verdict, Verdict::failed);
    EXPECT_NE(asked.reason.find("git lfs pull --include"), std::string::npos) << asked.reason;
    ASSERT_EQ(asked.awaits.size(), 1U);
    EXPECT_EQ(asked.awaits.front(), folder / "goldens/a.png");
    EXPECT_FALSE(asked.awaitsStore);
    EXPECT_FALSE(asked.got.empty());
    writeText(folder / "goldens/a.png", picture);
    EXPECT_EQ(decide(other).result.verdict, Verdict::passed);
}

/// The list of hashes is the same whether the pictures are there or not.
TEST_F(Pointers, LeaveTheListOfHashesAsItIs) {
    update(gradient());
    const std::string list = textOf(folder / "goldens/s.hashes");
    point();
    EXPECT_EQ(update(gradient()).verdict, Verdict::passed);
    EXPECT_EQ(textOf(folder / "goldens/s.hashes"), list);
}

TEST_F(Pointers, UpdateKeepsOneWhosePictureIsNotThere) {
    update(gradient());
    point();
    const std::string before = textOf(folder / "goldens/a.png");
    const ShotResult kept = update(gradient(40));
    EXPECT_EQ(kept.verdict, Verdict::refused);
    EXPECT_EQ(kept.awaits.size(), 1U);
    EXPECT_EQ(textOf(folder / "goldens/a.png"), before);
    EXPECT_EQ(update(gradient(40), {.replaceUnreadable = true}).verdict, Verdict::updated);
}

/// A picture of the family that is not there is not needed if the golden for all drivers is the picture.
TEST_F(Pointers, AreAskedForOnlyIfNoOtherGoldenPasses) {
    update(gradient());
    update(gradient(40), {.variant = true});
    point("goldens/a.llvmpipe.png");
    const ShotResult passed = decide(gradient()).result;
    EXPECT_EQ(passed.verdict, Verdict::passed) << passed.reason;
    EXPECT_FALSE(hasError(passed.diagnostics));
    point();
    EXPECT_EQ(decide(gradient()).result.verdict, Verdict::passed);
    EXPECT_EQ(decide(gradient(40)).result.verdict, Verdict::passed);
    EXPECT_EQ(decide(gradient(80)).result.awaits.size(), 2U);
}

TEST_F(Pointers, OfAFolderLeadToItsPictures) {
    suite.store = (folder / "pictures").generic_string();
    EXPECT_EQ(update(gradient()).verdict, Verdict::updated);
    const auto pointer = parsed(textOf(folder / "goldens/a.png"));
    ASSERT_TRUE(pointer);
    const auto stored = folder / "pictures" / (pointer->sha256 + ".png");
    EXPECT_EQ(image::readImage(stored)->width, 32);
    EXPECT_EQ(decide(gradient()).result.verdict, Verdict::passed);
    const ShotResult failed = decide(gradient(40)).result;
    EXPECT_EQ(failed.verdict, Verdict::failed);
    EXPECT_FALSE(failed.difference.empty()) << "compared with the picture of the store";
    // A file that is not what its name says is no picture of the store.
    writeText(stored, png(7));
    const ShotResult wrong = decide(gradient(40)).result;
    EXPECT_NE(wrong.reason.find("missing or cannot be read"), std::string::npos) << wrong.reason;
    EXPECT_EQ(decide(gradient()).result.verdict, Verdict::passed) << "its hash suffices";
}

TEST_F(Pointers, OfAWebServerPutNewPicturesAmongTheUploads) {
    suite.store = "https://pictures.example/x/{hash}.png";
    EXPECT_EQ(update(gradient()).verdict, Verdict::updated);
    const auto pointer = parsed(textOf(folder / "goldens/a.png"));
    ASSERT_TRUE(pointer);
    const std::string bytes = textOf(folder / ("results/upload/" + pointer->sha256 + ".png"));
    EXPECT_EQ(base::sha256Text(std::as_bytes(std::span(bytes))), pointer->sha256);
    EXPECT_EQ(decide(gradient(40)).result.difference.empty(), false)
        << "the picture is among the downloads, too";
    std::filesystem::remove_all(folder / "cache");
    EXPECT_EQ(decide(gradient()).result.verdict, Verdict::passed);
    const ShotResult asked = decide(gradient(40)).result;
    EXPECT_TRUE(asked.awaitsStore);
    EXPECT_NE(asked.reason.find("https://pictures.example/x/" + pointer->sha256 + ".png"), std::string::npos)
        << asked.reason;
}

/// The name of a registry's blob begins with "sha256:", which Windows takes for a stream of another file.
TEST_F(Pointers, NameUploadsAsEverySystemTakesThem) {
    suite.store = "https://registry.example/v2/team/goldens/blobs/sha256:{hash}?ns=\"a*b\"";
    EXPECT_EQ(update(gradient()).verdict, Verdict::updated);
    const auto pointer = parsed(textOf(folder / "goldens/a.png"));
    ASSERT_TRUE(pointer);
    EXPECT_TRUE(std::filesystem::exists(folder / ("results/upload/sha256_" + pointer->sha256 + "_ns=_a_b_")));
}

/// A suite that gets a store moves its goldens there.
TEST_F(Pointers, TakeThePlaceOfPicturesWithUpdate) {
    update(gradient());
    const std::string picture = textOf(folder / "goldens/a.png");
    suite.store = (folder / "pictures").generic_string();
    EXPECT_EQ(decide(gradient()).result.verdict, Verdict::passed);
    EXPECT_EQ(textOf(folder / "goldens/a.png"), picture) << "a run moves nothing";
    image::Image other = gradient();
    other.data[40] ^= std::byte{1};
    EXPECT_EQ(update(other).verdict, Verdict::updated);
    const auto pointer = parsed(textOf(folder / "goldens/a.png"));
    ASSERT_TRUE(pointer);
    EXPECT_EQ(textOf(folder / "pictures" / (pointer->sha256 + ".png")), picture)
        << "the golden moves, not the drawing that it passes";
    EXPECT_EQ(update(other).verdict, Verdict::passed);
}

TEST_F(Pointers, AStoreOutsideOfTheSuiteIsNotWrittenWithoutAsking) {
    suite.store = (folder.path().parent_path() / "elsewhere").generic_string();
    const Diagnostics problems = checkGoldenFolder(suite);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems.front().id, "suite-E20");
    EXPECT_EQ(problems.front().text.rfind("store: ", 0), 0U);
}

TEST_F(Pointers, OfNoShotAreFoundByTheirHash) {
    update(gradient());
    point();
    const Orphans orphans({folder / "goldens/a.png"});
    EXPECT_EQ(orphans.find(gradient()), folder / "goldens/a.png");
    EXPECT_TRUE(orphans.find(gradient(40)).empty());
}

TEST(PullCommand, NamesAllPicturesFromTheRootOfTheRepository) {
    const Folder folder;
    std::filesystem::create_directories(folder / ".git");
    std::vector<std::filesystem::path> goldens{folder / "tests/golden/a.png",
                                               folder / "tests/golden/a@uC=1,0.5.png"};
    EXPECT_EQ(pullCommand(goldens),
              "git lfs pull --include 'tests/golden/a.png,tests/golden/a@uC=1?0.5.png'");
    for (int i = 0; i < 60; ++i) goldens.push_back(folder / ("tests/golden/x" + std::to_string(i) + ".png"));
    EXPECT_EQ(pullCommand(goldens), "git lfs pull --include tests/golden");
}

/// The line that a failure proposes is pasted into the suite: then the shot passes.
TEST(ToPass, IsALineThatTheSuiteReads) {
    const Folder folder;
    writeText(folder / "a.glib", "");
    const auto shotWith = [&](const std::string& line, const std::string& defaults = "") {
        const auto suite =
            readSuiteText(defaults + "[[shot]]\nscript = \"a.glib\"\n" + line + "\n", folder / "s.toml");
        EXPECT_TRUE(suite) << suite.message();
        return suite->shots.front();
    };
    image::Image other = gradient();
    for (int i = 0; i < 9; ++i) other.data[static_cast<std::size_t>(3 * (5 * 32 + 10 + i))] ^= std::byte{64};
    const struct {
        const char *defaults, *line;
    } cases[] = {{"", ""},
                 {"", "tolerance = { max = 12, line = 3 }"},
                 {"[defaults]\ntolerance = { max = 1, cluster = 2, bias = 0 }\n", ""},
                 {"[defaults]\ntolerance = { max = 1 }\n", "tolerance = { max = 3, bias = 0.01 }"}};
    for (const auto& each : cases) {
        Suite suite;
        suite.name = "s";
        suite.file = folder / "s.toml";
        suite.goldens = folder / "goldens";
        writeText(folder / "goldens/a.png", std::string(base::asText(image::encodePng(gradient()))));
        const auto result = [&](const Shot& shot) {
            const GoldenStore store = *GoldenStore::open(suite);
            const ShotJudge judge(suite, store, "llvmpipe", "key", {.results = folder / "results"});
            const Attempt attempt = attemptAt(shot, other);
            const std::optional<Judged> first = judge.first(attempt);
            return first ? first->result : judge.second(attempt, attempt).result;
        };
        const ShotResult failed = result(shotWith(each.line, each.defaults));
        ASSERT_EQ(failed.verdict, Verdict::failed) << each.line;
        ASSERT_FALSE(failed.toPass.empty()) << failed.noTolerance;
        EXPECT_EQ(result(shotWith(failed.toPass, each.defaults)).verdict, Verdict::passed) << failed.toPass;
        EXPECT_EQ(failed.steps.pixels, (std::vector<std::uint64_t>{9, 9, 9, 9, 9, 9}));
        EXPECT_TRUE(result(shotWith(failed.toPass, each.defaults)).toPass.empty());
    }
}

}  // namespace
}  // namespace glibra::suite
