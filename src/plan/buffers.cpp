#include "plan/buffers.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "base/number.h"
#include "base/suggest.h"
#include "base/text.h"
#include "glib/number.h"
#include "plan/accesses.h"

namespace glibra::plan {
namespace {

/// The members through which a program sees a buffer: of the storage block, the uniform block, or the atomic
/// counters that use it.
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
        member.type = each.type;
    }
    return block;
}

/// True if the block is an array of the type that its buffer is declared with, as long as the buffer.
bool isAsDeclared(const scene::Buffer& buffer, const ProgramInterface& interface, const BlockUse& use) {
    if (use.kind != BlockUse::Kind::storage) return false;
    const std::string& name = interface.storageBlocks.at(use.index).name;
    const glsl::MemoryBlock* block = interface.facts.memory.block(name.substr(0, name.find('[')), true);
    return block != nullptr && block->members.size() == 1 && block->members.front().type == buffer.type &&
           block->members.front().sizes == glsl::ArraySizes{0};
}

/// Adds the buffers of one plan to the layouts.
class LayoutFinder {
  public:
    LayoutFinder(const scene::Scene& scene, const FramePlan& plan, std::uint64_t mostBytes,
                 std::uint64_t (*fileBytes)(const scene::FileReference&),
                 std::map<scene::BufferIndex, BufferLayout>& layouts)
        : scene_(scene), plan_(plan), mostBytes_(mostBytes), fileBytes_(fileBytes), layouts_(layouts) {}

    Diagnostics add(std::span<const FramePlan* const> others) && {
        for (const PlannedProgram& each : plan_.programs) programs_.push_back(&each);
        for (const FramePlan* other : others)
            for (const PlannedProgram& each : other->programs) programs_.push_back(&each);
        for (const bool asDeclared : {true, false})
            for (std::size_t i = 0; i < programs_.size(); ++i)
                for (const BlockUse& use : programs_[i]->blocks)
                    if (decides(*programs_[i]->interface, use, i < plan_.programs.size(), asDeclared))
                        addBlock(*programs_[i]->interface, use);
        for (const scene::BufferIndex each : plan_.buffers)
            if (!layouts_.contains(each) && !failed_.contains(each)) addByType(each);
        plan_.visitDraws([&](const PlannedDraw& planned, const scene::Draw& draw, const auto&) {
            checkTexels(planned.program, planned.textures, draw.place);
        });
        for (const PlannedDispatch& each : plan_.dispatches)
            checkTexels(each.program, each.textures, plan_.dispatchOf(each).place);
        return std::move(diagnostics_);
    }

  private:
    /// True for a block that is to be added: first those of the declared type, then those of the plan itself,
    /// and those of others for buffers that neither a block nor a basic type describes so far.
    bool decides(const ProgramInterface& interface, const BlockUse& use, bool isOwn, bool asDeclared) const {
        const scene::BufferIndex index = use.buffer.buffer;
        const bool isOpen = !layouts_.contains(index) &&
                            (isOwn || std::ranges::find(plan_.buffers, index) != plan_.buffers.end());
        const scene::Buffer& buffer = scene_.buffers[index];
        return asDeclared ? isOpen && isAsDeclared(buffer, interface, use)
                          : isOwn || (isOpen && !patternOf(buffer.type, glsl::MemoryStructures()));
    }

    void fail(scene::BufferIndex buffer, const char* id, std::string text) {
        if (failed_.insert(buffer).second)
            diagnostics_.push_back(diagnose(id, std::move(text), scene_.buffers[buffer].place));
    }

    void addBlock(const ProgramInterface& interface, const BlockUse& use) {
        const scene::BufferIndex index = use.buffer.buffer;
        if (failed_.contains(index)) return;
        const std::string what = describe(use, interface);
        std::optional<MemoryPattern> pattern;
        if (use.kind == BlockUse::Kind::uniform) pattern = patternOf(interface, use.index);
        if (use.kind == BlockUse::Kind::storage) pattern = patternOf(interface.storageBlocks.at(use.index));
        if (use.kind == BlockUse::Kind::counters) pattern = patternOf(interface.counterBuffers.at(use.index));
        if (!pattern)
            return fail(index, "memory-E17",
                        fmt::format("{} has too many members for a buffer of a scene", what));
        const auto known = layouts_.find(index);
        if (known == layouts_.end())
            return addLayout(index, std::move(*pattern), what, use.place, blockOf(use, interface));
        BufferLayout& first = known->second;
        if (!first.block) first.block = blockOf(use, interface);
        const std::string& name = scene_.buffers[index].name;
        if (firstDifference(first.pattern, *pattern, first.pattern.numbers(first.elements)))
            return fail(index, "memory-E03",
                        fmt::format("{} ({}:{}) and {} ({}:{}) lay out buffer '{}' differently; give both "
                                    "the same members and layout",
                                    first.from, first.place.file, first.place.line, what, use.place.file,
                                    use.place.line, name));
        if (pattern->least > paddedBytes(first, *pattern))
            return reportSmall(index, first.bytes, *pattern, what);
        if (!pattern->isRuntimeSized()) first.bytes = std::max(first.bytes, pattern->least);
    }

    /// The bytes that a buffer of that layout may have for another pattern. Drivers round the size of a block
    /// up, so one with as many numbers as the buffer may be larger by padding.
    static std::uint64_t paddedBytes(const BufferLayout& layout, const MemoryPattern& pattern) {
        if (pattern.isRuntimeSized()) return std::max(layout.bytes, kLeastBufferBytes);
        if (pattern.numbers(0) > layout.pattern.numbers(layout.elements)) return layout.bytes;
        return (layout.bytes + kLeastBufferBytes - 1) / kLeastBufferBytes * kLeastBufferBytes;
    }

    /// Reports memory-E03 for buffers that are read as textures, but that a block lays out otherwise than
    /// their type says.
    void checkTexels(PlannedProgramIndex program, const std::vector<TextureUse>& textures,
                     const Place& place) {
        for (const TextureUse& each : textures) {
            const auto known = layouts_.find(each.buffer.buffer);
            if (!each.buffer.buffer || known == layouts_.end()) continue;
            const scene::Buffer& buffer = scene_.buffers[each.buffer.buffer];
            const BufferLayout& layout = known->second;
            const auto ofType = patternOf(buffer.type, glsl::MemoryStructures());
            if (!ofType || !firstDifference(layout.pattern, *ofType, layout.pattern.numbers(layout.elements)))
                continue;
            const ActiveUniform& uniform = at(plan_.programs[program].interface->uniforms, each.uniform);
            fail(each.buffer.buffer, "memory-E03",
                 fmt::format("{} ({}:{}) and {} '{}' ({}:{}) lay out buffer '{}' differently; give both the "
                             "same members and layout",
                             layout.from, layout.place.file, layout.place.line, uniform.type.word,
                             uniform.name, place.file, place.line, buffer.name));
        }
    }

    void reportSmall(scene::BufferIndex index, std::uint64_t bytes, const MemoryPattern& pattern,
                     const std::string& what) {
        fail(index, "memory-E04",
             fmt::format("buffer '{}' has {}, but {} needs {}", scene_.buffers[index].name,
                         base::countedInGroups(bytes, "byte"), what, base::groupedText(pattern.least)));
    }

    /// The numbers of one element of the declared type; 0 if no type is declared or known.
    std::uint64_t numbersOfType(const scene::Buffer& buffer) const {
        const std::optional<MemoryPattern> pattern = declaredPattern(buffer);
        return pattern ? pattern->element.size() : 0;
    }

    std::optional<MemoryPattern> declaredPattern(const scene::Buffer& buffer) const {
        if (buffer.type.empty()) return std::nullopt;
        if (std::optional<MemoryPattern> basic = patternOf(buffer.type, glsl::MemoryStructures()))
            return basic;
        for (const PlannedProgram* each : programs_)
            if (std::optional<MemoryPattern> known =
                    patternOf(buffer.type, each->interface->facts.memory.structures))
                return known;
        return std::nullopt;
    }

    /// What is wrong with the type of the buffer, which nothing declares.
    std::string noStructure(const scene::Buffer& buffer) const {
        std::vector<std::string_view> types{"float", "int",   "uint",  "vec2",  "vec3",  "vec4",
                                            "ivec2", "ivec3", "ivec4", "uvec2", "uvec3", "uvec4",
                                            "mat2",  "mat3",  "mat4",  "double"};
        for (const PlannedProgram* each : programs_)
            for (const auto& [name, structure] : each->interface->facts.memory.structures)
                types.push_back(name);
        return fmt::format("no shader has a structure '{}', which is the type of buffer '{}'{}", buffer.type,
                           buffer.name, base::suggestion(buffer.type, types));
    }

    /// False for a buffer that a Once or Step has for the frame alone, whose plan reports what is wrong.
    bool isUsed(scene::BufferIndex buffer) const {
        bool isUsed = plan_.nodes == &scene_.frame;
        for (const NodeAccess& node : plan_.accesses)
            for (const ObjectUse& each : node.uses) isUsed |= objectOf(each.object) == Object(buffer);
        return isUsed;
    }

    void addByType(scene::BufferIndex index) {
        const scene::Buffer& buffer = scene_.buffers[index];
        std::optional<MemoryPattern> pattern = declaredPattern(buffer);
        if (!pattern && !isUsed(index)) return;
        if (!pattern)
            return fail(index, "memory-E05",
                        buffer.type.empty()
                            ? fmt::format("buffer '{}' has no type, and no block of a shader is called '{}'; "
                                          "write 'Buffer {} float' or another type",
                                          buffer.name, buffer.name, buffer.name)
                            : noStructure(buffer));
        addLayout(index, std::move(*pattern), "type " + buffer.type, buffer.place);
    }

    void addLayout(scene::BufferIndex index, MemoryPattern pattern, const std::string& from,
                   const Place& place, std::optional<base::StorageBlock> block = {}) {
        const scene::Buffer& buffer = scene_.buffers[index];
        const std::uint64_t ofType = numbersOfType(buffer);
        if (!buffer.type.empty() && ofType == 0 && buffer.count)
            return fail(index, "memory-E05", noStructure(buffer));
        const std::uint64_t head = pattern.head.size();
        const std::uint64_t perElement = std::max<std::uint64_t>(1, pattern.element.size());
        const auto elementsFor = [&](std::uint64_t numbers) {
            return numbers <= head ? 0 : (numbers - head + perElement - 1) / perElement;
        };
        const bool countsElements = ofType == 0 || ofType == pattern.element.size();
        std::uint64_t elements = elementsFor(buffer.values.size());
        std::uint64_t fileBytes = 0;
        if (buffer.file) {
            fileBytes = fileBytes_(scene_.files[buffer.file]);
            if (pattern.stride > 0)
                elements = (fileBytes - std::min(fileBytes, pattern.elementsAt)) / pattern.stride;
        }
        // Products of larger counts might overflow; such buffers are too large in any case.
        const std::uint64_t count = std::min(buffer.count.value_or(0), mostBytes_ + 1);
        if (buffer.count)
            elements = countsElements ? count : elementsFor(count * std::min(ofType, mostBytes_));
        elements = std::min(elements, mostBytes_ + 1);
        BufferLayout layout{std::move(pattern), elements, 0, from, place, std::move(block)};
        if (layout.pattern.elements != 0) layout.elements = layout.pattern.elements;
        std::uint64_t written = layout.pattern.numbers(layout.elements);
        if (ofType != 0 && !layout.pattern.isRuntimeSized())
            written = buffer.count ? count * ofType : buffer.file ? written : buffer.values.size();
        layout.bytes = std::max(layout.pattern.bytes(layout.elements), fileBytes);
        if (layout.bytes > mostBytes_)
            return fail(
                index, "memory-E17",
                fmt::format("buffer '{}' needs {}; the limit is {}", buffer.name,
                            base::countedInGroups(layout.bytes, "byte"), base::groupedText(mostBytes_)));
        if (written < layout.pattern.numbers(layout.elements))
            return fail(index, "memory-E04",
                        fmt::format("buffer '{}' has {}, but {} needs {}", buffer.name,
                                    base::countedInGroups(written, "number"), from,
                                    layout.pattern.numbers(layout.elements)));
        if (buffer.values.size() > layout.pattern.numbers(layout.elements))
            return fail(index, "memory-E04",
                        fmt::format("buffer '{}' has {}, but {} has room for {}", buffer.name,
                                    base::countedInGroups(buffer.values.size(), "value"), from,
                                    layout.pattern.numbers(layout.elements)));
        if (buffer.file && fileBytes < layout.pattern.least)
            return reportSmall(index, fileBytes, layout.pattern, from);
        if (const std::uint64_t wanted = ofType != 0 ? ofType : numbersPerElement(layout.pattern);
            buffer.isComputed && wanted != 0 && buffer.values.size() != count * wanted)
            return fail(
                index, "memory-E04",
                fmt::format("buffer '{}': an element has {}, but the expression gives {}", buffer.name,
                            base::countedInGroups(wanted, "number"), buffer.values.size() / count));
        checkValues(buffer, layout.pattern);
        checkType(buffer, layout);
        layouts_.emplace(index, std::move(layout));
    }

    /// The numbers of an element of a block that is a runtime-sized array; 0 for other blocks.
    static std::uint64_t numbersPerElement(const MemoryPattern& pattern) {
        return pattern.isRuntimeSized() && pattern.head.empty() ? pattern.element.size() : 0;
    }

    /// Reports glib-E31 for the first value that its float does not hold, and memory-W02 for the first that
    /// is out of the range of its integer.
    void checkValues(const scene::Buffer& buffer, const MemoryPattern& pattern) {
        const std::vector<double>& values = buffer.values.numbers();
        for (std::size_t i = 0; i < values.size(); ++i) {
            const NumberKind kind = pattern.at(i).kind;
            if (kind == NumberKind::floating && !base::fitsFloat(values[i])) {
                diagnostics_.push_back(
                    diagnose("glib-E31",
                             fmt::format("buffer '{}': value {} is {}, which is too large for a 32-bit float",
                                         buffer.name, i, glib::numberText(values[i])),
                             buffer.place));
                return;
            }
            const bool isSigned = kind == NumberKind::integer;
            if (!isSigned && kind != NumberKind::unsignedInteger) continue;
            const double value = values[i];
            const double held = isSigned ? static_cast<double>(base::toInt(value))
                                         : static_cast<double>(base::toUnsigned(value));
            if (base::wholeNumber(value).value == held) continue;
            diagnostics_.push_back(
                diagnose("memory-W02",
                         fmt::format("buffer '{}': value {} is {}, which is stored as {:.0f}; {}",
                                     buffer.name, i, glib::numberText(value), held,
                                     isSigned ? "an int holds -2,147,483,648 to 2,147,483,647"
                                              : "a uint holds 0 to 4,294,967,295"),
                         buffer.place));
            return;
        }
    }

    /// Reports memory-W03 for a block that is an array of other elements than the buffer is declared with. An
    /// array of the numbers of these elements is none: `Buffer places float 300` for `vec3 places[]`.
    void checkType(const scene::Buffer& buffer, const BufferLayout& layout) {
        const std::optional<MemoryPattern> declared = declaredPattern(buffer);
        const std::vector<MemoryNumber>& found = layout.pattern.element;
        constexpr std::size_t kMostNumbers = 256;
        const auto isWhole = [](NumberKind kind) {
            return kind == NumberKind::integer || kind == NumberKind::unsignedInteger;
        };
        const auto areAlike = [&](NumberKind a, NumberKind b) {
            return a == b || (isWhole(a) && isWhole(b));
        };
        if (!declared || declared->element.empty()) return;
        const std::vector<MemoryNumber>& wanted = declared->element;
        if (!layout.pattern.isRuntimeSized()) {
            // Without an array that the buffer's elements are, all numbers of the block are of its type.
            const bool isOneKind = std::ranges::all_of(
                wanted, [&](const MemoryNumber& each) { return each.kind == wanted.front().kind; });
            const std::uint64_t numbers =
                std::min<std::uint64_t>(kMostNumbers, layout.pattern.numbers(layout.elements));
            for (std::uint64_t i = 0; isOneKind && i < numbers; ++i) {
                const NumberKind kind = layout.pattern.at(i).kind;
                if (areAlike(kind, wanted.front().kind)) continue;
                diagnostics_.push_back(diagnose(
                    "memory-W04",
                    fmt::format(
                        "buffer '{}' is declared with the type {}, but number {} of {} ({}:{}) is {} {} "
                        "and decides; leave out the type, or make them the same",
                        buffer.name, buffer.type, i, layout.from, layout.place.file, layout.place.line,
                        kind == NumberKind::integer ? "an" : "a", wordOf(kind)),
                    buffer.place));
                return;
            }
            if (isOneKind) return;
        }
        if (found.empty() || !layout.pattern.head.empty()) return;
        bool fits = wanted.size() % found.size() == 0 || found.size() % wanted.size() == 0;
        for (std::size_t i = 0; fits && i < std::min(kMostNumbers, std::max(wanted.size(), found.size()));
             ++i)
            fits = areAlike(wanted[i % wanted.size()].kind, found[i % found.size()].kind);
        if (!fits)
            diagnostics_.push_back(diagnose(
                "memory-W03",
                fmt::format("buffer '{}' is declared with the type {}, but the elements of {} ({}:{}) differ "
                            "from it and decide; leave out the type, or make them the same",
                            buffer.name, buffer.type, layout.from, layout.place.file, layout.place.line),
                buffer.place));
    }

    const scene::Scene& scene_;
    const FramePlan& plan_;
    std::uint64_t mostBytes_;
    std::uint64_t (*fileBytes_)(const scene::FileReference&);
    std::map<scene::BufferIndex, BufferLayout>& layouts_;
    std::vector<const PlannedProgram*> programs_;  ///< of the plan, then of the others
    std::set<scene::BufferIndex> failed_;
    Diagnostics diagnostics_;
};

}  // namespace

Diagnostics BufferLayouts::add(const scene::Scene& scene, const FramePlan& plan, std::uint64_t mostBytes,
                               std::uint64_t (*fileBytes)(const scene::FileReference& file),
                               std::span<const FramePlan* const> others) {
    return LayoutFinder(scene, plan, mostBytes, fileBytes, layouts_).add(others);
}

const BufferLayout* BufferLayouts::find(scene::BufferIndex buffer) const {
    const auto found = layouts_.find(buffer);
    return found == layouts_.end() ? nullptr : &found->second;
}

namespace {

constexpr std::uint64_t kMostNames = 4096;  // of one member

/// Replaces the first or last [0] of a name by another index.
void setIndex(std::string& name, std::size_t at, std::uint64_t index) {
    if (at != std::string::npos) name.replace(at, 3, fmt::format("[{}]", index));
}

struct MemberAt {
    std::string name;
    int matrixColumns = 1;
};

/// The member that begins at each byte of the block.
std::map<std::uint64_t, MemberAt> namesOf(const base::StorageBlock& block) {
    std::map<std::uint64_t, MemberAt> names;
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
                                  MemberAt{std::move(name), member.type.columns});
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
                                    const std::map<std::uint64_t, MemberAt>& names, bool isElement,
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
        if (name != names.end()) title = isElement ? nameInElement(name->second.name) : name->second.name;
        columns.push_back({std::move(title), i, 1, name != names.end() ? name->second.matrixColumns : 1});
    }
    return columns;
}

}  // namespace

BufferTable tableOf(const BufferLayout& layout, std::size_t most) {
    std::map<std::uint64_t, MemberAt> names;
    if (layout.block) names = namesOf(*layout.block);
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
