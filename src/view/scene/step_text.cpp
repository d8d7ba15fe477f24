#include "view/scene/step_text.h"

#include <algorithm>
#include <cstddef>

#include "glib/modern/statement_table.h"
#include "glib/number.h"

namespace glibra::view {
namespace {

using glib::Command;
using glib::CommandId;
using glib::Value;

bool isStage(CommandId id) {
    return (id >= CommandId::vertex && id <= CommandId::fragment) || id == CommandId::compute;
}

bool isControl(Value::Kind kind) {
    return kind == Value::Kind::range || kind == Value::Kind::color || kind == Value::Kind::truth;
}

void add(const Command& command, std::string& text) {
    const bool isLetOfControl = (command.id == CommandId::let || command.id == CommandId::bound) &&
                                std::any_of(command.values.begin(), command.values.end(),
                                            [](const Value& each) { return isControl(each.kind); });
    if (isLetOfControl) {
        text += "Let";
        for (const Value& each : command.values) text += " " + (isControl(each.kind) ? "?" : written(each));
        text += '\n';
        return;
    }
    if (command.isModern) {
        text += written(command);
    } else {
        text += command.word;
        for (const Value& each : command.values) text += " " + written(each);
        for (const glib::KeyedValues& each : command.tags) {
            text += " " + each.key;
            for (const Value& value : each.values) text += " " + written(value);
        }
    }
    for (const double each : command.numbers) text += " " + glib::numberText(each);
    text += " " + command.text;
    for (const std::string& each : command.files) text += " " + each;
    for (const glib::PointGroup& group : command.points)
        for (const double each : group.values) text += " " + glib::numberText(each);
    for (const glib::UniformSpec& each : command.uniforms) {
        text += " " + each.tag;
        const bool isFixed = each.form == glib::UniformForm::number || each.form == glib::UniformForm::list;
        if (isFixed)
            for (const double value : each.values) text += " " + glib::numberText(value);
    }
    text += '\n';
}

}  // namespace

std::string stepText(std::span<const glib::Script* const> scripts) {
    std::string text;
    for (const glib::Script* script : scripts) {
        std::size_t blockEnd = 0;  // the command that ends the outermost open block, or is before the next
        for (std::size_t i = 0; i < script->commands.size(); ++i) {
            const Command& command = script->commands[i];
            const bool opens = command.partner != Command::kNoPartner && command.partner > i;
            const bool isInBlock = blockEnd > i || (blockEnd == i && i > 0);
            if (opens && command.id != CommandId::pass) blockEnd = std::max(blockEnd, command.partner);
            if (isStage(command.id) || (!isInBlock && !glib::restartsSimulation(command.id))) continue;
            add(command, text);
        }
        text += '\f';
    }
    return text;
}

}  // namespace glibra::view
