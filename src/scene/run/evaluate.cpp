#include "scene/run/evaluate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/number.h"
#include "base/text.h"
#include "glib/number.h"
#include "glib/text.h"
#include "scene/run/camera_use.h"
#include "scene/run/scope.h"

namespace glibra::scene {
namespace {

/// Sets the names whose values depend on where the expression stands.
void supply(Interpreter& in, expression::Depends depends) {
    using expression::Depends;
    Environment& names = in.names();
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
    return std::ranges::any_of(kFields, [&](std::string_view field) { return path.ends_with(field); });
}

/// What the value of a name can change with. Remembers which variables a block reads.
expression::Depends noteUse(Interpreter& in, std::string_view path, Environment::Slot slot,
                            const Place& place) {
    using expression::Depends;
    if (path.starts_with("eye.")) in.modern.usesEye = true;
    const Depends now = in.names().dependsOf(slot);
    if (any(now &
            (Depends::variable | Depends::camera | Depends::texture | Depends::buffer | Depends::window)))
        noteRead(in, path, slot, place);
    return now;
}

/// What the value can change with, through variables too.
expression::Depends dependsOf(Interpreter& in, const expression::Expression& expression) {
    expression::Depends depends = expression.depends();
    for (const expression::Use& each : expression.uses())
        depends = depends | noteUse(in, each.path, each.symbol.slot, expression.origin());
    return depends;
}

}  // namespace

std::string whereSet(const Interpreter& in, const Value& value, std::span<const NotedNames::Note> notes) {
    const auto unknown = std::ranges::find_if(
        notes, [](const auto& each) { return !each.count && each.path.find('.') == std::string::npos; });
    if (unknown == notes.end()) return {};
    for (const Command& each : in.script->commands) {
        if (each.id != CommandId::let || each.values.empty() || each.position.line <= value.position.line)
            continue;
        const Value& target = each.values.front();
        if (headOf(target) == unknown->path)
            return fmt::format("; line {} sets it, which is below", each.position.line);
    }
    return {};
}

namespace {

ReadExpression& readExpression(Interpreter& in, const Value& value, const expression::Wanted& wanted) {
    const Environment& environment = in.names();
    MadeOfNames<ReadExpression>& readSoFar = in.shared->computed.expressions[writtenAt(in, value)];
    if (ReadExpression* known = readSoFar.find(environment)) return *known;
    const bool isWord = value.kind == Value::Kind::word;
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
        in.reportOnce(parsed.problem.message);
    }
    return readSoFar.add(environment, std::move(notes), std::move(made));
}

}  // namespace

bool readsLostName(const Interpreter& in, std::string_view text) {
    if (in.modern.lostNames.empty()) return false;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && glib::isOfName(text[end])) ++end;
        if (end > at && in.modern.lostNames.contains(text.substr(at, end - at))) return true;
        at = end + 1;
    }
    return false;
}

namespace {

/// Reads an expression, sets the names that it reads, and notes what it depends on. Null if it is wrong.
ReadExpression* supplied(Interpreter& in, const Value& value, const expression::Wanted& wanted) {
    if (readsLostName(in, value.text)) return nullptr;
    ReadExpression& read = readExpression(in, value, wanted);
    if (!read.expression) return nullptr;
    supply(in, read.expression->depends());
    addDepends(in, dependsOf(in, *read.expression));
    return &read;
}

/// False with glib-E15 reported if so many elements of so many numbers are more than `most` numbers.
bool areFew(Interpreter& in, const Value& owner, std::size_t numbers, int count, double most) {
    if (static_cast<double>(numbers) * count <= most) return true;
    in.reportAt(owner, "glib-E15",
                fmt::format("{} elements of {} numbers; the limit is {} numbers", base::groupedText(count),
                            numbers, base::groupedText(static_cast<long long>(most))));
    return false;
}

/// The values that the names of an expression of `i` have where it stands.
class KeptValues final : public expression::Values {
  public:
    KeptValues(const Environment& names, std::span<const expression::Use> uses, Environment::Slot counter)
        : counter_(counter) {
        for (const expression::Use& use : uses) {
            const expression::Symbol& symbol = use.symbol;
            if (symbol.slot == counter) continue;
            Kept kept{symbol.slot, symbol.type.size(), {}, {}, {}};
            for (std::size_t i = 0; i < std::max<std::size_t>(1, symbol.count); ++i) {
                const double* value = names.find(symbol.slot, i);
                if (value == nullptr) kept.why = names.whyMissing(symbol.slot, i);
                kept.has.push_back(value != nullptr);
                kept.components.resize((i + 1) * kept.size);
                if (value != nullptr) std::copy_n(value, kept.size, &kept.components[i * kept.size]);
            }
            kept_.push_back(std::move(kept));
        }
    }
    void setCounter(double value) { i_ = value; }

    [[nodiscard]] const double* find(std::uint32_t slot, std::size_t element) const override {
        if (slot == counter_) return &i_;
        const Kept& kept = of(slot);
        return element < kept.has.size() && kept.has[element] ? &kept.components[element * kept.size]
                                                              : nullptr;
    }
    [[nodiscard]] std::string whyMissing(std::uint32_t slot, std::size_t /*element*/) const override {
        return of(slot).why;
    }

  private:
    struct Kept {
        Environment::Slot slot = 0;
        std::size_t size = 1;
        std::vector<double> components;  ///< of all elements
        std::vector<bool> has;           ///< one per element
        std::string why;                 ///< there is no value
    };
    [[nodiscard]] const Kept& of(std::uint32_t slot) const {
        return *std::ranges::find(kept_, slot, &Kept::slot);  // few, so that a search is fast
    }

    Environment::Slot counter_;
    double i_ = 0;
    std::vector<Kept> kept_;
};

/// True for a value that another picture may have otherwise though nobody has changed the scene. Its
/// fractions are cut on purpose.
bool changesByItself(expression::Depends depends) {
    using expression::Depends;
    return changesWithTime(depends) || any(depends & (Depends::window | Depends::mouse));
}

/// Reports a fraction that is cut, once for each place.
void reportCut(Interpreter& in, Diagnostic cut) {
    const Place& place = cut.place;
    if (in.reported.insert({cut.id, place.file, place.line, place.column}).second) in.report(std::move(cut));
}
void reportCut(Interpreter& in, const Value& value, double number) {
    reportCut(in, diagnose("glib-W27",
                           fmt::format("{} is cut to {}", glib::numberText(number),
                                       glib::numberText(base::wholeNumber(number).value)),
                           in.place(value)));
}

}  // namespace

WrittenAt writtenAt(const Interpreter& in, const Value& value) {
    return {in.script, value.position.line, value.position.column, value.kind};
}

std::optional<expression::Value> evaluate(Interpreter& in, const Value& value,
                                          const expression::Wanted& wanted) {
    if (ReadExpression* const read = supplied(in, value, wanted)) {
        if (read->readsShape) addDepends(in, expression::Depends::window);
        const auto result = read->expression->evaluate(in.names());
        if (result) return *result;
        if (!in.shared->seen.isTrial && !std::exchange(read->isProblemReported, true))
            in.report(result.problem.message);
    }
    ++in.problems;
    return std::nullopt;
}

bool supplyNames(Interpreter& in, const Value& value, const expression::Wanted& wanted) {
    return supplied(in, value, wanted) != nullptr;
}

bool supplyNames(Interpreter& in, const Value& value, std::span<const std::string> paths) {
    if (readsLostName(in, value.text)) return false;
    expression::Depends depends = expression::Depends::nothing;
    for (const std::string& each : paths)
        if (const expression::Symbol* symbol = in.names().lookUp(each))
            depends = depends | symbol->depends | noteUse(in, each, symbol->slot, in.place(value));
    supply(in, depends);
    addDepends(in, depends);
    return true;
}

std::optional<double> numberOf(Interpreter& in, const Value& value) {
    using Kind = Value::Kind;
    if (value.kind == Kind::number || value.kind == Kind::truth) return value.number;
    if (value.kind != Kind::expression) return std::nullopt;
    static constexpr expression::Type kTypes[] = {expression::Type::number(), expression::Type::boolean()};
    const auto result = evaluate(in, value, {.types = kTypes});
    return result ? std::optional(result->number()) : std::nullopt;
}

std::optional<bool> truthOf(Interpreter& in, const Value& value) {
    const std::optional<double> number = numberOf(in, value);
    return number ? std::optional(*number != 0) : std::nullopt;
}

std::optional<std::size_t> wordOf(Interpreter& in, const Value& value,
                                  std::span<const std::string_view> words) {
    if (value.kind == Value::Kind::expression) {
        static constexpr expression::Type kTypes[] = {expression::Type::word()};
        const auto result = evaluate(in, value, {.types = kTypes, .words = words});
        return result ? std::optional(result->word()) : std::nullopt;
    }
    const auto found =
        std::ranges::find_if(words, [&](std::string_view each) { return glib::sameWord(each, value.text); });
    return found != words.end() ? std::optional(static_cast<std::size_t>(found - words.begin()))
                                : std::nullopt;
}

static std::nullopt_t outside(Interpreter& in, const Value& value, std::string_view what, double number,
                              double least, double most) {
    return in.reportAt(value, "glib-E05",
                       fmt::format("{} {} is not between {} and {}", what, glib::numberText(number),
                                   glib::numberText(least), glib::numberText(most)));
}

std::optional<double> numberIn(Interpreter& in, const Value& value, std::string_view what, double least,
                               double most) {
    const auto number = numberOf(in, value);
    if (!number || (*number >= least && *number <= most)) return number;
    return outside(in, value, what, *number, least, most);
}

std::optional<std::vector<double>> wholesOf(Interpreter& in, std::span<const Value> values) {
    std::vector<double> wholes;
    for (const Value& each : values) {
        const DependsOnly collected(in);
        const auto numbers = numbersOf(in, {&each, 1});
        if (!numbers) return std::nullopt;
        for (const double number : *numbers) {
            const auto [whole, isCut] = base::wholeNumber(number);
            wholes.push_back(whole);
            if (isCut && !changesByItself(collected.depends())) reportCut(in, each, number);
        }
    }
    return wholes;
}

std::optional<double> wholeOf(Interpreter& in, const Value& value) {
    const DependsOnly collected(in);
    const auto number = numberOf(in, value);
    if (!number) return std::nullopt;
    const auto [whole, isCut] = base::wholeNumber(*number);
    if (isCut && !changesByItself(collected.depends())) reportCut(in, value, *number);
    return whole;
}

std::optional<double> wholeIn(Interpreter& in, const Value& value, std::string_view what, double least,
                              double most) {
    const auto whole = wholeOf(in, value);
    if (!whole || (*whole >= least && *whole <= most)) return whole;
    return outside(in, value, what, *whole, least, most);
}

std::optional<int> integerIn(Interpreter& in, const Value& value, std::string_view what, int least,
                             int most) {
    const auto whole = wholeOf(in, value);
    if (!whole) return std::nullopt;
    if (*whole >= least && *whole <= most) return static_cast<int>(*whole);
    return in.reportAt(value, "glib-E05",
                       fmt::format("{} {} is not between {} and {}", what, glib::numberText(*whole),
                                   base::groupedText(least), base::groupedText(most)));
}

std::optional<std::vector<double>> numbersOf(Interpreter& in, std::span<const Value> values) {
    std::vector<double> numbers;
    for (const Value& each : values) {
        if (each.kind == Value::Kind::expression) {
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

bool fitFloats(Interpreter& in, const Value& value, std::span<const double> numbers) {
    const auto large = std::ranges::find_if_not(numbers, base::fitsFloat);
    if (large == numbers.end()) return true;
    in.reportAt(value, "glib-E31",
                fmt::format("{} is too large for a 32-bit float", glib::numberText(*large)));
    return false;
}

std::optional<std::vector<double>> floatsOf(Interpreter& in, std::span<const Value> values) {
    std::vector<double> all;
    for (const Value& each : values) {
        const auto numbers = numbersOf(in, {&each, 1});
        if (!numbers || !fitFloats(in, each, *numbers)) return std::nullopt;
        all.insert(all.end(), numbers->begin(), numbers->end());
    }
    return all;
}

std::optional<std::vector<glib::EvaluatedNumber>> evaluatedNumbers(Interpreter& in,
                                                                   std::span<const Value> values) {
    std::vector<glib::EvaluatedNumber> numbers;
    for (const Value& each : values) {
        const DependsOnly collected(in);
        const auto own = numbersOf(in, {&each, 1});
        if (!own) return std::nullopt;
        const bool reportsCut = !changesByItself(collected.depends());
        for (const double number : *own) numbers.push_back({number, each.position, reportsCut});
    }
    return numbers;
}

bool fillNumbers(Interpreter& in, const glib::StatementRow& row,
                 std::span<const glib::EvaluatedNumber> numbers, Command& command) {
    glib::MessageLog log(in.script->path);
    glib::evaluateNumbers(row, command, numbers, log);
    const bool isRight = log.errorCount() == 0;
    for (Diagnostic& each : log.take()) {
        if (each.id == "glib-W27")
            reportCut(in, std::move(each));
        else
            in.report(std::move(each));
    }
    return isRight;
}

/// The numbers if they are `count`; otherwise nothing with glib-E26 reported.
static std::optional<std::vector<double>> exactly(Interpreter& in, std::optional<std::vector<double>> numbers,
                                                  std::span<const Value> values, std::size_t count,
                                                  std::string_view what) {
    if (!numbers || numbers->size() == count) return numbers;
    const glib::Position position = values.empty() ? glib::Position{} : values.front().position;
    in.report(diagnose("glib-E26",
                       fmt::format("{} needs {}; the values here have {}", what,
                                   base::counted(count, "number"), numbers->size()),
                       in.script->place(position)));
    return std::nullopt;
}

std::optional<std::vector<double>> numbersOf(Interpreter& in, std::span<const Value> values,
                                             std::size_t count, std::string_view what) {
    return exactly(in, numbersOf(in, values), values, count, what);
}

std::optional<std::vector<double>> floatsOf(Interpreter& in, std::span<const Value> values, std::size_t count,
                                            std::string_view what) {
    return exactly(in, floatsOf(in, values), values, count, what);
}

std::optional<std::vector<double>> wholesOf(Interpreter& in, std::span<const Value> values, std::size_t count,
                                            std::string_view what) {
    return exactly(in, wholesOf(in, values), values, count, what);
}

std::optional<expression::Value> constantOf(Interpreter& in, std::span<const Value> values) {
    using Kind = Value::Kind;
    if (values.size() == 1 && (values[0].kind == Kind::expression || values[0].kind == Kind::word))
        return evaluate(in, values[0]);
    const auto numbers = numbersOf(in, values);
    if (!numbers || numbers->empty()) return std::nullopt;
    expression::Value value;
    if (numbers->size() > 4)
        return in.reportAt(
            values.front(), "glib-E33",
            fmt::format("{} numbers are not a value here; write an expression", numbers->size()));
    value.type = values[0].kind == Value::Kind::truth ? expression::Type::boolean()
                                                      : expression::Type::vector(numbers->size());
    std::copy(numbers->begin(), numbers->end(), value.components.begin());
    return value;
}

std::optional<std::vector<double>> listOf(Interpreter& in, const Value& list) {
    if (list.count.empty()) return numbersOf(in, {&list, 1});
    const auto count = integerIn(in, list.count.front(), "the number of elements", 1, kMostVariableElements);
    if (!count || !countElements(in, list, *count)) return std::nullopt;
    constexpr double kMostComponents = 16.0 * kMostVariableElements;
    return elementsOf(in, list, list.items, *count, kMostComponents);
}

expression::Symbol counterSymbol() {
    expression::Symbol symbol;
    symbol.depends = expression::Depends::counter;
    return symbol;
}

std::optional<std::vector<double>> elementsOf(Interpreter& in, const Value& owner,
                                              std::span<const Value> element, int count, double most) {
    const InnerNames inner(in);
    Environment& names = in.names();
    const Environment::Slot counter = names.bind("i", counterSymbol());
    std::optional<std::vector<double>> all(std::in_place);
    for (double i = 0; i < count && all; ++i) {
        names.setNumber(counter, i);
        const auto numbers = numbersOf(in, element);
        if (!numbers) {
            all.reset();
        } else if (!areFew(in, owner, numbers->size(), count, most)) {
            all.reset();
        } else {
            all->insert(all->end(), numbers->begin(), numbers->end());
        }
    }
    return all;
}

Diagnostics reportFirstCut(std::span<const double> numbers, const Place& place) {
    const auto cut = std::ranges::find_if(numbers, [](double each) { return base::wholeNumber(each).isCut; });
    if (cut == numbers.end() || !std::isfinite(*cut)) return {};
    return {diagnose("glib-W27",
                     fmt::format("{} is cut to {}", glib::numberText(*cut),
                                 glib::numberText(base::wholeNumber(*cut).value)),
                     place)};
}

std::optional<BufferValues> elementsLater(Interpreter& in, const Value& element, int count, double most,
                                          bool areWhole) {
    const InnerNames inner(in);
    Environment& names = in.names();
    const Environment::Slot counter = names.bind("i", counterSymbol());
    names.setNumber(counter, 0);
    const DependsOnly collected(in);
    const auto first = evaluate(in, element);
    if (!first || !areFew(in, element, first->all().size(), count, most)) return std::nullopt;
    const expression::Expression& expression = *readExpression(in, element, {}).expression;
    const std::size_t size = first->all().size() * static_cast<std::size_t>(count);
    const auto make = [expression, values = KeptValues(names, expression.uses(), counter), count, size,
                       reportsCut = areWhole && !changesByItself(collected.depends()),
                       place = in.place(element)]() mutable {
        BufferValues::Made made;
        made.numbers.reserve(size);
        for (int i = 0; i < count; ++i) {
            values.setCounter(i);
            const auto value = expression.evaluate(values);
            if (!value) {
                made.problems.push_back(value.problem.message);
                return made;
            }
            made.numbers.insert(made.numbers.end(), value->all().begin(), value->all().end());
        }
        if (reportsCut) made.problems = reportFirstCut(made.numbers, place);
        return made;
    };
    return BufferValues(size, make);
}

// ---- What a scene, or a Once or Step block, depends on.

namespace {

/// What Once writes stays, so it cannot follow a variable of time. Variables that the block sets are its own.
void checkOnce(Interpreter& in, std::string_view name, expression::Depends depends, const Place& place) {
    const OpenBlock* block = in.around.block;
    if (block == nullptr || block->isStep || !any(depends & expression::Depends::variable) ||
        !changesWithTime(depends) || in.names().isOfBlock(name))
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

/// What the scene, or the block that is open, depends on.
expression::Depends& currentDepends(Interpreter& in) {
    return in.around.block != nullptr ? in.around.block->depends : in.shared->depends;
}

}  // namespace

void noteRead(Interpreter& in, std::string_view name, Environment::Slot slot, const Place& place) {
    checkOnce(in, name, in.names().dependsOf(slot), place);
    if (in.around.readSlots != nullptr) in.around.readSlots->push_back(slot);
    if (in.around.block == nullptr || !in.around.block->readSlots.insert(slot).second) return;
    const std::vector<double> values = in.names().valuesOf(slot);
    in.around.block->reads.insert(in.around.block->reads.end(), values.begin(), values.end());
}

void addDepends(Interpreter& in, expression::Depends depends) {
    currentDepends(in) = currentDepends(in) | depends;
}

DependsOnly::DependsOnly(Interpreter& in)
    : all_(currentDepends(in)), before_(std::exchange(all_, expression::Depends::nothing)) {}

}  // namespace glibra::scene
