#include "plan/memory_pattern.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "base/number.h"
#include "glsl/facts/block_layout.h"

namespace glibra::plan {
namespace {

constexpr std::uint64_t kMostHeadNumbers = std::uint64_t{1} << 22;

NumberKind numberKindOf(BaseType base) {
    switch (base) {
        case BaseType::doublePrecision:
            return NumberKind::doublePrecision;
        case BaseType::integer:
            return NumberKind::integer;
        case BaseType::unsignedInteger:
            return NumberKind::unsignedInteger;
        case BaseType::boolean:
            return NumberKind::boolean;
        default:
            break;
    }
    return NumberKind::floating;
}

constexpr std::array<std::string_view, 5> kKindWords{"float", "double", "int", "uint", "bool"};

NumberKind kindNamed(std::string_view scalar) {
    const auto found = std::ranges::find(kKindWords, scalar);
    return found == kKindWords.end() ? NumberKind::floating
                                     : static_cast<NumberKind>(found - kKindWords.begin());
}

struct Array {
    std::uint64_t count = 1;  ///< 0: runtime-sized
    std::uint64_t stride = 0;
};

/// A scalar, vector or matrix, or an array of them, in an array of structures.
struct Field {
    std::string group;  ///< fields of one array of structures have the same
    std::uint64_t offset = 0;
    NumberKind kind = NumberKind::floating;
    int columns = 1, rows = 1;
    std::uint64_t matrixStride = 0;
    bool isRowMajor = false;
    Array outer, inner;

    /// The numbers of element 0 of the outer array, with offsets from `from`.
    void add(std::uint64_t from, std::vector<MemoryNumber>& to) const {
        const auto size = sizeOf(kind);
        for (std::uint64_t i = 0; i < inner.count; ++i)
            for (int column = 0; column < columns; ++column)
                for (int row = 0; row < rows; ++row) {
                    const auto along = static_cast<std::uint64_t>(isRowMajor ? row : column);
                    const auto across = static_cast<std::uint64_t>(isRowMajor ? column : row);
                    to.push_back(
                        {offset - from + i * inner.stride + along * matrixStride + across * size, kind});
                }
    }
    [[nodiscard]] std::uint64_t numbers() const {
        return inner.count * static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows);
    }
};

/// The fields of a block, sorted by offset, as head and array.
std::optional<MemoryPattern> patternOfFields(std::vector<Field> fields, std::uint64_t least) {
    MemoryPattern pattern;
    pattern.least = least;
    std::ranges::stable_sort(fields, [](const Field& a, const Field& b) { return a.offset < b.offset; });
    const bool endsInArray = !fields.empty() && fields.back().outer.count != 1;
    auto first = fields.begin();
    while (first != fields.end()) {
        // Fields of one array of structures: an element has all of them.
        auto end =
            std::find_if(first, fields.end(), [&](const Field& each) { return each.group != first->group; });
        if (endsInArray && first->group == fields.back().group) {
            pattern.elementsAt = first->offset;
            pattern.stride = first->outer.stride;
            pattern.elements = first->outer.count;
            for (auto each = first; each != fields.end(); ++each)
                each->add(pattern.elementsAt, pattern.element);
            break;
        }
        std::uint64_t numbers = 0;
        for (auto each = first; each != end; ++each) numbers += each->numbers();
        if (numbers * first->outer.count > kMostHeadNumbers - pattern.head.size()) return std::nullopt;
        for (std::uint64_t i = 0; i < first->outer.count; ++i)
            for (auto each = first; each != end; ++each) {
                Field moved = *each;
                moved.offset += i * first->outer.stride;
                moved.add(0, pattern.head);
            }
        first = end;
    }
    return pattern;
}

std::uint64_t unsignedOf(long long value) {
    return static_cast<std::uint64_t>(std::max(0LL, value));
}

/// A field as the driver reports it, without its group and arrays. `Resource`: StorageMember or
/// ActiveUniform.
template <class Resource>
Field plainField(const Resource& resource) {
    Field field;
    field.offset = unsignedOf(resource.offset);
    field.kind = numberKindOf(resource.type.base);
    field.columns = resource.type.columns;
    field.rows = resource.type.rows;
    field.matrixStride = unsignedOf(resource.matrixStride);
    field.isRowMajor = resource.rowMajor;
    return field;
}

Field fieldOf(const base::StorageMember& member, std::string_view blockName) {
    Field field = plainField(member);
    std::string_view name = member.name;
    const std::string_view plainBlock = blockName.substr(0, blockName.find('['));
    if (name.starts_with(plainBlock) && name.substr(plainBlock.size()).starts_with('.'))
        name.remove_prefix(plainBlock.size() + 1);
    field.group = name.substr(0, name.find_first_of(".["));
    const Array own{unsignedOf(member.arraySize), unsignedOf(member.arrayStride)};
    const bool isAlone = name.find('.') == std::string_view::npos;
    // Drivers differ in what they report as the outer array of a member that is an array of a basic type.
    if (isAlone && std::count(name.begin(), name.end(), '[') <= 1) {
        const bool isArray = name.ends_with(']') || member.arraySize != 1;
        if (isArray) field.outer = own;
    } else {
        field.outer = {unsignedOf(member.outerSize), unsignedOf(member.outerStride)};
        field.inner = own;
    }
    return field;
}

Field fieldOf(const ActiveUniform& uniform) {
    Field field = plainField(uniform);
    field.group = uniform.emittedName;
    if (uniform.isArray) field.outer = {unsignedOf(uniform.arraySize), unsignedOf(uniform.arrayStride)};
    return field;
}

/// Adds the numbers of a field that lies in arrays of fixed sizes.
void addAll(const glsl::MemoryField& field, std::size_t depth, std::uint64_t offset,
            std::vector<std::pair<std::uint64_t, MemoryNumber>>& to) {
    if (depth < field.arrays.size()) {
        for (long long i = 0; i < field.arrays[depth].count && to.size() < kMostHeadNumbers; ++i)
            addAll(field, depth + 1, offset + unsignedOf(i * field.arrays[depth].stride), to);
        return;
    }
    Field one;
    one.offset = offset;
    one.kind = kindNamed(field.scalar);
    one.columns = field.columns;
    one.rows = field.components;
    one.matrixStride = unsignedOf(field.matrixStride);
    one.isRowMajor = field.isRowMajor;
    std::vector<MemoryNumber> numbers;
    one.add(0, numbers);
    for (const MemoryNumber& each : numbers) to.emplace_back(offset, each);
}

template <class T>
void store(T value, std::span<std::byte> to) {
    std::memcpy(to.data(), &value, sizeof(T));
}
template <class T>
T load(std::span<const std::byte> from) {
    T value{};
    std::memcpy(&value, from.data(), sizeof(T));
    return value;
}

bool areAlike(NumberKind a, NumberKind b) {
    const auto isWhole = [](NumberKind kind) {
        return kind != NumberKind::floating && kind != NumberKind::doublePrecision;
    };
    return a == b || (isWhole(a) && isWhole(b));
}

}  // namespace

std::string_view wordOf(NumberKind kind) {
    return kKindWords.at(static_cast<std::size_t>(kind));
}

std::uint64_t MemoryPattern::bytes(std::uint64_t count) const {
    const std::uint64_t most = elements != 0 ? elements : count;
    return element.empty() ? least : std::max(least, elementsAt + stride * most);
}

MemoryNumber MemoryPattern::at(std::uint64_t index) const {
    if (index < head.size()) return head[index];
    index -= head.size();
    MemoryNumber number = element.at(index % element.size());
    number.offset += elementsAt + index / element.size() * stride;
    return number;
}

std::optional<MemoryPattern> patternOf(const base::StorageBlock& block) {
    std::vector<Field> fields;
    for (const base::StorageMember& each : block.members) fields.push_back(fieldOf(each, block.name));
    return patternOfFields(std::move(fields), unsignedOf(block.bytes));
}

std::optional<MemoryPattern> patternOf(const base::ActiveResources& resources, std::size_t block) {
    std::vector<Field> fields;
    for (const ActiveUniform& each : resources.uniforms)
        if (each.block == static_cast<int>(block)) fields.push_back(fieldOf(each));
    return patternOfFields(std::move(fields), unsignedOf(resources.blocks.at(block).bytes));
}

MemoryPattern patternOf(const base::CounterBuffer& counters) {
    MemoryPattern pattern;
    pattern.least = unsignedOf(counters.bytes);
    pattern.element = {{0, NumberKind::unsignedInteger}};
    pattern.stride = 4;
    return pattern;
}

std::optional<MemoryPattern> patternOf(std::string_view type, const glsl::MemoryStructures& structures) {
    const Result<glsl::MemoryLayout> layout = glsl::layoutOf(type, glsl::Packing::std430, structures);
    if (!layout || layout->stride <= 0) return std::nullopt;
    // Sorted by where their scalar, vector or matrix begins, which is the order of declaration.
    std::vector<std::pair<std::uint64_t, MemoryNumber>> numbers;
    for (const glsl::MemoryField& each : layout->fields) addAll(each, 0, unsignedOf(each.offset), numbers);
    if (numbers.size() >= kMostHeadNumbers) return std::nullopt;
    std::ranges::stable_sort(numbers, [](const auto& a, const auto& b) { return a.first < b.first; });
    MemoryPattern pattern;
    for (const auto& [from, number] : numbers) pattern.element.push_back(number);
    pattern.stride = unsignedOf(layout->stride);
    return pattern;
}

std::optional<std::uint64_t> firstDifference(const MemoryPattern& a, const MemoryPattern& b,
                                             std::uint64_t numbers) {
    // After the heads and one common period of both arrays everything repeats.
    const std::uint64_t period =
        std::max<std::uint64_t>(1, a.element.size()) * std::max<std::uint64_t>(1, b.element.size());
    const std::uint64_t most =
        std::min(numbers, std::max(a.head.size(), b.head.size()) + 2 * std::min(period, kMostHeadNumbers));
    for (std::uint64_t i = 0; i < most; ++i) {
        if ((i >= a.head.size() && a.element.empty()) || (i >= b.head.size() && b.element.empty())) return {};
        const MemoryNumber inA = a.at(i);
        const MemoryNumber inB = b.at(i);
        if (inA.offset != inB.offset || !areAlike(inA.kind, inB.kind)) return i;
    }
    return {};
}

void writeNumbers(const MemoryPattern& pattern, std::uint64_t first, std::span<const double> values,
                  std::span<std::byte> memory) {
    for (std::uint64_t i = 0; i < values.size(); ++i) {
        if (first + i >= pattern.head.size() && pattern.element.empty()) return;
        const MemoryNumber number = pattern.at(first + i);
        if (number.offset + sizeOf(number.kind) > memory.size()) continue;
        const std::span<std::byte> to = memory.subspan(number.offset);
        switch (number.kind) {
            case NumberKind::floating:
                store(base::toFloat(values[i]), to);
                break;
            case NumberKind::doublePrecision:
                store(values[i], to);
                break;
            case NumberKind::integer:
                store(base::toInt(values[i]), to);
                break;
            case NumberKind::unsignedInteger:
                store(base::toUnsigned(values[i]), to);
                break;
            case NumberKind::boolean:
                store(std::uint32_t{values[i] != 0 ? 1U : 0U}, to);
                break;
        }
    }
}

double readNumber(const MemoryNumber& number, std::span<const std::byte> memory) {
    const std::span<const std::byte> from = memory.subspan(number.offset, sizeOf(number.kind));
    switch (number.kind) {
        case NumberKind::doublePrecision:
            return load<double>(from);
        case NumberKind::integer:
            return load<std::int32_t>(from);
        case NumberKind::unsignedInteger:
            return load<std::uint32_t>(from);
        case NumberKind::boolean:
            return load<std::uint32_t>(from) != 0 ? 1 : 0;
        case NumberKind::floating:
            break;
    }
    return load<float>(from);
}

}  // namespace glibra::plan
