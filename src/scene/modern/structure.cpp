// Groups, conditions and included files (language, 12.2).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "base/suggest.h"
#include "expression/measures.h"
#include "glib/limits.h"
#include "glib/statement_table.h"
#include "glib/text.h"
#include "image/file.h"
#include "scene/modern/modern.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"
#include "scene/run/scope.h"
#include "scene/run/statements.h"
#include "scene/textures.h"

namespace glibra::scene {
namespace {

/// Nested groups and included files.
constexpr std::size_t kMostCalls = 64;

/// True if one more level of groups or files may be entered; otherwise glib-E15 is reported.
bool mayEnter(Interpreter& in, const Command& command) {
    if (in.around.calls < kMostCalls) return true;
    in.reportAt(command, "glib-E15",
                fmt::format("{}: more than {} nested groups and files", command.word, kMostCalls));
    return false;
}

/// What a choice, or the counter of a Repeat over words, stands for where it is given to a parameter: its
/// value, or what its word names.
enum class Wanted { value, object, camera };

/// What the default of a parameter is.
Wanted kindOf(Interpreter& in, const Value& usual) {
    if (namesObject(in, usual) || choosesObject(in, usual)) return Wanted::object;
    return namesCamera(in, usual) || choosesCamera(in, usual) ? Wanted::camera : Wanted::value;
}

std::optional<decltype(Argument::value)> valueOf(Interpreter& in, std::span<const Value> values,
                                                 Wanted wanted) {
    const bool isWord = values.size() == 1 && values.front().kind == Value::Kind::word;
    const bool isPart = isWord && values.front().path.size() > 1;
    const bool wantsObject = wanted == Wanted::object;
    if (isWord && (namesCamera(in, values.front()) ||
                   (wanted == Wanted::camera && choosesCamera(in, values.front())))) {
        const auto camera = cameraNamed(in, values.front());
        if (!camera) return std::nullopt;
        return camera->name;
    }
    if (isWord &&
        (namesObject(in, values.front()) || ((wantsObject || isPart) && choosesObject(in, values.front())))) {
        const auto object = objectNamed(in, values.front());
        if (!object) return std::nullopt;
        return *object;
    }
    const auto value = constantOf(in, values);
    if (!value) return std::nullopt;
    return *value;
}

std::optional<Argument> argumentOf(Interpreter& in, std::span<const Value> values, Wanted wanted) {
    const DependsOnly depends(in);
    auto value = valueOf(in, values, wanted);
    if (!value) return std::nullopt;
    return Argument{*std::move(value), depends.depends()};
}

/// True if one of the values reads a name that nothing has declared so far.
bool readsLaterName(Interpreter& in, std::span<const Value> values) {
    const Environment& names = in.names();
    return std::ranges::any_of(values, [&](const Value& each) {
        if (each.kind == Value::Kind::word) return !names.find(headOf(each));
        if (each.kind != Value::Kind::expression) return false;
        const NotedNames noted(names);
        static_cast<void>(expression::parse(each.text, {}, noted));
        return std::ranges::any_of(noted.take(), [](const NotedNames::Note& note) {
            return !note.count && note.path.find('.') == std::string::npos;
        });
    });
}

void doGroup(Interpreter& in, const Command& command) {
    const std::size_t index = indexOf(in, command);
    if (!command.values.empty()) {
        GroupDefinition& group = in.modern.groups[command.values.front().text];
        group = {{in.script, in.around.given}, index, in.names().here(), group.isRunning, group.isDrawn};
        // No default reads a parameter.
        for (const KeyedValues& each : command.tags)
            group.defaults.push_back(
                readsLaterName(in, each.values)
                    ? GroupDefinition::Default{{}, true}
                    : GroupDefinition::Default{argumentOf(in, each.values, kindOf(in, each.values.front()))});
        return;
    }
    const Scope scope(in);
    runBody(in, index + 1, command.partner);
}

/// What a parameter with that default is given.
Wanted wantedLike(const Argument& usual) {
    if (std::holds_alternative<ObjectView>(usual.value)) return Wanted::object;
    return std::holds_alternative<CameraName>(usual.value) ? Wanted::camera : Wanted::value;
}

/// True if all arguments have the name of a parameter; otherwise glib-E27 is reported, which calls the
/// parameters' owner `owner`.
bool haveParameters(Interpreter& in, std::span<const KeyedValues> arguments,
                    std::span<const std::string_view> names, const std::string& owner) {
    for (const KeyedValues& given : arguments) {
        if (std::ranges::find(names, given.key) != names.end()) continue;
        in.reportAt(given, "glib-E27",
                    fmt::format("{} '{}'{}", owner, given.key, base::suggestion(given.key, names)));
        return false;
    }
    return true;
}

/// Gives a parameter its value for the statements of the group.
void bindValue(Environment& names, const KeyedValues& parameter, const expression::Value& value,
               expression::Depends depends) {
    expression::Symbol symbol;
    symbol.type = value.type;
    symbol.depends = expression::Depends::variable;
    const Environment::Slot slot = names.bind(parameter.key, symbol);
    names.setDepends(slot, depends);
    names.set(slot, value.all());
}

/// Makes a parameter stand for a texture or buffer, with its size.
void bindObject(Interpreter& in, const KeyedValues& parameter, const ObjectView& object) {
    Environment& names = in.names();
    const auto* texture = std::get_if<TextureView>(&object);
    const std::string& own = texture != nullptr ? in.scene.textures[texture->texture].name
                                                : in.scene.buffers[std::get<BufferView>(object).buffer].name;
    expression::Symbol symbol;
    symbol.type = expression::Type::record();
    symbol.what = texture != nullptr ? "texture" : "buffer";
    if (const expression::Symbol* declared = texture == nullptr ? names.lookUpInScene(own) : nullptr)
        symbol = *declared;  // with the type of its elements
    names.setObject(names.bind(parameter.key, symbol), object);
    const char* const field = texture != nullptr ? ".size" : ".count";
    const expression::Symbol* const declared = names.lookUpInScene(own + field);
    if (declared == nullptr) return;
    std::vector<double> size = names.valuesOf(declared->slot);
    // Layers do not become fewer.
    const std::size_t sides = texture != nullptr ? sideCount(in.scene.textures[texture->texture].target) : 0;
    for (std::size_t i = 0; i < sides && texture->level && i < size.size(); ++i)
        size[i] = std::max(1., std::floor(std::ldexp(size[i], -*texture->level)));
    const Environment::Slot slot = names.bind(parameter.key + field, expression::Symbol(*declared));
    if (!size.empty()) names.set(slot, size);
}

/// Does `work` with the names that the Group has around it.
template <class Work>
auto aroundGroup(Interpreter& in, const GroupDefinition& group, const Work& work) {
    const InFile file(in, group.file);
    const InnerNames inner(in);
    in.names().enterGroup(group.names, &group.file.script->commands[group.command]);
    return work();
}

/// What a parameter has for a Draw. `given`: by the Draw; null: nothing.
std::optional<Argument> argumentOf(Interpreter& in, const GroupDefinition& group, std::size_t index,
                                   const KeyedValues* given) {
    const auto& [usual, isOfLater] = group.defaults[index];
    if (!isOfLater) {
        if (given == nullptr) return usual;
        return argumentOf(in, given->values, usual ? wantedLike(*usual) : Wanted::value);
    }
    const std::vector<Value>& values = group.file.script->commands[group.command].tags[index].values;
    const Wanted wanted = aroundGroup(in, group, [&] { return kindOf(in, values.front()); });
    if (given != nullptr) return argumentOf(in, given->values, wanted);
    return aroundGroup(in, group, [&] { return argumentOf(in, values, wanted); });
}

/// What the parameters of a group have for a Draw, where that stands: what it gives, or their defaults.
/// Nothing with the reason reported.
std::optional<std::vector<Argument>> argumentsOf(Interpreter& in, const GroupDefinition& group,
                                                 const Command& call) {
    const Command& definition = group.file.script->commands[group.command];
    std::vector<std::string_view> names;
    for (const KeyedValues& each : definition.tags) names.push_back(each.key);
    if (!haveParameters(in, call.tags, names,
                        fmt::format("group '{}' has no parameter", definition.values.front().text)))
        return std::nullopt;
    std::vector<Argument> arguments;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto given = std::ranges::find(call.tags, names[i], &KeyedValues::key);
        auto argument = argumentOf(in, group, i, given == call.tags.end() ? nullptr : &*given);
        if (!argument) return std::nullopt;
        arguments.push_back(*std::move(argument));
    }
    return arguments;
}

void bindParameters(Interpreter& in, const Command& group, const std::vector<Argument>& arguments) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const auto& [argument, depends] = arguments[i];
        if (const auto* value = std::get_if<expression::Value>(&argument))
            bindValue(in.names(), group.tags[i], *value, depends);
        else if (const auto* camera = std::get_if<CameraName>(&argument))
            in.names().bindCamera(group.tags[i].key, *camera);
        else
            bindObject(in, group.tags[i], std::get<ObjectView>(argument));
    }
}

/// Whoever misses a variable that only these statements set reports nothing.
void loseNames(Interpreter& in, const glib::Script& script, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const Command& each = script.commands[i];
        if (each.id != CommandId::let || each.values.empty()) continue;
        const Value& target = each.values.front();
        const std::string& name = headOf(target);
        if (in.names().lookUpInScene(name) == nullptr) in.modern.lostNames.insert(name);
    }
}

/// Runs a group for a Draw. Errors of the arguments are those of the Draw.
void runGroup(Interpreter& in, const GroupDefinition& group, const Command& call) {
    const Command& definition = group.file.script->commands[group.command];
    const auto arguments = argumentsOf(in, group, call);
    if (!arguments) return loseNames(in, *group.file.script, group.command + 1, definition.partner);
    const InFile file(in, group.file);
    in.names().enterGroup(group.names, &definition);
    bindParameters(in, definition, *arguments);
    runBody(in, group.command + 1, definition.partner);
}

void doDraw(Interpreter& in, const Command& command) {
    std::string name = command.values.front().text;
    auto known = in.modern.groups.find(name);
    if (known == in.modern.groups.end()) known = in.modern.groups.find(name = wordBehind(in, name));
    if (known == in.modern.groups.end()) {
        if (in.modern.lostNames.contains(name)) return;
        std::vector<std::string_view> names;
        for (const auto& [each, group] : in.modern.groups) names.push_back(each);
        const std::string hint = base::suggestion(name, names);
        in.reportAt(command.values.front(), "glib-E27",
                    fmt::format("no group '{}' is declared before this line{}", name, hint));
        return;
    }
    if (known->second.isRunning) {
        in.reportAt(command, "glib-E28", fmt::format("group '{}' draws itself", name));
        return;
    }
    if (!mayEnter(in, command)) return;
    const Scope scope(in);
    known->second.isRunning = known->second.isDrawn = true;
    ++in.around.calls;
    in.modern.checks.path.push_back(command.begin);
    runGroup(in, GroupDefinition(known->second), command);
    in.modern.checks.path.pop_back();
    --in.around.calls;
    in.modern.groups.find(name)->second.isRunning = false;
}

}  // namespace

void drawOtherGroups(Interpreter& in) {
    for (const auto& [name, group] : in.modern.groups) {
        if (group.isDrawn) continue;
        Command call = group.file.script->commands[group.command];
        call.tags.clear();
        doDraw(in, call);
    }
}

void addConditions(Interpreter& in, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const Command& each = in.script->commands[i];
        if (each.id != CommandId::let || each.values.empty()) continue;
        const Value& target = each.values.front();
        const expression::Symbol* const symbol = in.names().lookUpInScene(headOf(target));
        if (symbol != nullptr) in.names().addDepends(symbol->slot, in.around.conditions);
    }
}

namespace {

void doWhen(Interpreter& in, const Command& command) {
    const std::size_t index = indexOf(in, command);
    const expression::Depends outer = in.around.conditions;
    std::optional<bool> condition;
    {
        const DependsOnly depends(in);
        condition = truthOf(in, command.values.front());
        in.around.conditions = outer | depends.depends();
    }
    const Command& partner = in.script->commands[command.partner];
    const bool hasElse = partner.id == CommandId::elseBranch;
    addConditions(in, index + 1, hasElse ? partner.partner : command.partner);
    if (in.around.conditions != expression::Depends::nothing || !condition)
        in.modern.untaken.push_back(
            condition && !*condition
                ? UntakenRange{in.script, index + 1, command.partner}
                : UntakenRange{in.script, command.partner + 1, hasElse ? partner.partner : command.partner});
    ++in.around.blocks;
    const auto isOfScope = [&](const std::string& path) {
        return in.names().findLocal(path.substr(0, path.find('.'))).has_value();
    };
    const bool runsBoth =
        in.runsAll && std::ranges::none_of(expression::pathsIn(command.values.front().text), isOfScope);
    if (runsBoth || (condition && *condition)) run(in, index + 1, command.partner);
    if (hasElse && (runsBoth || (condition && !*condition))) run(in, command.partner + 1, partner.partner);
    --in.around.blocks;
    in.around.conditions = outer;
}

/// The script of an included file; null with the reason reported.
const glib::Script* includedScript(Interpreter& in, const Command& command, const std::string& name) {
    const FileIndex file = fileOf(in, name, in.place(command.values.front()));
    const FileReference& reference = in.scene.files[file];
    if (reference.path.empty()) {
        for (const Diagnostic& each : reference.remarks) in.report(each);
        return nullptr;
    }
    const std::string path = reference.path.generic_string();
    std::unique_ptr<const glib::Script>& script = in.shared->files.included[path];
    if (script) return script.get();
    const auto bytes = image::readFile(reference.source(), {name, in.place(command)}, glib::kLargestFile);
    if (!bytes) {
        for (const Diagnostic& each : bytes.diagnostics) in.report(each);
        return nullptr;
    }
    script = std::make_unique<const glib::Script>(
        glib::parse({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, path));
    in.shared->files.includedOrder.push_back(script.get());
    if (!reference.content && !shownRoots(in.folders).contains(reference.path))
        in.shared->files.hidden.insert(path);
    for (const Diagnostic& each : script->diagnostics) in.reportOnce(each);
    return script.get();
}

/// What is declared keeps its index from frame to frame, so it stands outside all blocks.
bool declares(const Command& command) {
    const glib::StatementRow* row = command.isModern ? glib::statementOf(command.id) : nullptr;
    if (row != nullptr && row->standing != glib::Standing::notInPass)
        return row->standing != glib::Standing::anywhere &&
               (command.id != CommandId::let || glib::declaresFunction(command)) &&
               command.id != CommandId::bound;
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
        if ((each.id != CommandId::let && each.id != CommandId::bound) || each.values.empty()) continue;
        const Value& name = each.values.front();
        if (name.path.empty())
            names.push_back(name.text);
        else if (name.path.front().index.empty())
            names.push_back(name.path.front().name);
    }
    if (!haveParameters(in, command.tags, names,
                        fmt::format("'{}' has no variable", command.values.front().text)))
        return std::nullopt;
    GivenVariables given;
    for (const KeyedValues& each : command.tags) {
        const auto value = constantOf(in, each.values);
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
    const auto declaration = std::ranges::find_if(script->commands, declares);
    if (in.around.blocks > 0 && declaration != script->commands.end()) {
        in.modern.including.erase(script);
        in.reportAt(command, "glib-E23",
                    fmt::format("'{}' declares something on line {}, so it cannot be included inside a block",
                                name, declaration->position.line));
        return;
    }
    if (auto given = givenVariables(in, command, *script)) {
        in.modern.lostNames.insert(script->lostNames.begin(), script->lostNames.end());
        ++in.around.calls;
        in.modern.checks.path.push_back(command.begin);
        {
            const InFile file(in, {script, std::make_shared<const GivenVariables>(*std::move(given))});
            expectNames(in);
            in.modern.included.insert(script);
            run(in, 0, script->commands.size());
        }
        in.modern.checks.path.pop_back();
        --in.around.calls;
    }
    in.modern.including.erase(script);
}

}  // namespace

std::span<const CommandAction> structureActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::group, doGroup},
        {CommandId::endGroup, doNothing},
        {CommandId::draw, doDraw, InList::isWrong, true},
        {CommandId::endRepeat, doNothing, InList::isPart},
        {CommandId::when, doWhen, InList::isPart},
        {CommandId::elseBranch, doNothing, InList::isPart},
        {CommandId::endWhen, doNothing, InList::isPart},
        {CommandId::include, doInclude, InList::isWrong},
    };
    return kActions;
}

namespace {

/// What a name may stand for: the words of a choice or of a Repeat, the values of a parameter.
class Aliases {
  public:
    void add(const glib::Script& script) {
        for (const Command& each : script.commands) {
            if (each.id == CommandId::let && each.values.size() > 1 &&
                each.values[1].kind == Value::Kind::range)
                addWords(headOf(each.values.front()), each.values[1].items, true);
            if (each.id == CommandId::repeat && !each.values.empty()) {
                const KeyedValues* as = each.key("as");
                addWords(as != nullptr ? as->values.front().text : "i", each.values.front().items, false);
            }
            if (each.id == CommandId::group || each.id == CommandId::draw || each.id == CommandId::include)
                for (const KeyedValues& parameter : each.tags)
                    addWords(parameter.key, parameter.values, false);
        }
    }

    /// Adds the names that `name` stands for in the end. `isChosen`: a choice is on the way.
    void resolve(const std::string& name, bool isChosen, std::set<std::pair<std::string, bool>>& to) const {
        if (!to.emplace(name, isChosen).second) return;
        const auto known = words_.find(name);
        if (known == words_.end()) return;
        for (const auto& [word, isOfChoice] : known->second) resolve(word, isChosen || isOfChoice, to);
    }

  private:
    void addWords(const std::string& name, const std::vector<Value>& values, bool isChoice) {
        for (const Value& each : values)
            if (each.kind == Value::Kind::word || each.kind == Value::Kind::expression)
                words_[name].emplace(headOf(each), isChoice);
    }

    std::map<std::string, std::set<std::pair<std::string, bool>>, std::less<>> words_;
};

class WriteSearch {
  public:
    explicit WriteSearch(const Interpreter& in) : in_(in) {
        addScript(*in.script);
        for (const glib::Script* each : in.shared->files.includedOrder) addScript(*each);
    }

    std::set<TextureIndex> find() {
        for (const glib::Script* script : scripts_)
            for (const Command& each : script->commands) addTargets(each, true);
        for (const UntakenRange& each : in_.modern.untaken) addRange(*each.script, each.first, each.last);
        return std::move(found_);
    }

  private:
    void addScript(const glib::Script& script) {
        scripts_.push_back(&script);
        aliases_.add(script);
    }

    void addRange(const glib::Script& script, std::size_t first, std::size_t last) {
        if (!ranges_.emplace(&script, first).second) return;
        for (std::size_t i = first; i < last && i < script.commands.size(); ++i) {
            const Command& each = script.commands[i];
            addTargets(each, false);
            if (each.id == CommandId::dispatch) addImages(each);
            if (each.id == CommandId::draw && !each.values.empty()) addGroup(each.values.front().text);
            if (each.id == CommandId::include) addIncluded(each);
        }
    }

    void addGroup(const std::string& name) {
        std::set<std::pair<std::string, bool>> names;
        aliases_.resolve(name, false, names);
        for (const auto& [each, isChosen] : names) {
            const auto known = in_.modern.groups.find(each);
            if (known == in_.modern.groups.end() || !groups_.insert(each).second) continue;
            const GroupDefinition& group = known->second;
            const glib::Script& script = *group.file.script;
            addRange(script, group.command + 1, script.commands[group.command].partner);
        }
    }

    /// A file that has not been read may write whatever has been declared.
    void addIncluded(const Command& command) {
        const std::string& name = command.values.front().text;
        for (const glib::Script* each : in_.shared->files.includedOrder)
            if (each->path.ends_with(name)) return addRange(*each, 0, each->commands.size());
        for (const TextureIndex each : in_.scene.textures.indices()) found_.insert(each);
    }

    /// The targets of a statement. `onlyChosen`: those that a choice makes.
    void addTargets(const Command& command, bool onlyChosen) {
        const bool isPass = command.id == CommandId::pass || command.id == CommandId::fill;
        const bool isClear = command.id == CommandId::clearParts && !command.values.empty();
        if (!command.isModern || (!isPass && !isClear)) return;
        for (const Value& each : command.values) addName(each, onlyChosen);
    }

    void addImages(const Command& command) {
        addTags(command.tags);
        const auto program = in_.modern.programs.find(command.values.front().text);
        if (program == in_.modern.programs.end()) return;
        const auto tags = in_.modern.programTags.find(program->second);
        if (tags != in_.modern.programTags.end()) addTags(tags->second.command->tags);
    }

    void addTags(const std::vector<KeyedValues>& tags) {
        for (const KeyedValues& each : tags)
            if (!each.values.empty()) addName(each.values.front(), false);
    }

    void addName(const Value& value, bool onlyChosen) {
        if (value.kind != Value::Kind::word) return;
        std::set<std::pair<std::string, bool>> names;
        aliases_.resolve(headOf(value), false, names);
        for (const auto& [name, isChosen] : names) {
            if (onlyChosen && !isChosen) continue;
            const auto known = in_.modern.names.find(name);
            if (known == in_.modern.names.end()) continue;
            if (const auto* texture = std::get_if<TextureIndex>(&known->second.object))
                found_.insert(*texture);
        }
    }

    const Interpreter& in_;
    std::vector<const glib::Script*> scripts_;
    Aliases aliases_;
    std::set<std::string> groups_;                                  ///< whose statements have been added
    std::set<std::pair<const glib::Script*, std::size_t>> ranges_;  ///< likewise
    std::set<TextureIndex> found_;
};

}  // namespace

std::set<TextureIndex> undecidedWrites(const Interpreter& in) {
    const auto isChoice = [](const Command& each) {
        return each.id == CommandId::let && each.values.size() > 1 &&
               each.values[1].kind == Value::Kind::range && !each.values[1].items.empty() &&
               each.values[1].items.front().kind == Value::Kind::word;
    };
    const auto hasChoice = [&](const glib::Script* script) {
        return std::ranges::any_of(script->commands, isChoice);
    };
    const std::vector<const glib::Script*>& included = in.shared->files.includedOrder;
    if (in.modern.untaken.empty() && !hasChoice(in.script) && std::ranges::none_of(included, hasChoice))
        return {};  // as in most frames
    return WriteSearch(in).find();
}

}  // namespace glibra::scene
