#include "cli/orphan_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/text.h"
#include "cli/commands.h"
#include "suite/golden/orphans.h"

namespace glibra::cli {

namespace fs = std::filesystem;

int answerOrphans(const std::vector<suite::Suite>& suites, const fs::path& goldens, bool prune) {
    constexpr std::size_t kMostNames = 10;
    int status = kDone;
    for (const suite::Suite& each : suites) {
        const std::vector<fs::path> orphans = suite::orphanGoldens(each, goldens, suites);
        if (orphans.empty()) continue;
        if (prune) {
            if (printErrors(suite::removeOrphans(orphans))) status = kSceneIsWrong;
        }
        const std::size_t count = orphans.size();
        const std::size_t shown = prune ? count : std::min(count, kMostNames);
        std::string text =
            fmt::format("{} of no shot of '{}' {}", base::counted(count, "golden"), each.name,
                        prune ? (count == 1 ? "was removed:" : "were removed:") : "(--prune removes them):");
        for (std::size_t i = 0; i < shown; ++i) text += " " + orphans[i].string();
        if (count > shown) text += fmt::format(" and {} more", count - shown);
        print({withoutId(Severity::note, text)});
    }
    return status;
}

}  // namespace glibra::cli
