#include "scene/run/uniforms.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>
#include <type_traits>
#include <utility>

#include "base/hash.h"
#include "base/suggest.h"
#include "glib/text.h"
#include "scene/run/camera_use.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"
#include "scene/run/scope.h"

namespace glibra::scene {
namespace {

/// The form of a variable that is a colour stays a colour, so that it fits three and four components.
bool isColor(const Interpreter& in, const std::string& name) {
    const auto known = in.modern.forms.find(name);
    return known != in.modern.forms.end() && known->second == glib::UniformForm::color;
}

/// The word of a choice.
void setWord(const expression::Symbol& symbol, glib::UniformSpec& spec) {
    if (spec.values.size() != 1) return;
    const double value = spec.values[0];
    if (value >= 0 && value < static_cast<double>(symbol.words.size()))
        spec.word = symbol.words[static_cast<std::size_t>(value)];
}

/// The values of a variable; nothing if it has none.
void setToVariable(const Interpreter& in, const std::string& name, const expression::Symbol& symbol,
                   glib::UniformSpec& spec) {
    const std::size_t elements = std::max<std::size_t>(1, symbol.count);
    for (std::size_t i = 0; i < elements; ++i)
        if (const double* values = in.names().find(symbol.slot, i))
            spec.values.insert(spec.values.end(), values, values + symbol.type.size());
    setWord(symbol, spec);
    spec.form = symbol.type.isBoolean() && elements == 1 ? glib::UniformForm::truth
                : isColor(in, name)                      ? glib::UniformForm::color
                                                         : glib::UniformForm::list;
}

bool setToExpression(Interpreter& in, const Value& expression, glib::UniformSpec& spec) {
    const auto value = evaluate(in, expression);
    if (!value) return false;
    spec.values.assign(value->all().begin(), value->all().end());
    spec.form = value->type.isBoolean() ? glib::UniformForm::truth : glib::UniformForm::list;
    return true;
}

/// The tag with its values of this moment, in the form in which a Program line would state it.
/// `isOfProgram`: a word that has no meaning here may name a function of the program.
std::optional<glib::UniformSpec> specOf(Interpreter& in, const KeyedValues& tag, bool isOfProgram) {
    glib::UniformSpec spec;
    spec.tag = tag.key;
    spec.tagPosition = tag.position;
    spec.valuePosition = tag.values.front().position;
    const Value& first = tag.values.front();
    if (first.kind == Value::Kind::word) {
        const expression::Symbol* const symbol = in.names().lookUp(first.text);
        const bool isPlain = symbol != nullptr && symbol->type.kind != expression::Kind::record;
        if (isPlain && symbol->words.empty() && first.path.size() <= 1 &&
            (first.path.empty() || first.path.front().index.empty())) {
            // Reading the name as an expression notes what it depends on.
            if (symbol->count == 0 && !evaluate(in, first)) return std::nullopt;
            if (symbol->count > 0) {
                noteRead(in, first.text, symbol->slot, in.place(first));
                addDepends(in, in.names().dependsOf(symbol->slot));
            }
            setToVariable(in, first.text, *symbol, spec);
            if (in.modern.lostNames.contains(spec.word)) return std::nullopt;
        } else if (isPlain || first.path.size() > 1 ||
                   (!first.path.empty() && !first.path.front().index.empty())) {
            if (!setToExpression(in, first, spec)) return std::nullopt;
            if (isPlain && first.path.size() <= 1) setWord(*symbol, spec);
        } else if (in.modern.lostNames.contains(first.text)) {
            return std::nullopt;
        } else if (isOfProgram && first.path.size() <= 1) {
            spec.word = first.text;
            return spec;
        } else {
            std::vector<std::string> names = in.names().known("");
            for (const auto& [each, declared] : in.modern.names) names.push_back(each);
            const std::vector<std::string_view> views(names.begin(), names.end());
            const bool isOther = symbol != nullptr || declaredName(in, first.text) != nullptr ||
                                 in.modern.groups.contains(first.text);
            return in.reportAt(first, isOther ? "glib-E34" : "glib-E27",
                               fmt::format("'{}' is no variable, texture or buffer{}", first.text,
                                           base::suggestion(first.text, views)));
        }
    } else if (first.kind == Value::Kind::list) {
        const auto numbers = listOf(in, first);
        if (!numbers) return std::nullopt;
        spec.values = *numbers;
        spec.form = glib::UniformForm::list;
    } else if (first.kind == Value::Kind::expression && tag.values.size() == 1) {
        if (!setToExpression(in, first, spec)) return std::nullopt;
    } else {
        const auto numbers = numbersOf(in, tag.values);
        if (!numbers) return std::nullopt;
        if (first.kind == Value::Kind::range && numbers->size() > 3) {
            in.report(
                diagnose("glib-E26",
                         fmt::format("'{0}': a range on a tag has three numbers; write 'Let {0} < >' for a "
                                     "vector with sliders",
                                     tag.key),
                         in.place(first)));
            return std::nullopt;
        }
        spec.values = *numbers;
        spec.form = first.kind == Value::Kind::color   ? glib::UniformForm::color
                    : first.kind == Value::Kind::truth ? glib::UniformForm::truth
                    : first.kind == Value::Kind::range ? glib::UniformForm::range
                                                       : glib::UniformForm::list;
    }
    if (spec.values.empty()) return std::nullopt;
    if (spec.form == glib::UniformForm::list && spec.values.size() == 1)
        spec.form = glib::UniformForm::number;
    return spec;
}

/// Equal for sets that areAlike().
std::size_t hashOfSet(const UniformSet& set) {
    std::size_t hash = set.objects.size();
    const auto add = [&hash](const auto& part) {
        hash = base::combined(hash, std::hash<std::remove_cvref_t<decltype(part)>>()(part));
    };
    for (const glib::UniformSpec& each : set.values) {
        add(each.tag);
        for (const double value : each.values) add(value);
    }
    for (const ObjectBinding& each : set.objects)
        add(std::holds_alternative<BufferView>(each.object)
                ? std::get<BufferView>(each.object).buffer.position()
                : std::get<TextureView>(each.object).texture.position());
    return hash;
}

/// True if draws can share one of them. Where the tags stand does not count.
bool areAlike(const UniformSet& a, const UniformSet& b) {
    const auto isSameValue = [](const glib::UniformSpec& x, const glib::UniformSpec& y) {
        return x.values == y.values && x.tag == y.tag && x.form == y.form &&
               x.mayBeUnknown == y.mayBeUnknown && x.resembles == y.resembles && x.word == y.word;
    };
    const auto isSameObject = [](const ObjectBinding& x, const ObjectBinding& y) {
        return x.object == y.object && x.tag == y.tag && x.mayBeUnknown == y.mayBeUnknown &&
               x.isChosen == y.isChosen && x.resembles == y.resembles;
    };
    return std::ranges::equal(a.values, b.values, isSameValue) &&
           std::ranges::equal(a.objects, b.objects, isSameObject) && a.lost == b.lost;
}

/// The word in the parentheses of `uMap (shown)`, if it is a choice that names objects: it means the same
/// with and without them.
std::optional<Value> choiceInParentheses(Interpreter& in, const KeyedValues& tag) {
    const Value& value = tag.values.front();
    if (value.kind != Value::Kind::expression || tag.values.size() > 1 || !glib::isIdentifier(value.text))
        return std::nullopt;
    Value word = value;
    word.kind = Value::Kind::word;
    return choosesObject(in, word) ? std::optional(std::move(word)) : std::nullopt;
}

/// The names of the statement that a tag stands in, for its expressions: they are evaluated at draws, which
/// may stand in other scopes.
class NamesOfTag {
  public:
    NamesOfTag(Interpreter& in, const KeyedValues& tag, Environment::Point names, const glib::Script* script)
        : file_(in, {script, in.around.given}), before_(in) {
        const auto hasNoNames = [](const Value& each) {
            return each.kind == Value::Kind::number || each.kind == Value::Kind::truth;
        };
        if (!std::ranges::all_of(tag.values, hasNoNames)) in.names().enterGroup(names, &tag);
    }

  private:
    InFile file_;
    InnerNames before_;
};

/// The numbers of a tag that Light or Material set, for a draw with the camera that is current.
std::vector<double> numbersInEye(Interpreter& in, const ScopedTag& tag) {
    if (tag.space == EyeSpace::asGiven) return tag.numbers;
    addDepends(in, expression::Depends::camera);
    const bool isDirection = tag.space == EyeSpace::direction;
    std::vector<double> inEye = transformed(currentCamera(in).view, tag.numbers, isDirection ? 0 : 1);
    if (isDirection) inEye.resize(3);
    if (tag.space != EyeSpace::halfVector) return inEye;
    const glm::dvec3 toLight(inEye[0], inEye[1], inEye[2]);
    const double length = glm::length(toLight);
    const glm::dvec3 half = (length > 0 ? toLight / length : glm::dvec3(0.0)) + glm::dvec3(0, 0, 1);
    const double size = glm::length(half);
    const glm::dvec3 unit = size > 0 ? half / size : half;
    return {unit.x, unit.y, unit.z, 0};
}

}  // namespace

std::vector<double> transformed(const glm::dmat4& matrix, const std::vector<double>& numbers, double w) {
    const glm::dvec4 result =
        matrix * glm::dvec4(numbers.at(0), numbers.at(1), numbers.at(2), numbers.size() > 3 ? numbers[3] : w);
    return {result.x, result.y, result.z, result.w};
}

std::optional<std::string> keyOfTag(Interpreter& in, const KeyedValues& tag) {
    constexpr double kMostSubscript = 1 << 20;
    const auto isComputed = [](const glib::NamePart& each) {
        return !each.index.empty() && each.index.front().kind == Value::Kind::expression;
    };
    if (std::ranges::none_of(tag.path, isComputed)) return tag.key;
    std::string key;
    for (const glib::NamePart& each : tag.path) {
        if (!key.empty()) key += '.';
        key += each.name;
        if (each.index.empty()) continue;
        const auto index = wholeIn(in, each.index.front(), tag.key + ": subscript", 0, kMostSubscript);
        if (!index) return std::nullopt;
        key += fmt::format("[{:.0f}]", *index);
    }
    return key;
}

UniformSetIndex uniformsOf(Interpreter& in, ProgramIndex program, std::span<const KeyedValues> own) {
    UniformSet set;
    const auto isGiven = [&](const std::string& key) {
        const auto isKey = [&](const auto& each) { return each.tag == key; };
        return std::ranges::any_of(set.values, isKey) || std::ranges::any_of(set.objects, isKey);
    };
    const auto add = [&](const KeyedValues& tag, const std::string& key, bool mayBeUnknown,
                         const std::optional<ObjectView>& named = {}) {
        const auto forget = [&] {
            std::erase(set.lost, key);
            std::erase_if(set.values, [&](const auto& each) { return each.tag == key; });
            std::erase_if(set.objects, [&](const auto& each) { return each.tag == key; });
        };
        const std::optional<Value> choice = choiceInParentheses(in, tag);
        const Value& value = choice ? *choice : tag.values.front();
        const bool isChosen = !named && choosesObject(in, value);
        const auto chosen = isChosen ? objectNamed(in, value) : std::nullopt;
        if (isChosen && !chosen) {
            // A faulty part of the object has been reported.
        } else if (named || namesObject(in, value) || (isChosen && value.path.size() > 1)) {
            if (auto object = named ? named : isChosen ? chosen : objectNamed(in, value)) {
                forget();
                set.objects.push_back(
                    {key, *object, tag.position, value.position, mayBeUnknown, tag.resembles});
            }
        } else if (auto spec = specOf(in, tag, !mayBeUnknown)) {
            spec->tag = key;
            spec->mayBeUnknown = mayBeUnknown;
            spec->resembles = tag.resembles;
            forget();
            set.values.push_back(std::move(*spec));
            if (chosen)
                set.objects.push_back(
                    {key, *chosen, tag.position, value.position, mayBeUnknown, tag.resembles, true});
        }
        if (!isGiven(key)) set.lost.push_back(key);
    };
    const auto addNumbers = [&](const ScopedTag& tag) {
        glib::UniformSpec spec;
        spec.tag = tag.key;
        spec.tagPosition = spec.valuePosition = tag.tag->position;
        spec.form = tag.numbers.size() == 1 ? glib::UniformForm::number : glib::UniformForm::list;
        spec.values = numbersInEye(in, tag);
        spec.mayBeUnknown = true;
        std::erase_if(set.values, [&](const auto& each) { return each.tag == tag.key; });
        set.values.push_back(std::move(spec));
    };
    const auto addOwn = [&](const KeyedValues& tag, bool mayBeUnknown) {
        if (const auto key = keyOfTag(in, tag)) add(tag, *key, mayBeUnknown);
    };
    if (const auto tags = in.modern.programTags.find(program); tags != in.modern.programTags.end())
        for (const KeyedValues& each : tags->second.command->tags) {
            const NamesOfTag names(in, each, tags->second.names, tags->second.script);
            addOwn(each, false);
        }
    for (const ScopedTag& each : in.state.set) {
        if (!each.numbers.empty()) {
            addNumbers(each);
            continue;
        }
        const NamesOfTag names(in, *each.tag, each.names, each.script);
        add(*each.tag, each.key, true, each.object);
    }
    for (const KeyedValues& each : own) addOwn(each, false);
    if (set.values.empty() && set.objects.empty() && set.lost.empty()) return {};
    const std::size_t hash = hashOfSet(set);
    const auto [first, last] = in.made.uniformSets.equal_range(hash);
    for (auto each = first; each != last; ++each)
        if (areAlike(in.scene.uniformSets[each->second], set)) return each->second;
    const UniformSetIndex index = in.scene.uniformSets.add(std::move(set));
    in.made.uniformSets.emplace(hash, index);
    return index;
}

std::vector<glib::UniformSpec> namedValuesOfBlock(Interpreter& in) {
    std::vector<glib::UniformSpec> own = namedValues(in);
    std::erase_if(own, [&](const auto& each) { return !in.names().isOfBlock(each.tag); });
    return own;
}

std::vector<glib::UniformSpec> namedValues(Interpreter& in) {
    std::vector<glib::UniformSpec> all;
    for (const auto& [name, position] : in.modern.variables) {
        const expression::Symbol* const symbol = in.names().lookUpInScene(name);
        if (symbol == nullptr || symbol->type.kind == expression::Kind::record) continue;
        glib::UniformSpec spec;
        spec.tag = name;
        spec.tagPosition = spec.valuePosition = position;
        spec.mayBeUnknown = true;
        setToVariable(in, name, *symbol, spec);
        spec.changesWithTime = changesWithTime(in.names().dependsOf(symbol->slot));
        if (spec.values.empty()) continue;
        if (spec.form == glib::UniformForm::list && spec.values.size() == 1)
            spec.form = glib::UniformForm::number;
        all.push_back(std::move(spec));
    }
    return all;
}

}  // namespace glibra::scene
