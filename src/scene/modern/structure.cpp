// Groups, conditions and included files (language, 12.2).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/suggest.h"
#include "glib/limits.h"
#include "glib/modern/statement_table.h"
#include "glib/number.h"
#include "glib/text.h"
#include "image/file.h"
#include "scene/modern/evaluate.h"
#include "scene/modern/modern.h"
#include "scene/modern/scope.h"
#include "scene/state.h"
#include "scene/texture_parts.h"

namespace glibra::scene {
namespace {

using glib::Command;
using glib::CommandId;

/// Nested groups and included files.
constexpr std::size_t kMostCalls = 64;

/// True if one more level of groups or files may be entered; otherwise glib-E28 is reported.
bool mayEnter(Interpreter& in, const Command& command) {
    if (in.modern.calls < kMostCalls) return true;
    in.reportAt(command, "glib-E28",
                fmt::format("{}: more than {} nested groups and files", command.word, kMostCalls));
    return false;
}

void doGroup(Interpreter& in, const Command& command) {
    const std::size_t index = indexOf(in, command);
    if (!command.values.empty()) {
        GroupDefinition& group = in.modern.groups[command.values.front().text];
        group = {in.script, index, group.isRunning};
        return;
    }
    const Scope scope(in);
    runBody(in, index + 1, command.partner);
}

/// Makes names stand for textures or buffers, and gives them back their meanings at its end.
class HiddenNames {
  public:
    explicit HiddenNames(Interpreter& in) : in_(in) {}
    HiddenNames(const HiddenNames&) = delete;
    HiddenNames& operator=(const HiddenNames&) = delete;
    ~HiddenNames() {
        for (auto each = before_.rbegin(); each != before_.rend(); ++each) {
            in_.modern.names.erase(each->first);
            if (each->second) in_.modern.names.emplace(each->first, std::move(*each->second));
        }
    }
    void hide(const std::string& name, DeclaredName meaning) {
        const auto known = in_.modern.names.find(name);
        before_.emplace_back(name,
                             known == in_.modern.names.end() ? std::nullopt : std::optional(known->second));
        in_.modern.names.insert_or_assign(name, std::move(meaning));
    }

  private:
    Interpreter& in_;
    std::vector<std::pair<std::string, std::optional<DeclaredName>>> before_;
};

/// What a parameter is given: a value, or a texture or buffer.
using Argument = std::variant<expression::Value, ObjectView>;

/// `wantsObject`: a choice, or the counter of a Repeat over words, is the texture or buffer that its word
/// names.
std::optional<Argument> argumentOf(Interpreter& in, std::span<const glib::Value> values, bool wantsObject) {
    const bool isWord = values.size() == 1 && values.front().kind == glib::Value::Kind::word;
    const bool isPart = isWord && values.front().path.size() > 1;
    if (isWord &&
        (namesObject(in, values.front()) || ((wantsObject || isPart) && choosesObject(in, values.front())))) {
        const auto object = objectNamed(in, values.front());
        return object ? std::optional<Argument>(*object) : std::nullopt;
    }
    const auto value = isWord ? evaluate(in, values.front()) : constantOf(in, values);
    return value ? std::optional<Argument>(*value) : std::nullopt;
}

/// True if all arguments have the name of a parameter; otherwise glib-E27 is reported, which calls the
/// parameters' owner `owner`.
bool haveParameters(Interpreter& in, std::span<const glib::KeyedValues> arguments,
                    std::span<const std::string_view> names, const std::string& owner) {
    for (const glib::KeyedValues& given : arguments) {
        if (std::find(names.begin(), names.end(), given.key) != names.end()) continue;
        in.report(diagnose("glib-E27",
                           fmt::format("{} '{}'{}", owner, given.key, base::suggestion(given.key, names)),
                           in.script->place(given.position)));
        return false;
    }
    return true;
}

/// Gives a parameter its value for the statements of the group.
void bindValue(Interpreter& in, const glib::KeyedValues& parameter, const expression::Value& value,
               expression::Depends depends, HiddenNames& hidden) {
    expression::Symbol symbol;
    symbol.type = value.type;
    Environment& names = in.shared->environment;
    const Environment::Slot slot = names.declareScoped(&parameter, parameter.key, symbol);
    names.setDepends(slot, expression::Depends::variable | depends);
    names.set(slot, value.all());
    const auto known = in.modern.names.find(parameter.key);
    if (known != in.modern.names.end() && (known->second.kind == DeclaredName::Kind::texture ||
                                           known->second.kind == DeclaredName::Kind::buffer))
        hidden.hide(parameter.key, {DeclaredName::Kind::computed, known->second.place, nullptr, {}, {}});
}

/// Makes a parameter stand for a texture or buffer, with its size.
void bindObject(Interpreter& in, const glib::KeyedValues& parameter, const ObjectView& object,
                HiddenNames& hidden) {
    Environment& names = in.shared->environment;
    const auto* texture = std::get_if<TextureView>(&object);
    const std::string& own = texture != nullptr ? in.scene.textures[texture->texture].name
                                                : in.scene.buffers[std::get<BufferView>(object).buffer].name;
    const char* const field = texture != nullptr ? ".size" : ".count";
    expression::Symbol record;
    record.type = expression::Type::record();
    record.what = texture != nullptr ? "texture" : "buffer";
    names.declareScoped(&parameter, parameter.key, record);
    if (const auto symbol = names.findOutermost(own + field)) {
        std::vector<double> size = names.valuesOf(symbol->slot);
        // Layers do not become fewer.
        const std::size_t sides =
            texture != nullptr ? sideCount(in.scene.textures[texture->texture].target) : 0;
        for (std::size_t i = 0; i < sides && texture->level && i < size.size(); ++i)
            size[i] = std::max(1., std::floor(std::ldexp(size[i], -*texture->level)));
        const Environment::Slot slot = names.declareScoped(&parameter, parameter.key + field, *symbol);
        if (!size.empty()) names.set(slot, size);
    }
    DeclaredName meaning{texture != nullptr ? DeclaredName::Kind::texture : DeclaredName::Kind::buffer,
                         {},
                         nullptr,
                         {},
                         object};
    if (texture != nullptr)
        meaning.object = texture->texture;
    else
        meaning.object = std::get<BufferView>(object).buffer;
    hidden.hide(parameter.key, std::move(meaning));
}

/// The parameters of a group: its defaults, and what Draw gives in their place.
bool bindParameters(Interpreter& in, const Command& group, const Command& call,
                    const glib::Script& callScript, HiddenNames& hidden) {
    std::vector<std::string_view> names;
    for (const glib::KeyedValues& each : group.tags) names.push_back(each.key);
    const glib::Script* const own = std::exchange(in.script, &callScript);
    const bool areKnown = haveParameters(
        in, call.tags, names, fmt::format("group '{}' has no parameter", group.values.front().text));
    in.script = own;
    if (!areKnown) return false;
    std::vector<std::pair<Argument, expression::Depends>> arguments;
    for (const glib::KeyedValues& parameter : group.tags) {
        const DependsOnly depends(in);
        const auto given =
            std::find_if(call.tags.begin(), call.tags.end(),
                         [&](const glib::KeyedValues& each) { return each.key == parameter.key; });
        const bool isGiven = given != call.tags.end();
        const glib::Value& usual = parameter.values.front();
        const bool wantsObject = namesObject(in, usual) || choosesObject(in, usual);
        in.script = isGiven ? &callScript : own;
        auto argument = argumentOf(in, isGiven ? given->values : parameter.values, wantsObject);
        in.script = own;
        if (!argument) return false;
        arguments.emplace_back(*std::move(argument), depends.depends());
    }
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const auto& [argument, depends] = arguments[i];
        if (const auto* value = std::get_if<expression::Value>(&argument))
            bindValue(in, group.tags[i], *value, depends, hidden);
        else
            bindObject(in, group.tags[i], std::get<ObjectView>(argument), hidden);
    }
    return true;
}

void doDraw(Interpreter& in, const Command& command) {
    std::string name = command.values.front().text;
    auto known = in.modern.groups.find(name);
    if (known == in.modern.groups.end()) known = in.modern.groups.find(name = wordBehind(in, name));
    if (known == in.modern.groups.end()) {
        if (isLost(in, name)) return;
        std::vector<std::string_view> names;
        for (const auto& [each, group] : in.modern.groups) names.push_back(each);
        const std::string hint = base::suggestion(name, names);
        in.report(diagnose("glib-E27",
                           fmt::format("no group '{}' is declared before this line{}", name, hint),
                           in.script->place(command.values.front().position)));
        return;
    }
    GroupDefinition& group = known->second;
    if (group.isRunning) {
        in.reportAt(command, "glib-E28", fmt::format("group '{}' draws itself", name));
        return;
    }
    if (!mayEnter(in, command)) return;
    const Scope scope(in);
    const glib::Script* const caller = std::exchange(in.script, group.script);
    const Command& definition = in.script->commands[group.command];
    group.isRunning = true;
    ++in.modern.calls;
    {
        HiddenNames hidden(in);
        if (bindParameters(in, definition, command, *caller, hidden))
            runBody(in, group.command + 1, definition.partner);
    }
    --in.modern.calls;
    in.modern.groups.find(name)->second.isRunning = false;
    in.script = caller;
}

/// The variables that a branch sets change with its condition, whichever branch runs now.
void addConditions(Interpreter& in, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const Command& each = in.script->commands[i];
        if (each.id != CommandId::let || each.values.empty()) continue;
        const glib::Value& target = each.values.front();
        const auto symbol = in.shared->environment.findOutermost(
            target.path.empty() ? target.text : target.path.front().name);
        if (symbol) in.shared->environment.addDepends(symbol->slot, in.modern.conditions);
    }
}

void doWhen(Interpreter& in, const Command& command) {
    const std::size_t index = indexOf(in, command);
    const expression::Depends outer = in.modern.conditions;
    std::optional<bool> condition;
    {
        const DependsOnly depends(in);
        condition = truthOf(in, command.values.front());
        in.modern.conditions = outer | depends.depends();
    }
    const Command& partner = in.script->commands[command.partner];
    const bool hasElse = partner.id == CommandId::elseBranch;
    addConditions(in, index + 1, hasElse ? partner.partner : command.partner);
    if (in.modern.conditions != expression::Depends::nothing || !condition)
        in.modern.untaken.push_back(
            condition && !*condition
                ? UntakenRange{in.script, index + 1, command.partner}
                : UntakenRange{in.script, command.partner + 1, hasElse ? partner.partner : command.partner});
    ++in.modern.blocks;
    if (condition && *condition)
        run(in, index + 1, command.partner);
    else if (condition && hasElse)
        run(in, command.partner + 1, partner.partner);
    --in.modern.blocks;
    in.modern.conditions = outer;
}

/// The script of an included file; null with the reason reported.
const glib::Script* includedScript(Interpreter& in, const Command& command, const std::string& name) {
    const FileIndex file = fileOf(in, name, in.script->place(command.values.front().position));
    const FileReference& reference = in.scene.files[file];
    if (reference.path.empty()) {
        for (const Diagnostic& each : reference.remarks) in.report(each);
        return nullptr;
    }
    const std::string path = reference.path.string();
    std::unique_ptr<const glib::Script>& script = in.shared->included[path];
    if (script) return script.get();
    if (const auto edited = in.shared->texts.find(reference.path); edited != in.shared->texts.end()) {
        script = std::make_unique<const glib::Script>(glib::parse(edited->second, path));
    } else {
        const auto bytes = image::readFile(reference.path, {name, in.place(command)}, glib::kLargestFile);
        if (!bytes) {
            for (const Diagnostic& each : bytes.diagnostics) in.report(each);
            return nullptr;
        }
        script = std::make_unique<const glib::Script>(
            glib::parse({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, path));
    }
    in.shared->includedOrder.push_back(script.get());
    for (const Diagnostic& each : script->diagnostics) in.report(each);
    return script.get();
}

/// What is declared keeps its index from frame to frame, so it stands outside all blocks.
bool declares(const Command& command) {
    const glib::StatementRow* row = command.isModern ? glib::statementOf(command.id) : nullptr;
    if (row != nullptr && row->standing != glib::Standing::notInPass)
        return row->standing != glib::Standing::anywhere && command.id != CommandId::let;
    switch (command.id) {
        case CommandId::program:
        case CommandId::texture:
        case CommandId::texture1D:
        case CommandId::texture2D:
        case CommandId::texture3D:
        case CommandId::cubeMap:
            return true;
        default:
            return false;
    }
}

/// What the statement gives the variables of the file. Nothing with the reason reported.
std::optional<GivenVariables> givenVariables(Interpreter& in, const Command& command,
                                             const glib::Script& script) {
    std::vector<std::string_view> names;
    for (const Command& each : script.commands) {
        if (each.id != CommandId::let || each.values.empty()) continue;
        const glib::Value& name = each.values.front();
        if (name.path.empty())
            names.push_back(name.text);
        else if (name.path.front().index.empty())
            names.push_back(name.path.front().name);
    }
    if (!haveParameters(in, command.tags, names,
                        fmt::format("'{}' has no variable", command.values.front().text)))
        return std::nullopt;
    GivenVariables given;
    for (const glib::KeyedValues& each : command.tags) {
        const bool isWord = each.values.size() == 1 && each.values.front().kind == glib::Value::Kind::word;
        const auto value = isWord ? evaluate(in, each.values.front()) : constantOf(in, each.values);
        if (!value) return std::nullopt;
        given.insert_or_assign(each.key, *value);
    }
    return given;
}

void doInclude(Interpreter& in, const Command& command) {
    const std::string& name = command.values.front().text;
    const glib::Script* script = includedScript(in, command, name);
    if (script == nullptr || !mayEnter(in, command)) return;
    if (in.script == script || !in.modern.including.insert(script).second) {
        in.reportAt(command, "glib-E28", fmt::format("'{}' includes itself", name));
        return;
    }
    const auto declaration = std::find_if(script->commands.begin(), script->commands.end(), declares);
    if (in.modern.blocks > 0 && declaration != script->commands.end()) {
        in.modern.including.erase(script);
        in.reportAt(command, "glib-E28",
                    fmt::format("'{}' declares something on line {}, so it cannot be included inside a block",
                                name, declaration->position.line));
        return;
    }
    if (auto given = givenVariables(in, command, *script)) {
        in.modern.lostNames.insert(script->lostNames.begin(), script->lostNames.end());
        ++in.modern.calls;
        const glib::Script* const outer = std::exchange(in.script, script);
        std::swap(in.modern.given, *given);
        run(in, 0, script->commands.size());
        std::swap(in.modern.given, *given);
        in.script = outer;
        --in.modern.calls;
    }
    in.modern.including.erase(script);
}

constexpr CommandAction kStructureActions[] = {
    {CommandId::group, doGroup},
    {CommandId::endGroup, doNothing},
    {CommandId::draw, doDraw, InList::isWrong, true},
    {CommandId::repeat, doRepeat, InList::isPart},
    {CommandId::endRepeat, doNothing, InList::isPart},
    {CommandId::when, doWhen, InList::isPart},
    {CommandId::elseBranch, doNothing, InList::isPart},
    {CommandId::endWhen, doNothing, InList::isPart},
    {CommandId::include, doInclude, InList::isWrong},
};

}  // namespace

std::span<const CommandAction> structureActions() {
    return kStructureActions;
}

void runBody(Interpreter& in, std::size_t first, std::size_t last) {
    ++in.modern.blocks;
    run(in, first, last);
    --in.modern.blocks;
    if (in.state.stack.empty()) return;
    in.report(diagnose("glib-W31", "PushMatrix without PopMatrix at the end of the block",
                       in.state.stack.back().place));
}

std::size_t indexOf(const Interpreter& in, const Command& command) {
    return static_cast<std::size_t>(&command - in.script->commands.data());
}

void run(Interpreter& in, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last && !in.modern.isFull;) {
        const Command& command = in.script->commands[i];
        if (in.scene.isModern && !countStatement(in, command)) return;
        execute(in, command);
        // A command that opens a block has run the block.
        const bool opens = command.partner != Command::kNoPartner && command.partner > i;
        const std::size_t end = opens ? command.partner : i;
        const bool hasElse = opens && in.script->commands[end].id == CommandId::elseBranch;
        i = (hasElse ? in.script->commands[end].partner : end) + 1;
    }
}

int fileNumber(const Interpreter& in) {
    const std::vector<const glib::Script*>& files = in.shared->includedOrder;
    const auto found = std::find(files.begin(), files.end(), in.script);
    return found == files.end() ? 0 : static_cast<int>(found - files.begin()) + 1;
}

bool countStatement(Interpreter& in, const Command& command) {
    if (++in.modern.statements <= kMostStatements) return true;
    if (!std::exchange(in.modern.isFull, true))
        in.reportAt(command, "glib-E28",
                    fmt::format("the frame has more than {} statements, with repetitions",
                                glib::groupedText(static_cast<long long>(kMostStatements))));
    return false;
}

}  // namespace glibra::scene
