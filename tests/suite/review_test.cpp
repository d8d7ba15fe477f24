// What a review accepts and rejects, as its page asks for it.

#include "suite/serve/review.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <span>

#include "folder.h"
#include "image/read.h"
#include "image/write.h"
#include "pictures.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

class Reviews : public testing::Test {
  protected:
    Reviews() {
        suite.name = "s";
        suite.file = folder / "s.toml";
        suite.goldens = folder / "goldens";
        suite.shots = {shotNamed("a")};
        ShotResult& failed = run.shots.emplace_back();
        failed.suite = "s";
        failed.shot = "a";
        failed.verdict = Verdict::failed;
        failed.script = "a.glib";
        failed.got = "s/a.got.png";
        failed.accept = "glibra test s.toml --only a --update";
        failed.acceptKey = "llvmpipe";
        fs::create_directories(folder / "results/s");
        EXPECT_TRUE(image::writeImage(gradient(40), folder / "results/s/a.got.png").empty());
    }
    void put(const image::Image& golden) {
        const GoldenStore store = *GoldenStore::open(suite);
        const Result<Golden> made = store.replace(suite.shots[0], "", golden);
        ASSERT_TRUE(made);
        const AcceptedHash line{"a", "", made->identity, hashOf(golden), "llvmpipe; another version"};
        ASSERT_TRUE(acceptHashes(store.hashFile(), {&line, 1}).empty());
    }
    void begin() { review.emplace(run, std::vector{suite}, ReviewOptions{.results = folder / "results"}); }
    std::string accept(const std::string& more = {}) {
        review->picture({{{"shot", "0"}, {"what", "got"}}, {}});
        review->see({{}, "{\"shots\": [0]}"});
        return review->accept({{}, "{\"shots\": [0]" + more + "}"}).body;
    }
    std::string reject() { return review->reject({{}, "{\"shots\": [0]}"}).body; }
    std::string golden() const { return textOf(folder / "goldens/a.png"); }
    std::string hashes() const { return textOf(folder / "goldens/s.hashes"); }

    Folder folder;
    Suite suite;
    RunResult run;
    std::optional<Review> review;
};

constexpr const char* kAccepted = "{\"accepted\":[0],\"refused\":[]}";
constexpr const char* kRejected = "{\"rejected\":[0],\"refused\":[]}";

TEST_F(Reviews, RejectingUndoesWhatWasAccepted) {
    put(gradient());
    const std::string oldGolden = golden(), oldHashes = hashes();
    begin();
    for (int round = 0; round < 2; ++round) {
        ASSERT_EQ(accept(), kAccepted);
        EXPECT_NE(golden(), oldGolden);
        EXPECT_NE(hashes(), oldHashes);
        EXPECT_EQ(reject(), kRejected);
        EXPECT_EQ(golden(), oldGolden);
        EXPECT_EQ(hashes(), oldHashes);
        EXPECT_EQ(review->decisionOf(0), "rejected");
    }
}

/// In a suite with a store, golden and line are pointers' before and after.
TEST_F(Reviews, RejectingRestoresThePointerOfAStore) {
    suite.store = (folder / "pictures").generic_string();
    put(gradient());
    const std::string oldGolden = golden(), oldHashes = hashes();
    EXPECT_TRUE(parsePointer(std::as_bytes(std::span(oldGolden))));
    begin();
    // Its folder may be away: whoever accepts has seen the golden in the report.
    fs::rename(folder / "pictures", folder / "away");
    ASSERT_EQ(accept(), kAccepted);
    const std::string newGolden = golden();
    EXPECT_TRUE(parsePointer(std::as_bytes(std::span(newGolden))));
    EXPECT_NE(newGolden, oldGolden);
    EXPECT_EQ(reject(), kRejected);
    EXPECT_EQ(golden(), oldGolden);
    EXPECT_EQ(hashes(), oldHashes);
}

/// --accept: by the names of shots, without a browser.
TEST_F(Reviews, AcceptsByName) {
    put(gradient());
    begin();
    for (const char* named : {"a", "s/a", "*", "s/*", "[a-c]"})
        EXPECT_TRUE(review->isNamed(0, std::vector<std::string>{"x", named})) << named;
    for (const char* other : {"b", "s", "t/a", "tag:a"})
        EXPECT_FALSE(review->isNamed(0, std::vector<std::string>{other})) << other;
    EXPECT_EQ(review->acceptUnseen(0), "");
    EXPECT_EQ(image::readImage(folder / "goldens/a.png")->data,
              image::readImage(folder / "results/s/a.got.png")->data);
    EXPECT_NE(hashes().find("\na - "), std::string::npos) << hashes();
    EXPECT_EQ(review->decisionOf(0), "accepted");
    EXPECT_EQ(review->acceptUnseen(0), "") << "once more changes nothing";
}

TEST_F(Reviews, AcceptsByNameNothingThatNeedsForce) {
    put(gradient());
    const std::string oldGolden = golden();
    EXPECT_TRUE(image::writeImage(oneColor(9), folder / "results/s/a.got.png").empty());
    begin();
    EXPECT_NE(review->acceptUnseen(0).find("one colour"), std::string::npos);
    run.shots[0].verdict = Verdict::unstable;
    begin();
    EXPECT_NE(review->acceptUnseen(0).find("drawings differ"), std::string::npos);
    EXPECT_EQ(golden(), oldGolden);
}

TEST_F(Reviews, RejectingRemovesAGoldenThatWasNotThereBefore) {
    run.shots[0].verdict = Verdict::missing;
    begin();
    ASSERT_EQ(accept(), kAccepted);
    EXPECT_EQ(reject(), kRejected);
    EXPECT_FALSE(fs::exists(folder / "goldens/a.png"));
    EXPECT_EQ(hashes().find("\na "), std::string::npos) << hashes();
}

TEST_F(Reviews, RejectingRemovesAPictureThatWasAcceptedBesides) {
    put(gradient());
    const std::string oldGolden = golden(), oldHashes = hashes();
    begin();
    ASSERT_EQ(accept(", \"also\": true"), kAccepted);
    EXPECT_TRUE(fs::exists(folder / "goldens/a.also1.png"));
    EXPECT_EQ(reject(), kRejected);
    EXPECT_FALSE(fs::exists(folder / "goldens/a.also1.png"));
    EXPECT_EQ(golden(), oldGolden);
    EXPECT_EQ(hashes(), oldHashes);
}

TEST_F(Reviews, RejectingSaysIfItCannotUndo) {
    put(gradient());
    begin();
    ASSERT_EQ(accept(), kAccepted);
    begin();
    EXPECT_NE(reject().find("accepted in an earlier review"), std::string::npos);
    EXPECT_EQ(review->decisionOf(0), "accepted") << "nothing has changed";
    put(gradient());
    begin();
    ASSERT_EQ(accept(), kAccepted);
    put(gradient(80));
    const std::string mine = golden();
    EXPECT_NE(reject().find("its golden has changed since"), std::string::npos);
    EXPECT_EQ(golden(), mine);
}

TEST_F(Reviews, WhatIsNotAcceptedIsRejected) {
    put(gradient());
    const std::string oldGolden = golden();
    begin();
    EXPECT_EQ(reject(), kRejected);
    EXPECT_EQ(golden(), oldGolden);
    EXPECT_EQ(review->reject({{}, "{\"shots\": [1]}"}).status, 400);
}

TEST_F(Reviews, ARepetitionCountsOnce) {
    begin();
    EXPECT_EQ(review->reject({{}, "{\"shots\": [0,0,0,0]}"}).body, kRejected);
}

/// Nobody has accepted that a golden goes of which the run has not seen the picture.
TEST_F(Reviews, AGoldenThatCannotBeReadOrIsAnotherDriversNeedsForce) {
    put(gradient());
    writeText(folder / "goldens/a.png", "version https://git-lfs.github.com/spec/v1\n");
    begin();
    EXPECT_NE(accept().find("git lfs pull"), std::string::npos);
    EXPECT_NE(golden().find("git-lfs"), std::string::npos) << "it is kept";
    put(gradient());
    run.shots[0].acceptKey = "NVIDIA GeForce RTX 3080/PCIe/SSE2; 4.6.0 NVIDIA 535.54";
    begin();
    const std::string refused = accept();
    EXPECT_NE(refused.find("drawn by llvmpipe, and this picture by nvidia; force accepts it"),
              std::string::npos)
        << refused;
    EXPECT_EQ(accept(", \"force\": true"), kAccepted);
}

TEST_F(Reviews, SaysThatItsFileIsDamaged) {
    begin();
    EXPECT_TRUE(review->problems().empty()) << "no review has decided anything";
    EXPECT_EQ(reject(), kRejected);
    begin();
    EXPECT_TRUE(review->problems().empty());
    EXPECT_EQ(review->decisionOf(0), "rejected");
    const fs::path file = folder / "results/review.json";
    for (const std::string& damaged : {std::string(), std::string("[]"), textOf(file).substr(0, 20)}) {
        writeText(file, damaged);
        begin();
        ASSERT_EQ(review->problems().size(), 1U) << damaged;
        EXPECT_EQ(review->problems()[0].id, "result-W02");
        EXPECT_NE(review->problems()[0].text.find("review.json"), std::string::npos);
        EXPECT_EQ(review->decisionOf(0), "");
    }
    fs::remove(file);
    fs::create_directory(file);
    begin();
    EXPECT_EQ(review->problems().size(), 1U) << "a folder is no file of decisions";
}

}  // namespace
}  // namespace glibra::suite
