// Statements as a scene writes them, and whether two scenes say the same.

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "glib/number.h"
#include "glib/script.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

std::string itemsOf(const Value& group) {
    std::string text;
    for (const Value& each : group.count) text += written(each) + " of";
    for (const Value& each : group.items) {
        if (!text.empty()) text += ' ';
        text += written(each);
    }
    return text;
}

void appendValues(const std::vector<Value>& values, std::string& text) {
    for (const Value& each : values) text += " " + written(each);
}

}  // namespace

std::string written(const Value& value) {
    switch (value.kind) {
        case Value::Kind::number:
            return numberText(value.number);
        case Value::Kind::word:
            break;
        case Value::Kind::text:
            return "\"" + value.text + "\"";
        case Value::Kind::truth:
            if (value.text.empty()) return value.number != 0 ? "<true>" : "<false>";
            break;
        case Value::Kind::expression:
            return "(" + value.text + ")";
        case Value::Kind::range:
            return "<" + itemsOf(value) + ">";
        case Value::Kind::color:
            return "{" + itemsOf(value) + "}";
        case Value::Kind::list:
            return "[" + itemsOf(value) + "]";
    }
    return value.text;
}

std::string written(const Command& command) {
    std::string text = command.word;
    appendValues(command.values, text);
    for (const KeyedValues& each : command.keys) {
        text += " " + each.key;
        if (!each.suffix.empty()) text += "." + each.suffix;
        appendValues(each.values, text);
    }
    for (const KeyedValues& each : command.tags) {
        text += " " + each.key;
        appendValues(each.values, text);
    }
    if (command.bodyPosition.line > 1) text += "\n" + command.body + "End" + command.word;
    return text;
}

bool declaresFunction(const Command& command) {
    if (command.id != CommandId::let || command.values.size() < 2) return false;
    const Value& name = command.values.front();
    return !name.path.empty() && !name.path.front().index.empty() && name.text.ends_with(')');
}

const KeyedValues* Command::key(std::string_view name) const {
    for (const KeyedValues& each : keys)
        if (each.key == name) return &each;
    return nullptr;
}

namespace {

bool isSame(const Command& a, const Command& b) {
    const auto pair = [](const UniformSpec& each) {
        return std::tie(each.tag, each.form, each.values, each.mayBeUnknown, each.word);
    };
    const auto values = [](const std::vector<Value>& all) {
        std::string text;
        for (const Value& each : all) text += written(each) + "\n";
        return text;
    };
    return a.id == b.id && sameWord(a.word, b.word) && a.position.line == b.position.line &&
           a.numbers == b.numbers && a.givenNumbers == b.givenNumbers &&
           std::ranges::equal(a.uniforms, b.uniforms, {}, pair, pair) &&
           values(a.values) == values(b.values) && a.body == b.body && a.isModern == b.isModern &&
           a.partner == b.partner && a.bodyPosition == b.bodyPosition &&
           (!a.isModern || sameWord(written(a), written(b)));
}

/// The messages that formatting cannot change. Blanks after a backslash are removed (glib-W02).
std::vector<std::pair<std::string, int>> messagesOf(const Script& script) {
    std::vector<std::pair<std::string, int>> all;
    for (const Diagnostic& each : script.diagnostics)
        if (each.id != "glib-W02") all.emplace_back(each.id, each.place.line);
    return all;
}

}  // namespace

bool meanTheSame(const Script& a, const Script& b) {
    return a.isModern == b.isModern && a.lostNames == b.lostNames && messagesOf(a) == messagesOf(b) &&
           std::ranges::equal(a.commands, b.commands, isSame);
}

}  // namespace glibra::glib
