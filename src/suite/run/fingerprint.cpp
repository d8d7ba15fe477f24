#include "suite/run/fingerprint.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>

#include "base/files.h"
#include "gpu/context/context.h"
#include "image/file.h"
#include "render/file/scene_inputs.h"
#include "suite/golden/golden_store.h"
#include "suite/golden/hash_list.h"
#include "suite/golden/ignored.h"
#include "suite/options/option_words.h"
#include "system/folder.h"
#include "system/places.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

std::string portablePathOf(const fs::path& folder, const fs::path& file) {
    return system::wholePath(file).lexically_relative(system::wholePath(folder)).generic_string();
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
        fmt::format("{} {} {} {} {} {}\n{} {}", optionArguments(options.ofAll), options.update,
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

namespace {

namespace fs = std::filesystem;

/// What the files of a scene may follow from, without the time.
std::string sourceOf(const SceneQuery& query) {
    const RenderOptions& options = query.options;
    std::string key = query.scene.generic_string();
    const auto add = [&](const std::string& word) { (key += '\0') += word; };
    add(fmt::format("{} {} {}", options.width, options.height, options.within.generic_string()));
    for (const fs::path& each : options.libraryRoots) add(each.generic_string());
    for (const std::string& each : options.set) add("=" + each);
    return key;
}

/// Runs in the worker. It hashes each file once.
class InputReader {
  public:
    std::string operator()(const SceneQuery& query) {
        std::string source = sourceOf(query);
        if (source == source_) return answer_;
        source_.clear();
        const render::ReadByScene read = render::filesReadBy(query.scene, query.options);
        std::string names, contents;
        for (const fs::path& each : read.files) {
            const auto [known, isNew] = contents_.try_emplace(each);
            if (isNew) known->second = contentOf(each);
            (names += '\0') += each.generic_string();
            (((contents += each.generic_string()) += '\0') += known->second) += '\0';
        }
        answer_ = (read.isWhole ? toText(hashOf(std::as_bytes(std::span(contents)))) : "") + names;
        if (!read.changesWithTime) source_ = std::move(source);
        return answer_;
    }

  private:
    std::map<fs::path, std::string> contents_;
    std::string source_, answer_;  ///< the last scene that is the same at all times, and its answer
};

SceneInputs unpacked(std::string_view answer) {
    SceneInputs inputs;
    std::size_t end = answer.find('\0');
    inputs.content = answer.substr(0, end);
    while (end != std::string_view::npos) {
        answer.remove_prefix(end + 1);
        end = answer.find('\0');
        inputs.files.emplace_back(answer.substr(0, end));
    }
    return inputs;
}

}  // namespace

std::string contentOf(const fs::path& file) {
    const auto bytes = image::readFile(file, {file.generic_string(), {}});
    return bytes ? toText(hashOf(*bytes)) : bytes.diagnostics.front().id;
}

std::vector<SceneInputs> readInputs(std::span<const SceneQuery> queries, const base::WorkerOptions& options) {
    std::map<std::string, std::size_t> numbers;
    std::vector<std::size_t> numberOf;
    std::vector<const SceneQuery*> distinct;
    for (const SceneQuery& each : queries) {
        const std::string key = fmt::format("{}\n{}", sourceOf(each), each.options.time);
        const auto [known, isNew] = numbers.try_emplace(key, distinct.size());
        if (isNew) distinct.push_back(&each);
        numberOf.push_back(known->second);
    }
    const auto timeoutOf = [&](std::size_t query) {
        return distinct[query]->timeout.value_or(options.timeout);
    };
    std::vector<SceneInputs> found(distinct.size());
    std::vector<bool> isDone(distinct.size());
    InputReader reader;
    // A scene that ends its worker or is late is given up, and those of its piece after it are asked again.
    while (!std::ranges::all_of(isDone, [](bool done) { return done; })) {
        // A message per scene would cost more than most of the scenes do.
        constexpr std::size_t kScenesPerPiece = 8;
        std::vector<std::vector<std::size_t>> pieces;
        for (std::size_t i = 0; i < distinct.size(); ++i) {
            if (isDone[i]) continue;
            if (pieces.empty() || pieces.back().size() == kScenesPerPiece ||
                timeoutOf(pieces.back().front()) != timeoutOf(i))
                pieces.emplace_back();
            pieces.back().push_back(i);
        }
        bool isStopped = false;
        base::WorkerOptions ofRound = options;
        ofRound.timeoutOf = [&](std::size_t piece) { return timeoutOf(pieces[piece].front()); };
        base::runInWorkers(
            pieces.size(), ofRound,
            [&](std::size_t piece, const base::Step& step) {
                for (std::size_t i = 0; i < pieces[piece].size(); ++i)
                    step(std::to_string(i) + '\0' + reader(*distinct[pieces[piece][i]]));
                return std::string();
            },
            [&](std::size_t piece, const base::Outcome& outcome) {
                isStopped |= outcome.end == base::Outcome::End::stopped;
                for (const std::size_t each : pieces[piece]) {
                    if (isDone[each]) continue;
                    isDone[each] = true;
                    if (outcome.end != base::Outcome::End::finished) break;
                }
            },
            [&](std::size_t piece, const std::string& text) {
                const std::size_t at = static_cast<std::size_t>(text.empty() ? 0 : text[0] - '0');
                if (text.size() < 2 || text[0] < '0' || at >= pieces[piece].size()) return;
                const std::size_t query = pieces[piece][at];
                found[query] = unpacked(std::string_view(text).substr(2));
                isDone[query] = true;
            });
        if (isStopped || (options.stop && options.stop())) break;
    }
    std::vector<SceneInputs> all;
    all.reserve(queries.size());
    for (const std::size_t each : numberOf) all.push_back(found[each]);
    return all;
}

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
        fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", shot.script.generic_string(), optionArguments(shot),
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
        const std::string stem = golden.stem().generic_string() + ".";
        std::string text;
        for (auto each = names.lower_bound(stem); each != names.end() && each->starts_with(stem); ++each)
            if (each->ends_with(golden.extension().generic_string()))
                text += fmt::format("\n{} {}", *each, contentOf(golden.parent_path() / *each));
        return text;
    }

  private:
    const std::set<std::string>& in(const fs::path& folder) {
        const auto [known, isNew] = folders_.try_emplace(folder);
        if (isNew)
            for (const fs::directory_entry& each : base::entriesOf(folder))
                known->second.insert(each.path().filename().generic_string());
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
        "{}\n{}\n{} {} {} {} {} {}\n{} {}", contentOf(system::pathOfThisProgram()),
        static_cast<int>(options.driver), optionArguments(options.ofAll), options.update,
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
