#include "glib/modern/build_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "glib/limits.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

bool isName(const Event& event) {
    if (event.node->kind == SyntaxNode::Kind::pairs) return true;
    const ValueType type = event.node->type;
    return type == ValueType::object || type == ValueType::array || type == ValueType::any;
}

/// `true` is a truth only where any value may stand. The words of a list have one spelling.
void finishValue(Value& value, const SyntaxNode& node) {
    const bool isAny = node.kind == SyntaxNode::Kind::pairs || node.type == ValueType::any ||
                       node.type == ValueType::constant;
    if (value.kind == Value::Kind::truth) {
        if (isAny) {
            value.text.clear();
        } else {
            value.kind = Value::Kind::word;
            value.number = 0;
        }
    }
    if (node.type == ValueType::oneOf && value.kind == Value::Kind::word) value.text = lower(value.text);
}

void checkTags(const StatementRow& row, const Command& command, MessageLog& log) {
    if (command.tags.size() > kMostTags) {
        log.report("glib-E15", fmt::format("{} has more than {} tags", row.name, kMostTags),
                   command.tags[kMostTags].position);
        return;
    }
    std::vector<const KeyedValues*> sorted;
    for (const KeyedValues& each : command.tags) sorted.push_back(&each);
    std::ranges::sort(sorted, [](const auto* a, const auto* b) {
        return std::pair(std::string_view(a->key), a) < std::pair(std::string_view(b->key), b);
    });
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (sorted[i]->key == sorted[i - 1]->key) {
            log.report("glib-E18", fmt::format("{}: tag {} given twice", row.name, inQuotes(sorted[i]->key)),
                       sorted[i]->position);
            return;
        }
}

}  // namespace

void build(const StatementRow& row, const std::vector<Event>& events, Pieces pieces, Command& command,
           MessageLog& log) {
    std::vector<Value>* place = &command.values;
    for (const Event& event : events) {
        const Value& first = pieces[event.begin];
        if (event.kind == Event::Kind::key) {
            command.keys.push_back({event.node->text, lower(afterPoint(first.text)), {}, first.position, {}});
            place = &command.keys.back().values;
        } else if (event.kind == Event::Kind::tag) {
            KeyedValues tag{
                pieces.written(event.begin, event.end), {}, {}, first.position, {}, event.resembles};
            std::vector<NamePart> path = pieces.pathOf(event.begin, event.end);
            if (path.size() > 1 || !path.front().index.empty()) tag.path = std::move(path);
            command.tags.push_back(std::move(tag));
            place = &command.tags.back().values;
        } else if (first.kind == Value::Kind::word && isName(event)) {
            place->push_back(pieces.nameOf(event.begin, event.end));
        } else {
            for (std::size_t i = event.begin; i < event.end; ++i) place->push_back(pieces.take(i));
            finishValue(place->back(), *event.node);
        }
    }
    checkTags(row, command, log);
}

}  // namespace glibra::glib
