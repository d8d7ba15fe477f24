#pragma once
// Where the numbers of a buffer lie in its memory, one after another: as the driver lays out the block of a
// linked program, or by the rules std430 for a type.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "glsl/types/translated_program.h"
#include "plan/program_variant.h"

namespace glibra::plan {

enum class NumberKind : std::uint8_t { floating, doublePrecision, integer, unsignedInteger, boolean };

/// The GLSL word: "float".
std::string_view wordOf(NumberKind kind);

/// Bytes of one number.
constexpr std::size_t sizeOf(NumberKind kind) {
    return kind == NumberKind::doublePrecision ? 8 : 4;
}

struct MemoryNumber {
    std::uint64_t offset = 0;  ///< bytes
    NumberKind kind = NumberKind::floating;
    friend bool operator==(const MemoryNumber&, const MemoryNumber&) = default;
};

/// The numbers in the order in which shaders declare them: structures member by member, matrices column by
/// column, arrays element by element. A block may end with an array, whose elements all look alike.
struct MemoryPattern {
    std::vector<MemoryNumber> head;     ///< before the array
    std::vector<MemoryNumber> element;  ///< of one element, counted from where that begins; empty: no array
    std::uint64_t elementsAt = 0;       ///< byte at which the first element begins
    std::uint64_t stride = 0;           ///< bytes from element to element
    std::uint64_t elements = 0;         ///< 0: as many as the buffer has room for
    std::uint64_t least = 0;            ///< bytes that a buffer must have

    /// The bytes of a buffer with that many elements of a runtime-sized array.
    [[nodiscard]] std::uint64_t bytes(std::uint64_t count) const;
    /// The number of numbers with that many elements.
    [[nodiscard]] std::uint64_t numbers(std::uint64_t count) const {
        return head.size() + element.size() * (elements != 0 ? elements : count);
    }
    /// Whether a buffer can be longer than `least`.
    [[nodiscard]] bool isRuntimeSized() const { return !element.empty() && elements == 0; }
    /// Number `index` of the buffer. There must be one.
    [[nodiscard]] MemoryNumber at(std::uint64_t index) const;
};

/// The pattern of a storage block. Nothing if it has more than 2^22 numbers before its array.
std::optional<MemoryPattern> patternOf(const base::StorageBlock& block);
/// The pattern of resources.blocks[block].
std::optional<MemoryPattern> patternOf(const base::ActiveResources& resources, std::size_t block);
MemoryPattern patternOf(const base::CounterBuffer& counters);
/// An array of a basic type or a structure, by the rules std430. Nothing for an unknown type.
std::optional<MemoryPattern> patternOf(std::string_view type, const glsl::MemoryStructures& structures);

/// The first of these many numbers that the two patterns place differently, or read as different kinds
/// (signed and unsigned integers count as one); nothing if they agree.
std::optional<std::uint64_t> firstDifference(const MemoryPattern& a, const MemoryPattern& b,
                                             std::uint64_t numbers);

/// Writes numbers from number `first` on. Those that would lie outside of `memory` are left out. Floats are
/// rounded once; integers are truncated and limited to their range.
void writeNumbers(const MemoryPattern& pattern, std::uint64_t first, std::span<const double> values,
                  std::span<std::byte> memory);
/// Reads a number from memory that contains it.
double readNumber(const MemoryNumber& number, std::span<const std::byte> memory);

}  // namespace glibra::plan
