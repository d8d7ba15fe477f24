// Expect: checks of the picture, of objects and of conditions (language, 12.9).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/suggest.h"
#include "glib/diagnostic_catalogue.h"
#include "glib/number.h"
#include "scene/conditions.h"
#include "scene/modern/modern.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"

namespace glibra::scene {
namespace {

using CheckKind = Check::Kind;

constexpr double kMostPrintedIndex = 1e12;

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

/// The object that a value names; nothing for the window.
bool readObject(Interpreter& in, const Value& value, std::optional<ObjectView>& object) {
    if (isWindow(value)) return true;
    object = objectNamed(in, value);
    return object.has_value();
}

bool isBracket(const Value& value) {
    return value.kind == Value::Kind::list || value.kind == Value::Kind::color;
}

}  // namespace

std::shared_ptr<const ConditionNames> namesOfCondition(Interpreter& in, const Value& value,
                                                       const expression::Wanted& wanted) {
    if (!supplyNames(in, value, wanted)) return nullptr;
    const Environment& environment = in.names();
    auto names = std::make_shared<ConditionNames>();
    // It is read again when it is answered, with all names in it: also those of what is folded, as in
    // arr.count.
    const NotedNames noted(environment);
    static_cast<void>(expression::parse(value.text, {}, noted, wanted));
    for (const NotedNames::Note& each : noted.take()) {
        if (each.function != nullptr) names->add(each.function);
        const bool isOfScene = each.kind == NotedNames::Note::Kind::nameOfScene;
        const auto symbol = isOfScene ? environment.findInScene(each.path) : environment.find(each.path);
        if (!symbol || each.kind == NotedNames::Note::Kind::function) continue;
        ConditionNames::Name name{each.path, *symbol, {}};
        name.isOfScene = isOfScene;
        if (any(symbol->depends & expression::Depends::buffer)) {
            constexpr std::string_view kCount = ".count";
            const std::string head = each.path.ends_with(kCount)
                                         ? each.path.substr(0, each.path.size() - kCount.size())
                                         : each.path;
            Value word;
            word.kind = Value::Kind::word;
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

namespace {

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
        check_.condition = &command_.values.front();
        static constexpr expression::Type kTypes[] = {expression::Type::boolean(),
                                                      expression::Type::number()};
        check_.names = namesOfCondition(in_, command_.values.front(), {.types = kTypes});
        if (!check_.names) return false;
        for (const std::string& name : check_.names->buffers())
            for (const BufferIndex each : in_.scene.buffers.indices())
                if (in_.scene.buffers[each].name == name) check_.reads.push_back(each);
        return true;
    }

    /// True if the object has pixels: it is the window or a texture.
    bool isTexture(const Value& value, const std::optional<ObjectView>& object) {
        if (!object || std::holds_alternative<TextureView>(*object)) return true;
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
        const auto buffer = bufferNamed(in_, key.values.front());
        if (!buffer) return false;
        check_.object = *buffer;
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
        const auto isBuffer = [](const std::optional<ObjectView>& object) {
            return object && std::holds_alternative<BufferView>(*object);
        };
        if (isBuffer(check_.object) == isBuffer(check_.other)) return true;
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
                if (!bounds || !readObject(in_, key.values.front(), check_.object)) return false;
                if ((*bounds)[0] > (*bounds)[1])
                    return refuse(key.values[1], "glib-E29",
                                  "range needs the least value before the largest");
                check_.numbers = *bounds;
                return true;
            }
            case CheckKind::sum:
                return readObject(in_, key.values.front(), check_.object) && readSum(key);
            case CheckKind::same:
            case CheckKind::different:
                return key.values.size() > 1 && readObject(in_, key.values[0], check_.object) &&
                       readObject(in_, key.values[1], check_.other) && isSameKind(key.values[1]);
            case CheckKind::finite:
                return readObject(in_, key.values.front(), check_.object);
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
                if (!readObject(in_, key.values.front(), check_.object) ||
                    !isTexture(key.values.front(), check_.object))
                    return false;
            } else if (key.key == "at" && key.values.size() == 1) {
                const auto seconds = numberIn(in_, key.values.front(), "Expect: the time", 0, 1e12);
                if (!seconds) return false;
                check_.seconds = *seconds;
            }
        }
        return true;
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
    const auto buffer = bufferNamed(in, command.values.front());
    if (!buffer) return;
    Print made{in.place(command), *buffer, command.values.front().text};
    const std::span<const Value> range = std::span(command.values).subspan(1);
    if (!range.empty()) {
        const auto numbers = wholesOf(in, range);
        if (!numbers) return;
        const double first = numbers->front(), last = numbers->back();
        if (numbers->size() > 2 || !(first >= 0 && last >= first && last < kMostPrintedIndex)) {
            refuse(in, "glib-E29", command, range.front().position,
                   "needs the first and the last element, from 0 on");
            return;
        }
        made.first = static_cast<std::uint64_t>(first);
        made.count = static_cast<std::uint64_t>(last - first) + 1;
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
