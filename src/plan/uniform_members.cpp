#include "plan/uniform_members.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <vector>

#include "base/suggest.h"
#include "base/text.h"
#include "plan/uniform_names.h"

namespace glibra::plan {
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

}  // namespace glibra::plan
