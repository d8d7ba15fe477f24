#include "bench/draw/byte_filter.h"

#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>

namespace glibra::bench {
namespace {

constexpr const char* kQuickWord = " quick";

}  // namespace

std::string pointsToText(const std::vector<Point>& points) {
    nlohmann::json list = nlohmann::json::array();
    for (const Point& each : points) {
        nlohmann::json entry{{"setting", each.setting}, {"label", each.label}, {"error", each.error}};
        if (each.time)
            entry["time"] = {each.time->median, each.time->low, each.time->high, each.time->repeats};
        if (each.memory) entry["memory"] = *each.memory;
        list.push_back(std::move(entry));
    }
    return list.dump();
}

std::optional<std::vector<Point>> pointsFromText(const std::string& text) {
    const nlohmann::json list = nlohmann::json::parse(text, nullptr, false);
    if (!list.is_array()) return std::nullopt;
    std::vector<Point> points;
    for (const nlohmann::json& entry : list) {
        Point point{.setting = entry.value("setting", 0.), .label = entry.value("label", "")};
        point.error = entry.contains("error") && entry["error"].is_number()
                          ? entry["error"].get<double>()
                          : std::numeric_limits<double>::quiet_NaN();
        if (entry.contains("time"))
            point.time = Timing{.median = entry["time"][0].get<double>(),
                                .low = entry["time"][1].get<double>(),
                                .high = entry["time"][2].get<double>(),
                                .repeats = entry["time"][3].get<int>()};
        if (entry.contains("memory")) point.memory = entry["memory"].get<double>();
        points.push_back(std::move(point));
    }
    return points;
}

std::string measureWithByteFilter(const std::string& request,
                                  Result<std::vector<Point>> (*measure)(const Bench&,
                                                                        const gpu::Capabilities&)) {
    const bool isQuick = request.ends_with(kQuickWord);
    const std::optional<Driver> driver = driverOfWord(request.substr(0, request.find(' ')));
    if (!driver) return {};
    unsetenv("GALLIVM_PERF");
    const Result<gpu::Context> context = gpu::openContext({.driver = *driver, .floatFiltering = false});
    if (!context) return {};
    const Bench bench({.quick = isQuick, .driver = *driver});
    const Result<std::vector<Point>> points = measure(bench, context->capabilities());
    return points ? pointsToText(*points) : std::string();
}

std::string byteFilterRequest(Bench& bench, const gpu::Context& context) {
    return std::string(word(context.driver())) + (bench.isQuick() ? kQuickWord : "");
}

}  // namespace glibra::bench
