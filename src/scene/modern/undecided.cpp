#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "scene/modern/modern.h"

namespace glibra::scene {
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
