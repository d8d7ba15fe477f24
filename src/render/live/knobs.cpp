#include "render/live/knobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>

#include "plan/uniform_names.h"
#include "plan/uniforms.h"
#include "render/draw/axes.h"

namespace glibra::render {
namespace {

Widget widgetOf(const glib::UniformSpec& spec, const plan::ActiveUniform& uniform,
                const plan::Control* control) {
    if (uniform.type.base == plan::BaseType::boolean && uniform.type.components() == 1 &&
        uniform.arraySize == 1)
        return Widget::checkBox;
    if (control == nullptr) return Widget::numbers;
    if (control->form == glib::UniformForm::color) return Widget::color;
    if (control->form == glib::UniformForm::truth) return Widget::checkBox;
    return spec.form == glib::UniformForm::range ? Widget::slider : Widget::numbers;
}

/// The limits of a range as the language defines them (language, 5.3): with one value v they are min(0, v)
/// and max(1, v). Reversed limits are exchanged; equal limits are made one unit apart.
std::pair<double, double> limitsOf(const glib::UniformSpec& spec) {
    const std::vector<double>& v = spec.values;
    double low = v.size() == 1 ? std::min(0.0, v[0]) : v[0];
    double high = v.size() == 1 ? std::max(1.0, v[0]) : v.size() == 2 ? std::max(v[0], v[1]) : v[2];
    if (low > high) std::swap(low, high);
    if (low == high) high = low + 1;
    return {low, high};
}

Knob knobOf(const scene::Scene& scene, const plan::PlannedProgram& planned, const glib::UniformSpec& spec,
            const plan::NamedUniform& named, const plan::Literal& literal) {
    const plan::ActiveUniform& uniform = at(planned.interface->uniforms, named.uniform);
    const plan::Control* control = nullptr;
    for (const plan::Control& each : planned.controls)
        if (each.uniform == named.uniform) control = &each;
    Knob knob;
    knob.program = planned.variant.program;
    knob.title = titleOf(scene, knob.program);
    knob.tag = spec.tag;
    knob.type = uniform.type;
    knob.widget = widgetOf(spec, uniform, control);
    knob.form = spec.form;
    knob.written = spec.values;
    knob.initial = knob.current = literal.values;
    knob.place = {scene.path, spec.valuePosition.line, spec.valuePosition.column};
    knob.declaration = uniform.type.word + " " + uniform.name;
    if (spec.form == glib::UniformForm::range && !spec.values.empty())
        std::tie(knob.minimum, knob.maximum) = limitsOf(spec);
    return knob;
}

/// The program's specifications without duplicates: of several with the same tag, the last one is used.
std::vector<const glib::UniformSpec*> countingSpecs(const scene::Program& program) {
    std::vector<const glib::UniformSpec*> specs;
    for (const glib::UniformSpec& each : program.uniforms) {
        const auto same = std::ranges::find(specs, each.tag, &glib::UniformSpec::tag);
        if (same != specs.end())
            *same = &each;
        else
            specs.push_back(&each);
    }
    return specs;
}

/// Calls `use` with each specification of the program and each literal that holds its value.
template <class Use>
void forEachLiteral(const scene::Scene& scene, plan::PlannedProgram& planned, const Use& use) {
    const plan::UniformNames names(*planned.interface);
    for (const glib::UniformSpec* spec : countingSpecs(scene.programs[planned.variant.program]))
        for (const plan::NamedUniform& named : names.find(spec->tag))
            for (plan::UniformBinding& binding : planned.values) {
                auto* literal = std::get_if<plan::Literal>(&binding.value);
                if (literal != nullptr && binding.uniform == named.uniform &&
                    binding.firstElement == named.element && !literal->values.empty())
                    use(*spec, named, *literal);
            }
}

bool hasKnobs(const plan::PlannedProgram& planned) {
    return planned.variant.program && planned.interface->usable;
}

void addKnobs(const scene::Scene& scene, const plan::PlannedProgram& planned, std::vector<Knob>& knobs) {
    plan::PlannedProgram read = planned;
    forEachLiteral(
        scene, read,
        [&](const glib::UniformSpec& spec, const plan::NamedUniform& named, const plan::Literal& literal) {
            const bool isKnown = std::any_of(knobs.begin(), knobs.end(), [&](const Knob& each) {
                return each.program == planned.variant.program && each.tag == spec.tag;
            });
            if (!isKnown) knobs.push_back(knobOf(scene, planned, spec, named, literal));
        });
}

plan::UniformBinding* bindingOf(plan::PlannedProgram& planned, plan::UniformIndex uniform) {
    const auto found = std::ranges::find(planned.values, uniform, &plan::UniformBinding::uniform);
    return found == planned.values.end() ? nullptr : &*found;
}

/// True for a uniform that takes a value and has none.
bool isUnset(const plan::PlannedProgram& planned, plan::UniformIndex index) {
    const plan::ActiveUniform& uniform = at(planned.interface->uniforms, index);
    return std::ranges::find(planned.values, index, &plan::UniformBinding::uniform) == planned.values.end() &&
           !uniform.type.isOpaque() && uniform.type.base != plan::BaseType::other &&
           !plan::isInBuffer(planned, uniform) && !plan::isInternalName(uniform.name) &&
           plan::suppliedBy(uniform) == nullptr && !plan::hasInitializer(*planned.interface, uniform) &&
           plan::functionsOf(*planned.interface, uniform) == nullptr;
}

/// The control of a uniform that is not set.
Knob unsetKnob(const scene::Scene& scene, const plan::PlannedProgram& planned,
               const plan::ActiveUniform& uniform) {
    Knob knob;
    knob.program = planned.variant.program;
    knob.title = titleOf(scene, knob.program);
    knob.tag = uniform.name;
    knob.type = uniform.type;
    knob.isUnset = true;
    const int elements =
        std::max({uniform.arraySize, plan::declaredElements(*planned.interface, uniform), 1});
    knob.initial.assign(static_cast<std::size_t>(elements * uniform.type.components()), 0);
    knob.current = knob.initial;
    knob.form = knob.initial.size() == 1 ? glib::UniformForm::number : glib::UniformForm::list;
    knob.place = scene.programs[knob.program].place;
    knob.declaration = uniform.type.word + " " + uniform.name;
    return knob;
}

/// True if the knob's value is another one for the program now, which may have had none.
bool giveUnset(const Knob& knob, plan::PlannedProgram& planned) {
    bool isChanged = false;
    const plan::UniformNames names(*planned.interface);
    for (const plan::NamedUniform& named : names.find(knob.tag)) {
        plan::UniformBinding* binding = bindingOf(planned, named.uniform);
        if (binding == nullptr) {
            planned.values.push_back({named.uniform, 0, plan::Literal{knob.current}});
            isChanged = true;
        } else if (auto* literal = std::get_if<plan::Literal>(&binding->value)) {
            isChanged = isChanged || literal->values != knob.current;
            literal->values = knob.current;
        }
    }
    return isChanged;
}

/// Knob::isShared.
void noteShared(std::vector<Knob>& knobs, std::span<const plan::FramePlan* const> plans) {
    for (Knob& knob : knobs) {
        const auto hasTag = [&](const plan::PlannedProgram& each) {
            return each.variant.program && each.variant.program != knob.program &&
                   !plan::UniformNames(*each.interface).find(knob.tag).empty();
        };
        knob.isShared = std::ranges::any_of(plans, [&](const plan::FramePlan* plan) {
            return std::any_of(plan->programs.begin(), plan->programs.end(), hasTag);
        });
    }
}

/// The control of a variable.
Knob knobOf(const scene::Variable& variable) {
    Knob knob;
    knob.title = "Variables";
    knob.tag = variable.name;
    knob.form = variable.form;
    knob.written = variable.written;
    const std::span<const double> stated = variable.statedValues();
    knob.initial.assign(stated.begin(), stated.end());
    knob.current = variable.current;
    knob.place = variable.place;
    knob.type.base = variable.form == glib::UniformForm::truth ? plan::BaseType::boolean
                     : variable.words.empty()                  ? plan::BaseType::floating
                                                               : plan::BaseType::integer;
    knob.type.rows = static_cast<int>(knob.initial.size());
    knob.declaration = "variable " + variable.name;
    knob.words = variable.words;
    knob.bound = variable.bound;
    if (variable.form == glib::UniformForm::range) {
        knob.widget = Widget::slider;
        knob.minimum = variable.least();
        knob.maximum = variable.largest();
    } else if (variable.form == glib::UniformForm::truth) {
        knob.widget = Widget::checkBox;
    } else if (variable.form == glib::UniformForm::color) {
        knob.widget = Widget::color;
    }
    return knob;
}

bool isSameValue(const Knob& a, const Knob& b) {
    return a.tag == b.tag && a.type.word == b.type.word && a.widget == b.widget && a.form == b.form &&
           a.minimum == b.minimum && a.maximum == b.maximum && a.initial == b.initial;
}

}  // namespace

std::vector<Knob> knobsOf(const scene::Scene& scene, std::span<const plan::FramePlan* const> plans) {
    std::vector<Knob> knobs;
    for (const plan::FramePlan* plan : plans)
        for (const plan::PlannedProgram& each : plan->programs)
            if (hasKnobs(each)) addKnobs(scene, each, knobs);
    noteShared(knobs, plans);
    std::ranges::stable_sort(knobs, {}, &Knob::program);
    std::vector<Knob> all;
    for (const scene::Variable& each : scene.variables) all.push_back(knobOf(each));
    all.insert(all.end(), std::make_move_iterator(knobs.begin()), std::make_move_iterator(knobs.end()));
    return all;
}

std::vector<Knob> unsetKnobs(const scene::Scene& scene, std::span<const plan::FramePlan* const> plans) {
    std::vector<Knob> knobs;
    for (const plan::FramePlan* plan : plans)
        for (const plan::PlannedProgram& each : plan->programs) {
            if (!hasKnobs(each)) continue;
            for (std::size_t i = 0; i < each.interface->uniforms.size(); ++i) {
                const plan::ActiveUniform& uniform = each.interface->uniforms[i];
                const bool isKnown = std::any_of(knobs.begin(), knobs.end(), [&](const Knob& known) {
                    return known.program == each.variant.program && known.tag == uniform.name;
                });
                if (!isKnown && isUnset(each, plan::UniformIndex(i)))
                    knobs.push_back(unsetKnob(scene, each, uniform));
            }
        }
    noteShared(knobs, plans);
    return knobs;
}

std::vector<std::vector<std::size_t>> sharedKnobs(std::span<const Knob> knobs) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        if (!knobs[i].program) continue;
        const auto known = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
            return isSameValue(knobs[group.front()], knobs[i]);
        });
        if (known == groups.end())
            groups.push_back({i});
        else if (knobs[known->back()].program != knobs[i].program)
            known->push_back(i);
    }
    std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
    return groups;
}

std::vector<plan::PlannedProgramIndex> apply(const scene::Scene& scene, std::span<const Knob> knobs,
                                             plan::FramePlan& plan) {
    std::vector<plan::PlannedProgramIndex> changed;
    if (knobs.empty()) return changed;
    for (const plan::PlannedProgramIndex i : plan.programs.indices()) {
        plan::PlannedProgram& planned = plan.programs[i];
        if (!hasKnobs(planned)) continue;
        bool isChanged = false;
        forEachLiteral(scene, planned,
                       [&](const glib::UniformSpec& spec, const plan::NamedUniform&, plan::Literal& literal) {
                           for (const Knob& each : knobs) {
                               if (each.program != planned.variant.program || each.tag != spec.tag ||
                                   each.current.size() != literal.values.size())
                                   continue;
                               isChanged = isChanged || literal.values != each.current;
                               literal.values = each.current;
                           }
                       });
        for (const Knob& each : knobs)
            if (each.isUnset && each.program == planned.variant.program)
                isChanged = giveUnset(each, planned) || isChanged;
        if (isChanged) changed.push_back(i);
    }
    return changed;
}

std::vector<KeptValues::Owner> KeptValues::ownersOf(const scene::Scene& scene) {
    std::vector<Owner> owners;
    std::map<std::string, int> seen;
    for (const scene::Program& each : scene.programs) owners.emplace_back(each.name, seen[each.name]++);
    return owners;
}

/// Gives the values of programs that have another name now to those names: between two programs that both
/// scenes have, as many names are gone as are new.
void KeptValues::rename(const std::vector<Owner>& now) {
    const auto gapsOf = [](const std::vector<Owner>& owners, const std::vector<Owner>& others) {
        std::vector<std::vector<Owner>> gaps(1);
        for (const Owner& each : owners) {
            if (std::ranges::find(others, each) != others.end())
                gaps.emplace_back();
            else
                gaps.back().push_back(each);
        }
        return gaps;
    };
    const auto before = gapsOf(owners_, now), after = gapsOf(now, owners_);
    std::map<Owner, Owner> renamed;
    for (std::size_t gap = 0; gap < std::min(before.size(), after.size()); ++gap)
        for (std::size_t i = 0; before[gap].size() == after[gap].size() && i < before[gap].size(); ++i)
            renamed.emplace(before[gap][i], after[gap][i]);
    std::map<std::pair<Owner, std::string>, Kept> moved;
    for (auto& [key, kept] : values_) {
        const auto known = renamed.find(key.first);
        moved.insert_or_assign({known == renamed.end() ? key.first : known->second, key.second},
                               std::move(kept));
    }
    values_ = std::move(moved);
}

void KeptValues::keep(const scene::Scene& scene, std::span<const Knob> knobs) {
    owners_ = ownersOf(scene);
    for (const Knob& each : knobs) {
        const std::pair key(each.program ? owners_[each.program.position()] : Owner(), each.tag);
        if (each.isChanged())
            values_[key] = {each.form, each.written, each.current};
        else
            values_.erase(key);
    }
}

void KeptValues::restore(const scene::Scene& scene, std::span<Knob> knobs) {
    std::vector<Owner> owners = ownersOf(scene);
    rename(owners);
    owners_ = std::move(owners);
    for (Knob& each : knobs) {
        const auto found =
            values_.find({each.program ? owners_[each.program.position()] : Owner(), each.tag});
        if (found == values_.end()) continue;
        const Kept& kept = found->second;
        if (kept.form == each.form && kept.written == each.written &&
            kept.current.size() == each.initial.size())
            each.current = kept.current;
    }
}

// Values that a user has set as a text, which other runs of the program read.

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string KeptValues::text() const {
    if (values_.empty()) return {};
    Json owners = Json::array(), values = Json::array();
    for (const auto& [name, number] : owners_) owners.push_back({name, number});
    for (const auto& [key, kept] : values_)
        values.push_back({{"program", {key.first.first, key.first.second}},
                          {"name", key.second},
                          {"form", static_cast<int>(kept.form)},
                          {"written", kept.written},
                          {"value", kept.current}});
    return Json{{"programs", owners}, {"values", values}}.dump(1, ' ', false, Json::error_handler_t::replace);
}

KeptValues KeptValues::ofText(std::string_view text) {
    KeptValues kept;
    const auto ownerOf = [](const Json& json) {
        return Owner(json.at(0).get<std::string>(), json.at(1).get<int>());
    };
    try {
        const Json json = Json::parse(text);
        for (const Json& each : json.at("programs")) kept.owners_.push_back(ownerOf(each));
        for (const Json& each : json.at("values"))
            kept.values_[{ownerOf(each.at("program")), each.at("name").get<std::string>()}] = {
                static_cast<glib::UniformForm>(each.at("form").get<int>()),
                each.at("written").get<std::vector<double>>(), each.at("value").get<std::vector<double>>()};
    } catch (const Json::exception&) {
        return {};  // somebody has changed the file
    }
    return kept;
}

// Knobs as text, for scenes and command lines.

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

nlohmann::ordered_json jsonOf(const Knob& knob) {
    constexpr std::array kWords{"slider", "checkBox", "color", "numbers"};  // of Widget
    nlohmann::ordered_json json{{"owner", knob.program ? knob.title : std::string()},
                                {"name", knob.tag},
                                {"widget", kWords.at(static_cast<std::size_t>(knob.widget))},
                                {"declaration", knob.declaration},
                                {"isInteger", knob.isInteger()},
                                {"isShared", knob.isShared},
                                {"minimum", knob.minimum},
                                {"maximum", knob.maximum},
                                {"components", knob.type.components()},
                                {"initial", knob.initial},
                                {"current", knob.current}};
    if (!knob.words.empty()) json["words"] = knob.words;
    return json;
}

}  // namespace glibra::render
