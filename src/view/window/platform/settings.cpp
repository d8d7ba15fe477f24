#include "view/window/platform/settings.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>

#include "image/file.h"
#include "system/folder.h"
#include "system/places.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kMostRecent = 12;
constexpr std::size_t kMostFolds = 500;
constexpr std::size_t kMostTabs = 50;

}  // namespace

void Settings::addRecent(const fs::path& scene) {
    const std::string whole = system::wholePath(scene).generic_string();
    std::erase(recent, whole);
    recent.insert(recent.begin(), whole);
    if (recent.size() > kMostRecent) recent.resize(kMostRecent);
}

void Settings::scaleSizes(float by) {
    const auto scaled = [by](int size) {
        return static_cast<int>(std::lround(static_cast<float>(size) * by));
    };
    windowWidth = scaled(windowWidth);
    windowHeight = scaled(windowHeight);
    panelWidth *= by;
}

fs::path settingsFile() {
    const fs::path folder = system::userFolder(system::UserFolder::settings);
    return folder.empty() ? folder : folder / "view.json";
}

Settings readSettings(const fs::path& file) {
    Settings settings;
    const auto bytes = image::readFile(file, {file.generic_string(), {}}, 1 << 20);
    if (!bytes) return settings;
    const auto* text = reinterpret_cast<const char*>(bytes->data());
    const nlohmann::json json = nlohmann::json::parse(text, text + bytes->size(), nullptr, false);
    if (!json.is_object()) return settings;
    const auto number = [&](const char* key, double most) {
        const auto found = json.find(key);
        return found != json.end() && found->is_number() ? std::clamp(found->get<double>(), 0.0, most) : 0.0;
    };
    constexpr double kLargestWindow = 16384;
    settings.windowWidth = static_cast<int>(number("windowWidth", kLargestWindow));
    settings.windowHeight = static_cast<int>(number("windowHeight", kLargestWindow));
    settings.panelWidth = static_cast<float>(number("panelWidth", kLargestWindow));
    const auto part = [&](const char* key, float& to) {
        if (json.contains(key))
            to = std::clamp(static_cast<float>(number(key, 1)), kLeastSource, kMostSource);
    };
    part("sourceBeside", settings.sourceBeside);
    part("sourceBelow", settings.sourceBelow);
    part("sourceOver", settings.sourceOver);
    settings.sourcePlace = static_cast<SourcePlace>(
        static_cast<int>(number("sourcePlace", static_cast<double>(SourcePlace::over))));
    settings.labelChoice = static_cast<LabelChoice>(
        static_cast<int>(number("labelChoice", static_cast<double>(LabelChoice::chosen))));
    if (json.contains("layoutScale"))
        settings.layoutScale = static_cast<float>(number("layoutScale", kMostZoom));
    if (!(settings.layoutScale > 0)) settings.layoutScale = 1;
    if (json.contains("zoom"))
        settings.zoom = std::max(kLeastZoom, static_cast<float>(number("zoom", kMostZoom)));
    if (json.contains("samples")) settings.samples = static_cast<int>(number("samples", kMostSamples));
    if (const auto shape = json.find("pictureShape"); shape != json.end() && *shape == "fill")
        settings.pictureShape = PictureShape::fill;
    if (const auto folds = json.find("folds"); folds != json.end() && folds->is_object())
        for (const auto& [section, isOpen] : folds->items())
            if (isOpen.is_boolean() && settings.folds.size() < kMostFolds)
                settings.folds[section] = isOpen.get<bool>();
    const auto truth = [&](const char* key) {
        const auto found = json.find(key);
        return found != json.end() && found->is_boolean() && found->get<bool>();
    };
    if (const auto found = json.find("layout"); found != json.end() && found->is_string())
        settings.layout = found->get<std::string>();
    if (const auto found = json.find("hardcopyFolder"); found != json.end() && found->is_string())
        settings.hardcopyFolder = found->get<std::string>();
    constexpr double kLastCorner = static_cast<double>(LabelCorner::topRight);
    if (const double corner = number("labelCorner", kLastCorner); corner >= 1)
        settings.labelCorner = static_cast<LabelCorner>(static_cast<int>(corner));
    settings.lightTheme = truth("lightTheme");
    settings.showSource = truth("showSource");
    settings.compilesWhileTyping = truth("compilesWhileTyping");
    settings.wrapsLines = truth("wrapsLines");
    const auto texts = [](const nlohmann::json& in, const char* key, std::size_t most) {
        std::vector<std::string> read;
        if (const auto found = in.find(key); found != in.end() && found->is_array())
            for (const auto& each : *found)
                if (each.is_string() && read.size() < most) read.push_back(each.get<std::string>());
        return read;
    };
    if (const auto found = json.find("tabs"); found != json.end() && found->is_array())
        for (const auto& each : *found)
            if (each.is_object() && each.contains("scene") && each["scene"].is_string() &&
                settings.tabs.size() < kMostTabs)
                settings.tabs.push_back(each["scene"].get<std::string>());
    settings.shownTab = static_cast<int>(number("shownTab", kMostTabs));
    settings.recent = texts(json, "recent", kMostRecent);
    return settings;
}

void writeSettings(const Settings& settings, const fs::path& file) {
    if (file.empty()) return;
    nlohmann::ordered_json tabs = nlohmann::ordered_json::array();
    for (const std::string& each : settings.tabs) tabs.push_back({{"scene", each}});
    const bool isFilled = settings.pictureShape == PictureShape::fill;
    const nlohmann::ordered_json json{{"windowWidth", settings.windowWidth},
                                      {"windowHeight", settings.windowHeight},
                                      {"panelWidth", settings.panelWidth},
                                      {"sourcePlace", static_cast<int>(settings.sourcePlace)},
                                      {"sourceBeside", settings.sourceBeside},
                                      {"sourceBelow", settings.sourceBelow},
                                      {"sourceOver", settings.sourceOver},
                                      {"showSource", settings.showSource},
                                      {"compilesWhileTyping", settings.compilesWhileTyping},
                                      {"wrapsLines", settings.wrapsLines},
                                      {"lightTheme", settings.lightTheme},
                                      {"labelCorner", static_cast<int>(settings.labelCorner)},
                                      {"labelChoice", static_cast<int>(settings.labelChoice)},
                                      {"hardcopyFolder", settings.hardcopyFolder},
                                      {"zoom", settings.zoom},
                                      {"samples", settings.samples},
                                      {"pictureShape", isFilled ? "fill" : "scene"},
                                      {"folds", settings.folds},
                                      {"layout", settings.layout},
                                      {"layoutScale", settings.layoutScale},
                                      {"tabs", tabs},
                                      {"shownTab", settings.shownTab},
                                      {"recent", settings.recent}};
    std::error_code failure;
    fs::create_directories(file.parent_path(), failure);
    const std::string text = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    image::writeFileAtomically(file, std::as_bytes(std::span(text)));
}

}  // namespace glibra::view
