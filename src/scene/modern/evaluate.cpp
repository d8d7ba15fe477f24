#include "scene/modern/evaluate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "glib/number.h"
#include "glib/text.h"
#include "scene/state.h"

namespace glibra::scene {
namespace {

/// Sets the names whose values depend on where the expression stands.
void supply(Interpreter& in, expression::Depends depends) {
    using expression::Depends;
    Environment& names = in.shared->environment;
    if (any(depends & Depends::model)) names.set("model", {&in.state.model[0][0], 16});
    if (any(depends & Depends::window)) {
        const std::array window{
            static_cast<double>(in.inputs.width > 0 ? in.inputs.width : in.scene.width),
            static_cast<double>(in.inputs.height > 0 ? in.inputs.height : in.scene.height)};
        names.set("window", window);
        names.setNumber("aspect", window[0] / window[1]);
    }
    if (!any(depends & Depends::camera)) return;
    const SceneCamera seen = currentCamera(in);
    const CameraValues now = valuesOf(seen, currentAspect(in));
    names.setCamera("camera", now);
    setPrevious(in, "camera", seen.name, now);
    const CameraName eye{"eye", 0};
    if (findCamera(in, eye) != nullptr) return;
    const CameraValues classic = valuesOf(classicCamera(in), windowAspect(in));
    names.setCamera("eye", classic);
    setPrevious(in, "eye", eye, classic);
}

/// True for the fields of a camera that change with the shape of the target.
bool readsShape(std::string_view path) {
    constexpr std::array<std::string_view, 4> kFields{".projection", ".viewProjection", ".shadow", ".aspect"};
    return std::any_of(kFields.begin(), kFields.end(),
                       [&](std::string_view field) { return path.ends_with(field); });
}

/// What the value can change with, through variables too. Remembers which variables a block reads.
expression::Depends dependsOf(Interpreter& in, const expression::Expression& expression) {
    expression::Depends depends = expression.depends();
    for (const expression::Use& each : expression.uses()) {
        if (each.path.starts_with("eye.")) in.modern.usesEye = true;
        const expression::Depends now = in.shared->environment.dependsOf(each.symbol.slot);
        depends = depends | now;
        using expression::Depends;
        if (any(now &
                (Depends::variable | Depends::camera | Depends::texture | Depends::buffer | Depends::window)))
            noteRead(in, each.path, each.symbol.slot, expression.origin());
    }
    return depends;
}

/// For an expression with an unknown name: where a Let below sets it. Empty if none does.
std::string whereSet(const Interpreter& in, const glib::Value& value,
                     std::span<const NotedNames::Note> notes) {
    const auto unknown = std::ranges::find_if(
        notes, [](const auto& each) { return !each.count && each.path.find('.') == std::string::npos; });
    if (unknown == notes.end()) return {};
    for (const glib::Command& each : in.script->commands) {
        if (each.id != glib::CommandId::let || each.values.empty() ||
            each.position.line <= value.position.line)
            continue;
        const glib::Value& target = each.values.front();
        if ((target.path.empty() ? target.text : target.path.front().name) == unknown->path)
            return fmt::format("; line {} sets it, which is below", each.position.line);
    }
    return {};
}

ReadExpression& readExpression(Interpreter& in, const glib::Value& value, const expression::Wanted& wanted) {
    const Environment& environment = in.shared->environment;
    MadeOfNames<ReadExpression>& readSoFar = in.shared->computed.expressions[writtenAt(in, value)];
    if (ReadExpression* known = readSoFar.find(environment)) return *known;
    const bool isWord = value.kind == glib::Value::Kind::word;
    const Place origin = in.script->place(isWord ? value.position : glib::placeIn(value, 0));
    const NotedNames names(environment);
    auto parsed = expression::parse(value.text, origin, names, wanted);
    std::vector<NotedNames::Note> notes = names.take();
    ReadExpression made;
    if (parsed) {
        for (const expression::Use& each : parsed->uses()) {
            if (each.path.find(".prev.") != std::string::npos) in.shared->seen.readsPrevious = true;
            if (!readsShape(each.path)) continue;
            made.readsShape = true;
            if (!each.path.starts_with("camera.")) in.shared->seen.readsShapes = true;
        }
        made.expression = std::move(*parsed);
    } else {
        parsed.problem.message.text += whereSet(in, value, notes);
        in.report(parsed.problem.message);
    }
    return readSoFar.add(environment, std::move(notes), std::move(made));
}

/// True if the expression reads what a faulty statement would have declared.
bool readsLostName(const Interpreter& in, std::string_view text) {
    if (in.modern.lostNames.empty()) return false;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && glib::isOfName(text[end])) ++end;
        if (end > at && isLost(in, text.substr(at, end - at))) return true;
        at = end + 1;
    }
    return false;
}

}  // namespace

WrittenAt writtenAt(const Interpreter& in, const glib::Value& value) {
    return {in.script, value.position.line, value.position.column, value.kind};
}

std::optional<expression::Value> evaluate(Interpreter& in, const glib::Value& value,
                                          const expression::Wanted& wanted) {
    const auto fail = [&] {
        ++in.problems;
        return std::nullopt;
    };
    if (readsLostName(in, value.text)) return fail();
    ReadExpression& entry = readExpression(in, value, wanted);
    if (!entry.expression) return fail();
    supply(in, entry.expression->depends());
    expression::Depends depends = dependsOf(in, *entry.expression);
    if (entry.readsShape) depends = depends | expression::Depends::window;
    addDepends(in, depends);
    const auto result = entry.expression->evaluate(in.shared->environment);
    if (result) return *result;
    if (!in.shared->seen.isTrial && !std::exchange(entry.isProblemReported, true))
        in.report(result.problem.message);
    return fail();
}

namespace {

/// What Once writes stays, so it cannot follow a variable of time. Variables that the block sets are its own.
void checkOnce(Interpreter& in, std::string_view name, expression::Depends depends, const Place& place) {
    const OpenBlock* block = in.around.block;
    if (block == nullptr || block->isStep || !any(depends & expression::Depends::variable) ||
        !changesWithTime(depends) || in.shared->environment.isOfBlock(name))
        return;
    const auto declared = in.modern.names.find(name);
    const std::string where =
        declared != in.modern.names.end() ? fmt::format(" (line {})", declared->second.place.line) : "";
    in.report(diagnose("memory-E11",
                       fmt::format("Once reads '{}'{}, which changes with time, but what Once writes stays; "
                                   "read it in Step",
                                   name, where),
                       place));
}

}  // namespace

void noteRead(Interpreter& in, std::string_view name, Environment::Slot slot, const Place& place) {
    checkOnce(in, name, in.shared->environment.dependsOf(slot), place);
    if (in.around.readSlots != nullptr) in.around.readSlots->push_back(slot);
    if (in.around.block == nullptr || !in.around.block->readSlots.insert(slot).second) return;
    const std::vector<double> values = in.shared->environment.valuesOf(slot);
    in.around.block->reads.insert(in.around.block->reads.end(), values.begin(), values.end());
}

namespace {

/// What the scene, or the block that is open, depends on.
expression::Depends& currentDepends(Interpreter& in) {
    return in.around.block != nullptr ? in.around.block->depends : in.shared->depends;
}

}  // namespace

void addDepends(Interpreter& in, expression::Depends depends) {
    currentDepends(in) = currentDepends(in) | depends;
}

DependsOnly::DependsOnly(Interpreter& in)
    : all_(currentDepends(in)), before_(std::exchange(all_, expression::Depends::nothing)) {}

std::shared_ptr<const ConditionNames> namesOfCondition(Interpreter& in, const glib::Value& value,
                                                       const expression::Wanted& wanted) {
    if (readsLostName(in, value.text)) return nullptr;
    const ReadExpression& entry = readExpression(in, value, wanted);
    if (!entry.expression) return nullptr;
    supply(in, entry.expression->depends());
    addDepends(in, dependsOf(in, *entry.expression));
    const Environment& environment = in.shared->environment;
    auto names = std::make_shared<ConditionNames>();
    // It is read again when it is answered, with all names in it: also those of what is folded, as in
    // arr.count.
    const NotedNames noted(environment);
    static_cast<void>(expression::parse(value.text, {}, noted, wanted));
    for (const NotedNames::Note& each : noted.take()) {
        const auto symbol = names->find(each.path) ? std::nullopt : environment.find(each.path);
        if (!symbol) continue;
        ConditionNames::Name name{each.path, *symbol, {}};
        if (any(symbol->depends & expression::Depends::buffer)) {
            constexpr std::string_view kCount = ".count";
            const std::string head = each.path.ends_with(kCount)
                                         ? each.path.substr(0, each.path.size() - kCount.size())
                                         : each.path;
            glib::Value word;
            word.kind = glib::Value::Kind::word;
            word.text = head;
            if (const std::size_t point = head.find('.'); point != std::string::npos)
                word.path = {{head.substr(0, point), {}}, {head.substr(point + 1), {}}};
            word.position = value.position;
            const auto object = objectNamed(in, word);
            if (const auto* view = object ? std::get_if<BufferView>(&*object) : nullptr)
                name.buffer = in.scene.buffers[view->buffer].name;
            const expression::Symbol* const elements = environment.lookUp(head);
            if (elements != nullptr && Environment::isBuffer(*elements))
                name.elementSize = elements->type.size();
        }
        const std::size_t count = Environment::isBuffer(*symbol) ? 0 : std::max(1U, symbol->count);
        for (std::size_t i = 0; i < count; ++i) {
            const double* const found = environment.find(symbol->slot, i);
            name.has.push_back(found != nullptr);
            for (std::size_t k = 0; k < symbol->type.size(); ++k)
                name.components.push_back(found != nullptr ? found[k] : 0);
        }
        name.why = environment.whyMissing(symbol->slot, 0);
        names->add(std::move(name));
    }
    return names;
}

std::optional<double> numberOf(Interpreter& in, const glib::Value& value) {
    using Kind = glib::Value::Kind;
    if (value.kind == Kind::number || value.kind == Kind::truth) return value.number;
    if (value.kind != Kind::expression) return std::nullopt;
    static constexpr expression::Type kTypes[] = {expression::Type::number(), expression::Type::boolean()};
    const auto result = evaluate(in, value, {.types = kTypes});
    return result ? std::optional(result->number()) : std::nullopt;
}

std::optional<bool> truthOf(Interpreter& in, const glib::Value& value) {
    const std::optional<double> number = numberOf(in, value);
    return number ? std::optional(*number != 0) : std::nullopt;
}

std::optional<std::size_t> wordOf(Interpreter& in, const glib::Value& value,
                                  std::span<const std::string_view> words) {
    if (value.kind == glib::Value::Kind::expression) {
        static constexpr expression::Type kTypes[] = {expression::Type::word()};
        const auto result = evaluate(in, value, {.types = kTypes, .words = words});
        return result ? std::optional(result->word()) : std::nullopt;
    }
    const auto found = std::find_if(words.begin(), words.end(),
                                    [&](std::string_view each) { return glib::sameWord(each, value.text); });
    return found != words.end() ? std::optional(static_cast<std::size_t>(found - words.begin()))
                                : std::nullopt;
}

std::optional<double> numberIn(Interpreter& in, const glib::Value& value, std::string_view what, double least,
                               double most) {
    const auto number = numberOf(in, value);
    if (!number || (*number >= least && *number <= most)) return number;
    in.report(diagnose("glib-E26",
                       fmt::format("{} {} is not between {} and {}", what, glib::numberText(*number),
                                   glib::numberText(least), glib::numberText(most)),
                       in.script->place(value.position)));
    return std::nullopt;
}

std::optional<int> integerIn(Interpreter& in, const glib::Value& value, std::string_view what, int least,
                             int most) {
    const auto number = numberOf(in, value);
    if (!number) return std::nullopt;
    const double whole = std::trunc(*number) + 0.0;  // never -0
    if (whole >= least && whole <= most) return static_cast<int>(whole);
    in.report(diagnose("glib-E26",
                       fmt::format("{} {} is not between {} and {}", what, glib::numberText(whole),
                                   glib::groupedText(least), glib::groupedText(most)),
                       in.script->place(value.position)));
    return std::nullopt;
}

std::optional<std::vector<double>> numbersOf(Interpreter& in, std::span<const glib::Value> values) {
    std::vector<double> numbers;
    for (const glib::Value& each : values) {
        if (each.kind == glib::Value::Kind::expression) {
            const auto result = evaluate(in, each);
            if (!result) return std::nullopt;
            numbers.insert(numbers.end(), result->all().begin(), result->all().end());
        } else if (!each.items.empty()) {
            const auto inner = numbersOf(in, each.items);
            if (!inner) return std::nullopt;
            numbers.insert(numbers.end(), inner->begin(), inner->end());
        } else {
            numbers.push_back(each.number);
        }
    }
    return numbers;
}

std::optional<std::vector<double>> numbersOf(Interpreter& in, std::span<const glib::Value> values,
                                             std::size_t count, std::string_view what) {
    auto numbers = numbersOf(in, values);
    if (!numbers || numbers->size() == count) return numbers;
    const glib::Position position = values.empty() ? glib::Position{} : values.front().position;
    in.report(diagnose("glib-E26",
                       fmt::format("{} needs {} number{}; the values here have {}", what, count,
                                   count == 1 ? "" : "s", numbers->size()),
                       in.script->place(position)));
    return std::nullopt;
}

}  // namespace glibra::scene
