#include "classroom/moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "base/text.h"
#include "glib/number.h"
#include "suite/file/suite_file.h"
#include "suite/file/sweep.h"

namespace glibra::classroom {
namespace {}  // namespace

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

}  // namespace glibra::classroom
