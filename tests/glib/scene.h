#pragma once
// Short functions with which the tests of this room ask about a scene.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "glib/script.h"

namespace glibra::glib::test {

using Ids = std::vector<std::string>;
using Words = std::vector<std::string>;
using Numbers = std::vector<double>;

inline Script read(std::string_view text) {
    return parse(text, "scene.glib");
}

/// The ids of all messages, in order.
inline Ids idsOf(const Script& script) {
    Ids ids;
    for (const Diagnostic& each : script.diagnostics) ids.push_back(each.id);
    return ids;
}
inline Ids idsOf(std::string_view text) {
    return idsOf(read(text));
}

/// The text of the first message with this id; empty if there is none.
inline std::string messageOf(std::string_view text, std::string_view id) {
    for (const Diagnostic& each : read(text).diagnostics)
        if (each.id == id) return each.text;
    return {};
}

/// "line:column" of the first message with this id.
inline std::string placeOf(std::string_view text, std::string_view id) {
    for (const Diagnostic& each : read(text).diagnostics)
        if (each.id == id) return std::to_string(each.place.line) + ":" + std::to_string(each.place.column);
    return {};
}

/// The numbers of the first command; empty if there is none.
inline std::vector<double> numbersOf(std::string_view text) {
    const Script script = read(text);
    return script.commands.empty() ? std::vector<double>() : script.commands.front().numbers;
}

/// The text of the first command.
inline std::string textOf(std::string_view text) {
    const Script script = read(text);
    return script.commands.empty() ? "no command" : script.commands.front().text();
}

/// The texts of a command's values.
inline Words textsOf(const Command& command) {
    Words texts;
    for (const Value& each : command.values) texts.push_back(each.text);
    return texts;
}

/// The words of all commands, as written.
inline std::vector<std::string> wordsOf(std::string_view text) {
    std::vector<std::string> words;
    for (const Command& each : read(text).commands) words.push_back(each.word);
    return words;
}

/// The tags of the first Program.
inline std::vector<std::string> tagsOf(std::string_view text) {
    std::vector<std::string> tags;
    for (const Command& each : read(text).commands) {
        if (each.id != CommandId::program) continue;
        for (const UniformSpec& spec : each.uniforms) tags.push_back(spec.tag);
        break;
    }
    return tags;
}

}  // namespace glibra::glib::test
