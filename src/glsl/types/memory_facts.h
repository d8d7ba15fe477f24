#pragma once
// The memory that a program reads and writes besides its textures, as the text of its stages declares it:
// image uniforms, blocks, and the structures from which layouts are computed. Code that the preprocessor
// removes does not count. All names are the user's.

#include <glibra/diagnostic.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace glibra::glsl {

/// The array sizes of a declaration, the outermost first. 0: runtime-sized, as `a[]`. kUnknownSize: the text
/// does not tell the size; the linked program does.
using ArraySizes = std::vector<long long>;
inline constexpr long long kUnknownSize = -1;

/// A uniform image. What is not readonly counts as written.
struct ImageUniform {
    Place place;
    std::string type;    ///< "image2D", "uimage2D", "image2DArray", ...
    std::string format;  ///< "r32f", "rgba8", ...; empty: none given, which only a writeonly image may omit
    bool isReadonly = false, isWriteonly = false;  ///< in every stage that declares it
    ArraySizes sizes;                              ///< empty: a single image
    std::optional<int> binding;
};

/// How the members of a block are placed.
enum class Packing {
    driver,  ///< `shared`, `packed` or no word: only the linked program knows
    std140,
    std430
};

/// A member of a block or structure.
struct MemoryMember {
    Place place;
    std::string name;
    std::string type;  ///< "float", "vec3", "mat4x2", "Particle"
    ArraySizes sizes;
    std::optional<bool> isRowMajor;          ///< nothing: as what contains it; column major on the outside
    std::optional<long long> offset, align;  ///< layout(offset = n, align = n), bytes
    bool isReadonly = false, isWriteonly = false;
};

/// struct Name { ... }
struct MemoryStructure {
    Place place;
    std::vector<MemoryMember> members;
};
using MemoryStructures = std::map<std::string, MemoryStructure, std::less<>>;

/// `buffer Name { ... } instance;` or `uniform Name { ... } instance;`
struct MemoryBlock {
    Place place;
    std::string name;
    std::string instance;  ///< empty: the members are global names
    ArraySizes sizes;      ///< of the instance; empty: a single block
    bool isStorage = false;
    /// The block or all of its members have the word, in every stage that declares the block. A storage block
    /// that is not readonly counts as written.
    bool isReadonly = false, isWriteonly = false;
    Packing packing = Packing::driver;
    bool isRowMajor = false;
    std::optional<int> binding;
    std::vector<MemoryMember> members;
};

/// A uniform atomic_uint.
struct AtomicCounter {
    Place place;
    std::optional<int> binding;
    long long offset = 0;  ///< bytes, as given or as GL counts on
    ArraySizes sizes;
};

/// An image, or a storage block of a single array, of which the text shows that a compute stage writes all
/// and reads nothing: each invocation writes the texel or element whose place is its gl_GlobalInvocationID,
/// if that lies within the sizes of all of `sizes`.
struct WholeWrite {
    std::string name;                ///< of the image or block
    bool isBlock = false;            ///< its array, not an image, is written
    int axes = 1;                    ///< components of the place
    std::vector<std::string> sizes;  ///< names of images, samplers and blocks; may be empty
};

struct MemoryFacts {
    std::map<std::string, ImageUniform> images;
    std::map<std::string, AtomicCounter> counters;
    std::vector<MemoryBlock> blocks;  ///< in order of declaration; each name once per kind
    /// Uniform variables whose type is a structure with a name, by the variable's name.
    std::map<std::string, MemoryMember, std::less<>> records;
    /// All structures with a name. If stages declare different ones of one name, the first counts.
    MemoryStructures structures;

    /// The block of that name and kind, or null.
    [[nodiscard]] const MemoryBlock* block(std::string_view name, bool isStorage) const {
        for (const MemoryBlock& each : blocks)
            if (each.name == name && each.isStorage == isStorage) return &each;
        return nullptr;
    }
};

}  // namespace glibra::glsl
