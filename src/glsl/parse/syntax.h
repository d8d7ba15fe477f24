#pragma once
// The declarations at file scope of a stage, found in its tokens after macro expansion. This is a light
// parser: it finds the name, type, qualifiers, sizes and initialiser of every declaration, and skips what it
// does not know.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/read/token.h"

namespace glibra::glsl {

/// The view tokens first ... end - 1.
struct Range {
    std::uint32_t first = 0;
    std::uint32_t end = 0;
    [[nodiscard]] bool empty() const { return end <= first; }
    [[nodiscard]] bool contains(std::uint32_t at) const { return at >= first && at < end; }
};

enum class Storage { none, constant, input, output, inputOutput, uniform, buffer, shared };
/// The word of each.
inline constexpr std::array<std::string_view, 8> kStorageWords{"",      "const",   "in",     "out",
                                                               "inout", "uniform", "buffer", "shared"};

/// One entry of layout(...).
struct LayoutItem {
    std::string name;
    Range value;   ///< after '='; empty: none
    Range tokens;  ///< name and value
};

/// The qualifiers that the rules may change.
struct ChangeableQualifiers {
    Storage storage = Storage::none;
    bool patch = false, invariant = false, precise = false, centroid = false, sample = false,
         subroutine = false;
    std::string interpolation;        ///< "flat", "smooth", "noperspective" or empty
    std::vector<std::string> memory;  ///< "readonly", "coherent", ...
    std::string precision;            ///< "highp", ... or empty
};

struct Qualifiers : ChangeableQualifiers {
    Range tokens;
    bool attributeWord = false, varyingWord = false;
    std::vector<LayoutItem> layout;
    std::vector<Range> layoutTokens;  ///< each layout ( ... ) as a whole
    Range subroutineTypes;            ///< between the parentheses of subroutine( )
    std::uint32_t storageToken = kNone;

    [[nodiscard]] const LayoutItem* item(std::string_view name) const;
    /// True for uniforms, inputs, outputs and storage.
    [[nodiscard]] bool isInterface() const {
        return attributeWord || varyingWord ||
               (storage != Storage::none && storage != Storage::constant && storage != Storage::shared);
    }
};

struct TypeUse {
    Range tokens;  ///< the name and the brackets after it, or a whole struct specifier
    std::string_view name;
    std::vector<Range> dimensions;  ///< the content of each pair of brackets after the name
    bool isStruct = false;          ///< the type is struct { ... }
};

struct Declarator {
    std::uint32_t name = 0;
    std::vector<Range> dimensions;
    Range dimensionTokens;        ///< the brackets themselves
    Range initializer;            ///< after '='
    std::uint32_t end = 0;        ///< the ',' or ';' (or ')') after it
    std::uint32_t value = kNone;  ///< the node of the initialiser (parse/tree.h)
};

struct Parameter {
    Qualifiers qualifiers;
    TypeUse type;
    std::uint32_t name = kNone;
    std::vector<Range> dimensions;
};

enum class DeclarationKind {
    variable,  ///< qualifiers type declarators ; (there may be no declarators: struct S {...};)
    block,     ///< qualifiers Name { members } instance ;
    function,  ///< definition
    prototype,
    layoutOnly,  ///< layout(triangles) in;
    requalify,   ///< invariant gl_Position;
    precision,
    stray,  ///< a lone ;
    unknown
};

struct Declaration {
    DeclarationKind kind = DeclarationKind::unknown;
    Range tokens;  ///< with the final ; or }
    Qualifiers qualifiers;
    TypeUse type;                         ///< of a variable; of the value of a function
    std::vector<Declarator> declarators;  ///< of a variable; instance of a block; names of `requalify`
    std::uint32_t name = kNone;           ///< of a block, function, or struct specifier
    std::vector<Declaration> members;     ///< of a block or struct specifier
    std::vector<Parameter> parameters;
    Range parameterTokens;
    Range body;                  ///< of a function, block or struct, with its braces
    std::uint32_t code = kNone;  ///< the node of the body of a function (parse/tree.h)
};

struct Syntax {
    std::vector<Declaration> declarations;
};

/// Parses all of `view`.
Syntax parseSyntax(std::span<const ViewToken> view);

/// Parses the variable declaration at `at` (qualifiers, type, declarators) with its ';', or up to `end`. It
/// serves for members, parameters and local variables.
Declaration parseVariable(std::span<const ViewToken> view, std::uint32_t at, std::uint32_t end);

/// The index of the bracket that closes the one at `open`, or `end`.
std::uint32_t closing(std::span<const ViewToken> view, std::uint32_t open, std::uint32_t end);

}  // namespace glibra::glsl
