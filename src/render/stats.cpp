#include "render/stats.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

namespace glibra::render {

namespace {

/// The entry of that name, which is added if there is none.
template <class Entry>
Entry& entryOf(std::vector<Entry>& entries, std::string_view name) {
    const auto found = std::ranges::find(entries, name, &Entry::name);
    return found == entries.end() ? entries.emplace_back(Entry{std::string(name)}) : *found;
}

/// What was skipped, chosen or found, with why and the line.
nlohmann::ordered_json reasonsOf(const auto& all) {
    auto json = nlohmann::ordered_json::array();
    for (const auto& each : all)
        json.push_back({{"what", each.what}, {"why", each.why}, {"line", each.place.line}});
    return json;
}

}  // namespace

void Stats::addTime(std::string_view stage, double milliseconds) {
    entryOf(stages, stage).milliseconds += milliseconds;
}

void Stats::add(std::string_view count, std::uint64_t value) {
    entryOf(counts, count).value += value;
}

void Stats::skip(std::string_view what, std::string why, const Place& place) {
    skipped.push_back({std::string(what), std::move(why), place});
}

std::string toJson(const Stats& stats, std::string_view scene, int width, int height,
                   std::string_view driver) {
    nlohmann::ordered_json json;
    json["scene"] = scene;
    json["size"] = {width, height};
    json["driver"] = driver;
    json["milliseconds"] = nlohmann::ordered_json::object();
    for (const Stats::Stage& each : stats.stages) json["milliseconds"][each.name] = each.milliseconds;
    // null: not measured
    json["gpuTime"] = nullptr;
    if (stats.gpu) json["gpuTime"] = nlohmann::ordered_json::array();
    for (const Stats::GpuTime& each : stats.gpu.value_or(std::vector<Stats::GpuTime>()))
        json["gpuTime"].push_back({{"what", each.what},
                                   {"line", each.line},
                                   {"times", each.times},
                                   {"milliseconds", each.milliseconds}});
    json["counts"] = nlohmann::ordered_json::object();
    for (const Stats::Count& each : stats.counts) json["counts"][each.name] = each.value;
    json["skipped"] = reasonsOf(stats.skipped);
    if (!stats.decisions.empty()) json["chosen"] = reasonsOf(stats.decisions);
    if (!stats.foundByName.empty()) json["foundByName"] = reasonsOf(stats.foundByName);
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

namespace {

/// One line for each kind of thing and reason, with their number and the line of the first.
std::string listed(std::span<const plan::Skipped> all) {
    struct Listed {
        const plan::Skipped* first;
        std::size_t count = 1;
    };
    std::vector<Listed> kinds;
    std::map<std::pair<std::string_view, std::string_view>, std::size_t> known;
    for (const plan::Skipped& each : all) {
        const auto [entry, isNew] = known.try_emplace({each.what, each.why}, kinds.size());
        if (isNew)
            kinds.push_back({&each});
        else
            ++kinds[entry->second].count;
    }
    std::string text;
    for (const Listed& each : kinds) {
        text += fmt::format("  line {:<4} {}: {}", each.first->place.line, each.first->what, each.first->why);
        text += each.count == 1 ? "\n" : fmt::format(" ({} times)\n", each.count);
    }
    return text;
}

std::string gpuTimes(const Stats& stats) {
    if (!stats.gpu) return "GPU time: not measured, the driver has no timer\n";
    std::string text = "GPU time\n";
    double total = 0;
    for (const Stats::GpuTime& each : *stats.gpu) {
        text += fmt::format("  {:9.2f} ms  {}", each.milliseconds, each.what);
        if (each.line > 0) text += fmt::format(", line {}", each.line);
        text += each.times == 1 ? "\n" : fmt::format(" ({} times)\n", each.times);
        total += each.milliseconds;
    }
    return text + fmt::format("  {:9.2f} ms  together\n", total);
}

}  // namespace

std::string toText(const Stats& stats) {
    std::string text = "time\n";
    double total = 0;
    for (const Stats::Stage& each : stats.stages) {
        text += fmt::format("  {:<12} {:9.2f} ms\n", each.name, each.milliseconds);
        total += each.milliseconds;
    }
    text += fmt::format("  {:<12} {:9.2f} ms\n", "together", total);
    text += gpuTimes(stats) + "made and drawn\n";
    for (const Stats::Count& each : stats.counts)
        text += fmt::format("  {:<20} {:>12}\n", each.name, each.value);
    if (!stats.decisions.empty()) text += "chosen\n";
    for (const budget::Decision& each : stats.decisions)
        text += fmt::format("  line {:<4} {}: {}\n", each.place.line, each.what, each.why);
    if (!stats.foundByName.empty()) text += "found by name\n";
    text += listed(stats.foundByName);
    text += stats.skipped.empty() ? "skipped: nothing\n" : "skipped\n";
    return text + listed(stats.skipped);
}

}  // namespace glibra::render
