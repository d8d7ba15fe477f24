#include "plan/uniform_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "expression/known_names.h"
#include "plan/uniform_members.h"

namespace glibra::plan {
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

void UniformMessages::misspelt(std::string_view tag, std::string_view key, const Place& place) {
    warn("glib-E16", fmt::format("Dispatch: unknown word '{}'; did you mean '{}'?", tag, key), place);
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
    if (member.empty() && !resembles.empty()) return misspelt(tag, resembles, given.tagPlace);
    const std::string near = member.empty() ? nearestUniform(tag, knownNames()) : member;
    warn("glib-W23", fmt::format("no shader of '{}' has a uniform '{}'{}", program_.name, tag, hintOf(near)),
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
                             modernHint(each)),
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
    for (const auto& [key, place] : modern_->setNames)
        if (isOfName(key))
            return fmt::format(
                "; the Set of '{}' in line {} ends with its scope (a round of Repeat, a Pass or a "
                "Group)",
                key, place.line);
    return {};
}

std::string UniformMessages::modernHint(const ActiveUniform& target) const {
    if (modern_ != nullptr) {
        const std::string_view value = expressionFor(target.name, modern_->localNames);
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
    return diagnose("glib-E27",
                    fmt::format("'{}' is no variable, texture or buffer{}", word, suggestionFor(word, names)),
                    place);
}

}  // namespace glibra::plan
