#include "view/window/platform/settings.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>

#include "image/file.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kMostRecent = 12;

}  // namespace

void Settings::addRecent(const fs::path& scene) {
    std::error_code failure;
    const std::string whole = fs::absolute(scene, failure).lexically_normal().string();
    std::erase(recent, whole);
    recent.insert(recent.begin(), whole);
    if (recent.size() > kMostRecent) recent.resize(kMostRecent);
}

fs::path settingsFile() {
    if (const char* folder = std::getenv("XDG_CONFIG_HOME"); folder && *folder)
        return fs::path(folder) / "glibra" / "view.json";
    if (const char* home = std::getenv("HOME"); home && *home)
        return fs::path(home) / ".config" / "glibra" / "view.json";
    return {};
}

Settings readSettings(const fs::path& file) {
    Settings settings;
    const auto bytes = image::readFile(file, {file.string(), {}}, 1 << 20);
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
    settings.sourceWidth = static_cast<float>(number("sourceWidth", kLargestWindow));
    settings.sourceHeight = static_cast<float>(number("sourceHeight", kLargestWindow));
    const auto truth = [&](const char* key) {
        const auto found = json.find(key);
        return found != json.end() && found->is_boolean() && found->get<bool>();
    };
    if (const auto found = json.find("layout"); found != json.end() && found->is_string())
        settings.layout = found->get<std::string>();
    settings.lightTheme = truth("lightTheme");
    settings.showSource = truth("showSource");
    if (const auto found = json.find("recent"); found != json.end() && found->is_array())
        for (const auto& each : *found)
            if (each.is_string() && settings.recent.size() < kMostRecent)
                settings.recent.push_back(each.get<std::string>());
    return settings;
}

void writeSettings(const Settings& settings, const fs::path& file) {
    if (file.empty()) return;
    const nlohmann::ordered_json json{{"windowWidth", settings.windowWidth},
                                      {"windowHeight", settings.windowHeight},
                                      {"panelWidth", settings.panelWidth},
                                      {"sourceWidth", settings.sourceWidth},
                                      {"sourceHeight", settings.sourceHeight},
                                      {"showSource", settings.showSource},
                                      {"lightTheme", settings.lightTheme},
                                      {"layout", settings.layout},
                                      {"recent", settings.recent}};
    std::error_code failure;
    fs::create_directories(file.parent_path(), failure);
    const std::string text = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    image::writeFileAtomically(file, std::as_bytes(std::span(text)));
}

}  // namespace glibra::view
