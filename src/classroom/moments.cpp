#include "classroom/moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <utility>
#include <variant>

#include "base/contained.h"
#include "base/files.h"
#include "base/text.h"
#include "classroom/json_members.h"
#include "classroom/names.h"
#include "glib/number.h"
#include "image/png/png_writer.h"
#include "image/read.h"
#include "suite/file/suite_file.h"
#include "suite/file/sweep.h"
#include "suite/options/option_words.h"
#include "suite/write_below.h"

namespace glibra::classroom {

std::vector<Slider> slidersOf(std::span<const Moment> moments) {
    const auto valuesOf = [](const Moment& moment) {
        std::map<std::string, std::string> values;
        for (const std::string& each : moment.shot.options.set) {
            const std::size_t equals = std::min(each.find('='), each.size());
            values[std::string(base::trimmed(each.substr(0, equals)))] = each.substr(equals);
        }
        values["time"] = glib::numberText(moment.shot.options.time);
        return values;
    };
    const auto onlyDifference = [&](const Moment& a, const Moment& b) -> std::string {
        std::vector<std::pair<std::string, std::string>> different;  // sorted by names
        std::ranges::set_symmetric_difference(valuesOf(a), valuesOf(b), std::back_inserter(different));
        const bool isOne = !different.empty() && different.front().first == different.back().first;
        return isOne ? different.front().first : "";
    };
    std::vector<Slider> sliders;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        std::set<std::string> seen;
        for (std::size_t k = i + 1; k < moments.size(); ++k) {
            const std::string name = onlyDifference(moments[i], moments[k]);
            if (name.empty() || !seen.insert(name).second) continue;
            auto known = std::ranges::find(sliders, name, &Slider::name);
            if (known == sliders.end()) known = sliders.insert(sliders.end(), {name, {}});
            if (known->pairs.size() < kMostPairs) known->pairs.emplace_back(i, k);
        }
    }
    return sliders;
}

Result<std::vector<Moment>> momentsOfSuite(const std::filesystem::path& file) {
    const Result<suite::Exercise> exercise = suite::readExercise(file);
    if (hasError(exercise.diagnostics)) return exercise.diagnostics;
    if (exercise) return momentsOf(*exercise, file);
    Result<suite::Suite> read = suite::readSuite(file);
    if (!read) return std::move(read.diagnostics);
    if (read->shots.size() > suite::kMostMoments) return suite::tooManyMoments(read->shots.size());
    std::vector<Moment> moments;
    for (const suite::Shot& shot : read->shots) {
        if (shot.script != read->shots.front().script)
            return withoutId(
                Severity::error,
                fmt::format("the suite of a reference has one scene, found '{}' and '{}'",
                            read->shots.front().script.generic_string(), shot.script.generic_string()),
                shot.place);
        Moment moment{read->shots.size() > 1 ? shot.name : "", {}};
        moment.shot.script = shot.script;
        moment.shot.options = shot.options;
        moment.shot.ownUniforms = shot.ownUniforms;
        moment.shot.options.floatPixels = false;  // a browser shows no such pictures
        moment.shot.memory = shot.memory;
        moments.push_back(std::move(moment));
    }
    if (moments.empty())
        return withoutId(Severity::error, "the suite has no shots", {file.generic_string(), 1, 1});
    return {std::move(moments), std::move(read.diagnostics)};
}

namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

constexpr std::uint64_t kLargestDescription = std::uint64_t{4} << 20U;
constexpr std::uint64_t kLargestReference = std::uint64_t{1} << 30U;

/// False for options that name files of one machine or say what its processes may take.
bool isHandedOut(const suite::OptionRow& row) {
    return !row.name.empty() && !std::holds_alternative<suite::FoldersValue>(row.value) &&
           !std::holds_alternative<suite::MemoryValue>(row.value);
}

/// The options of a shot as words of a command line: {"--time", "0.5", "--set", "uKd=1"}.
OrderedJson optionWordsOf(const suite::Shot& shot) {
    OrderedJson words = OrderedJson::array();
    for (const suite::OptionRow& row : suite::optionTable())
        if (isHandedOut(row))
            for (std::string& each : suite::optionWords(row, shot)) words.push_back(std::move(each));
    return words;
}

/// Gives a shot options that optionWordsOf wrote. Returns what is wrong, or an empty text.
std::string readOptions(const std::vector<std::string>& words, suite::Shot& shot) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const suite::OptionRow* row = word.starts_with("--") ? suite::findOption(word.substr(2)) : nullptr;
        if (!row || !isHandedOut(*row)) return fmt::format("'{}' is no option of a picture", word);
        std::string value;
        if (!std::holds_alternative<suite::FlagValue>(row->value)) {
            if (++i >= words.size()) return fmt::format("'{}' has no value", word);
            value = words[i];
        }
        if (const std::string wrong = suite::readOptionText(*row, value, shot); !wrong.empty())
            return fmt::format("{}: {}", word, wrong);
    }
    return {};
}

OrderedJson colorsOf(const std::optional<suite::ColorShare>& has) {
    if (!has) return nullptr;
    return {{"color", has->color}, {"within", has->within}, {"least", has->least}, {"most", has->most}};
}

/// The names of the pictures, which every system accepts: "uTol=0.1.png".
std::vector<std::string> pictureFiles(const std::vector<Moment>& moments) {
    std::vector<std::string> names;
    for (const Moment& each : moments) names.push_back(each.label.empty() ? "reference" : each.label);
    names = fileNames(std::move(names));
    for (std::string& each : names) each += ".png";
    return names;
}

Diagnostic unreadable(const fs::path& folder, const std::exception& why, std::string_view text) {
    return wrongFile("suite-E35", "these are no pictures of a reference: ", why, text,
                     (folder / kReferenceFile).generic_string());
}

suite::ColorShare colorsIn(const OrderedJson& json) {
    return {valueOf<std::array<double, 3>>(json, "color"), valueOf<double>(json, "within"),
            valueOf<double>(json, "least"), valueOf<double>(json, "most")};
}

Result<ReferencePictures> parsed(const std::string& text, const fs::path& folder) try {
    const OrderedJson json = OrderedJson::parse(text);
    ReferencePictures found;
    found.scene = fs::path(valueOf<std::string>(json, "scene")).filename().generic_string();
    for (const OrderedJson& each : valueOf<std::vector<OrderedJson>>(json, "pictures")) {
        Moment moment;
        moment.label = valueOf<std::string>(each, "label");
        if (const std::string wrong =
                readOptions(valueOf<std::vector<std::string>>(each, "options"), moment.shot);
            !wrong.empty())
            throw std::runtime_error(wrong);
        if (const auto has = valueOf<OrderedJson>(each, "has"); !has.is_null())
            moment.has = inMember("has", [&] { return colorsIn(has); });
        found.moments.push_back(std::move(moment));
        found.files.push_back(folder / fs::path(valueOf<std::string>(each, "file")).filename());
    }
    if (found.moments.empty()) throw std::runtime_error("there are none");
    if (found.moments.size() > suite::kMostMoments) return suite::tooManyMoments(found.moments.size());
    return found;
} catch (const std::exception& problem) {
    return unreadable(folder, problem, text);
}

}  // namespace

bool hasReferencePictures(const fs::path& folder) {
    std::error_code failure;
    return fs::exists(folder / kReferenceFile, failure);
}

Result<ReferencePictures> readReferencePictures(const fs::path& folder) {
    const auto text = base::textIn(base::openBeneath(folder, kReferenceFile), kLargestDescription);
    return text ? parsed(*text, folder) : unreadable(folder, std::runtime_error("it cannot be read"), "");
}

Diagnostics writeReferencePictures(const Classroom& room, const fs::path& site, const fs::path& folder) {
    const std::vector<std::string> files = pictureFiles(room.moments);
    if (const Result<ReferencePictures> earlier = readReferencePictures(folder))
        for (const fs::path& each : earlier->files) base::removeBeneath(folder, each.filename());
    OrderedJson json = {{"scene", room.reference.submission.scene.filename().generic_string()},
                        {"pictures", OrderedJson::array()}};
    for (std::size_t i = 0; i < room.moments.size(); ++i) {
        const std::string& drawn = room.reference.pictures[i].file;
        const auto bytes = base::bytesIn(base::openBeneath(site, drawn), kLargestReference);
        if (!bytes) return {suite::cannotWrite(folder / files[i], EIO)};
        // Written anew, because a PNG file may tell more than its pixels.
        const Result<image::Image> picture = image::decodeImage(*bytes, site / drawn);
        if (!picture) return picture.diagnostics;
        if (Diagnostics problems = suite::writeBelow(folder, files[i], image::encodePng(*picture));
            !problems.empty())
            return problems;
        json["pictures"].push_back({{"file", files[i]},
                                    {"label", room.moments[i].label},
                                    {"options", optionWordsOf(room.moments[i].shot)},
                                    {"has", colorsOf(room.moments[i].has)}});
    }
    const std::string text = json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
    return suite::writeBelow(folder, kReferenceFile, std::as_bytes(std::span(text)));
}

}  // namespace glibra::classroom
