#include "glsl/facts/block_layout.h"

#include <algorithm>
#include <array>
#include <utility>

#include "glsl/facts/facts.h"
#include "glsl/parse/types.h"
#include "glsl/parse/usage.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

constexpr int kDeepestStructure = 32;
constexpr int kMostMembers = 20'000;
constexpr long long kMostBlockBytes = 1LL << 40;

struct Extent {
    long long alignment = 1;
    long long size = 0;
};

long long roundUp(long long value, long long multiple) {
    return (value + multiple - 1) / multiple * multiple;
}

/// Where the members of a structure or block lie.
struct Placed {
    Extent extent;
    std::vector<long long> offsets;
    long long runtimeStride = 0;
};

class Layouter {
  public:
    Layouter(Packing packing, const MemoryStructures& structures)
        : packing_(packing), structures_(structures) {}

    Result<MemoryLayout> ofBlock(const MemoryBlock& block) {
        MemoryLayout layout;
        if (const auto placed = place(block.members, block.isRowMajor, block.isStorage)) {
            layout.size = placed->extent.size;
            layout.alignment = placed->extent.alignment;
            layout.stride = placed->runtimeStride;
            addMembers(block.members, *placed, block.isRowMajor, {{}, 0, {}});
        }
        return finished(std::move(layout), block.place);
    }

    Result<MemoryLayout> ofType(std::string_view type) {
        MemoryLayout layout;
        if (const auto extent = extentOf(std::string(type), false)) {
            layout.size = extent->size;
            layout.alignment = extent->alignment;
            layout.stride = arrayOf(*extent, 1)->size;
            add(std::string(type), false, {{}, 0, {}});
        }
        return finished(std::move(layout), {});
    }

  private:
    /// Where a value lies: what is known of its field so far.
    struct Position {
        std::string path;
        long long offset;
        std::vector<MemoryArray> arrays;
    };

    std::nullopt_t fail(std::string text, const Place& place) {
        if (problem_.empty()) problem_.push_back(withoutId(Severity::error, std::move(text), place));
        return std::nullopt;
    }
    Result<MemoryLayout> finished(MemoryLayout layout, const Place& place) {
        if (problem_.empty()) {
            layout.fields = std::move(fields_);
            return layout;
        }
        if (problem_.front().place.file.empty()) problem_.front().place = place;
        return std::move(problem_);
    }

    [[nodiscard]] long long inArray(long long alignment) const {
        return packing_ == Packing::std140 ? roundUp(alignment, 16) : alignment;
    }

    // An array of `count` values (rule 4 and 10).
    std::optional<Extent> arrayOf(const Extent& element, long long count) {
        const long long alignment = inArray(element.alignment);
        const long long stride = roundUp(element.size, alignment);
        if (count > kMostBlockBytes / std::max(stride, 1LL))
            return fail("the array is larger than 1 TiB", {});
        return Extent{alignment, stride * count};
    }

    /// Rules 1 to 3.
    static Extent vectorExtent(long long scalar, int components) {
        return {scalar * (components == 3 ? 4 : components), scalar * components};
    }

    static long long sizeOfScalar(const Type& type) { return type.base == BaseType::doublePrecision ? 8 : 4; }

    /// The vectors in which a matrix is stored (rules 5 and 7).
    static std::pair<int, int> vectorsOf(const Type& type, bool isRowMajor) {
        return isRowMajor ? std::pair<int, int>{type.rows, type.columns}
                          : std::pair<int, int>{type.columns, type.rows};
    }

    std::optional<Extent> extentOf(const std::string& word, bool isRowMajor) {
        const Type type = typeOfWord(word);
        if (!type.numeric()) {
            const Placed* placed = structure(word, isRowMajor);
            return placed ? std::optional(placed->extent) : std::nullopt;
        }
        if (!type.matrix()) return vectorExtent(sizeOfScalar(type), type.rows);
        const auto [count, components] = vectorsOf(type, isRowMajor);
        return arrayOf(vectorExtent(sizeOfScalar(type), components), count);
    }

    const Placed* structure(const std::string& name, bool isRowMajor) {
        const std::pair key{name, isRowMajor};
        if (const auto known = placed_.find(key); known != placed_.end()) return &known->second;
        const auto found = structures_.find(name);
        if (found == structures_.end()) {
            fail("'" + name + "' is neither a basic type nor a structure of the shader", {});
            return nullptr;
        }
        if (depth_ >= kDeepestStructure) {
            fail("structures are nested more than 32 levels deep", found->second.place);
            return nullptr;
        }
        ++depth_;
        auto placed = place(found->second.members, isRowMajor, false);
        --depth_;
        if (!placed) return nullptr;
        placed->extent.alignment = inArray(placed->extent.alignment);  // rule 9
        placed->extent.size = roundUp(placed->extent.size, placed->extent.alignment);
        return &placed_.emplace(key, std::move(*placed)).first->second;
    }

    /// Places members one after the other. Only the last one may be runtime-sized, if `mayGrow` is true.
    std::optional<Placed> place(const std::vector<MemoryMember>& members, bool isRowMajor, bool mayGrow) {
        Placed placed;
        long long next = 0, end = 0;
        for (const MemoryMember& each : members) {
            const bool isLast = &each == &members.back();
            auto extent = extentOf(each.type, each.isRowMajor.value_or(isRowMajor));
            if (!extent) {
                if (problem_.front().place.file.empty()) problem_.front().place = each.place;
                return std::nullopt;
            }
            for (std::size_t i = each.sizes.size(); i-- > 0;) {
                const long long count = each.sizes[i];
                if (count < 0)
                    return fail("the text does not show the array size of '" + each.name + "'", each.place);
                if (count == 0 && !(mayGrow && isLast && i == 0))
                    return fail("'" + each.name + "' has no array size, which only the last member of a " +
                                    "storage block may lack",
                                each.place);
                if (count == 0) placed.runtimeStride = arrayOf(*extent, 1)->size;
                extent = arrayOf(*extent, count);
                if (!extent) return std::nullopt;
            }
            if (each.offset.value_or(0) < 0 || each.offset.value_or(0) > kMostBlockBytes ||
                each.align.value_or(1) < 1 || each.align.value_or(1) > kMostBlockBytes)
                return fail("the offset or alignment of '" + each.name + "' is out of range", each.place);
            next = each.offset.value_or(roundUp(next, extent->alignment));
            if (each.align) next = roundUp(next, *each.align);
            placed.offsets.push_back(next);
            placed.extent.alignment =
                std::max({placed.extent.alignment, extent->alignment, each.align.value_or(1)});
            next += extent->size;
            end = std::max(end, next);
            if (next > kMostBlockBytes) return fail("the members are larger than 1 TiB", each.place);
        }
        if (placed.runtimeStride > 0)
            placed.extent.size = placed.offsets.back();
        else
            placed.extent.size = roundUp(end, inArray(placed.extent.alignment));
        return placed;
    }

    void addMembers(const std::vector<MemoryMember>& members, const Placed& placed, bool isRowMajor,
                    const Position& at) {
        for (std::size_t i = 0; i < members.size() && problem_.empty(); ++i) {
            const MemoryMember& member = members[i];
            Position own{at.path.empty() ? member.name : at.path + "." + member.name,
                         at.offset + placed.offsets[i], at.arrays};
            const bool rows = member.isRowMajor.value_or(isRowMajor);
            std::optional<Extent> element = extentOf(member.type, rows);
            const std::size_t outer = own.arrays.size();
            own.arrays.resize(outer + member.sizes.size());
            for (std::size_t k = member.sizes.size(); k-- > 0;) {
                own.arrays[outer + k] = {member.sizes[k], arrayOf(*element, 1)->size};
                element = arrayOf(*element, member.sizes[k]);
                own.path += "[]";
            }
            add(member.type, rows, std::move(own));
        }
    }

    void add(const std::string& word, bool isRowMajor, Position at) {
        if (++added_ > kMostMembers) {
            fail("the structures have more than 20,000 members", {});
            return;
        }
        const Type type = typeOfWord(word);
        if (!type.numeric()) {
            const Placed* placed = structure(word, isRowMajor);
            if (placed) addMembers(structures_.find(word)->second.members, *placed, isRowMajor, at);
            return;
        }
        MemoryField field;
        field.path = std::move(at.path);
        field.scalar = wordOf(scalarType(type.base));
        field.components = type.rows;
        field.columns = type.columns;
        field.offset = at.offset;
        field.arrays = std::move(at.arrays);
        if (type.matrix()) {
            field.isRowMajor = isRowMajor;
            const auto [count, components] = vectorsOf(type, isRowMajor);
            field.matrixStride = arrayOf(vectorExtent(sizeOfScalar(type), components), 1)->size;
        }
        fields_.push_back(std::move(field));
    }

    Packing packing_;
    const MemoryStructures& structures_;
    std::map<std::pair<std::string, bool>, Placed> placed_;
    std::vector<MemoryField> fields_;
    Diagnostics problem_;  ///< at most one
    int depth_ = 0;
    int added_ = 0;
};

}  // namespace

Result<MemoryLayout> layoutOf(const MemoryBlock& block, const MemoryStructures& structures) {
    if (block.packing == Packing::driver)
        return withoutId(Severity::error,
                         "block '" + block.name + "' has neither layout(std140) nor layout(std430)",
                         block.place);
    return Layouter(block.packing, structures).ofBlock(block);
}

Result<MemoryLayout> layoutOf(std::string_view type, Packing packing, const MemoryStructures& structures) {
    if (packing == Packing::driver)
        return withoutId(Severity::error, "the packing of '" + std::string(type) + "' is not known");
    return Layouter(packing, structures).ofType(type);
}

// Images, blocks, counters and structures (types/translated_program.h), and the local size of a compute
// stage.

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
