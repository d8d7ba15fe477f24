// Variables, lists and programs by their names (language, 12.1).

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "base/suggest.h"
#include "glib/number.h"
#include "glib/text.h"
#include "scene/modern/modern.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"
#include "scene/run/scope.h"
#include "scene/run/statements.h"
#include "scene/statement_words.h"

namespace glibra::scene {
namespace {

/// The value that the run gives a variable in place of the scene's, if it has as many components.
const std::vector<double>* chosenValue(Interpreter& in, const std::string& name, std::size_t components) {
    const auto chosen = in.inputs.variables.find(name);
    if (chosen == in.inputs.variables.end()) return nullptr;
    in.scene.usedVariables.insert_or_assign(name, components);
    return chosen->second.size() == components ? &chosen->second : nullptr;
}

/// The number of the word that the run gives a choice. Reports a word that it does not have.
std::optional<double> chosenWord(Interpreter& in, const Variable& variable) {
    const auto chosen = in.inputs.words.find(variable.name);
    if (chosen == in.inputs.words.end() || variable.words.empty()) return std::nullopt;
    in.scene.usedVariables.insert_or_assign(variable.name, std::size_t{1});
    const auto found = std::ranges::find(variable.words, chosen->second);
    if (found != variable.words.end()) return static_cast<double>(found - variable.words.begin());
    const std::vector<std::string_view> words(variable.words.begin(), variable.words.end());
    in.report(
        diagnose("glib-E16",
                 fmt::format("'{}' is set to '{}', but it is one of {}{}", variable.name, chosen->second,
                             fmt::join(variable.words, ", "), base::suggestion(chosen->second, words)),
                 variable.place));
    return std::nullopt;
}

/// The slot of the variable that Let sets. Nothing with the reason reported.
std::optional<Environment::Slot> slotOfLet(Interpreter& in, const Command& command, const std::string& name,
                                           const expression::Symbol& symbol) {
    Environment& names = in.names();
    const auto slot = names.declareVariable(name, symbol);
    if (!slot)
        in.reportAt(command, "glib-E36", fmt::format("'{}' is declared above with another type", name));
    return slot;
}

void declare(Interpreter& in, const Command& command, const std::string& name,
             const expression::Symbol& symbol, std::span<const double> components) {
    const auto slot = slotOfLet(in, command, name, symbol);
    if (!slot) return;
    const std::size_t size = symbol.type.size();
    for (std::size_t i = 0; i * size < components.size(); ++i)
        in.names().set(*slot, components.subspan(i * size, size), i);
}

expression::Symbol variable(expression::Type type, std::size_t count = 0) {
    expression::Symbol symbol;
    symbol.type = type;
    symbol.count = static_cast<std::uint32_t>(count);
    symbol.depends = expression::Depends::variable;
    return symbol;
}

const expression::Value* find(const GivenVariables& given, const std::string& name) {
    const auto found = given.find(name);
    return found != given.end() ? &found->second : nullptr;
}

/// A file that is included twice declares its variables twice.
void addVariable(Interpreter& in, Variable variable) {
    if (in.modern.forms.emplace(variable.name, variable.form).second)
        in.scene.variables.push_back(std::move(variable));
}

/// True if a number that the run gives a choice counts one of its words; reports one that does not.
bool countsWord(Interpreter& in, const Variable& variable, double number) {
    const double last = static_cast<double>(variable.words.size()) - 1;
    if (variable.words.empty() || (number >= 0 && number <= last && number == std::floor(number)))
        return true;
    in.report(diagnose(
        "glib-E05",
        fmt::format("'{}' is set to {}, but it is one of {}, which are 0 to {}", variable.name,
                    glib::numberText(number), fmt::join(variable.words, ", "), glib::numberText(last)),
        variable.place));
    return false;
}

/// Reports glib-W21 for a range whose current value is outside.
void checkCurrent(Interpreter& in, const Variable& variable) {
    for (const double each : variable.statedValues()) {
        if (each >= variable.least() && each <= variable.largest()) continue;
        in.report(diagnose("glib-W21",
                           fmt::format("{}: current value {} is outside {} ... {}; it is kept", variable.name,
                                       glib::numberText(each), glib::numberText(variable.least()),
                                       glib::numberText(variable.largest())),
                           variable.place));
        return;
    }
}

/// The range of Bound: three numbers above 0, from the one that costs least to the one with the finest
/// picture. Makes it the range of a slider. Reports what is wrong and returns false.
bool makeBound(Interpreter& in, const Value& value, Variable& made) {
    std::vector<double>& numbers = made.written;
    const auto isWord = [](const Value& each) { return each.kind == Value::Kind::word; };
    if (value.kind != Value::Kind::range || std::ranges::any_of(value.items, isWord) || numbers.size() != 3) {
        in.reportAt(value, "glib-E26",
                    fmt::format("'{}' needs <cheapest current finest>: three numbers", made.name));
        return false;
    }
    const double coarsest = numbers[0], finest = numbers[2];
    if (coarsest <= 0 || finest <= 0 || coarsest == finest) {
        in.reportAt(value, "glib-E29",
                    fmt::format("'{}' goes from {} to {}; both ends of a Bound must be above 0, and "
                                "different",
                                made.name, glib::numberText(coarsest), glib::numberText(finest)));
        return false;
    }
    const bool isWhole = std::ranges::all_of(numbers, [](double each) { return each == std::round(each); });
    made.bound = Variable::Fineness{coarsest, finest, isWhole};
    if (coarsest > finest) std::swap(numbers[0], numbers[2]);
    return true;
}

/// A variable with a control: <min cur max>, <word word ...>, <true> or {r g b}.
void declareControl(Interpreter& in, const Command& command, const std::string& name, const Value& value) {
    Variable made;
    made.name = name;
    made.place = in.place(value);
    const auto numbers = floatsOf(in, value.items);
    if (!numbers) return;
    made.written = *numbers;
    expression::Symbol symbol;
    if (command.id == CommandId::bound) {
        if (!makeBound(in, value, made)) return;
        made.form = glib::UniformForm::range;
        symbol = variable(expression::Type::number());
        checkCurrent(in, made);
    } else if (value.kind == Value::Kind::color) {
        if (made.written.size() < 3 || made.written.size() > 4) {
            in.reportAt(
                value, "glib-E26",
                fmt::format("'{}': a colour has 3 or 4 components, not {}", name, made.written.size()));
            return;
        }
        made.form = glib::UniformForm::color;
        symbol = variable(expression::Type::vector(made.written.size()));
    } else if (!value.items.empty() && value.items.front().kind == Value::Kind::word) {
        made.form = glib::UniformForm::range;
        for (const Value& each : value.items) made.words.push_back(each.text);
        made.written = {0, 0, static_cast<double>(made.words.size()) - 1};
        symbol = variable(expression::Type::number());
        symbol.words = made.words;
    } else if (value.items.size() == 1) {
        made.form = glib::UniformForm::truth;
        symbol = variable(expression::Type::boolean());
    } else {
        made.form = glib::UniformForm::range;
        if (made.written.size() < 3 || made.written.size() > 6 || made.least() > made.largest()) {
            in.report(
                diagnose("glib-E26",
                         fmt::format("'{}' needs <least current largest>; a vector has two to four current "
                                     "values, one per component",
                                     name),
                         in.place(value)));
            return;
        }
        const std::size_t components = made.statedValues().size();
        symbol =
            variable(components == 1 ? expression::Type::number() : expression::Type::vector(components));
        checkCurrent(in, made);
    }
    const std::span<const double> stated = made.statedValues();
    made.current.assign(stated.begin(), stated.end());
    const std::vector<double>* chosen = chosenValue(in, name, made.current.size());
    if (chosen != nullptr && countsWord(in, made, chosen->front())) made.current = *chosen;
    if (const auto word = chosenWord(in, made)) made.current = {*word};
    declare(in, command, name, symbol, made.current);
    addVariable(in, std::move(made));
}

/// The names of an environment, and an array that is about to be declared.
class NamesWithArray final : public expression::Names {
  public:
    NamesWithArray(const expression::Names& names, std::string_view name, expression::Symbol array)
        : names_(names), name_(name), array_(std::move(array)) {}
    [[nodiscard]] std::optional<expression::Symbol> find(std::string_view path) const override {
        return path == name_ ? array_ : names_.find(path);
    }
    [[nodiscard]] std::optional<expression::Symbol> findInScene(std::string_view path) const override {
        return names_.findInScene(path);
    }
    [[nodiscard]] std::shared_ptr<const expression::Function> findFunction(
        std::string_view name) const override {
        return names_.findFunction(name);
    }
    [[nodiscard]] std::vector<std::string> knownFunctions() const override { return names_.knownFunctions(); }
    [[nodiscard]] std::vector<std::string> known(std::string_view path) const override {
        return names_.known(path);
    }

  private:
    const expression::Names& names_;
    std::string_view name_;
    std::optional<expression::Symbol> array_;
};

/// The type with which the expression of an array, which may read earlier elements, has this same type.
/// Nothing if there is none.
std::optional<expression::Type> typeOfElements(Interpreter& in, const std::string& name, const Value& value,
                                               std::size_t elements) {
    const Environment& environment = in.names();
    auto& foundSoFar = in.shared->computed.arrayTypes[writtenAt(in, value)];
    if (const auto* known = foundSoFar.find(environment)) return *known;
    const NotedNames noted(environment);
    std::optional<expression::Type> type;
    using expression::Type;
    for (const Type candidate : {Type::number(), Type::vector(3), Type::vector(4), Type::matrix(4),
                                 Type::vector(2), Type::matrix(3), Type::boolean(), Type::matrix(2)}) {
        const NamesWithArray names(noted, name, variable(candidate, elements));
        const auto parsed = expression::parse(value.text, in.script->place(glib::placeIn(value, 0)), names);
        if (!parsed || parsed->type() != candidate) continue;
        type = candidate;
        break;
    }
    foundSoFar.add(environment, noted.take(), type);
    return type;
}

void declareArray(Interpreter& in, const Command& command, const std::string& name, const Value& count,
                  const Value& value) {
    const auto wanted = wholeOf(in, count);
    if (!wanted) return;
    if (!(*wanted >= 1 && *wanted <= kMostVariableElements)) {
        in.reportAt(count, "glib-E05",
                    fmt::format("'{}' cannot have {} elements; there are 1 to {}", name, *wanted,
                                kMostVariableElements));
        return;
    }
    const auto elements = static_cast<std::size_t>(*wanted);
    if (!countElements(in, value, *wanted)) return;
    const InnerNames inner(in);
    Environment& names = in.names();
    const Environment::Slot counter = names.bind("i", counterSymbol());
    // The expression may read earlier elements, so their type must be known before it can be read. Without a
    // type it is wrong; evaluating it reports why.
    const auto type = value.kind == Value::Kind::number ? expression::Type::number()
                                                        : typeOfElements(in, name, value, elements);
    const auto slot =
        slotOfLet(in, command, name, variable(type.value_or(expression::Type::number()), elements));
    for (std::size_t i = 0; slot && i < elements; ++i) {
        names.setNumber(counter, static_cast<double>(i));
        const auto element = constantOf(in, {&value, 1});
        if (!element) break;
        names.set(*slot, element->all(), i);
    }
}

/// What stands in the parentheses of [n of (...)].
std::string bodyOf(const Value& list) {
    const Value& item = list.items.front();
    return item.kind == Value::Kind::number ? glib::numberText(item.number) : item.text;
}

void runLet(Interpreter& in, const Command& command) {
    if (command.values.size() < 2) return;
    const Value& target = command.values[0];
    const Value& value = command.values[1];
    const std::string name = headOf(target);
    const bool isArray = !target.path.empty() && !target.path.front().index.empty();
    const expression::Value* const given = in.around.given ? find(*in.around.given, name) : nullptr;
    const bool isGiven = given != nullptr;
    const bool isRule = value.kind == Value::Kind::list && !value.count.empty();
    const bool isComputed = value.kind == Value::Kind::expression || isRule || isGiven;
    if (!declareName(in, command, name,
                     isComputed ? DeclaredName::Kind::computed : DeclaredName::Kind::variable))
        return;
    if (in.modern.variableNames.insert(name).second) in.modern.variables.emplace_back(name, command.position);
    if (isGiven) return declare(in, command, name, variable(given->type), given->all());
    if (command.id == CommandId::bound) return declareControl(in, command, name, value);
    if (isArray && isRule) {
        in.reportAt(
            value, "glib-E32",
            fmt::format("'{}' has two counts; write 'Let {} ({})'", name, target.text, bodyOf(value)));
        return;
    }
    if (isRule) return declareArray(in, command, name, value.count.front(), value.items.front());
    if (isArray && isComputed)
        return declareArray(in, command, name, target.path.front().index.front(), value);
    switch (value.kind) {
        case Value::Kind::range:
        case Value::Kind::color:
            return declareControl(in, command, name, value);
        case Value::Kind::list: {
            auto numbers = numbersOf(in, {&value, 1});
            if (!numbers || numbers->empty()) return;
            if (const auto* chosen = chosenValue(in, name, numbers->size())) numbers = *chosen;
            const bool isVector = numbers->size() >= 2 && numbers->size() <= 4 && !isArray;
            return declare(in, command, name,
                           isVector ? variable(expression::Type::vector(numbers->size()))
                                    : variable(expression::Type::number(), numbers->size()),
                           *numbers);
        }
        default:
            break;
    }
    auto result = constantOf(in, {&value, 1});
    if (!result) return;
    const expression::Value written = *result;
    if (const std::vector<double>* chosen = chosenValue(in, name, result->type.size()))
        std::copy(chosen->begin(), chosen->end(), result->components.begin());
    if (value.kind != Value::Kind::expression) {
        Variable made;
        made.name = name;
        made.place = in.place(value);
        made.form = value.kind == Value::Kind::truth ? glib::UniformForm::truth : glib::UniformForm::number;
        made.written.assign(written.all().begin(), written.all().end());
        made.current.assign(result->all().begin(), result->all().end());
        addVariable(in, std::move(made));
    }
    declare(in, command, name, variable(result->type), result->all());
}

/// A counter or parameter of this name is hidden from here to the end of the scope, so that what Let sets
/// can be read.
void showVariable(Interpreter& in, const Command& command, const std::string& name) {
    Environment& names = in.names();
    const expression::Symbol* const own = names.lookUpInScene(name);
    const auto seen = names.findOwn(name);
    if (own == nullptr || !seen || *seen == own->slot) return;
    const Environment::Slot slot = own->slot;
    names.bind(name, slot);
    if (!in.modern.hidingLets.insert(&command).second) return;
    in.reportAt(
        command, "glib-W40",
        fmt::format("'{0}' is a counter or parameter here; from this Let on to the end of the scope, '{0}' "
                    "is the variable of the scene; choose another name",
                    name));
}

/// The names of parameters, which blanks or commas separate. Nothing with the reason reported.
std::optional<std::vector<std::string>> parametersOf(Interpreter& in, const Value& target) {
    const Value& list = target.path.front().index.front();
    std::vector<std::string> names;
    const std::string_view rest = list.text;
    bool isFirstOfItem = true;
    for (std::size_t begin = 0; begin < rest.size();) {
        if (std::string_view(" \t\r\n").find(rest[begin]) != std::string_view::npos || rest[begin] == ',' ||
            rest[begin] == '\\') {
            isFirstOfItem = isFirstOfItem || rest[begin] == ',';
            ++begin;
            continue;
        }
        std::size_t end = begin;
        while (end < rest.size() && glib::isOfName(rest[end])) ++end;
        const std::string name(rest.substr(begin, std::max<std::size_t>(end - begin, 1)));
        const bool isTyped = !isFirstOfItem && rest.find(',') != std::string_view::npos;
        const auto refuse = [&](const char* id, std::string text) {
            const glib::Position position = glib::placeIn(list, begin);
            in.reportOnce(diagnose(id, std::move(text), in.script->place(position)));
            return std::nullopt;
        };
        if (!glib::isIdentifier(name) || isTyped || name == "true" || name == "false")
            return refuse("glib-E19", fmt::format("Let: expected the name of a parameter, found '{}'{}", name,
                                                  isTyped ? "; a parameter has no type, since each call "
                                                            "decides it"
                                                          : ""));
        if (std::ranges::find(names, name) != names.end())
            return refuse("glib-E18", fmt::format("Let: parameter '{}' given twice", name));
        names.push_back(name);
        isFirstOfItem = false;
        begin = end;
    }
    return names;
}

/// `Let name(parameters) (body)`.
void declareFunction(Interpreter& in, const Command& command) {
    const Value& target = command.values[0];
    const Value& value = command.values[1];
    const std::string& name = headOf(target);
    Environment& names = in.names();
    const auto lose = [&] { in.modern.lostNames.insert(name); };
    if (!declareName(in, command, name, DeclaredName::Kind::function)) return;
    auto& madeSoFar = in.shared->computed.functions[writtenAt(in, target)];
    if (names.findFunction(name) != nullptr) return;  // of a file that is included again
    const auto add = [&](const std::shared_ptr<const expression::Function>& function) {
        names.declareFunction(function);
        in.scene.functions.push_back(function);
    };
    if (const auto* known = madeSoFar.find(names)) return *known ? add(*known) : lose();
    if (value.kind != Value::Kind::expression) {
        in.reportAt(value, "glib-E19",
                    fmt::format("Let: expected the value of the function '{}' in parentheses", name));
        return lose();
    }
    if (readsLostName(in, value.text)) return lose();
    std::shared_ptr<const expression::Function> made;
    std::vector<NotedNames::Note> notes;
    if (const auto parameters = parametersOf(in, target)) {
        made = std::make_shared<const expression::Function>(expression::Function{
            name, *parameters, value.text, in.script->place(glib::placeIn(value, 0)), names.functionCount()});
        const NotedNames noted(names);
        auto problem = expression::problemOf(*made, noted);
        notes = noted.take();
        if (problem) {
            problem->message.text += whereSet(in, value, notes);
            in.reportOnce(problem->message);
            made.reset();
        }
    }
    madeSoFar.add(names, std::move(notes), made);
    return made ? add(made) : lose();
}

void doLet(Interpreter& in, const Command& command) {
    if (glib::declaresFunction(command)) return declareFunction(in, command);
    const Value& target = command.values.front();
    const std::string& name = headOf(target);
    const DependsOnly own(in);
    runLet(in, command);
    Environment& names = in.names();
    const expression::Symbol* const symbol = names.lookUpInScene(name);
    if (symbol == nullptr) return;
    names.addDepends(symbol->slot, own.depends() | in.around.conditions);
    showVariable(in, command, name);
}

void doUse(Interpreter& in, const Command& command) {
    if (const auto program = programNamed(in, command.values.front(), false)) in.state.program = *program;
}

void doFps(Interpreter& in, const Command& command) {
    const auto rate = numberOf(in, command.values.front());
    if (!rate) return;
    constexpr double kLeast = 1e-3, kMost = 1e6;
    if (!(*rate >= kLeast && *rate <= kMost)) {
        in.reportAt(command.values.front(), "glib-E05",
                    fmt::format("Fps: {} is not between {} and {}", *rate, kLeast, kMost));
        return;
    }
    in.shared->frameRate = *rate;
    setTime(in);
}

// ---- Key.

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
    const bool countsWords = !variable.words.empty();
    for (double& each : *numbers) {
        const bool isAllowed = each >= variable.least() && each <= variable.largest() &&
                               (!countsWords || each == std::floor(each));
        if (variable.form != glib::UniformForm::range || isSpeed || isAllowed) continue;
        // What is computed from the present value stops at the ends of the slider.
        if (value.kind == Value::Kind::expression && std::isfinite(each)) {
            each = std::clamp(countsWords ? std::floor(each) : each, variable.least(), variable.largest());
            continue;
        }
        return in.reportAt(
            value, "glib-E05",
            fmt::format("Key: {} is not {}between {} and {}, which '{}' allows", glib::numberText(each),
                        countsWords ? "a whole number " : "", glib::numberText(variable.least()),
                        glib::numberText(variable.largest()), variable.name));
    }
    if (numbers->size() == variable.current.size()) return numbers;
    return in.reportAt(value, "glib-E26",
                       fmt::format("Key: '{}' has {} components, not {}", variable.name,
                                   variable.current.size(), numbers->size()));
}

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

std::span<const CommandAction> variableActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::key, doKey},
        {CommandId::let, doLet, InList::isPart},
        {CommandId::bound, doLet, InList::isPart},
        {CommandId::use, doUse},
        {CommandId::fps, doFps},
    };
    return kActions;
}

}  // namespace glibra::scene
