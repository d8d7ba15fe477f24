// The digest by which --merge knows the parts of one run.

#include "suite/run/fingerprint.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "folder.h"
#include "suite/file/suite_file.h"

namespace glibra::suite {
namespace {

class PlanDigest : public testing::Test {
  protected:
    PlanDigest() {
        for (const char* each : {"a.glib", "b.glib"}) writeText(folder / each, "Sphere\n");
        writeText(folder / "s.toml", "[[shot]]\nscript = \"a.glib\"\n[[shot]]\nscript = \"b.glib\"\n");
        suites.push_back(*readSuite(folder / "s.toml"));
    }
    std::string digest() const {
        std::vector<ShotReference> all;
        for (std::size_t i = 0; i < suites.size(); ++i)
            for (std::size_t shot = 0; shot < suites[i].shots.size(); ++shot) all.push_back({i, shot});
        return planDigest(suites, all, options);
    }

    Folder folder;
    std::vector<Suite> suites;
    RunOptions options;
};

TEST_F(PlanDigest, EveryShotAndEverySettingCounts) {
    const std::string before = digest();
    EXPECT_EQ(digest(), before);
    const system::Sandbox sandbox;
    const std::map<std::string, std::function<void(Suite&, RunOptions&)>> changes{
        {"another shot", [](Suite& suite, RunOptions&) { suite.shots.push_back(suite.shots.front()); }},
        {"a shot less", [](Suite& suite, RunOptions&) { suite.shots.pop_back(); }},
        {"the order", [](Suite& suite, RunOptions&) { std::swap(suite.shots[0], suite.shots[1]); }},
        {"a name", [](Suite& suite, RunOptions&) { suite.shots[0].name = "c"; }},
        {"the suite's name", [](Suite& suite, RunOptions&) { suite.name = "t"; }},
        {"a script", [](Suite& suite, RunOptions&) { suite.shots[0].script = suite.shots[1].script; }},
        {"a size",
         [](Suite& suite, RunOptions&) { suite.shots[0].options.width = suite.shots[0].options.height = 7; }},
        {"a time", [](Suite& suite, RunOptions&) { suite.shots[0].options.time = 7; }},
        {"a value", [](Suite& suite, RunOptions&) { suite.shots[0].options.set = {"uA=1"}; }},
        {"float pixels", [](Suite& suite, RunOptions&) { suite.shots[0].options.floatPixels = true; }},
        {"strict", [](Suite& suite, RunOptions&) { suite.shots[0].options.strict = true; }},
        {"a tolerance", [](Suite& suite, RunOptions&) { suite.shots[0].tolerance.largest = 255; }},
        {"flip", [](Suite& suite, RunOptions&) { suite.shots[0].tolerance.flip = 1; }},
        {"golden = false", [](Suite& suite, RunOptions&) { suite.shots[0].golden = false; }},
        {"match", [](Suite& suite, RunOptions&) { suite.shots[0].match = "b"; }},
        {"differ", [](Suite& suite, RunOptions&) { suite.shots[0].differ = "b"; }},
        {"expect-error", [](Suite& suite, RunOptions&) { suite.shots[0].expectedError.emplace(); }},
        {"a time limit of a shot", [](Suite& suite, RunOptions&) { suite.shots[0].timeout = 1; }},
        {"a memory limit of a shot", [](Suite& suite, RunOptions&) { suite.shots[0].memory = 1ULL << 30; }},
        {"--update", [](Suite&, RunOptions& run) { run.update = true; }},
        {"--force", [](Suite&, RunOptions& run) { run.force = true; }},
        {"--variant", [](Suite&, RunOptions& run) { run.variant = true; }},
        {"--no-skip", [](Suite&, RunOptions& run) { run.ofAll.options.skip = false; }},
        {"--check-undefined", [](Suite&, RunOptions& run) { run.ofAll.options.checkUndefined = true; }},
        {"--allow-outside", [](Suite&, RunOptions& run) { run.allowOutside = true; }},
        {"--timeout", [](Suite&, RunOptions& run) { run.timeout = 5; }},
        {"--memory", [](Suite&, RunOptions& run) { run.memory = 1ULL << 30; }},
        {"--untrusted", [&](Suite&, RunOptions& run) { run.sandbox = &sandbox; }},
    };
    std::map<std::string, std::string> seen{{before, "nothing"}};
    for (const auto& [what, change] : changes) {
        suites[0] = *readSuite(folder / "s.toml");
        options = {};
        ASSERT_EQ(digest(), before);
        change(suites[0], options);
        const auto [known, isNew] = seen.emplace(digest(), what);
        EXPECT_TRUE(isNew) << what << " is as " << known->second;
    }
    suites[0] = *readSuite(folder / "s.toml");
    options = {};
    writeText(folder / "a.glib", "Box\n");
    EXPECT_NE(digest(), before) << "the text of a scene";
}

TEST_F(PlanDigest, WhatDiffersBetweenMachinesDoesNotCount) {
    const std::string before = digest();
    options.driver = Driver::osmesa;
    options.jobs = 7;
    options.goldens = "elsewhere";
    options.results = "elsewhere";
    for (Shot& each : suites[0].shots) each.options.libraryRoots = {"/opt/glibra"};
    EXPECT_EQ(digest(), before);
    // The same checkout in another folder.
    const Folder other;
    for (const char* each : {"a.glib", "b.glib", "s.toml"}) writeText(other / each, textOf(folder / each));
    suites[0] = *readSuite(other / "s.toml");
    EXPECT_EQ(digest(), before);
}

}  // namespace
}  // namespace glibra::suite
