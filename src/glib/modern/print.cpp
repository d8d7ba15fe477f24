// Statements as a scene writes them.

#include <string>

#include "glib/number.h"
#include "glib/script.h"
#include "glib/value.h"

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

const KeyedValues* Command::key(std::string_view name) const {
    for (const KeyedValues& each : keys)
        if (each.key == name) return &each;
    return nullptr;
}

}  // namespace glibra::glib
