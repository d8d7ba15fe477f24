#include "suite/run/read_inputs.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>

#include "image/file.h"
#include "render/file/scene_inputs.h"
#include "suite/golden/hash.h"
#include "suite/options/option_words.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

/// What the files of a scene may follow from.
std::string keyOf(const SceneQuery& query) {
    std::string key = query.scene.string();
    const auto add = [&](const std::string& word) { (key += '\0') += word; };
    for (const fs::path& each : query.options.libraryRoots) add(each.string());
    for (const std::string& each : query.options.set) add("=" + each);
    return key;
}

/// Runs in the worker. It hashes each file once.
class InputReader {
  public:
    std::string operator()(const SceneQuery& query) {
        std::string names, contents;
        for (const fs::path& each : render::filesReadBy(query.scene, query.options)) {
            const auto [known, isNew] = contents_.try_emplace(each);
            if (isNew) known->second = contentOf(each);
            (names += '\0') += each.string();
            (((contents += each.string()) += '\0') += known->second) += '\0';
        }
        return toText(hashOf(std::as_bytes(std::span(contents)))) + names;
    }

  private:
    std::map<fs::path, std::string> contents_;
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
        const auto [known, isNew] = numbers.try_emplace(keyOf(each), distinct.size());
        if (isNew) distinct.push_back(&each);
        numberOf.push_back(known->second);
    }
    // A message per scene would cost more than most of the scenes do.
    constexpr std::size_t kScenesPerPiece = 8;
    std::vector<SceneInputs> found(distinct.size());
    InputReader reader;
    base::runInWorkers(
        (distinct.size() + kScenesPerPiece - 1) / kScenesPerPiece, options,
        [&](std::size_t piece, const base::Step& step) {
            const std::size_t end = std::min(distinct.size(), (piece + 1) * kScenesPerPiece);
            for (std::size_t i = piece * kScenesPerPiece; i < end; ++i)
                step(std::to_string(i - piece * kScenesPerPiece) + '\0' + reader(*distinct[i]));
            return std::string();
        },
        [](std::size_t, const base::Outcome&) {},
        [&](std::size_t piece, const std::string& text) {
            const std::size_t at =
                piece * kScenesPerPiece + static_cast<std::size_t>(text.empty() ? 0 : text[0] - '0');
            if (text.size() < 2 || text[0] < '0' ||
                at >= std::min(distinct.size(), (piece + 1) * kScenesPerPiece))
                return;
            found[at] = unpacked(std::string_view(text).substr(2));
        });
    std::vector<SceneInputs> all;
    all.reserve(queries.size());
    for (const std::size_t each : numberOf) all.push_back(found[each]);
    return all;
}

}  // namespace glibra::suite
