#include "suite/run/read_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>

#include "image/file.h"
#include "render/file/scene_inputs.h"
#include "suite/golden/hash.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

/// What the files of a scene may follow from, without the time.
std::string sourceOf(const SceneQuery& query) {
    const RenderOptions& options = query.options;
    std::string key = query.scene.string();
    const auto add = [&](const std::string& word) { (key += '\0') += word; };
    add(fmt::format("{} {} {}", options.width, options.height, options.within.string()));
    for (const fs::path& each : options.libraryRoots) add(each.string());
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
            (names += '\0') += each.string();
            (((contents += each.string()) += '\0') += known->second) += '\0';
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
    const auto bytes = image::readFile(file, {file.string(), {}});
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

}  // namespace glibra::suite
