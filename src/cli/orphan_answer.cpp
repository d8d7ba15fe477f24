#include "cli/orphan_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <system_error>

#include "base/text.h"
#include "cli/commands.h"

namespace glibra::cli {

namespace fs = std::filesystem;

std::vector<std::shared_ptr<const suite::Orphans>> orphansOf(const std::vector<suite::Suite>& suites,
                                                             const fs::path& goldens) {
    std::vector<std::shared_ptr<const suite::Orphans>> orphans;
    for (const suite::Suite& each : suites)
        orphans.push_back(
            std::make_shared<const suite::Orphans>(suite::orphanGoldens(each, goldens, suites)));
    return orphans;
}

int settleOrphans(const std::vector<suite::Suite>& suites,
                  const std::vector<std::shared_ptr<const suite::Orphans>>& orphans, bool prune,
                  suite::RunResult& run) {
    int status = kDone;
    for (std::size_t i = 0; i < suites.size(); ++i) {
        std::vector<fs::path> left = orphans[i]->files();
        std::error_code ignored;
        std::erase_if(left, [&](const fs::path& each) { return !fs::exists(each, ignored); });
        if (left.empty()) continue;
        const bool isRefused = std::ranges::any_of(run.shots, [&](const suite::ShotResult& each) {
            return each.suite == suites[i].name && each.verdict == suite::Verdict::refused;
        });
        if (prune && isRefused)
            print({withoutId(Severity::note,
                             fmt::format("--prune removes nothing of '{}', because a picture of it was not "
                                         "accepted",
                                         suites[i].name))});
        if (prune && !isRefused) {
            if (printErrors(suite::removeOrphans(left))) status = kSceneIsWrong;
            std::string text =
                fmt::format("{} of no shot of '{}' {} removed:", base::counted(left.size(), "golden"),
                            suites[i].name, left.size() == 1 ? "was" : "were");
            for (const fs::path& each : left) text += " " + each.string();
            print({withoutId(Severity::note, text)});
            continue;
        }
        for (const fs::path& each : left) run.orphans.push_back({suites[i].name, each.string()});
    }
    std::ranges::sort(run.orphans);
    return status;
}

void noteOrphans(const suite::RunResult& run) {
    constexpr std::size_t kMostNames = 10;
    for (std::string& each : suite::orphanLines(run, kMostNames))
        print({withoutId(Severity::note, std::move(each))});
}

}  // namespace glibra::cli
