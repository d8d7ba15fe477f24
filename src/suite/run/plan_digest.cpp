#include "suite/run/plan_digest.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <system_error>

#include "suite/golden/golden_store.h"
#include "suite/golden/hash.h"
#include "suite/options/option_toml.h"
#include "suite/options/option_words.h"
#include "suite/run/read_inputs.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

std::string portablePathOf(const fs::path& folder, const fs::path& file) {
    std::error_code failed;
    const fs::path base = fs::absolute(folder, failed).lexically_normal();
    return fs::absolute(file, failed).lexically_normal().lexically_relative(base).generic_string();
}

std::string portableSettingsOf(const Shot& shot) {
    Shot portable = shot;
    portable.script.clear();
    portable.options.libraryRoots.clear();
    std::string text = fmt::format("{}\n{}\n{} {}\n{}\n{}\n{}\n{}", shot.name, optionArguments(portable),
                                   optionLines(portable, "."), shot.golden, shot.match, shot.differ,
                                   toText(shot.tolerance), shot.timeout);
    // Shards on both sides of a midnight belong together, so dates count and not whether they are over.
    text += fmt::format("\n{} {} {} {}", shot.statesTolerance, shot.retries, shot.quarantine,
                        shot.mask.filename().generic_string());
    for (const IgnoredRegion& each : shot.ignored)
        text += fmt::format(" {},{},{},{} {}", each.x, each.y, each.width, each.height, each.until);
    if (shot.expectedError)
        text += fmt::format("\n{}\n{}\n{}", shot.expectedError->id, shot.expectedError->text,
                            shot.expectedError->line);
    return text;
}

}  // namespace

std::string planDigest(std::span<const Suite> suites, std::span<const ShotReference> undivided,
                       const RunOptions& options) {
    std::string text =
        fmt::format("{} {} {} {} {} {}\n{} {}", options.skip + 2 * options.checkUndefined, options.update,
                    options.force + 2 * options.also + 4 * options.onlyMissing +
                        8 * options.replaceUnreadable + 16 * options.anyDriver,
                    options.variant, options.allowOutside, options.sandbox != nullptr,
                    options.timeout.value_or(-1), options.memory ? std::to_string(*options.memory) : "-");
    for (const Suite& suite : suites) text += "\n" + suite.name;
    std::map<fs::path, std::string> contents;
    for (const ShotReference& each : undivided) {
        const Suite& suite = suites[each.suite];
        const Shot& shot = suite.shots[each.shot];
        const auto [known, isNew] = contents.try_emplace(shot.script);
        if (isNew) known->second = contentOf(shot.script);
        text += fmt::format("\n\n{}\n{}\n{}\n{}", suite.name, portablePathOf(folderOf(suite), shot.script),
                            known->second, portableSettingsOf(shot));
    }
    return fmt::format("{}-{}", toText(hashOf(std::as_bytes(std::span(text)))), undivided.size());
}

}  // namespace glibra::suite
