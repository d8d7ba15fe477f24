// Key: what a key of the keyboard does (language, 12.8).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/suggest.h"
#include "glib/number.h"
#include "glib/text.h"
#include "scene/modern/modern.h"
#include "scene/run/evaluate.h"

namespace glibra::scene {
namespace {

/// The variable of that name with its control; null with glib-E27 reported.
const Variable* variableNamed(Interpreter& in, const Value& value) {
    for (const Variable& each : in.scene.variables)
        if (each.name == value.text) return &each;
    if (in.modern.lostNames.contains(value.text)) return nullptr;
    std::vector<std::string_view> names;
    for (const Variable& each : in.scene.variables) names.push_back(each.name);
    in.reportAt(value, "glib-E27",
                fmt::format("Key: no variable '{}' with a control is declared before this line{}", value.text,
                            base::suggestion(value.text, names)));
    return nullptr;
}

/// The components of a value that the key sets.
std::optional<std::vector<double>> valueForKey(Interpreter& in, const Value& value, const Variable& variable,
                                               bool isSpeed) {
    if (value.kind == Value::Kind::word) {
        for (std::size_t i = 0; i < variable.words.size(); ++i)
            if (glib::sameWord(variable.words[i], value.text)) return std::vector{static_cast<double>(i)};
        const std::vector<std::string_view> words(variable.words.begin(), variable.words.end());
        return in.reportAt(value, "glib-E16",
                           fmt::format("Key: '{}' has no choice '{}'{}", variable.name, value.text,
                                       base::suggestion(value.text, words)));
    }
    auto numbers = numbersOf(in, {&value, 1});
    if (!numbers) return std::nullopt;
    const bool isSlider = variable.form == glib::UniformForm::range && variable.words.empty();
    for (double& each : *numbers) {
        if (!isSlider || isSpeed || (each >= variable.least() && each <= variable.largest())) continue;
        // What is computed from the present value stops at the ends of the slider.
        if (value.kind == Value::Kind::expression && std::isfinite(each)) {
            each = std::clamp(each, variable.least(), variable.largest());
            continue;
        }
        return in.reportAt(value, "glib-E05",
                           fmt::format("Key: {} is not between {} and {}, which '{}' allows",
                                       glib::numberText(each), glib::numberText(variable.least()),
                                       glib::numberText(variable.largest()), variable.name));
    }
    if (numbers->size() == variable.current.size()) return numbers;
    return in.reportAt(value, "glib-E26",
                       fmt::format("Key: '{}' has {} components, not {}", variable.name,
                                   variable.current.size(), numbers->size()));
}

constexpr std::string_view kKeyNames[] = {"space", "enter", "left", "right", "up", "down"};

/// A letter, a digit, or one of the names.
bool isKey(std::string_view key) {
    return glib::isAmong(key, kKeyNames) ||
           (key.size() == 1 && (glib::isLetter(key[0]) || glib::isDigit(key[0])));
}

void doKey(Interpreter& in, const Command& command) {
    KeyBinding binding;
    const Value& key = command.values.front();
    binding.key = key.kind == Value::Kind::number ? fmt::format("{}", key.number) : key.text;
    binding.place = in.place(command);
    if (!isKey(binding.key)) {
        in.reportAt(key, "glib-E16",
                    fmt::format("Key: '{}' is no key; write a letter, a digit, space, enter, left, "
                                "right, up or down",
                                binding.key));
        return;
    }
    if (command.key("restart") != nullptr) {
        binding.restarts = true;
        in.scene.keys.push_back(std::move(binding));
        return;
    }
    binding.isHeld = command.key("held") != nullptr;
    const std::span<const Value> rest =
        binding.isHeld ? std::span(command.key("held")->values) : std::span(command.values).subspan(1);
    if (rest.size() < 2) return;
    const Variable* variable = variableNamed(in, rest.front());
    if (variable == nullptr) return;
    binding.variable = variable->name;
    const bool isNumeric = variable->words.empty() && variable->form != glib::UniformForm::truth;
    if (binding.isHeld && !isNumeric) {
        in.reportAt(rest.front(), "glib-E32",
                    fmt::format("Key: '{}' has no values between its {}, through which a held key "
                                "could move it",
                                variable->name, variable->words.empty() ? "two" : "words"));
        return;
    }
    for (const Value& each : rest.subspan(1)) {
        auto value = valueForKey(in, each, *variable, binding.isHeld);
        if (!value) return;
        binding.values.push_back(std::move(*value));
    }
    in.scene.keys.push_back(std::move(binding));
}

}  // namespace

std::span<const CommandAction> keyActions() {
    static constexpr CommandAction kActions[] = {{CommandId::key, doKey}};
    return kActions;
}

}  // namespace glibra::scene
