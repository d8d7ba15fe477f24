#include "glsl/facts/block_layout.h"

#include <algorithm>
#include <utility>

#include "glsl/parse/types.h"

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

}  // namespace glibra::glsl
