#include "suite/file/shot_template.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <system_error>
#include <utility>

#include "glib/diagnostic_catalogue.h"
#include "glib/suggest.h"
#include "glib/text.h"
#include "suite/file/missing_folder.h"
#include "suite/file/shot_name.h"
#include "suite/file/shot_view.h"

namespace glibra::suite {
namespace {

constexpr double kLongestTime = 1e9;
constexpr double kNoLimit = std::numeric_limits<double>::max();

struct Context {
    TomlReader& reader;
    const std::filesystem::path& folder;
    ShotTemplate& to;
};

void readSize(const Context& in, const toml::node& node) {
    constexpr std::string_view kWanted = "[WIDTH, HEIGHT] or \"WIDTHxHEIGHT\"";
    int width = 0;
    int height = 0;
    if (const auto* text = node.as_string()) {
        const std::string& size = **text;
        const char* const end = size.data() + size.size();
        const auto first = std::from_chars(size.data(), end, width);
        if (first.ec != std::errc() || first.ptr == end || *first.ptr != 'x')
            return in.reader.wrongType(node, "size", kWanted);
        const auto second = std::from_chars(first.ptr + 1, end, height);
        if (second.ec != std::errc() || second.ptr != end) return in.reader.wrongType(node, "size", kWanted);
        if (std::min(width, height) < 1 || std::max(width, height) > kLargestPictureSide)
            return in.reader.error(
                "suite-E04", fmt::format("size: {} is not 1 to {} pixels a side", size, kLargestPictureSide),
                in.reader.placeOf(node));
    } else {
        const toml::array* list = node.as_array();
        if (!list || list->size() != 2) return in.reader.wrongType(node, "size", kWanted);
        const auto first = in.reader.whole(*list->get(0), "size", 1, kLargestPictureSide);
        const auto second = in.reader.whole(*list->get(1), "size", 1, kLargestPictureSide);
        if (!first || !second) return;
        width = *first;
        height = *second;
    }
    in.to.shot.options.width = width;
    in.to.shot.options.height = height;
}

void readTime(const Context& in, const toml::node& node) {
    const toml::array* list = node.as_array();
    std::vector<double> times;
    if (!list) {
        if (const auto one = in.reader.number(node, "time", -kLongestTime, kLongestTime))
            times.push_back(*one);
    } else if (list->empty()) {
        in.reader.error("suite-E04", "time: the list is empty", in.reader.placeOf(node));
    } else {
        for (const toml::node& each : *list)
            if (const auto one = in.reader.number(each, "time", -kLongestTime, kLongestTime))
                times.push_back(*one);
    }
    if (times.empty()) return;
    in.to.times = std::move(times);
    in.to.namesTimes = list != nullptr;
}

void readSet(const Context& in, const toml::node& node) {
    const toml::table* table = in.reader.table(node, "set");
    if (!table) return;
    for (UniformValues& each : readUniforms(in.reader, *table, UniformTable::set)) {
        const auto same = std::find_if(in.to.set.begin(), in.to.set.end(),
                                       [&](const UniformValues& old) { return old.name == each.name; });
        if (same == in.to.set.end())
            in.to.set.push_back(std::move(each));
        else
            *same = std::move(each);
    }
}

void readSweep(const Context& in, const toml::node& node) {
    if (const toml::table* table = in.reader.table(node, "sweep"))
        in.to.sweeps = readUniforms(in.reader, *table, UniformTable::sweep);
}

void readView(const Context& in, const toml::node& node) {
    const auto* text = node.as_string();
    if (text && **text == "auto")
        in.to.shot.options.view = ViewPolicy::automatic;
    else if (text && **text == "glman")
        in.to.shot.options.view = ViewPolicy::glman;
    else
        in.reader.wrongType(node, "view", "\"auto\" or \"glman\"");
}

void readTolerance(const Context& in, const toml::node& node) {
    struct Field {
        std::string_view key;
        double most;
        void (*store)(image::Tolerance&, double);
        bool isWhole = false;
    };
    static constexpr std::array<Field, 9> kFields{{
        {"max", 255, [](image::Tolerance& to, double v) { to.largest = v; }},
        {"fraction", 1, [](image::Tolerance& to, double v) { to.fraction = v; }},
        {"cluster", 1e9, [](image::Tolerance& to, double v) { to.cluster = static_cast<int>(v); }, true},
        {"line", 1e9, [](image::Tolerance& to, double v) { to.line = static_cast<int>(v); }, true},
        {"bias", 255, [](image::Tolerance& to, double v) { to.bias = v; }},
        {"flip", 1, [](image::Tolerance& to, double v) { to.flip = v; }},
        {"structure", 1, [](image::Tolerance& to, double v) { to.structure = v; }},
        {"relative", kNoLimit, [](image::Tolerance& to, double v) { to.relative = v; }},
        {"absolute", kNoLimit, [](image::Tolerance& to, double v) { to.absolute = v; }},
    }};
    const toml::table* table = in.reader.table(node, "tolerance");
    if (!table) return;
    for (const TomlEntry& entry : in.reader.entries(*table)) {
        const auto* const field = std::find_if(kFields.begin(), kFields.end(),
                                               [&](const Field& each) { return each.key == entry.key; });
        if (field == kFields.end()) {
            std::array<std::string_view, kFields.size()> keys;
            std::transform(kFields.begin(), kFields.end(), keys.begin(),
                           [](const Field& f) { return f.key; });
            in.reader.unknownKey(entry, "in tolerance", keys);
        } else {
            const std::string name = fmt::format("tolerance.{}", field->key);
            std::optional<double> value;
            if (!field->isWhole)
                value = in.reader.number(*entry.value, name, 0, field->most);
            else if (const auto pixels =
                         in.reader.whole(*entry.value, name, 0, static_cast<int>(field->most)))
                value = *pixels;
            if (value) field->store(in.to.shot.tolerance, *value);
        }
    }
}

void readTags(const Context& in, const toml::node& node) {
    const auto tags = in.reader.texts(node, "tags");
    if (!tags) return;
    for (const std::string& each : *tags) {
        std::string why = whyNotAName(each);
        if (why.empty() && each.find('/') != std::string::npos) why = "has '/' in it";
        if (!why.empty())
            in.reader.error("suite-E05", fmt::format("tag {} {}", glib::inQuotes(each), why),
                            in.reader.placeOf(node));
        else if (std::find(in.to.shot.tags.begin(), in.to.shot.tags.end(), each) == in.to.shot.tags.end())
            in.to.shot.tags.push_back(each);
    }
}

/// An id of the catalogue, or suite-E17 with the nearest.
void readErrorId(const Context& in, const toml::node& node, std::string_view name, ExpectedError& expected) {
    const auto id = in.reader.text(node, name);
    if (!id) return;
    expected.id = *id;
    if (glib::findDiagnostic(*id)) return;
    std::vector<std::string_view> ids;
    for (const glib::CatalogueRow& row : glib::diagnosticCatalogue()) ids.push_back(row.id);
    const std::string meant = glib::suggestion(*id, ids);
    in.reader.error("suite-E17",
                    fmt::format("{}: there is no message {}{}", name, glib::inQuotes(*id),
                                meant.empty() ? "; 'glibra language --diagnostics' lists them" : meant),
                    in.reader.placeOf(node));
}

void readExpectedError(const Context& in, const toml::node& node) {
    constexpr std::string_view kName = "expect-error";
    ExpectedError expected;
    if (const toml::table* table = node.as_table()) {
        static constexpr std::array<std::string_view, 3> kKeys{"id", "text", "line"};
        for (const TomlEntry& entry : in.reader.entries(*table)) {
            if (entry.key == "id") {
                readErrorId(in, *entry.value, "expect-error.id", expected);
            } else if (entry.key == "text") {
                expected.text = in.reader.text(*entry.value, "expect-error.text").value_or("");
            } else if (entry.key == "line") {
                expected.line =
                    in.reader.whole(*entry.value, "expect-error.line", 1, std::numeric_limits<int>::max())
                        .value_or(0);
            } else {
                in.reader.unknownKey(entry, "in expect-error", kKeys);
            }
        }
    } else if (node.is_string()) {
        readErrorId(in, node, kName, expected);
    } else if (const auto* any = node.as_boolean(); !any || !**any) {
        return in.reader.wrongType(node, kName, "an id, as \"glsl-E01\", a table { id, text, line } or true");
    }
    in.to.shot.expectedError = std::move(expected);
}

void readLibrary(const Context& in, const toml::node& node) {
    const auto folders = in.reader.texts(node, "library");
    if (!folders) return;
    in.to.shot.options.libraryRoots.clear();
    for (const std::string& each : *folders) {
        const std::filesystem::path path = (in.folder / each).lexically_normal();
        std::error_code failure;
        if (std::filesystem::is_regular_file(path, failure))
            in.reader.error("suite-E10",
                            fmt::format("library: {} is not a folder", glib::inQuotes(path.string())),
                            in.reader.placeOf(node));
        else if (const std::string why = whyNoFolder(path); !why.empty())
            in.reader.error("suite-E10", "library: " + why, in.reader.placeOf(node));
        in.to.shot.options.libraryRoots.push_back(path);
    }
}

void readScript(const Context& in, const toml::node& node) {
    if (const auto scripts = in.reader.texts(node, "script"))
        for (std::size_t i = 0; i < scripts->size(); ++i)
            in.to.scripts.push_back(
                {(*scripts)[i], in.reader.placeOf(node.is_array() ? *node.as_array()->get(i) : node)});
    in.to.isList = node.is_array();
}

void readExceptions(const Context& in, const toml::node& node) {
    if (const auto patterns = in.reader.texts(node, "except"))
        for (const std::string& each : *patterns) in.to.exceptions.push_back({each, in.reader.placeOf(node)});
}

template <std::optional<PlacedText> ShotTemplate::*field>
void readName(const Context& in, const toml::node& node) {
    constexpr std::string_view kWord = field == &ShotTemplate::name    ? "name"
                                       : field == &ShotTemplate::match ? "match"
                                                                       : "differ";
    const auto text = in.reader.text(node, kWord);
    if (!text) return;
    if (const std::string why = whyNotAName(*text); !why.empty())
        return in.reader.error("suite-E05", fmt::format("{}: {} {}", kWord, glib::inQuotes(*text), why),
                               in.reader.placeOf(node));
    in.to.*field = PlacedText{*text, in.reader.placeOf(node)};
}

template <bool RenderOptions::*field>
void readFlag(const Context& in, const toml::node& node) {
    constexpr std::string_view kWord = field == &RenderOptions::axes             ? "axes"
                                       : field == &RenderOptions::alpha          ? "alpha"
                                       : field == &RenderOptions::floatPixels    ? "float"
                                       : field == &RenderOptions::strict         ? "strict"
                                       : field == &RenderOptions::overrideCounts ? "override-counts"
                                                                                 : "shim";
    if (const auto value = in.reader.truth(node, kWord)) in.to.shot.options.*field = *value;
}

template <Matrix ViewState::*field>
void readTransform(const Context& in, const toml::node& node) {
    constexpr std::string_view kWord = field == &ViewState::scene ? "scene-transform"
                                       : field == &ViewState::eye ? "eye-transform"
                                                                  : "texture-transform";
    readMatrix(in.reader, node, kWord, in.to.shot.options.viewState.*field);
}

struct Key {
    std::string_view name;
    bool inDefaults;
    void (*read)(const Context&, const toml::node&);
};

/// Every key of [[shot]] and [defaults].
constexpr std::array<Key, 31> kKeys{{
    {"script", false, readScript},
    {"except", false, readExceptions},
    {"name", false, readName<&ShotTemplate::name>},
    {"size", true, readSize},
    {"time", true, readTime},
    {"set", true, readSet},
    {"sweep", false, readSweep},
    {"samples", true,
     [](const Context& in, const toml::node& node) {
         if (const auto value = in.reader.whole(node, "samples", 1, 64)) in.to.shot.options.samples = *value;
     }},
    {"max-error", true,
     [](const Context& in, const toml::node& node) {
         if (const auto value = in.reader.number(node, "max-error", kLeastMaxError, kLargestMaxError))
             in.to.shot.options.maxError = *value;
     }},
    {"override-counts", true, readFlag<&RenderOptions::overrideCounts>},
    {"view", true, readView},
    {"scene-transform", true, readTransform<&ViewState::scene>},
    {"eye-transform", true, readTransform<&ViewState::eye>},
    {"texture-transform", true, readTransform<&ViewState::texture>},
    {"object-transform", true,
     [](const Context& in, const toml::node& node) {
         readObjectTransforms(in.reader, node, in.to.shot.options.viewState);
     }},
    {"projection", true,
     [](const Context& in, const toml::node& node) {
         readProjection(in.reader, node, in.to.shot.options.viewState);
     }},
    {"background", true,
     [](const Context& in, const toml::node& node) {
         readBackground(in.reader, node, in.to.shot.options.viewState);
     }},
    {"axes", true, readFlag<&RenderOptions::axes>},
    {"alpha", true, readFlag<&RenderOptions::alpha>},
    {"float", true, readFlag<&RenderOptions::floatPixels>},
    {"strict", true, readFlag<&RenderOptions::strict>},
    {"shim", true, readFlag<&RenderOptions::shim>},
    {"tile", true,
     [](const Context& in, const toml::node& node) {
         if (const auto value = in.reader.whole(node, "tile", 16, 16384))
             in.to.shot.options.tileSize = *value;
     }},
    {"library", true, readLibrary},
    {"timeout", true,
     [](const Context& in, const toml::node& node) {
         if (const auto value = in.reader.number(node, "timeout", 0, 1e6)) in.to.shot.timeout = *value;
     }},
    {"tolerance", true, readTolerance},
    {"tags", true, readTags},
    {"expect-error", false, readExpectedError},
    {"match", false, readName<&ShotTemplate::match>},
    {"differ", false, readName<&ShotTemplate::differ>},
    {"golden", true,
     [](const Context& in, const toml::node& node) {
         if (const auto value = in.reader.truth(node, "golden")) in.to.shot.golden = *value;
     }},
}};

const Key* findKey(std::string_view name) {
    const auto* const found =
        std::find_if(kKeys.begin(), kKeys.end(), [&](const Key& key) { return key.name == name; });
    return found == kKeys.end() ? nullptr : found;
}

}  // namespace

void readTemplate(TomlReader& reader, const toml::table& table, const std::filesystem::path& folder,
                  bool isDefaults, ShotTemplate& shot) {
    const Context in{reader, folder, shot};
    for (const TomlEntry& entry : reader.entries(table)) {
        const Key* key = findKey(entry.key);
        if (key && (key->inDefaults || !isDefaults)) {
            key->read(in, *entry.value);
        } else if (key) {
            reader.error("suite-E02",
                         fmt::format("'{}' belongs to one shot and cannot stand in [defaults]", entry.key),
                         entry.keyPlace);
        } else {
            std::vector<std::string_view> names;
            for (const Key& each : kKeys)
                if (each.inDefaults || !isDefaults) names.push_back(each.name);
            reader.unknownKey(entry, isDefaults ? "in [defaults]" : "in [[shot]]", names);
        }
    }
}

bool isShotKey(std::string_view key) {
    return findKey(key) != nullptr;
}

bool isDefaultsKey(std::string_view key) {
    const Key* found = findKey(key);
    return found && found->inDefaults;
}

}  // namespace glibra::suite
