// Knobs as text, for scenes and command lines.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/live/knobs.h"

namespace glibra::render {
namespace {

/// The shortest decimal number that reads back as the same value.
std::string exact(double value) {
    if (value == std::trunc(value) && std::abs(value) < 1e9) return fmt::format("{:.0f}", value);
    return fmt::format("{}", value);
}

std::string joined(const std::vector<double>& values, std::size_t count, std::string_view between) {
    std::string text;
    for (const double each : std::span(values).first(std::min(count, values.size())))
        text += (text.empty() ? "" : std::string(between)) + exact(each);
    return text;
}

bool sameValues(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [&](double each) { return each == values.front(); });
}

}  // namespace

std::string valueText(const Knob& knob) {
    if (!knob.words.empty()) {  // the file cannot state which of the words is chosen
        std::string words;
        for (const std::string& each : knob.words) words += (words.empty() ? "<" : " ") + each;
        return words + ">";
    }
    switch (knob.form) {
        case glib::UniformForm::range:
            if (knob.widget == Widget::checkBox) return knob.current.front() != 0 ? "<true>" : "<false>";
            if (knob.bound)  // its finest value may be the smaller one
                return fmt::format("<{} {} {}>", exact(knob.bound->coarsest), exact(knob.current.front()),
                                   exact(knob.bound->finest));
            if (!knob.program || sameValues(knob.current)) {
                // A variable has a value per component, a uniform variable one for all.
                const std::size_t count = knob.program ? 1 : knob.current.size();
                return fmt::format("<{} {} {}>", exact(knob.minimum), joined(knob.current, count, " "),
                                   exact(knob.maximum));
            }
            break;
        case glib::UniformForm::truth:
            return knob.current.front() != 0 ? "<true>" : "<false>";
        case glib::UniformForm::color:
            return "{" + joined(knob.current, knob.current.size(), " ") + "}";
        case glib::UniformForm::number:
            if (knob.current.size() == 1) return exact(knob.current.front());
            break;
        case glib::UniformForm::list:
            break;
    }
    return "[" + joined(knob.current, knob.current.size(), " ") + "]";
}

std::string pairText(const Knob& knob) {
    return knob.tag + " " + valueText(knob);
}

std::string programLine(const scene::Scene& scene, scene::ProgramIndex program, std::span<const Knob> knobs) {
    std::string text;
    if (!program) {
        for (const Knob& each : knobs)
            if (!each.program) text += (each.bound ? "Bound " : "Let ") + pairText(each) + "\n";
        return text;
    }
    text = "Program " + scene.programs[program].name;
    for (const Knob& each : knobs)
        if (each.program == program) text += " \\\n    " + pairText(each);
    return text + "\n";
}

std::string labelBegin(const Knob& knob) {
    return (knob.program ? knob.title + " : " : "") + knob.tag + " = ";
}

std::vector<std::string> onlyLabels(std::vector<std::string> labels, std::span<const std::string> only) {
    if (only.empty()) return labels;
    std::erase_if(labels, [&](const std::string& label) {
        return std::ranges::none_of(only, [&](const std::string& begin) { return label.starts_with(begin); });
    });
    return labels;
}

std::string setArgument(const scene::Scene& scene, const Knob& knob, std::span<const Knob> knobs) {
    const bool isShared =
        knob.program && (knob.isShared || std::any_of(knobs.begin(), knobs.end(), [&](const Knob& each) {
                             return each.tag == knob.tag && each.program != knob.program;
                         }));
    std::string name = knob.tag;
    if (isShared) name = fmt::format("{}:{}", scene.programs[knob.program].place.line, name);
    if (knob.widget == Widget::checkBox) return name + (knob.current.front() != 0 ? "=true" : "=false");
    return name + "=" + joined(knob.current, knob.current.size(), ",");
}

}  // namespace glibra::render
