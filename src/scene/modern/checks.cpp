// Expect: checks of the picture, of objects and of conditions (language, 12.9).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/suggest.h"
#include "glib/messages.h"
#include "glib/number.h"
#include "scene/modern/modern.h"
#include "scene/run/evaluate.h"
#include "scene/run/selections.h"

namespace glibra::scene {
namespace {

using CheckKind = Check::Kind;

struct KindRow {
    std::string_view key;
    CheckKind kind;
};
constexpr KindRow kKinds[] = {
    {"pixel", CheckKind::pixel},         {"mean", CheckKind::mean},
    {"count", CheckKind::count},         {"buffer", CheckKind::buffer},
    {"range", CheckKind::range},         {"same", CheckKind::same},
    {"finite", CheckKind::finite},       {"primitives", CheckKind::primitives},
    {"samples", CheckKind::samples},     {"error", CheckKind::error},
    {"different", CheckKind::different}, {"sum", CheckKind::sum},
};

constexpr double kMostPrintedIndex = 1e12;

bool isBuffer(const Selection& selection) {
    return selection.object && std::holds_alternative<BufferView>(*selection.object);
}

bool isBracket(const Value& value) {
    return value.kind == Value::Kind::list || value.kind == Value::Kind::color;
}

class CheckReader {
  public:
    CheckReader(Interpreter& in, const Command& command) : in_(in), command_(command) {}

    std::optional<Check> read() {
        check_.place = in_.place(command_);
        check_.path = in_.modern.checks.path;
        check_.text = glib::written(command_);
        if (!readSubject() || !readOptions()) return std::nullopt;
        return std::move(check_);
    }

  private:
    template <class Where>
    bool refuse(const Where& where, const char* id, const std::string& text) {
        in_.reportAt(where, id, "Expect: " + text);
        return false;
    }

    bool readSubject() {
        for (const KindRow& row : kKinds)
            if (const KeyedValues* key = command_.key(row.key)) {
                check_.kind = row.kind;
                return readKind(*key);
            }
        if (command_.values.empty()) return false;
        check_.kind = CheckKind::condition;
        const Value& condition = command_.values.front();
        check_.condition = {&condition, namesOfQuestion(in_, condition, {.types = kConditionTypes}, true)};
        return check_.condition.names != nullptr;
    }

    bool readObject(const Value& value, Selection& selection) {
        auto read = selectionNamed(in_, value);
        if (read) selection = std::move(*read);
        return read.has_value();
    }

    /// True if it has pixels: it is the window or a texture.
    bool isTexture(const Value& value, const Selection& selection) {
        if (!isBuffer(selection)) return true;
        return refuse(
            value, "glib-E34",
            fmt::format("'{}' is a buffer; pixels are those of the window or a texture", value.text));
    }

    /// Reads `count` numbers and then the wanted colour.
    bool readColor(const KeyedValues& key, std::size_t count) {
        const std::span<const Value> values(key.values);  // expressions are known by their address
        const auto bracket = std::ranges::find_if(values, isBracket);
        const auto plain = static_cast<std::size_t>(bracket - values.begin());
        auto numbers = numbersOf(in_, values.first(plain));
        if (!numbers) return false;
        if (bracket != values.end()) {
            const auto wanted = numbersOf(in_, values.subspan(plain));
            if (!wanted) return false;
            check_.wanted = *wanted;
        } else if (numbers->size() > count) {  // an expression gives the colour
            check_.wanted.assign(numbers->begin() + static_cast<std::ptrdiff_t>(count), numbers->end());
            numbers->resize(count);
        }
        if (numbers->size() != count || check_.wanted.empty() || check_.wanted.size() > 4)
            return refuse(
                command_, "glib-E26",
                fmt::format("{} needs {} numbers and a colour of 1 to 4 components", key.key, count));
        check_.numbers = std::move(*numbers);
        return true;
    }

    bool readCount(const KeyedValues& key) {
        if (key.values.size() < 2) return false;
        const auto wanted = numbersOf(in_, std::span(key.values).first(1));
        const auto numbers = numbersOf(in_, std::span(key.values).subspan(1));
        if (!wanted || !numbers) return false;
        if (wanted->empty() || wanted->size() > 4)
            return refuse(key.values.front(), "glib-E26",
                          fmt::format("a colour has 1 to 4 components, not {}", wanted->size()));
        if (numbers->empty() || numbers->size() > 2)
            return refuse(key.values[1], "glib-E26", "count needs one number, or the least and the largest");
        for (const double each : *numbers)
            if (!isCount(key.values[1], each)) return false;
        if (numbers->front() > numbers->back())
            return refuse(key.values[1], "glib-E29", "count needs the least number before the largest");
        check_.wanted = *wanted;
        check_.numbers = {numbers->front(), numbers->back()};
        return true;
    }

    bool isCount(const Value& value, double number) {
        if (number >= 0 && number == std::trunc(number)) return true;
        return refuse(value, "glib-E05", fmt::format("{} is not a count", glib::numberText(number)));
    }

    bool readBuffer(const KeyedValues& key) {
        if (!readObject(key.values.front(), check_.of)) return false;
        if (!isBuffer(check_.of))
            return refuse(key.values.front(), "glib-E34",
                          fmt::format("'{}' is not a buffer", key.values.front().text));
        std::span<const Value> rest = std::span(key.values).subspan(1);
        if (const KeyedValues* at = firstAt()) {
            rest = at->values;
            const auto index = wholeIn(in_, rest.front(), "Expect: the index", 0, 1e12);
            if (!index) return false;
            check_.numbers = {*index};
            rest = rest.subspan(1);
        }
        if (rest.empty()) return refuse(command_, "glib-E17", "buffer needs a list of values");
        const auto wanted = listOf(in_, rest.front());
        if (!wanted) return false;
        check_.wanted = *wanted;
        return true;
    }

    bool readSum(const KeyedValues& key) {
        if (key.values.size() < 2) return false;
        const Value& wanted = key.values[1];
        if (wanted.kind == Value::Kind::list) {
            auto values = listOf(in_, wanted);
            if (!values) return false;
            check_.wanted = std::move(*values);
            return true;
        }
        const auto total = numberOf(in_, wanted);
        if (!total) return false;
        check_.wanted = {*total};
        return true;
    }

    /// The key `at` that states the first element of a buffer; null if there is only the one with the
    /// seconds.
    const KeyedValues* firstAt() {
        for (const KeyedValues& each : command_.keys)
            if (each.key == "at" && each.values.size() > 1) return &each;
        return nullptr;
    }

    bool isSameKind(const Value& second) {
        if (isBuffer(check_.of) == isBuffer(check_.other)) return true;
        return refuse(second, "glib-E34",
                      "a buffer is compared with a buffer, a texture with a texture or the window");
    }

    bool readKind(const KeyedValues& key) {
        switch (check_.kind) {
            case CheckKind::pixel:
                return readColor(key, 2);
            case CheckKind::mean:
                return readColor(key, 4);
            case CheckKind::count:
                return readCount(key);
            case CheckKind::buffer:
                return readBuffer(key);
            case CheckKind::range: {
                const auto bounds = numbersOf(in_, std::span(key.values).subspan(1), 2, "Expect: range");
                if (!bounds || !readObject(key.values.front(), check_.of)) return false;
                if ((*bounds)[0] > (*bounds)[1])
                    return refuse(key.values[1], "glib-E29",
                                  "range needs the least value before the largest");
                check_.numbers = *bounds;
                return true;
            }
            case CheckKind::sum:
                return readObject(key.values.front(), check_.of) && readSum(key);
            case CheckKind::same:
            case CheckKind::different:
                return key.values.size() > 1 && readObject(key.values[0], check_.of) &&
                       readObject(key.values[1], check_.other) && isSameKind(key.values[1]);
            case CheckKind::finite:
                return readObject(key.values.front(), check_.of);
            case CheckKind::primitives:
            case CheckKind::samples: {
                const auto count = numberOf(in_, key.values.front());
                if (!count || !isCount(key.values.front(), *count)) return false;
                check_.numbers = {*count};
                return true;
            }
            case CheckKind::error: {
                const Value& id = key.values.front();
                check_.word = id.text;
                if (glib::findDiagnostic(id.text) != nullptr) return true;
                std::vector<std::string_view> ids;
                for (const glib::CatalogueRow& each : glib::diagnosticCatalogue()) ids.push_back(each.id);
                return refuse(
                    id, "glib-E16",
                    fmt::format("there is no message '{}'{}", id.text, base::suggestion(id.text, ids)));
            }
            case CheckKind::condition:
                break;
        }
        return false;
    }

    bool readOptions() {
        for (const KeyedValues& key : command_.keys) {
            if (key.key == "within") {
                const auto tolerance = numberIn(in_, key.values.front(), "Expect: the tolerance", 0, 1e300);
                if (!tolerance) return false;
                check_.tolerance = *tolerance;
            } else if (key.key == "of") {
                if (!readObject(key.values.front(), check_.of) || !isTexture(key.values.front(), check_.of))
                    return false;
            } else if (key.key == "at" && key.values.size() == 1) {
                const auto seconds = numberIn(in_, key.values.front(), "Expect: the time", 0, 1e12);
                if (!seconds) return false;
                check_.seconds = *seconds;
            }
        }
        return readArea();
    }

    /// `in x y w h` or `in first last`, after the object is known.
    bool readArea() {
        const KeyedValues* area = command_.key("in");
        if (area == nullptr) return true;
        const auto numbers = wholesOf(in_, area->values);
        if (!numbers || !selectArea(in_, area->values.front(), *numbers, "Expect", check_.of)) return false;
        const bool hasOther = check_.kind == CheckKind::same || check_.kind == CheckKind::different;
        return !hasOther || selectArea(in_, area->values.front(), *numbers, "Expect", check_.other);
    }

    Interpreter& in_;
    const Command& command_;
    Check check_;
};

void doExpect(Interpreter& in, const Command& command) {
    in.modern.checks.run.insert(&command);
    if (auto check = CheckReader(in, command).read()) in.scene.checks.push_back(std::move(*check));
}

/// Why the statements of a body have not run; empty if they have, or if an error is the reason.
std::string whyIdle(const Command& opener) {
    switch (opener.id) {
        case CommandId::group:
            return fmt::format("group '{}' is not drawn", opener.values.front().text);
        case CommandId::repeat:
            return fmt::format("the Repeat on line {} has no round", opener.position.line);
        case CommandId::when:
            return fmt::format("the condition of the When on line {} is false", opener.position.line);
        case CommandId::elseBranch:
            return fmt::format("the condition of the When before the Else on line {} is true",
                               opener.position.line);
        default:
            return {};
    }
}

/// The outermost statement around an Expect whose body has not run; null if there is none.
const Command* idleBodyAround(const ChecksOfRun& checks, const std::vector<Command>& commands,
                              std::size_t expect) {
    for (std::size_t i = 0; i < expect; ++i) {
        const std::size_t partner = commands[i].partner;
        if (partner != Command::kNoPartner && partner > expect && !checks.bodies.contains(&commands[i]))
            return &commands[i];
    }
    return nullptr;
}

void doPrint(Interpreter& in, const Command& command) {
    const Value& what = command.values.front();
    Print made{in.place(command), glib::written(what)};
    if (what.kind == Value::Kind::expression) {
        made.value = {&what, namesOfQuestion(in, what, {}, false)};
        if (made.value.names) in.scene.prints.push_back(std::move(made));
        return;
    }
    auto selection = selectionNamed(in, what);
    if (!selection) return;
    made.of = std::move(*selection);
    const KeyedValues* const area = command.key("in");
    const std::span<const Value> range =
        area != nullptr ? std::span(area->values) : std::span(command.values).subspan(1);
    if (!range.empty()) {
        auto numbers = wholesOf(in, range);
        if (!numbers) return;
        if (area == nullptr && isBuffer(made.of)) {  // what the buffer does not have is left out
            const double first = numbers->front(), last = numbers->back();
            if (numbers->size() > 2 || !(first >= 0 && last >= first && last < kMostPrintedIndex)) {
                refuse(in, "glib-E29", command, range.front().position,
                       "needs the first and the last element, from 0 on");
                return;
            }
            made.of.area = {first, last};
        } else {
            if (area == nullptr) {                                // one texel
                if (numbers->size() == 1) numbers->push_back(0);  // of a row
                numbers->insert(numbers->end(), 2, 1);
            }
            if (!selectArea(in, range.front(), *numbers, "Print", made.of)) return;
        }
    }
    in.scene.prints.push_back(std::move(made));
}

}  // namespace

std::vector<IdleCheck> idleChecks(const Interpreter& in) {
    std::vector<IdleCheck> idle;
    const ChecksOfRun& checks = in.modern.checks;
    if (!checks.areThere) return idle;
    std::vector<const glib::Script*> scripts{in.script};
    scripts.insert(scripts.end(), in.modern.included.begin(), in.modern.included.end());
    for (const glib::Script* script : scripts)
        for (std::size_t i = 0; i < script->commands.size(); ++i) {
            const Command& each = script->commands[i];
            if (each.id != CommandId::expect || checks.run.contains(&each)) continue;
            const Command* const body = idleBodyAround(checks, script->commands, i);
            const std::string why = body != nullptr ? whyIdle(*body) : std::string();
            if (why.empty()) continue;
            IdleCheck check{script->place(each.position), glib::written(each), why};
            check.mayRun = body->id == CommandId::when || body->id == CommandId::elseBranch;
            for (const KeyedValues& key : each.keys)
                if (key.key == "at" && key.values.size() == 1 &&
                    key.values.front().kind == Value::Kind::number && key.values.front().number >= 0)
                    check.seconds = key.values.front().number;
            idle.push_back(std::move(check));
        }
    return idle;
}

std::span<const CommandAction> checkActions() {
    static constexpr CommandAction kActions[] = {{CommandId::expect, doExpect}, {CommandId::print, doPrint}};
    return kActions;
}

}  // namespace glibra::scene
