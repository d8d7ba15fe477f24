#include "suite/file/pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "base/suggest.h"
#include "glib/text.h"

namespace glibra::suite {
namespace {

struct Edge {
    std::size_t to = 0;
    const PairRequest* request = nullptr;
};
using Edges = std::vector<std::vector<Edge>>;  // one list per shot

using Names = std::unordered_map<std::string_view, std::size_t>;

std::optional<std::size_t> find(const Names& names, const PairRequest& request) {
    auto found = names.end();
    if (!request.suffix.empty()) found = names.find(request.name.text + request.suffix);
    if (found == names.end()) found = names.find(request.name.text);
    if (found == names.end()) return std::nullopt;
    return found->second;
}

/// Suggests a shot of a sweep, or the nearest name.
std::string hint(const Suite& suite, const std::string& wanted) {
    std::vector<std::string_view> names;
    for (const Shot& shot : suite.shots) {
        if (shot.name.starts_with(wanted + '@'))
            return fmt::format("; there is '{}', one of several", shot.name);
        names.emplace_back(shot.name);
    }
    return base::suggestion(wanted, names);
}

/// The names of a cycle: "a, b, c, a". Long cycles are cut.
std::string cycleText(const Suite& suite, std::span<const std::size_t> path, std::size_t begin) {
    constexpr std::size_t kShown = 6;
    std::string text;
    for (std::size_t i = begin; i < path.size() && i < begin + kShown; ++i)
        text += suite.shots[path[i]].name + ", ";
    return text + (path.size() > begin + kShown ? "..., " : "") + suite.shots[path[begin]].name;
}

/// Reports suite-E08 for every edge that closes a cycle.
void reportCycles(TomlReader& reader, const Suite& suite, const Edges& edges) {
    enum class State : char { unseen, onPath, done };
    std::vector<State> states(edges.size(), State::unseen);
    std::vector<std::size_t> next(edges.size());  // the next edge to follow, per shot
    for (std::size_t start = 0; start < edges.size(); ++start) {
        if (states[start] != State::unseen) continue;
        std::vector<std::size_t> path{start};
        states[start] = State::onPath;
        while (!path.empty()) {
            const std::size_t here = path.back();
            if (next[here] == edges[here].size()) {
                states[here] = State::done;
                path.pop_back();
                continue;
            }
            const Edge& edge = edges[here][next[here]++];
            if (states[edge.to] == State::unseen) {
                states[edge.to] = State::onPath;
                path.push_back(edge.to);
            } else if (states[edge.to] == State::onPath) {
                const auto begin = std::ranges::find(path, edge.to) - path.begin();
                reader.report("suite-E08",
                              fmt::format("{}: the shots name each other in a cycle: {}",
                                          edge.request->isMatch ? "match" : "differ",
                                          cycleText(suite, path, static_cast<std::size_t>(begin))),
                              edge.request->name.place);
            }
        }
    }
}

}  // namespace

void resolvePairs(TomlReader& reader, std::span<const PairRequest> requests, Suite& suite) {
    Names names;
    for (std::size_t i = 0; i < suite.shots.size(); ++i) names.emplace(suite.shots[i].name, i);
    // One entry of the suite may make several shots and name one of them, with which the others are compared.
    std::set<std::tuple<int, int, std::size_t>> namedByOthers;
    for (const PairRequest& request : requests)
        if (const auto other = find(names, request); other && *other != request.shot)
            namedByOthers.emplace(request.name.place.line, request.name.place.column, *other);
    Edges edges(suite.shots.size());
    for (const PairRequest& request : requests) {
        const char* word = request.isMatch ? "match" : "differ";
        const auto other = find(names, request);
        if (other == request.shot &&
            namedByOthers.contains({request.name.place.line, request.name.place.column, *other}))
            continue;
        if (!other) {
            reader.report("suite-E07",
                          fmt::format("{}: there is no shot {}{}", word, glib::inQuotes(request.name.text),
                                      hint(suite, request.name.text)),
                          request.name.place);
            continue;
        }
        Shot& shot = suite.shots[request.shot];
        if (suite.shots[*other].expectedError)
            reader.report("suite-E12",
                          fmt::format("{}: '{}' expects an error, so it makes no picture", word,
                                      suite.shots[*other].name),
                          request.name.place);
        (request.isMatch ? shot.match : shot.differ) = suite.shots[*other].name;
        if (shot.match == shot.differ)
            reader.report("suite-E12", fmt::format("match and differ both name '{}'", shot.match),
                          request.name.place);
        edges[request.shot].push_back({*other, &request});
    }
    reportCycles(reader, suite, edges);
}

}  // namespace glibra::suite
