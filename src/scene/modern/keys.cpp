// Key: what a key of the keyboard does (language, 12.8).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>

#include "base/suggest.h"
#include "glib/number.h"
#include "glib/text.h"
#include "scene/modern/evaluate.h"
#include "scene/modern/modern.h"
#include "scene/state.h"

namespace glibra::scene {
namespace {

using glib::Command;
using glib::Value;

/// The variable of that name with its control; null with glib-E27 reported.
const Variable* variableNamed(Interpreter& in, const Value& value) {
    for (const Variable& each : in.scene.variables)
        if (each.name == value.text) return &each;
    if (isLost(in, value.text)) return nullptr;
    std::vector<std::string_view> names;
    for (const Variable& each : in.scene.variables) names.push_back(each.name);
    in.report(diagnose("glib-E27",
                       fmt::format("Key: no variable '{}' with a control is declared before this line{}",
                                   value.text, base::suggestion(value.text, names)),
                       in.script->place(value.position)));
    return nullptr;
}

/// The components of a value that the key sets.
std::optional<std::vector<double>> valueForKey(Interpreter& in, const Value& value, const Variable& variable,
                                               bool isSpeed) {
    if (value.kind == Value::Kind::word) {
        for (std::size_t i = 0; i < variable.words.size(); ++i)
            if (glib::sameWord(variable.words[i], value.text)) return std::vector{static_cast<double>(i)};
        const std::vector<std::string_view> words(variable.words.begin(), variable.words.end());
        in.report(diagnose("glib-E26",
                           fmt::format("Key: '{}' has no choice '{}'{}", variable.name, value.text,
                                       base::suggestion(value.text, words)),
                           in.script->place(value.position)));
        return std::nullopt;
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
        in.report(diagnose("glib-E26",
                           fmt::format("Key: {} is not between {} and {}, which '{}' allows",
                                       glib::numberText(each), glib::numberText(variable.least()),
                                       glib::numberText(variable.largest()), variable.name),
                           in.script->place(value.position)));
        return std::nullopt;
    }
    if (numbers->size() == variable.current.size()) return numbers;
    in.report(diagnose("glib-E26",
                       fmt::format("Key: '{}' has {} components, not {}", variable.name,
                                   variable.current.size(), numbers->size()),
                       in.script->place(value.position)));
    return std::nullopt;
}

constexpr std::string_view kKeyNames[] = {"space", "enter", "left", "right", "up", "down"};

/// A letter, a digit, or one of the names.
bool isKey(std::string_view key) {
    const auto isSame = [&](std::string_view name) { return glib::sameWord(name, key); };
    if (std::any_of(std::begin(kKeyNames), std::end(kKeyNames), isSame)) return true;
    const char lower = key.size() == 1 ? static_cast<char>(key[0] | 0x20) : ' ';
    return key.size() == 1 && ((lower >= 'a' && lower <= 'z') || (key[0] >= '0' && key[0] <= '9'));
}

void doKey(Interpreter& in, const Command& command) {
    KeyBinding binding;
    const Value& key = command.values.front();
    binding.key = key.kind == Value::Kind::number ? fmt::format("{}", key.number) : key.text;
    binding.place = in.place(command);
    if (!isKey(binding.key)) {
        in.report(diagnose("glib-E26",
                           fmt::format("Key: '{}' is no key; write a letter, a digit, space, enter, left, "
                                       "right, up or down",
                                       binding.key),
                           in.script->place(key.position)));
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
        in.report(diagnose("glib-E26",
                           fmt::format("Key: '{}' has no values between its {}, through which a held key "
                                       "could move it",
                                       variable->name, variable->words.empty() ? "two" : "words"),
                           in.script->place(rest.front().position)));
        return;
    }
    for (const Value& each : rest.subspan(1)) {
        auto value = valueForKey(in, each, *variable, binding.isHeld);
        if (!value) return;
        binding.values.push_back(std::move(*value));
    }
    in.scene.keys.push_back(std::move(binding));
}

constexpr CommandAction kKeyActions[] = {{glib::CommandId::key, doKey}};

}  // namespace

std::span<const CommandAction> keyActions() {
    return kKeyActions;
}

}  // namespace glibra::scene
