// Repetitions: a number of rounds, words, or values (language, 12.2).

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/text.h"
#include "glib/number.h"
#include "glib/text.h"
#include "scene/modern/modern.h"
#include "scene/run/counts.h"
#include "scene/run/depends.h"
#include "scene/run/evaluate.h"
#include "scene/run/scope.h"
#include "scene/run/statements.h"

namespace glibra::scene {
namespace {

/// The words over which a Repeat runs.
const std::vector<Value>* wordsOf(const Command& command) {
    const Value& what = command.values.front();
    return what.kind == Value::Kind::list && what.count.empty() ? &what.items : nullptr;
}

/// True for a list of values: numbers, expressions, and variables that are no choices. Any other list is one
/// of words.
bool isListOfValues(const Interpreter& in, std::span<const Value> items) {
    const auto isPlainVariable = [&](const Value& each) {
        const expression::Symbol* const symbol = in.names().lookUp(each.text);
        return symbol != nullptr && symbol->type.kind != expression::Kind::record && symbol->words.empty() &&
               symbol->count == 0;
    };
    return std::ranges::any_of(items, [](const Value& each) { return each.kind != Value::Kind::word; }) ||
           std::ranges::all_of(items, isPlainVariable);
}

/// The values over which a Repeat runs, all of one type. Nothing with the reason reported.
std::optional<std::vector<expression::Value>> repeatedValues(Interpreter& in, std::span<const Value> items) {
    std::vector<expression::Value> values;
    for (const Value& each : items) {
        const auto value = constantOf(in, {&each, 1});
        if (!value) return std::nullopt;
        values.push_back(*value);
        if (value->type == values.front().type) continue;
        return in.reportAt(each, "glib-E33",
                           fmt::format("Repeat: the first value is {}, but this one is {}",
                                       expression::name(values.front().type), expression::name(value->type)));
    }
    return values;
}

/// The names that a Repeat gives each round.
struct RoundNames {
    Environment::Slot counter = 0;
    std::optional<Environment::Slot> index;  ///< NAME.index, if the counter is a word or a value
};

RoundNames bindCounter(Environment& names, const std::string& name, const expression::Symbol& counter,
                       bool hasIndex) {
    RoundNames bound;
    bound.counter = names.bind(name, counter);
    if (hasIndex) bound.index = names.bind(name + ".index", counterSymbol());
    return bound;
}

}  // namespace

void doRepeat(Interpreter& in, const Command& command) {
    const std::size_t index = indexOf(in, command);
    const std::vector<Value>* words = wordsOf(command);
    const KeyedValues* as = command.key("as");
    const std::string name = as != nullptr ? as->values.front().text : "i";
    double rounds = 0;
    std::optional<std::vector<expression::Value>> values;
    expression::Depends depends = expression::Depends::counter;
    if (words != nullptr && isListOfValues(in, *words)) {
        const DependsOnly collected(in);
        values = repeatedValues(in, *words);
        if (!values) return;
        depends = depends | collected.depends();
    }
    if (words != nullptr) {
        rounds = static_cast<double>(words->size());
    } else {
        const auto count = wholeOf(in, command.values.front());
        if (!count) return;
        rounds = *count;
    }
    if (rounds > static_cast<double>(kMostStatements)) {
        in.reportAt(command, "glib-E15",
                    fmt::format("Repeat: {} rounds; the limit is {}", glib::numberText(rounds),
                                base::groupedText(kMostStatements)));
        return;
    }
    if (rounds < 1) in.modern.untaken.push_back({in.script, index + 1, command.partner});
    expression::Symbol symbol = counterSymbol();
    if (values && !values->empty())
        symbol.type = values->front().type;
    else if (words != nullptr)
        for (const Value& each : *words) symbol.words.push_back(each.text);
    // All rounds have the same names, so they are made once.
    Environment& names = in.names();
    const InnerNames outer(in);
    const RoundNames own = bindCounter(names, name, symbol, words != nullptr);
    std::vector<std::size_t>& path = in.modern.checks.path;
    path.push_back(0);
    for (double round = 0; round < rounds && !in.counts.isFull; ++round) {
        if (!countRound(in, command)) break;
        const Scope scope(in);
        path.back() = static_cast<std::size_t>(round);
        names.setDepends(own.counter, depends);
        if (values)
            names.set(own.counter, (*values)[path.back()].all());
        else
            names.setNumber(own.counter, round);
        if (own.index) names.setNumber(*own.index, round);
        runBody(in, index + 1, command.partner);
    }
    path.pop_back();
}

}  // namespace glibra::scene
