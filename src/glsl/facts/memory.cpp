// Images, blocks, counters and structures (types/memory_facts.h), and the local size of a compute stage.

#include <algorithm>
#include <array>
#include <span>

#include "glsl/facts/facts.h"
#include "glsl/parse/usage.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

bool hasWord(const Qualifiers& qualifiers, std::string_view word) {
    return std::ranges::find(qualifiers.memory, word) != qualifiers.memory.end();
}

/// r32f, rgba8_snorm, r11f_g11f_b10f, rgb10_a2ui, ...; not row_major.
bool isImageFormat(const LayoutItem& item) {
    return item.value.empty() && item.name.starts_with('r') &&
           item.name.find_first_of("0123456789") != std::string::npos;
}

/// Packing and matrix order, as layout(...) gives them for a block, a member or all blocks that follow.
struct BlockDefaults {
    Packing packing = Packing::driver;
    bool isRowMajor = false;

    void apply(const Qualifiers& qualifiers) {
        for (const LayoutItem& each : qualifiers.layout) {
            if (each.name == "std140") packing = Packing::std140;
            if (each.name == "std430") packing = Packing::std430;
            if (each.name == "shared" || each.name == "packed") packing = Packing::driver;
            if (each.name == "row_major") isRowMajor = true;
            if (each.name == "column_major") isRowMajor = false;
        }
    }
};

class MemoryReader {
  public:
    MemoryReader(const Unit& unit, TranslatedProgram& result) : unit_(unit), result_(result) {}

    void run() {
        for (const Declaration& each : unit_.syntax.declarations) {
            if (each.kind == DeclarationKind::layoutOnly) layoutOnly(each.qualifiers);
            if (each.type.isStruct && each.name != kNone) structure(each);
            if (each.kind == DeclarationKind::block) block(each);
        }
        for (const Variable& each : unit_.variables)
            if (each.storage == Storage::uniform && !each.removed) uniform(each);
    }

  private:
    // ---- Constants

    [[nodiscard]] std::optional<long long> constant(Range range) const {
        long long value = 0;
        return globalIntegerValue(unit_, range, value) ? std::optional(value) : std::nullopt;
    }
    [[nodiscard]] std::optional<long long> item(const Qualifiers& qualifiers, std::string_view name) const {
        const LayoutItem* found = qualifiers.item(name);
        return found ? constant(found->value) : std::nullopt;
    }
    [[nodiscard]] std::optional<int> binding(const Qualifiers& qualifiers) const {
        const auto value = item(qualifiers, "binding");
        return value && *value >= 0 && *value < 100'000 ? std::optional(static_cast<int>(*value))
                                                        : std::nullopt;
    }

    void addSizes(const std::vector<Range>& dimensions, ArraySizes& to) const {
        for (const Range& each : dimensions) {
            const auto value = constant(each);
            to.push_back(each.empty() ? 0 : value && *value > 0 ? *value : kUnknownSize);
        }
    }
    [[nodiscard]] ArraySizes sizesOf(const TypeUse& type, const Declarator& declarator) const {
        ArraySizes sizes;
        addSizes(declarator.dimensions, sizes);
        addSizes(type.dimensions, sizes);
        return sizes;
    }

    // ---- Declarations

    void layoutOnly(const Qualifiers& qualifiers) {
        if (qualifiers.storage == Storage::uniform) uniformDefaults_.apply(qualifiers);
        if (qualifiers.storage == Storage::buffer) storageDefaults_.apply(qualifiers);
        if (unit_.stage != Stage::compute || qualifiers.storage != Storage::input) return;
        constexpr std::array<std::string_view, 3> kNames{"local_size_x", "local_size_y", "local_size_z"};
        const bool isFirst = result_.localSize == std::array{0, 0, 0};
        for (std::size_t i = 0; i < kNames.size(); ++i) {
            if (!qualifiers.item(kNames[i])) continue;
            if (isFirst)
                for (int& each : result_.localSize) each = std::max(each, 1);
            const auto value = item(qualifiers, kNames[i]);
            result_.localSize[i] = value && *value > 0 && *value < 1'000'000 ? static_cast<int>(*value) : 0;
        }
    }

    [[nodiscard]] std::vector<MemoryMember> membersOf(const Declaration& declaration) const {
        std::vector<MemoryMember> members;
        for (const Declaration& each : declaration.members)
            for (const Declarator& declarator : each.declarators) {
                MemoryMember& member = members.emplace_back();
                member.place = unit_.place(declarator.name);
                member.name = unit_.text(declarator.name);
                member.type = each.type.name;
                member.sizes = sizesOf(each.type, declarator);
                if (each.qualifiers.item("row_major")) member.isRowMajor = true;
                if (each.qualifiers.item("column_major")) member.isRowMajor = false;
                member.offset = item(each.qualifiers, "offset");
                member.align = item(each.qualifiers, "align");
                if (!member.align) member.align = item(declaration.qualifiers, "align");
                member.isReadonly = hasWord(each.qualifiers, "readonly");
                member.isWriteonly = hasWord(each.qualifiers, "writeonly");
            }
        return members;
    }

    void structure(const Declaration& declaration) {
        result_.memory.structures.emplace(
            unit_.text(declaration.name),
            MemoryStructure{unit_.place(declaration.name), membersOf(declaration)});
    }

    void block(const Declaration& declaration) {
        const Qualifiers& qualifiers = declaration.qualifiers;
        const bool isStorage = qualifiers.storage == Storage::buffer;
        if (!isStorage && qualifiers.storage != Storage::uniform) return;
        MemoryBlock block;
        block.place = unit_.place(declaration.name);
        block.name = unit_.text(declaration.name);
        block.isStorage = isStorage;
        BlockDefaults defaults = isStorage ? storageDefaults_ : uniformDefaults_;
        defaults.apply(qualifiers);
        block.packing = defaults.packing;
        block.isRowMajor = defaults.isRowMajor;
        block.binding = binding(qualifiers);
        block.members = membersOf(declaration);
        const auto all = [&](bool MemoryMember::* word) {
            return !block.members.empty() &&
                   std::ranges::all_of(block.members, [&](const MemoryMember& each) { return each.*word; });
        };
        block.isReadonly = !isStorage || hasWord(qualifiers, "readonly") || all(&MemoryMember::isReadonly);
        block.isWriteonly = hasWord(qualifiers, "writeonly") || all(&MemoryMember::isWriteonly);
        if (!declaration.declarators.empty()) {
            block.instance = unit_.text(declaration.declarators.front().name);
            addSizes(declaration.declarators.front().dimensions, block.sizes);
        }
        for (MemoryBlock& known : result_.memory.blocks) {
            if (known.name != block.name || known.isStorage != isStorage) continue;
            known.isReadonly = known.isReadonly && block.isReadonly;
            known.isWriteonly = known.isWriteonly && block.isWriteonly;
            if (!known.binding) known.binding = block.binding;
            return;
        }
        result_.memory.blocks.push_back(std::move(block));
    }

    void uniform(const Variable& variable) {
        const Declaration& declaration = unit_.syntax.declarations[variable.declaration];
        const Qualifiers& qualifiers = declaration.qualifiers;
        const ArraySizes sizes = sizesOf(declaration.type, declaration.declarators[variable.declarator]);
        if (variable.type == "atomic_uint") return counter(variable, qualifiers, sizes);
        if (result_.memory.structures.contains(variable.type)) {
            MemoryMember record;
            record.place = unit_.place(variable.nameToken);
            record.name = variable.name;
            record.type = variable.type;
            record.sizes = sizes;
            result_.memory.records.emplace(variable.name, std::move(record));
        }
        if (!isImageTypeWord(variable.type)) return;
        ImageUniform image;
        image.place = unit_.place(variable.nameToken);
        image.type = variable.type;
        const auto format = std::ranges::find_if(qualifiers.layout, isImageFormat);
        if (format != qualifiers.layout.end()) image.format = format->name;
        image.isReadonly = hasWord(qualifiers, "readonly");
        image.isWriteonly = hasWord(qualifiers, "writeonly");
        image.sizes = sizes;
        image.binding = binding(qualifiers);
        const auto [known, isNew] = result_.memory.images.emplace(variable.name, image);
        if (isNew) return;
        known->second.isReadonly = known->second.isReadonly && image.isReadonly;
        known->second.isWriteonly = known->second.isWriteonly && image.isWriteonly;
        if (known->second.format.empty()) known->second.format = image.format;
        if (!known->second.binding) known->second.binding = image.binding;
    }

    /// A counter without an offset follows the one before it at the same binding.
    void counter(const Variable& variable, const Qualifiers& qualifiers, const ArraySizes& sizes) {
        AtomicCounter counter;
        counter.place = unit_.place(variable.nameToken);
        counter.binding = binding(qualifiers);
        counter.sizes = sizes;
        long long& next = nextOffset_[counter.binding.value_or(-1)];
        const auto given = variable.declarator == 0 ? item(qualifiers, "offset") : std::nullopt;
        counter.offset = given.value_or(next);
        long long count = 1;
        for (const long long each : sizes) count *= std::clamp(each, 1LL, 10'000LL);
        next = counter.offset + 4 * std::min(count, 10'000LL);
        result_.memory.counters.emplace(variable.name, std::move(counter));
    }

    const Unit& unit_;
    TranslatedProgram& result_;
    BlockDefaults uniformDefaults_, storageDefaults_;
    std::map<int, long long> nextOffset_;  ///< by binding
};

}  // namespace

void collectMemory(ProgramUnits& program) {
    for (const Unit& unit : program.units) MemoryReader(unit, *program.result).run();
}

bool hasWritableStorage(const Unit& unit) {
    return std::ranges::any_of(unit.syntax.declarations, [&](const Declaration& each) {
        if (each.kind != DeclarationKind::block || each.qualifiers.storage != Storage::buffer ||
            hasWord(each.qualifiers, "readonly"))
            return false;
        if (!each.declarators.empty()) {
            const bool isReadonly = std::ranges::all_of(each.members, [](const Declaration& member) {
                return hasWord(member.qualifiers, "readonly");
            });
            return !isReadonly && unit.isUsed(unit.text(each.declarators.front().name));
        }
        return std::ranges::any_of(each.members, [&](const Declaration& member) {
            return !hasWord(member.qualifiers, "readonly") &&
                   std::ranges::any_of(member.declarators, [&](const Declarator& name) {
                       return unit.isUsed(unit.text(name.name));
                   });
        });
    });
}

bool writesMemory(const Unit& unit) {
    const auto isWritten = [&](const Variable& each) {
        if (each.storage != Storage::uniform || each.removed || !unit.isUsed(each.name)) return false;
        const Qualifiers& qualifiers = unit.syntax.declarations[each.declaration].qualifiers;
        return each.type == "atomic_uint" || (isImageTypeWord(each.type) && !hasWord(qualifiers, "readonly"));
    };
    return hasWritableStorage(unit) || std::ranges::any_of(unit.variables, isWritten);
}

}  // namespace glibra::glsl
