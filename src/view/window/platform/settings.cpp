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
using Json = nlohmann::ordered_json;

constexpr std::size_t kMostRecent = 12;
constexpr std::size_t kMostFolds = 500;
constexpr std::size_t kMostTabs = 50;

/// Calls `each` with the settings and their keys in the file, in its order. Numbers come with their limits,
/// and lists with the most elements that they have.
void eachSetting(auto& settings, const auto& each) {
    constexpr double kLargestWindow = 16384;
    each("windowWidth", settings.windowWidth, 0, kLargestWindow);
    each("windowHeight", settings.windowHeight, 0, kLargestWindow);
    each("panelWidth", settings.panelWidth, 0, kLargestWindow);
    each("sourcePlace", settings.sourcePlace, SourcePlace::automatic, SourcePlace::over);
    each("sourceBeside", settings.sourceBeside, kLeastSource, kMostSource);
    each("sourceBelow", settings.sourceBelow, kLeastSource, kMostSource);
    each("sourceOver", settings.sourceOver, kLeastSource, kMostSource);
    each("showSource", settings.showSource);
    each("compilesWhileTyping", settings.compilesWhileTyping);
    each("wrapsLines", settings.wrapsLines);
    each("lightTheme", settings.lightTheme);
    each("labelCorner", settings.labelCorner, LabelCorner::bottomLeft, LabelCorner::topRight);
    each("labelChoice", settings.labelChoice, LabelChoice::all, LabelChoice::chosen);
    each("hardcopyFolder", settings.hardcopyFolder);
    each("zoom", settings.zoom, kLeastZoom, kMostZoom);
    each("samples", settings.samples, 0, kMostSamples);
    each("pictureShape", settings.pictureShape);
    each("folds", settings.folds, kMostFolds);
    each("layout", settings.layout);
    each("layoutScale", settings.layoutScale, 0, kMostZoom);
    each("tabs", settings.tabs, kMostTabs, "scene");
    each("shownTab", settings.shownTab, 0, kMostTabs);
    each("recent", settings.recent, kMostRecent);
}

/// Keeps the default of what is missing or has another type.
struct Reader {
    const Json& json;

    void operator()(const char* key, auto& to, auto least, auto most) const {
        const Json& value = of(key);
        if (value.is_number())
            to = static_cast<std::remove_reference_t<decltype(to)>>(
                std::clamp(value.get<double>(), static_cast<double>(least), static_cast<double>(most)));
    }
    void operator()(const char* key, bool& to) const {
        if (of(key).is_boolean()) to = of(key).get<bool>();
    }
    void operator()(const char* key, std::string& to) const {
        if (of(key).is_string()) to = of(key).get<std::string>();
    }
    void operator()(const char* key, PictureShape& to) const {
        if (of(key) == "fill") to = PictureShape::fill;
    }
    void operator()(const char* key, auto& folds, std::size_t most) const {
        if (!of(key).is_object()) return;
        for (const auto& [section, isOpen] : of(key).items())
            if (isOpen.is_boolean() && folds.size() < most) folds[section] = isOpen.template get<bool>();
    }
    /// `member`: of the objects that are the elements; null: they are texts.
    void operator()(const char* key, std::vector<std::string>& to, std::size_t most,
                    const char* member = nullptr) const {
        if (!of(key).is_array()) return;
        for (const Json& each : of(key)) {
            const Json text = member == nullptr  ? each
                              : each.is_object() ? each.value(member, Json())
                                                 : Json();
            if (text.is_string() && to.size() < most) to.push_back(text.get<std::string>());
        }
    }

  private:
    [[nodiscard]] const Json& of(const char* key) const {
        static const Json kMissing;
        const auto found = json.find(key);
        return found == json.end() ? kMissing : *found;
    }
};

struct Writer {
    Json& json;

    void operator()(const char* key, const auto& value, auto... /*limits*/) const { json[key] = value; }
    void operator()(const char* key, PictureShape shape) const {
        json[key] = shape == PictureShape::fill ? "fill" : "scene";
    }
    void operator()(const char* key, const std::vector<std::string>& texts, std::size_t /*most*/,
                    const char* member) const {
        json[key] = Json::array();
        for (const std::string& each : texts) json[key].push_back({{member, each}});
    }
};

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
    const Json json = Json::parse(text, text + bytes->size(), nullptr, false);
    if (!json.is_object()) return settings;
    eachSetting(settings, Reader{json});
    if (!(settings.layoutScale > 0)) settings.layoutScale = 1;
    return settings;
}

void writeSettings(const Settings& settings, const fs::path& file) {
    if (file.empty()) return;
    Json json;
    eachSetting(settings, Writer{json});
    std::error_code failure;
    fs::create_directories(file.parent_path(), failure);
    const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    image::writeFileAtomically(file, std::as_bytes(std::span(text)));
}

}  // namespace glibra::view
