#include "plan/buffer_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace glibra::plan {
namespace {

constexpr std::uint64_t kMostNames = 4096;  // of one member

/// Replaces the first or last [0] of a name by another index.
void setIndex(std::string& name, std::size_t at, std::uint64_t index) {
    if (at != std::string::npos) name.replace(at, 3, fmt::format("[{}]", index));
}

/// The name of the member that begins at each byte of the block.
std::map<std::uint64_t, std::string> namesOf(const base::StorageBlock& block) {
    std::map<std::uint64_t, std::string> names;
    const std::string prefix = block.name.substr(0, block.name.find('[')) + ".";
    for (const base::StorageMember& member : block.members) {
        const bool hasPrefix = member.name.starts_with(prefix);
        const std::string plain = hasPrefix ? member.name.substr(prefix.size()) : member.name;
        const bool isInStructure = plain.find('.') != std::string::npos;
        const auto count = [](int declared) {
            return std::clamp<std::uint64_t>(declared > 0 ? static_cast<std::uint64_t>(declared) : 1, 1,
                                             kMostNames);
        };
        for (std::uint64_t i = 0; i < count(member.outerSize); ++i)
            for (std::uint64_t j = 0; j < count(member.arraySize); ++j) {
                std::string name = plain;
                if (name.ends_with("[0]")) setIndex(name, name.size() - 3, j);
                if (isInStructure) setIndex(name, name.find("[0]"), i);
                names.try_emplace(static_cast<std::uint64_t>(member.offset) +
                                      i * static_cast<std::uint64_t>(member.outerStride) +
                                      j * static_cast<std::uint64_t>(member.arrayStride),
                                  std::move(name));
            }
    }
    return names;
}

/// The name within an element: "all[0].velocity" is "velocity", "values[0]" is "values".
std::string nameInElement(const std::string& name) {
    if (const std::size_t point = name.find("]."); point != std::string::npos) return name.substr(point + 2);
    return name.substr(0, name.find('['));
}

/// A column begins where a member begins.
std::vector<BufferColumn> columnsOf(const std::vector<MemoryNumber>& numbers, std::uint64_t from,
                                    const std::map<std::uint64_t, std::string>& names, bool isElement,
                                    std::size_t most) {
    std::vector<BufferColumn> columns;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto name = names.find(from + numbers[i].offset);
        const bool begins = name != names.end() || columns.empty() || (names.empty() && i % 4 == 0);
        if (!begins || (isElement && columns.size() == most)) {
            ++columns.back().count;
            continue;
        }
        std::string title = numbers.size() <= 4 ? "value" : fmt::format("numbers from {}", i);
        if (name != names.end()) title = isElement ? nameInElement(name->second) : name->second;
        columns.push_back({std::move(title), i, 1});
    }
    return columns;
}

}  // namespace

base::StorageBlock blockOf(const BlockUse& use, const ProgramInterface& interface) {
    if (use.kind == BlockUse::Kind::storage) return interface.storageBlocks.at(use.index);
    base::StorageBlock block;
    const auto add = [&](std::string name, int offset) -> base::StorageMember& {
        base::StorageMember& member = block.members.emplace_back();
        member.name = std::move(name);
        member.offset = offset;
        return member;
    };
    if (use.kind == BlockUse::Kind::counters) {
        constexpr int kCounterBytes = 4;
        for (const std::string& each : interface.counterBuffers.at(use.index).counters)
            add(each, static_cast<int>(block.members.size()) * kCounterBytes);
        return block;
    }
    block.name = interface.blocks.at(use.index).name;
    for (const base::ActiveUniform& each : interface.uniforms) {
        if (each.block != static_cast<int>(use.index)) continue;
        base::StorageMember& member = add(each.isArray ? each.name + "[0]" : each.name, each.offset);
        member.arraySize = each.arraySize;
        member.arrayStride = each.arrayStride;
    }
    return block;
}

std::optional<base::StorageBlock> blockOf(const FramePlan& plan, scene::BufferIndex buffer) {
    for (const PlannedProgram& program : plan.programs)
        for (const BlockUse& each : program.blocks)
            if (each.buffer.buffer == buffer) return blockOf(each, *program.interface);
    return std::nullopt;
}

BufferTable tableOf(const BufferLayout& layout, const base::StorageBlock* block, std::size_t most) {
    std::map<std::uint64_t, std::string> names;
    if (block != nullptr) names = namesOf(*block);
    const MemoryPattern& pattern = layout.pattern;
    BufferTable table;
    table.head = columnsOf(pattern.head, 0, names, false, most);
    table.columns = columnsOf(pattern.element, pattern.elementsAt, names, true, most);
    table.elements = pattern.element.empty() ? 0 : layout.elements;
    return table;
}

std::vector<BufferField> fieldsOf(const BufferTable& table, const MemoryPattern& pattern) {
    std::vector<BufferField> fields;
    std::map<std::string, int> known;
    const auto add = [&](const std::vector<BufferColumn>& columns, const std::vector<MemoryNumber>& numbers,
                         bool isOfElement) {
        for (const BufferColumn& column : columns)
            for (std::size_t i = column.first; i < column.first + column.count;) {
                BufferField& field = fields.emplace_back(BufferField{column.name, {}, isOfElement});
                const NumberKind kind = numbers[i].kind;
                while (i < column.first + column.count && numbers[i].kind == kind)
                    field.numbers.push_back(numbers[i++]);
                if (const int before = known[field.name]++; before > 0)
                    field.name += fmt::format(" {}", before + 1);
            }
    };
    add(table.head, pattern.head, false);
    add(table.columns, pattern.element, true);
    return fields;
}

std::string cellText(std::span<const MemoryNumber> kinds, std::span<const double> values) {
    std::string text;
    for (std::size_t i = 0; i < std::min(kinds.size(), values.size()); ++i) {
        if (i > 0) text += ' ';
        const NumberKind kind = kinds[i].kind;
        const bool isFloat = kind == NumberKind::floating || kind == NumberKind::doublePrecision;
        if (isFloat)
            text += fmt::format("{:.6g}", values[i]);
        else if (kind == NumberKind::boolean)
            text += values[i] != 0 ? "true" : "false";
        else
            text += fmt::format("{:.0f}", values[i]);
    }
    return text;
}

}  // namespace glibra::plan
