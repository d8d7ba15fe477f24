// Results of somebody else: whatever a results file and its folder hold, a merge and a report show no byte of
// a file outside of their roots, and nothing outside of their output folders is written, changed or removed.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <map>
#include <random>

#include "folder.h"
#include "pictures.h"
#include "results_maker.h"
#include "suite/report/report_files.h"
#include "suite/report/terminal_report.h"
#include "suite/results/merge.h"
#include "suite/results/results_file.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

const std::string kSecret = "TOP-SECRET-0f3c9a41";

/// All files below a folder with their contents; links with their targets.
std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> all;
    for (const auto& each : fs::recursive_directory_iterator(folder)) {
        const std::string name = each.path().string();
        if (each.is_symlink())
            all[name] = "link " + fs::read_symlink(each.path()).string();
        else if (each.is_regular_file())
            all[name] = textOf(each.path());
        else
            all[name] = "other";
    }
    return all;
}

/// A place with secrets, a project that may be shown, and the folder of a hostile run.
class Hostile : public testing::Test {
  protected:
    Hostile() {
        secretPicture = png(77);
        writeText(folder / "outside/secret.txt", kSecret + "\nSphere 1\n");
        writeText(folder / "outside/secret.png", secretPicture);
        writeText(folder / "project/scene.glib", "Sphere 1\n");
        writeText(folder / "project/.git/config", kSecret);
        fs::create_symlink(folder / "outside/secret.txt", folder / "project/link.glib");
        roots.texts.add(folder / "project");
        roots.pictures.add(folder / "project");

        const fs::path run = folder / "run";
        writeText(run / "s/a.got.png", png(1));
        writeText(run / "s/b.got.png", png(2).substr(0, 50));
        writeText(run / "evil.sh", "#!/bin/sh\n");
        writeText(run / ".git/hooks/post-checkout", "#!/bin/sh\n");
        fs::create_symlink(folder / "outside/secret.png", run / "s/link.png");
        fs::create_symlink(folder / "outside/secret.txt", run / "s/text.glib");
        fs::create_directory_symlink(folder / "outside", run / "up");
        fs::create_directories(run / "s/folder.png");
        ::mkfifo((run / "s/pipe.png").c_str(), 0600);
        std::error_code ignored;
        writeText(run / "s/huge.png", png(3));
        fs::resize_file(run / "s/huge.png", 3ULL << 30, ignored);  // a sparse file
    }

    fs::path path(std::mt19937& random) const {
        const fs::path outside = folder / "outside";
        const std::vector<fs::path> known{
            "s/a.got.png",
            "s/b.got.png",
            "evil.sh",
            ".git/hooks/post-checkout",
            "s/link.png",
            "s/text.glib",
            "up/secret.png",
            "up/secret.txt",
            "s/folder.png",
            "s/pipe.png",
            "s/huge.png",
            "../outside/secret.png",
            "../outside/secret.txt",
            "s/../../outside/secret.txt",
            outside / "secret.png",
            outside / "secret.txt",
            "/etc/passwd",
            "/dev/zero",
            "/dev/stdin",
            "/proc/self/environ",
            folder / "project/scene.glib",
            folder / "project/link.glib",
            folder / "project/.git/config",
            folder / "project/../outside/secret.txt",
            "results.jsonl",
            "",
            "/",
            "..",
            std::string("s/a\0.png", 8),
            "s/\x1b]0;x\x07.png",
            std::string(5000, 'a'),
        };
        std::string text = known[random() % known.size()].string();
        while (random() % 3 == 0) {
            const std::size_t at = random() % (text.size() + 1);
            const char* const pieces[] = {"../", "/", "./", "//", "\\", "\n", "%2e%2e/", "s/", "up/"};
            text.insert(at, pieces[random() % std::size(pieces)]);
        }
        return text;
    }

    RunResult hostile(std::mt19937& random) const {
        ResultsMaker maker(static_cast<unsigned>(random()));
        RunResult run = maker.run();
        run.planned.emplace();
        for (int i = 0; i < 12; ++i) {
            ShotResult shot = maker.shot();
            if (random() % 2 == 0) shot.suite = "s";
            shot.shot += std::to_string(i);
            shot.got = path(random);
            shot.expected = path(random);
            shot.difference = path(random);
            shot.script = path(random);
            for (Diagnostic& each : shot.diagnostics) each.place.file = path(random).string();
            shot.diagnostics.push_back(diagnose("glib-E01", "x", {path(random).string(), 1, 1}));
            run.planned->push_back({shot.suite, {shot.shot}});
            run.shots.push_back(std::move(shot));
        }
        return run;
    }

    /// No file below these folders holds a secret.
    void expectNoSecrets(std::initializer_list<fs::path> outputs) const {
        for (const fs::path& output : outputs)
            for (const auto& [name, text] : contents(output)) {
                EXPECT_EQ(text.find(kSecret), std::string::npos) << name;
                EXPECT_NE(text, secretPicture) << name;
                EXPECT_NE(text.substr(0, 5), "link ") << name;
            }
    }

    Folder folder;
    std::string secretPicture;
    ReportRoots roots;
};

TEST_F(Hostile, NoMergeAndNoReportHoldsWhatLiesOutsideOfItsRoots) {
    const auto outside = contents(folder / "outside"), project = contents(folder / "project");
    std::mt19937 random(21);
    for (int i = 0; i < 60; ++i) {
        const RunResult run = hostile(random);
        ASSERT_TRUE(writeResults(run, folder / "run").empty());
        const fs::path into = folder / "into", report = folder / "report", direct = folder / "direct";
        const std::vector<fs::path> folders{folder / "run"};
        const Result<RunResult> merged = mergeResults(folders, into);
        ASSERT_TRUE(merged) << i << toString(merged.diagnostics.front());
        ASSERT_EQ(merged->shots.size(), run.shots.size());
        for (const ShotResult& shot : merged->shots)
            for (const fs::path& each : {shot.got, shot.expected, shot.difference})
                EXPECT_TRUE(each.empty() || *each.begin() != "pictures" || each.extension() == ".png")
                    << each;
        EXPECT_FALSE(hasError(writeHtmlReport(*merged, into, report, roots)));
        EXPECT_FALSE(hasError(writeHtmlReport(run, folder / "run", direct, roots)));
        writeText(report / "text",
                  toText(*merged, {.resultsFolder = into}) + toText(run, {.resultsFolder = folder / "run"}));
        writeText(report / "junit.xml", toJunit(*merged) + toJunit(run));
        expectNoSecrets({into, report, direct});
        for (const auto& [name, text] : contents(into))
            EXPECT_TRUE(fs::path(name) == into / "results.jsonl" || fs::path(name) == into / "pictures" ||
                        fs::path(name).parent_path() == into / "pictures")
                << name;
    }
    EXPECT_EQ(contents(folder / "outside"), outside);
    EXPECT_EQ(contents(folder / "project"), project);
    std::vector<std::string> made;
    for (const auto& each : fs::directory_iterator(folder.path())) made.push_back(each.path().filename());
    std::ranges::sort(made);
    EXPECT_EQ(made, (std::vector<std::string>{"direct", "into", "outside", "project", "report", "run"}));
}

TEST_F(Hostile, TheTestCanFail) {
    // What may be shown is shown: a scene below a root, and a picture in the folder of the run.
    ShotResult shot;
    shot.suite = "s";
    shot.shot = "a";
    shot.verdict = Verdict::failed;
    shot.got = "s/a.got.png";
    shot.script = folder / "project/scene.glib";
    RunResult run;
    run.shots = {shot};
    ASSERT_FALSE(hasError(writeHtmlReport(run, folder / "run", folder / "report", roots)));
    EXPECT_NE(textOf(folder / "report/index.html").find("Sphere 1"), std::string::npos);
    EXPECT_FALSE(fs::is_empty(folder / "report/pictures"));
    roots.pictures.add(folder / "outside");
    run.shots[0].script = folder / "outside/secret.txt";
    ASSERT_FALSE(hasError(writeHtmlReport(run, folder / "run", folder / "report", roots)));
    EXPECT_EQ(textOf(folder / "report/index.html").find(kSecret), std::string::npos)
        << "a folder of goldens shows no texts";
    roots.texts.add(folder / "outside");
    ASSERT_FALSE(hasError(writeHtmlReport(run, folder / "run", folder / "report", roots)));
    EXPECT_NE(textOf(folder / "report/index.html").find(kSecret), std::string::npos);
}

TEST_F(Hostile, DamagedFilesOfResultsNeverShowAnythingElse) {
    std::mt19937 random(22);
    for (int i = 0; i < 200; ++i) {
        ASSERT_TRUE(writeResults(hostile(random), folder / "run").empty());
        std::string text = textOf(folder / "run/results.jsonl");
        for (int change = 0; change < 4; ++change) {
            const std::size_t at = random() % text.size();
            switch (random() % 4) {
                case 0:
                    text[at] = static_cast<char>(random());
                    break;
                case 1:
                    text.erase(at, random() % 40);
                    break;
                case 2:
                    text.insert(at, text.substr(random() % text.size(), random() % 40));
                    break;
                default:
                    text.insert(at, "1e308");
                    break;
            }
        }
        writeText(folder / "run/results.jsonl", text);
        const std::vector<fs::path> folders{folder / "run"};
        const Result<RunResult> merged = mergeResults(folders, folder / "into");
        if (merged) {
            EXPECT_FALSE(hasError(writeHtmlReport(*merged, folder / "into", folder / "report", roots)));
            expectNoSecrets({folder / "report"});
        }
        if (fs::exists(folder / "into")) expectNoSecrets({folder / "into"});
    }
}

}  // namespace
}  // namespace glibra::suite
