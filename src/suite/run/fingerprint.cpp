#include "suite/run/fingerprint.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <set>
#include <vector>

#include "base/files.h"
#include "gpu/context/context.h"
#include "suite/golden/golden_store.h"
#include "suite/golden/hash.h"
#include "suite/golden/hash_key.h"
#include "suite/golden/ignored.h"
#include "suite/options/option_toml.h"
#include "suite/options/option_words.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

/// The shots that a shot is compared with.
std::vector<ShotReference> partnersOf(std::span<const Suite> suites, const ShotReference& shot) {
    std::vector<ShotReference> partners;
    const Suite& suite = suites[shot.suite];
    for (const std::string* name : {&suite.shots[shot.shot].match, &suite.shots[shot.shot].differ})
        if (const Shot* found = name->empty() ? nullptr : suite.find(*name))
            partners.push_back({shot.suite, static_cast<std::size_t>(found - suite.shots.data())});
    return partners;
}

std::string settingsOf(const Shot& shot) {
    std::string text =
        fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", shot.script.string(), optionArguments(shot),
                    optionLines(shot, "."), shot.golden, shot.match, shot.differ, toText(shot.tolerance));
    text += judgedBy(shot);
    if (shot.expectedError)
        text += fmt::format("\n{}\n{}\n{}", shot.expectedError->id, shot.expectedError->text,
                            shot.expectedError->line);
    return text;
}

/// The names of all goldens of a folder, read once.
class GoldenNames {
  public:
    /// Names and contents of the golden and its variants.
    std::string contentsFor(const fs::path& golden) {
        const std::set<std::string>& names = in(golden.parent_path());
        const std::string stem = golden.stem().string() + ".";
        std::string text;
        for (auto each = names.lower_bound(stem); each != names.end() && each->starts_with(stem); ++each)
            if (each->ends_with(golden.extension().string()))
                text += fmt::format("\n{} {}", *each, contentOf(golden.parent_path() / *each));
        return text;
    }

  private:
    const std::set<std::string>& in(const fs::path& folder) {
        const auto [known, isNew] = folders_.try_emplace(folder);
        if (isNew)
            for (const fs::directory_entry& each : base::entriesOf(folder))
                known->second.insert(each.path().filename().string());
        return known->second;
    }

    std::map<fs::path, std::set<std::string>> folders_;
};

}  // namespace

ShotInputs inputsOf(std::span<const Suite> suites, std::span<const ShotReference> shots,
                    const base::WorkerOptions& workers, std::optional<double> timeout) {
    ShotInputs inputs;
    for (const ShotReference& each : shots) {
        inputs.try_emplace(each);
        for (const ShotReference& partner : partnersOf(suites, each)) inputs.try_emplace(partner);
    }
    std::vector<SceneQuery> queries;
    for (const auto& [shot, ignored] : inputs) {
        const Shot& asked = suites[shot.suite].shots[shot.shot];
        queries.push_back({asked.script, asked.options, timeout.value_or(asked.timeout)});
    }
    std::vector<SceneInputs> found = readInputs(queries, workers);
    auto next = found.begin();
    for (auto& [shot, each] : inputs) each = std::move(*next++);
    return inputs;
}

std::string keyOfDriver(Driver driver, const base::WorkerOptions& workers) {
    std::string key;
    base::runInWorkers(
        1, workers,
        [driver](std::size_t, const base::Step&) {
            const Result<gpu::Context> context = gpu::openContext({.driver = driver});
            return context ? driverKey(context->capabilities()) : std::string();
        },
        [&](std::size_t, const base::Outcome& outcome) { key = outcome.answer; },
        [](std::size_t, const std::string&) {});
    return key.empty() ? key : toText(hashOf(std::as_bytes(std::span(key))));
}

std::map<ShotReference, std::string> fingerprints(std::span<const Suite> suites,
                                                  std::span<const ShotReference> shots,
                                                  const ShotInputs& inputs, const RunOptions& options) {
    const std::string ofRun = fmt::format(
        "{}\n{}\n{} {} {} {} {} {}\n{} {}", contentOf("/proc/self/exe"), static_cast<int>(options.driver),
        options.skip + 2 * options.checkUndefined, options.update,
        options.force + 2 * options.also + 4 * options.onlyMissing + 8 * options.replaceUnreadable +
            16 * options.anyDriver,
        options.variant + 2 * options.strictFlaky, options.allowOutside, options.sandbox != nullptr,
        options.timeout.value_or(-1), options.memory ? std::to_string(*options.memory) : "-");
    GoldenNames goldens;
    std::map<std::size_t, GoldenStore> stores;  // per suite
    std::map<std::size_t, bool> haveGoldens;
    const auto linesOf = [&](std::size_t suite, const Shot& shot) {
        auto store = stores.find(suite);
        if (store == stores.end()) {
            store = stores.emplace(suite, *GoldenStore::open(suites[suite], options.goldens)).first;
            haveGoldens.emplace(suite, store->second.hasAny(suites[suite]));
        }
        std::string text = haveGoldens[suite] ? "\ngoldens" : "";
        for (const AcceptedHash& each : store->second.accepted().linesOf(shot.name))
            text += "\n" + toLine(each);
        return text;
    };
    std::map<ShotReference, std::string> all;
    for (const ShotReference& each : shots) {
        std::vector<ShotReference> parts = partnersOf(suites, each);
        parts.insert(parts.begin(), each);
        std::string text = ofRun;
        bool isKnown = true;
        for (const ShotReference& part : parts) {
            const auto found = inputs.find(part);
            isKnown = isKnown && found != inputs.end() && !found->second.content.empty();
            text += "\n" + settingsOf(suites[part.suite].shots[part.shot]);
            if (isKnown) text += "\n" + found->second.content;
        }
        const Suite& suite = suites[each.suite];
        if (!options.update)
            text += goldens.contentsFor(goldenFolder(suite, options.goldens) /
                                        goldenName(suite.shots[each.shot])) +
                    linesOf(each.suite, suite.shots[each.shot]);
        all.emplace(each, isKnown ? toText(hashOf(std::as_bytes(std::span(text)))) : std::string());
    }
    return all;
}

std::string sealed(const std::string& fingerprint, Verdict verdict) {
    if (fingerprint.empty()) return {};
    const std::string text = fingerprint + " " + name(verdict);
    return toText(hashOf(std::as_bytes(std::span(text))));
}

}  // namespace glibra::suite
