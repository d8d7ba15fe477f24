// The values of a loaded scene: what they are, what fits them, and how they are set.

#include <fmt/format.h>
#include <glibra/scene.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "base/number.h"
#include "base/suggest.h"
#include "base/text.h"
#include "library/renderer_state.h"
#include "plan/overrides.h"

namespace glibra {
namespace {

std::string typeOf(const render::Knob& knob) {
    if (!knob.words.empty()) return "choice";
    if (!knob.type.word.empty()) return knob.type.word;
    const std::size_t count = knob.initial.size();
    if (knob.type.base == plan::BaseType::boolean) return "bool";
    return count == 1 ? "float" : fmt::format("vec{}", count);
}

/// The numbers of the value's type in words, if the type has no such number; else empty.
std::string limitsBroken(const render::Knob& knob, double value) {
    const auto limits = [&](double least, double most) {
        return value >= least && value <= most ? std::string()
                                               : fmt::format("numbers from {:.0f} to {:.0f}", least, most);
    };
    if (!knob.words.empty()) return {};
    if (knob.type.base == plan::BaseType::integer)
        return limits(std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max());
    if (knob.type.base == plan::BaseType::unsignedInteger)
        return limits(0, std::numeric_limits<std::uint32_t>::max());
    if (knob.type.base == plan::BaseType::floating && std::isinf(base::toFloat(value)))
        return fmt::format("numbers up to {:.7g}, the largest of 32 bits", std::numeric_limits<float>::max());
    return {};
}

std::size_t elementsOf(const render::Knob& knob) {
    return knob.initial.size() / static_cast<std::size_t>(std::max(knob.type.components(), 1));
}

/// Takes the subscript away: "uColors[1]" becomes "uColors". Nothing if there is none.
std::optional<std::size_t> takeSubscript(std::string_view& name) {
    const std::size_t open = name.rfind('[');
    if (open == std::string_view::npos || !name.ends_with(']')) return std::nullopt;
    const std::string_view digits = name.substr(open + 1, name.size() - open - 2);
    std::size_t number = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (problem != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    name = name.substr(0, open);
    return number;
}

/// What is wrong with these numbers for the value, or for one of so many parts of it; empty if nothing is.
std::string whyNot(const render::Knob& knob, std::string_view name, std::span<const double> values,
                   std::size_t parts) {
    const std::size_t wanted = knob.initial.size() / parts;
    if (values.size() != wanted)
        return fmt::format("'{}' takes {}, found {}", name, base::counted(wanted, "number"), values.size());
    for (const double each : values) {
        if (!std::isfinite(each)) return fmt::format("'{}': {} is not a finite number", knob.tag, each);
        if (!knob.words.empty() &&
            (each < 0 || each >= static_cast<double>(knob.words.size()) || each != std::floor(each)))
            return fmt::format("'{}': {} is not the number of a word, 0 to {}", knob.tag, each,
                               knob.words.size() - 1);
        if (knob.isInteger() && each != std::floor(each))
            return fmt::format("'{}' takes whole numbers, found {}", knob.tag, each);
        if (std::string limits = limitsBroken(knob, each); !limits.empty())
            return fmt::format("'{}' takes {}, found {}", knob.tag, limits, each);
        if (knob.type.base == plan::BaseType::boolean && each != 0 && each != 1)
            return fmt::format("'{}' is true (1) or false (0), found {}", knob.tag, each);
    }
    return {};
}

}  // namespace

/// With the values that have been set.
std::vector<render::Knob> Scene::State::knobs() const {
    std::vector<render::Knob> all = device.live->knobs();
    for (render::Knob& each : device.live->unsetKnobs()) all.push_back(std::move(each));
    for (const render::Knob& set : changed) {
        const auto same = std::ranges::find_if(all, [&](const render::Knob& each) {
            return each.tag == set.tag && each.program == set.program;
        });
        if (same == all.end()) {
            all.push_back(set);  // it is not unset any more
            continue;
        }
        same->current = set.current;
        same->initial = set.initial;  // a plan knows only the present value
    }
    std::ranges::stable_sort(all, {}, &render::Knob::program);
    return all;
}

std::vector<std::string> Scene::State::settings() const {
    std::vector<std::string> all;
    for (const render::Knob& each : changed)
        all.push_back(render::setArgument(device.live->scene(), each, device.live->knobs()));
    return all;
}

std::vector<Value> Scene::values() const {
    Result<std::vector<render::Knob>> knobs = State::guarded<std::vector<render::Knob>>(
        state_.get(), [&]() -> Result<std::vector<render::Knob>> { return state_->knobs(); });
    if (!knobs) return {};
    std::vector<Value> values;
    for (const render::Knob& knob : *knobs) {
        Value& to = values.emplace_back();
        to.name = knob.tag;
        if (knob.program) {
            const scene::Program& program = state_->device.live->scene().programs[knob.program];
            to.program = program.name;
            to.programLine = program.place.line;
        }
        to.type = typeOf(knob);
        to.value = knob.current;
        to.initial = knob.initial;
        to.hasRange = knob.form == glib::UniformForm::range;
        to.minimum = knob.minimum;
        to.maximum = knob.maximum;
        to.words = knob.words;
        to.place = knob.place;
    }
    return values;
}

Result<void> Scene::State::set(std::string_view name, std::span<const double> values, std::string_view text) {
    // A text is read as the command line reads it, which knows lines, programs, words and numbers.
    std::string_view tag = name;
    std::string program;
    if (const std::size_t colon = name.find(':'); colon != std::string_view::npos) {
        program = name.substr(0, colon);
        tag = name.substr(colon + 1);
    }
    const scene::Scene& scene = device.live->scene();
    std::vector<render::Knob> all = knobs();
    const auto isMeant = [&](const render::Knob& knob) {
        if (knob.tag == tag && program.empty()) return true;
        if (!knob.program) return false;
        const scene::Program& of = scene.programs[knob.program];
        if (knob.tag == tag && (of.name == program || std::to_string(of.place.line) == program)) return true;
        return program.empty() && tag == of.name + "." + knob.tag;
    };
    std::vector<render::Knob> meant;
    std::ranges::copy_if(all, std::back_inserter(meant), isMeant);
    std::optional<std::size_t> element;
    if (meant.empty()) element = takeSubscript(tag);
    if (element) {
        std::ranges::copy_if(all, std::back_inserter(meant), isMeant);
        std::erase_if(meant, [&](const render::Knob& each) { return *element >= elementsOf(each); });
    }
    if (meant.empty()) {
        std::vector<std::string_view> names;
        for (const render::Knob& each : all) names.push_back(each.tag);
        return diagnose("library-E02",
                        fmt::format("the scene has no value '{}'{}", name, base::suggestion(name, names)),
                        {path.generic_string(), 1, 1});
    }
    std::vector<double> read(values.begin(), values.end());
    if (values.empty()) {
        const auto& words = meant.front().words;
        if (const auto word = std::ranges::find(words, text); word != words.end()) {
            read = {static_cast<double>(word - words.begin())};
        } else {
            Result<plan::Override> parsed =
                plan::parseOverride(fmt::format("{}={}", meant.front().tag, text));
            if (!parsed || !parsed->word.empty())
                return diagnose("library-E03",
                                words.empty() ? fmt::format("'{}': expected numbers, found '{}'", tag, text)
                                              : fmt::format("'{}': expected one of {}, found '{}'", tag,
                                                            fmt::join(words, ", "), text),
                                {path.generic_string(), 1, 1});
            read = parsed->values;
        }
    }
    for (const render::Knob& each : meant)
        if (const std::string why = whyNot(each, name, read, element ? elementsOf(each) : 1); !why.empty())
            return diagnose("library-E03", why, each.place);
    for (render::Knob& each : meant) {
        if (!element) each.current = read;
        std::ranges::copy(
            read, each.current.begin() + static_cast<std::ptrdiff_t>(element.value_or(0) * read.size()));
        device.live->setValue(each);
        std::erase_if(changed, [&](const render::Knob& one) {
            return one.tag == each.tag && one.program == each.program;
        });
        changed.push_back(std::move(each));
    }
    return {};
}

Result<void> Scene::set(std::string_view name, double value) {
    return set(name, std::span<const double>(&value, 1));
}
Result<void> Scene::set(std::string_view name, int value) {
    return set(name, static_cast<double>(value));
}
Result<void> Scene::set(std::string_view name, bool value) {
    return set(name, value ? 1. : 0.);
}
Result<void> Scene::set(std::string_view name, std::initializer_list<double> values) {
    return set(name, std::span<const double>(values.begin(), values.size()));
}

Result<void> Scene::set(std::string_view name, std::span<const double> values) {
    if (values.empty()) return diagnose("library-E03", fmt::format("'{}': no numbers", name));
    return State::guarded<void>(state_.get(), [&] { return state_->set(name, values, {}); });
}

Result<void> Scene::set(std::string_view name, std::string_view text) {
    return State::guarded<void>(state_.get(), [&] { return state_->set(name, {}, text); });
}

}  // namespace glibra
