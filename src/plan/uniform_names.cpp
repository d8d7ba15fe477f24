#include "plan/uniform_names.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cstddef>
#include <set>
#include <utility>

#include "base/suggest.h"
#include "base/text.h"
#include "expression/known_names.h"

namespace glibra::plan {

bool isTextureMatrix(glsl::Builtin value) {
    return value == glsl::Builtin::textureMatrix || value == glsl::Builtin::textureMatrixInverse ||
           value == glsl::Builtin::textureMatrixTranspose ||
           value == glsl::Builtin::textureMatrixInverseTranspose;
}

UniformNames::UniformNames(const ProgramInterface& interface) {
    for (std::size_t i = 0; i < interface.uniforms.size(); ++i) {
        const ActiveUniform& uniform = interface.uniforms[i];
        const UniformIndex index(i);
        arraySizes_.push_back(uniform.isArray ? std::max(uniform.arraySize, 1) : 0);
        exact_[uniform.name].push_back(index);
        if (uniform.block < 0) continue;
        // GL reports `Block.member` for a block with an instance name, and `member` for one without.
        const std::string prefix = uniform.blockName + ".";
        const bool hasPrefix = uniform.name.starts_with(prefix);
        const std::string member = hasPrefix ? uniform.name.substr(prefix.size()) : uniform.name;
        members_[hasPrefix ? member : prefix + member].push_back(index);
        const std::size_t plain = std::min(uniform.blockName.find('['), uniform.blockName.size());
        const glsl::MemoryBlock* block =
            interface.facts.memory.block(uniform.blockName.substr(0, plain), false);
        if (block != nullptr && !block->instance.empty() && block->instance != block->name)
            members_[block->instance + uniform.blockName.substr(plain) + "." + member].push_back(index);
    }
}

const std::vector<UniformIndex>* UniformNames::indices(std::string_view name) const {
    if (const auto found = exact_.find(name); found != exact_.end()) return &found->second;
    if (const auto found = members_.find(name); found != members_.end()) return &found->second;
    return nullptr;
}

std::vector<NamedUniform> UniformNames::find(std::string_view tag) const {
    std::vector<NamedUniform> found;
    if (const std::vector<UniformIndex>* whole = indices(tag)) {
        for (const UniformIndex each : *whole) found.push_back({each, 0, false});
        return found;
    }
    const std::size_t bracket = tag.rfind('[');
    if (bracket == std::string_view::npos || !tag.ends_with(']')) return found;
    const std::string_view digits = tag.substr(bracket + 1, tag.size() - bracket - 2);
    int element = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), element);
    if (problem != std::errc() || end != digits.data() + digits.size() || element < 0) return found;
    const std::vector<UniformIndex>* arrays = indices(tag.substr(0, bracket));
    if (arrays == nullptr) return found;
    for (const UniformIndex each : *arrays)
        if (element < arraySizes_[each]) found.push_back({each, element, true});
    return found;
}

const glsl::BuiltinUniform* suppliedBy(const ActiveUniform& uniform) {
    const glsl::BuiltinUniform* row = glsl::findBuiltinUniform(uniform.name);
    const bool isSame =
        row != nullptr && row->type == uniform.type.word && uniform.isArray == isTextureMatrix(row->value);
    return isSame ? row : nullptr;
}

std::optional<std::string_view> attributeOfInput(const ActiveInput& input, bool knowsNames) {
    if (const glsl::BuiltinInput* row = glsl::findBuiltinInput(input.name)) return row->attribute;
    if (!knowsNames) return std::nullopt;
    const std::string_view attribute = glsl::wellKnownAttribute(input.name, input.type.word);
    return attribute.empty() ? std::nullopt : std::optional(attribute);
}

bool isSuppliedName(std::string_view name) {
    return glsl::findBuiltinUniform(name) != nullptr || glsl::findBuiltinInput(name) != nullptr;
}

bool isInternalName(std::string_view name) {
    return name.starts_with("glibra_") || name.starts_with("gl_");
}

bool namesMemory(const glsl::MemoryFacts& memory, std::string_view name) {
    return memory.counters.contains(std::string(name)) ||
           std::ranges::any_of(memory.blocks, [&](const glsl::MemoryBlock& each) {
               return each.name == name || each.instance == name ||
                      (!each.members.empty() && each.members.back().name == name);
           });
}

void addMemory(const glsl::MemoryFacts& memory, std::vector<std::string>& to) {
    for (const glsl::MemoryBlock& each : memory.blocks)
        for (const std::string& name : {each.name, each.instance})
            if (!name.empty()) to.push_back(name);
    for (const auto& [name, counter] : memory.counters) to.push_back(name);
}

std::string nearestUniform(std::string_view tag, std::span<const std::string> names) {
    constexpr std::size_t kPrefix = 1;  // the u at the beginning of most uniform names
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    return base::nearestName(tag, candidates, kPrefix);
}

std::string hintOf(std::string_view name) {
    return name.empty() ? std::string() : fmt::format("; did you mean '{}'?", name);
}

std::string suggestionFor(std::string_view tag, std::span<const std::string> names) {
    return hintOf(nearestUniform(tag, names));
}

std::string_view rootName(std::string_view name) {
    return name.substr(0, name.find_first_of(".["));
}

namespace {

/// A part of a tag: `lights[2]`. A subscript that is no number is kept as nothing.
struct TagPart {
    std::string_view name;
    std::vector<std::optional<long long>> subscripts;
    std::size_t nameEnd = 0, end = 0;  ///< in the tag
};

std::optional<long long> subscriptOf(std::string_view text) {
    long long value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::vector<TagPart> partsOf(std::string_view tag) {
    std::vector<TagPart> parts;
    for (std::size_t at = 0; at < tag.size();) {
        TagPart part;
        const std::size_t end = std::min(tag.find_first_of(".[", at), tag.size());
        part.name = tag.substr(at, end - at);
        at = part.nameEnd = end;
        while (at < tag.size() && tag[at] == '[') {
            const std::size_t close = std::min(tag.find(']', at), tag.size());
            part.subscripts.push_back(subscriptOf(tag.substr(at + 1, close - at - 1)));
            at = std::min(close + 1, tag.size());
        }
        part.end = at;
        parts.push_back(std::move(part));
        at = std::max(std::min(tag.find('.', at), tag.size() - 1) + 1, at + 1);
    }
    return parts;
}

/// What a name stands for: a structure or block with members, or a value of a basic type.
struct Declared {
    const std::vector<glsl::MemoryMember>* members = nullptr;  ///< null: a basic type
    std::string_view type;
    const glsl::ArraySizes* sizes = nullptr;
};

Declared declaredBy(const glsl::MemoryFacts& memory, const glsl::MemoryMember& member) {
    const auto structure = memory.structures.find(member.type);
    return {structure == memory.structures.end() ? nullptr : &structure->second.members, member.type,
            &member.sizes};
}

std::optional<Declared> rootOf(const glsl::MemoryFacts& memory, std::string_view name) {
    if (const auto record = memory.records.find(name); record != memory.records.end())
        return declaredBy(memory, record->second);
    for (const glsl::MemoryBlock& each : memory.blocks)
        if (!each.isStorage && (each.name == name || each.instance == name))
            return Declared{&each.members, "block", &each.sizes};
    return std::nullopt;
}

/// What is wrong with the subscripts of a part; empty if nothing is. `goesOn`: a member follows.
std::string subscriptProblem(const TagPart& part, std::string_view path, const Declared& declared,
                             bool goesOn) {
    const glsl::ArraySizes& sizes = *declared.sizes;
    if (part.subscripts.size() > sizes.size()) return fmt::format("; '{}' is no array", part.name);
    for (std::size_t i = 0; i < part.subscripts.size(); ++i)
        if (part.subscripts[i] && sizes[i] > 0 && *part.subscripts[i] >= sizes[i])
            return fmt::format("; '{}' has {}", part.name, base::counted(sizes[i], "element"));
    if (goesOn && part.subscripts.size() < sizes.size())
        return fmt::format("; '{}' is an array, so write '{}[0].'", part.name, path);
    return {};
}

/// Structures contain no others deeper than any scene needs; faulty text may contain itself.
constexpr int kDeepest = 16;

/// True if the text shows the size of every array of structures in it.
bool hasKnownSizes(const glsl::MemoryFacts& memory, const glsl::MemoryMember& member, int depth) {
    const Declared declared = declaredBy(memory, member);
    if (declared.members == nullptr) return true;
    return depth < kDeepest &&
           std::ranges::all_of(
               member.sizes, [](long long size) { return size > 0; }) &&
           std::ranges::all_of(
               *declared.members,
               [&](const glsl::MemoryMember& each) { return hasKnownSizes(memory, each, depth + 1); });
}

using VisitMember = std::function<bool(const MemberValue&)>;

/// `path`: with the subscripts of the first `axis` sizes.
bool visitAll(const glsl::MemoryFacts& memory, const glsl::MemoryMember& member, const std::string& path,
              std::size_t axis, const VisitMember& visit) {
    const Declared declared = declaredBy(memory, member);
    if (declared.members == nullptr) {
        // Of an array of arrays of a basic type, only the innermost is one value.
        if (axis + 1 >= member.sizes.size()) return visit({path, member.type, axis < member.sizes.size()});
    } else if (axis == member.sizes.size()) {
        return std::ranges::all_of(*declared.members, [&](const glsl::MemoryMember& each) {
            return visitAll(memory, each, path + "." + each.name, 0, visit);
        });
    }
    for (long long i = 0; i < std::max(member.sizes[axis], 1LL); ++i)
        if (!visitAll(memory, member, fmt::format("{}[{}]", path, i), axis + 1, visit)) return false;
    return true;
}

}  // namespace

std::optional<MemberSearch> searchMember(const glsl::MemoryFacts& memory, std::string_view tag) {
    const std::vector<TagPart> parts = partsOf(tag);
    if (parts.empty()) return std::nullopt;
    std::optional<Declared> here = rootOf(memory, parts.front().name);
    if (!here) return std::nullopt;
    for (std::size_t i = 0;; ++i) {
        const std::string_view path = tag.substr(0, parts[i].end);
        const bool goesOn = i + 1 < parts.size();
        if (std::string problem = subscriptProblem(parts[i], path, *here, goesOn); !problem.empty())
            return MemberSearch{false, std::move(problem)};
        if (!goesOn) break;
        if (here->members == nullptr)
            return MemberSearch{false,
                                fmt::format("; '{}' is of type {}, which has no members", path, here->type)};
        const std::string_view name = parts[i + 1].name;
        const auto member = std::ranges::find_if(
            *here->members, [&](const glsl::MemoryMember& each) { return each.name == name; });
        if (member == here->members->end()) {
            std::vector<std::string_view> names;
            for (const glsl::MemoryMember& each : *here->members) names.push_back(each.name);
            const std::string nearest = base::nearestName(name, names);
            if (nearest.empty())
                return MemberSearch{
                    false, fmt::format("; the members of '{}' are {}", path, fmt::join(names, ", "))};
            const std::string whole = fmt::format("{}.{}{}", path, nearest, tag.substr(parts[i + 1].nameEnd));
            return MemberSearch{false, hintOf(whole), whole};
        }
        here = declaredBy(memory, *member);
    }
    if (here->members == nullptr) {
        MemberSearch found{true};
        const glsl::ArraySizes& sizes = *here->sizes;
        if (parts.back().subscripts.size() + 1 == sizes.size())
            found.elements = static_cast<int>(std::clamp(sizes.back(), 0LL, 1LL << 20));
        return found;
    }
    if (here->members->empty()) return MemberSearch{};
    const bool isElement = parts.back().subscripts.size() >= here->sizes->size();
    const std::string whole =
        fmt::format("{}{}.{}", tag, isElement ? "" : "[0]", here->members->front().name);
    return MemberSearch{false, hintOf(whole), whole};
}

bool visitMembers(const glsl::MemoryFacts& memory, std::string_view root, const VisitMember& visit) {
    const auto record = memory.records.find(root);
    if (record == memory.records.end() || !hasKnownSizes(memory, record->second, 0)) return false;
    visitAll(memory, record->second, std::string(root), 0, visit);
    return true;
}

namespace {

/// The variable or block whose members are reported together.
std::string_view groupOf(const ActiveUniform& each) {
    return rootName(each.block < 0 ? each.name : each.blockName);
}

/// What other programs supply to shaders, as expressions of a scene.
struct ForeignName {
    std::string_view name, expression;
};
constexpr ForeignName kForeignNames[] = {
    {"iTime", "time"},
    {"iTimeDelta", "dt"},
    {"iFrame", "frame"},
    {"iResolution", "vec3(window, 1)"},
    {"iMouse", "vec4(mouse * window, mouse * window)"},
    {"u_time", "time"},
    {"u_resolution", "window"},
    {"u_mouse", "mouse * window"},
    {"uTime", "time"},
    {"uResolution", "window"},
};

/// The expression for the value that the name has elsewhere or in expressions; empty if it has none.
std::string_view expressionFor(std::string_view name, const std::set<std::string, std::less<>>& local) {
    const auto rows = expression::sceneNames();
    if (local.contains(name) ||
        std::ranges::any_of(rows, [&](const expression::NameRow& each) { return each.path == name; }))
        return name;
    for (const ForeignName& each : kForeignNames)
        if (each.name == name) return each.expression;
    return {};
}

}  // namespace

void UniformMessages::warn(const char* id, std::string text, const Place& place, std::string_view subject,
                           std::string suggestion) {
    to_.push_back(about(diagnose(id, std::move(text), place), std::string(subject), std::move(suggestion)));
}

bool UniformMessages::isDeclared(std::string_view name) const {
    const std::optional<MemberSearch> search = searchMember(interface_.facts.memory, name);
    return search ? search->isDeclared
                  : interface_.facts.uniforms.contains(std::string(name)) ||
                        interface_.facts.uniforms.contains(std::string(rootName(name)));
}

void UniformMessages::supplied(const GivenValue& given) {
    if (given.tag == "Timer") {
        constexpr double kDefaultPeriod = 10;
        const bool isPeriod =
            given.form == glib::UniformForm::number && !given.values.empty() && given.values.front() > 0;
        const double period = isPeriod ? given.values.front() : kDefaultPeriod;
        return warn("glib-W25",
                    fmt::format("glibra supplies 'Timer'; set its period with the command "
                                "'Timer {}'",
                                numberText(period)),
                    given.tagPlace);
    }
    warn("glib-W25", fmt::format("glibra supplies '{}', so the tag has no effect", given.tag),
         given.tagPlace);
}

void UniformMessages::unknown(const GivenValue& given, std::string_view resembles) {
    const std::string_view tag = given.tag;
    if (isSuppliedName(tag)) return supplied(given);
    if (isUnreadPart(tag)) return;
    const std::string members = std::string(tag) + ".";
    const std::string elements = std::string(tag) + "[";
    std::string member;
    for (const ActiveUniform& each : interface_.uniforms)
        if (member.empty() && (each.name.starts_with(members) || each.name.starts_with(elements)))
            member = each.name;
    const std::optional<MemberSearch> search = searchMember(interface_.facts.memory, tag);
    if (search && !search->isDeclared)
        return warn("glib-W23",
                    fmt::format("no shader of '{}' has a uniform '{}'{}", program_.name, tag, search->hint),
                    given.tagPlace, tag, search->suggestion);
    if (member.empty() && isDeclared(tag))
        return warn("glib-W24",
                    fmt::format("uniform '{}' is declared in '{}' but unused, so its value has no effect",
                                tag, program_.name),
                    given.tagPlace, program_.name);
    const bool isMemory = member.empty() && namesMemory(interface_.facts.memory, rootName(tag));
    if (!isMemory && member.empty() && !resembles.empty())
        return warn("glib-E16",
                    fmt::format("Dispatch: unknown word '{}'; did you mean '{}'?", tag, resembles),
                    given.tagPlace);
    const std::string near = isMemory ? "" : member.empty() ? nearestUniform(tag, knownNames()) : member;
    warn("glib-W23",
         fmt::format("no shader of '{}' has a uniform '{}'{}", program_.name, tag,
                     isMemory ? "; the block or atomic counter takes a buffer" : hintOf(near)),
         given.tagPlace, tag, near);
}

const std::vector<std::string>& UniformMessages::knownNames() {
    if (knownNames_.empty()) {
        const glsl::MemoryFacts& memory = interface_.facts.memory;
        std::set<std::string_view> listed;
        for (const auto& [root, record] : memory.records)
            if (visitMembers(memory, root, [this](const MemberValue& each) {
                    knownNames_.push_back(each.name);
                    return true;
                }))
                listed.insert(root);
        for (const ActiveUniform& each : interface_.uniforms)
            if (!isInternalName(each.name) && suppliedBy(each) == nullptr &&
                !listed.contains(rootName(each.name)))
                knownNames_.push_back(each.name);
        for (const auto& [name, declared] : interface_.facts.uniforms)
            if (!isInternalName(name)) knownNames_.push_back(name);
        addMemory(memory, knownNames_);
    }
    return knownNames_;
}

bool UniformMessages::isUnreadPart(std::string_view tag) const {
    const std::string_view root = rootName(tag);
    const bool isRead = std::ranges::any_of(interface_.uniforms, [&](const ActiveUniform& each) {
        return each.block < 0 && rootName(each.name) == root;
    });
    if (!isRead || root == tag) return false;
    if (interface_.facts.memory.records.contains(root))
        return searchMember(interface_.facts.memory, tag).value_or(MemberSearch{}).isDeclared;
    const auto declared = interface_.facts.uniforms.find(std::string(root));
    int element = 0;
    const std::string_view rest = tag.substr(root.size());
    const auto [end, problem] = std::from_chars(rest.data() + 1, rest.data() + rest.size(), element);
    return declared != interface_.facts.uniforms.end() && rest.starts_with('[') && problem == std::errc() &&
           std::string_view(end, rest.data() + rest.size()) == "]" && element >= 0 &&
           element < declared->second.arraySize;
}

void UniformMessages::unset(std::span<const ActiveUniform> uniforms) {
    constexpr std::size_t kMostNamed = 3;
    std::map<std::string_view, std::size_t> members;  // of each variable or block
    for (const ActiveUniform& each : uniforms) ++members[groupOf(each)];
    for (const ActiveUniform& each : uniforms) {
        std::size_t& count = members[groupOf(each)];
        if (count > 0 && count <= kMostNamed)
            warn("glib-W37",
                 fmt::format("uniform '{}' of '{}' is not set; it is 0{}", each.name, program_.name,
                             hintOfNames(each)),
                 program_.place, each.name);
        if (count <= kMostNamed) continue;
        warn("glib-W37",
             fmt::format("members of '{}' of '{}' are not set; they are 0. The first is '{}'", groupOf(each),
                         program_.name, each.name),
             program_.place);
        count = 0;  // reported
    }
}

std::string UniformMessages::scopeHint(const std::string& name) const {
    const auto isOfName = [&](const std::string& key) { return key == name || key.starts_with(name + "["); };
    for (const auto& [key, place] : scene_->setNames)
        if (isOfName(key))
            return fmt::format(
                "; the Set of '{}' in line {} ends with its scope (a round of Repeat, a Pass or a "
                "Group)",
                key, place.line);
    return {};
}

std::string UniformMessages::hintOfNames(const ActiveUniform& target) const {
    if (scene_ != nullptr) {
        const std::string_view value = expressionFor(target.name, scene_->localNames);
        if (value.empty()) return scopeHint(target.name);
        return fmt::format("; write '{} ({})' on the line of its Program, Fill or Dispatch", target.name,
                           value);
    }
    const auto isUniform = [this](std::string_view name) { return names_.hasUniform(name); };
    if (target.isArray || target.block >= 0 ||
        !glsl::wellKnownUniform(target.name, target.type.word, isUniform))
        return {};
    return "; scenes with a Camera or another modern statement supply it";
}

Diagnostic unknownWord(const scene::Scene& scene, std::string_view word, const Place& place) {
    std::vector<std::string> names;
    for (const scene::Variable& each : scene.variables) names.push_back(each.name);
    for (const glib::UniformSpec& each : scene.namedValues) names.push_back(each.tag);
    for (const scene::Texture& each : scene.textures)
        if (!each.name.empty()) names.push_back(each.name);
    for (const scene::Buffer& each : scene.buffers) names.push_back(each.name);
    return diagnose(scene.otherNames.contains(word) ? "glib-E34" : "glib-E27",
                    fmt::format("'{}' is no variable, texture or buffer{}", word, suggestionFor(word, names)),
                    place);
}

}  // namespace glibra::plan
