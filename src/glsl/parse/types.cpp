#include "glsl/parse/types.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <unordered_map>

#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

using enum BaseType;

int digit(char c) {
    return c >= '2' && c <= '4' ? c - '0' : 0;
}

BaseType promoted(BaseType a, BaseType b) {
    for (const BaseType each : {doublePrecision, floating, unsignedInteger, integer, boolean})
        if (a == each || b == each) return each;
    return unknown;
}

/// Functions whose result has as many components as their widest argument.
constexpr std::string_view kGeneric =
    " radians degrees sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh pow exp log exp2 log2 sqrt "
    "inversesqrt abs sign floor trunc truncate round roundEven ceil fract mod min max clamp mix step "
    "smoothstep "
    "normalize faceforward reflect refract dFdx dFdy fwidth dFdxFine dFdyFine fwidthFine dFdxCoarse "
    "dFdyCoarse "
    "fwidthCoarse fma modf ldexp ";
/// Those of these functions that exist for integers too.
constexpr std::string_view kIntegerToo = " abs sign min max clamp ";
constexpr std::string_view kToScalar = " length distance dot determinant noise1 ";
constexpr std::string_view kRelational =
    " lessThan lessThanEqual greaterThan greaterThanEqual equal notEqual not ";

Type textureType(std::string_view function, std::span<const Type> arguments) {
    if (function.starts_with("textureSize") || function.starts_with("textureQuery")) return {};
    if (arguments.empty() || arguments[0].base != opaque) {
        // texture2D and its kin read floating-point or integer samplers (EXT_gpu_shader4), so only the
        // argument decides.
        return {};
    }
    const std::string_view sampler = arguments[0].word;
    if (sampler.ends_with("Shadow") && !function.starts_with("textureGather")) return scalarType(floating);
    if (sampler.starts_with("i")) return vectorType(integer, 4);
    if (sampler.starts_with("u")) return vectorType(unsignedInteger, 4);
    return vectorType(floating, 4);
}

/// Names of variables of one type, with blanks around each.
struct Supplied {
    std::string_view type;
    std::size_t arrayDepth;
    std::string_view names;
};
constexpr std::array kSupplied = std::to_array<Supplied>({
    {"vec4", 0,
     " gl_Position gl_ClipVertex gl_FragCoord gl_FragColor gl_Vertex gl_Color "
     "gl_SecondaryColor gl_FrontColor gl_BackColor gl_FrontSecondaryColor "
     "gl_BackSecondaryColor aVertex aColor "},
    {"float", 0, " gl_PointSize gl_FragDepth gl_FogCoord gl_FogFragCoord Timer "},
    {"float", 1, " gl_ClipDistance gl_TessLevelOuter gl_TessLevelInner gl_PointSizeIn "},
    {"vec4", 1, " gl_FragData gl_TexCoord gl_PositionIn gl_FrontColorIn gl_BackColorIn "},
    {"vec2", 0, " gl_PointCoord "},
    {"bool", 0, " gl_FrontFacing "},
    {"vec3", 0, " gl_TessCoord gl_Normal aNormal Tangent aTangent "},
    {"int", 0,
     " gl_VertexID gl_InstanceID gl_PrimitiveID gl_InvocationID gl_PrimitiveIDIn "
     "gl_Layer "},
    {"vec4", 2, " gl_TexCoordIn "},
    {"mat3", 0, " gl_NormalMatrix uNormalMatrix "},
    {"mat4", 1, " gl_TextureMatrix "},
    {"sampler2D", 0, " Noise2 "},
    {"sampler3D", 0, " Noise3 "},
});

const std::unordered_map<std::string_view, Type>& suppliedTypes() {
    static const auto kTypesByName = [] {
        std::unordered_map<std::string_view, Type> table;
        for (const Supplied& each : kSupplied)
            for (const std::string_view name : splitWords(each.names))
                table.emplace(name, arrayOf(typeOfWord(each.type), each.arrayDepth));
        return table;
    }();
    return kTypesByName;
}

}  // namespace

Type typeOfWord(std::string_view word) {
    if (!isTypeWord(word)) return {};
    if (word == "void") return scalarType(voidType);
    if (word == "float") return scalarType(floating);
    if (word == "double") return scalarType(doublePrecision);
    if (word == "int") return scalarType(integer);
    if (word == "uint") return scalarType(unsignedInteger);
    if (word == "bool") return scalarType(boolean);
    if (isOpaqueTypeWord(word)) {
        Type type = scalarType(opaque);
        type.word = word;
        return type;
    }
    BaseType base = floating;
    std::string_view rest = word;
    const auto prefixed = [&](char letter, BaseType value) {
        if (rest.starts_with(letter) && rest.size() > 3 &&
            (rest.substr(1).starts_with("vec") || rest.substr(1).starts_with("mat"))) {
            base = value;
            rest.remove_prefix(1);
        }
    };
    prefixed('d', doublePrecision);
    prefixed('i', integer);
    prefixed('u', unsignedInteger);
    prefixed('b', boolean);
    if (rest.starts_with("vec") && rest.size() == 4 && digit(rest[3]))
        return vectorType(base, digit(rest[3]));
    if (rest.starts_with("mat") && rest.size() >= 4 && digit(rest[3])) {
        const int columns = digit(rest[3]);
        const int rows = rest.size() == 6 ? digit(rest[5]) : columns;
        if (!rows) return {};
        return {base, static_cast<std::uint8_t>(columns), static_cast<std::uint8_t>(rows), 0, -1, {}};
    }
    return {};
}

std::string wordOf(const Type& type) {
    static constexpr std::array<std::string_view, 5> kScalars = {"float", "double", "int", "uint", "bool"};
    static constexpr std::array<std::string_view, 5> kPrefixes = {"", "d", "i", "u", "b"};
    if (type.base == opaque) return std::string(type.word);
    if (type.base < floating || type.base > boolean) return type.base == voidType ? "void" : "?";
    const auto index = static_cast<std::size_t>(type.base) - static_cast<std::size_t>(floating);
    if (type.columns == 1 && type.rows == 1) return std::string(kScalars[index]);
    std::string word(kPrefixes[index]);
    if (type.columns == 1) return word + "vec" + std::to_string(type.rows);
    word += "mat" + std::to_string(type.columns);
    if (type.columns != type.rows) word += "x" + std::to_string(type.rows);
    return word;
}

Type typeOfSuppliedName(std::string_view name) {
    if (const auto found = suppliedTypes().find(name); found != suppliedTypes().end()) return found->second;
    if (name.starts_with("gl_MultiTexCoord") || name.starts_with("aTexCoord")) return vectorType(floating, 4);
    const bool matrix =
        (name.starts_with("gl_") || name.starts_with("u")) && name.find("Matrix") != std::string_view::npos;
    if (matrix && (name.find("ModelView") != std::string_view::npos ||
                   name.find("Projection") != std::string_view::npos))
        return typeOfWord("mat4");
    return {};
}

Type binaryType(std::string_view op, const Type& left, const Type& right) {
    if (listed(" < > <= >= == != && || ^^ ", op)) return scalarType(boolean);
    if (!left.numeric() || !right.numeric()) return {};
    const BaseType base = promoted(left.base, right.base);
    const auto shaped = [&](const Type& shape) {
        Type type = shape;
        type.base = base;
        return type;
    };
    if (op == "<<" || op == ">>") return left;
    if (op == "*") {
        if (left.matrix() && right.vector())
            return left.columns == right.rows ? vectorType(base, left.rows) : Type{};
        if (left.vector() && right.matrix())
            return left.rows == right.rows ? vectorType(base, right.columns) : Type{};
        if (left.matrix() && right.matrix()) {
            if (left.columns != right.rows) return {};
            return {base, right.columns, left.rows, 0, -1, {}};
        }
    }
    if (left.scalar()) return shaped(right);
    if (right.scalar()) return shaped(left);
    return left.columns == right.columns && left.rows == right.rows ? shaped(left) : Type{};
}

Type callType(std::string_view function, std::span<const Type> arguments) {
    if (isTypeWord(function)) return typeOfWord(function);
    if (function == "ftransform") return vectorType(floating, 4);
    if (function == "cross") return vectorType(floating, 3);
    if (function.size() == 6 && function.starts_with("noise") && digit(function[5]))
        return vectorType(floating, digit(function[5]));
    if (listed(" any all ", function)) return scalarType(boolean);
    if (function.starts_with("shadow1D") || function.starts_with("shadow2D") ||
        function.starts_with("shadowCube"))
        return function.ends_with("EXT") || function.ends_with("NV") ? scalarType(floating)
                                                                     : vectorType(floating, 4);
    if (function.starts_with("texture") || function.starts_with("texelFetch"))
        return textureType(function, arguments);
    if (arguments.empty() || std::ranges::any_of(arguments, [](const Type& t) { return !t.numeric(); }))
        return {};
    const Type& first = arguments.front();
    BaseType base = first.base;
    Type widest = first;
    for (const Type& each : arguments) {
        base = promoted(base, each.base);
        if (each.components() > widest.components()) widest = each;
    }
    const BaseType real = base == doublePrecision ? doublePrecision : floating;
    if (listed(kToScalar, function)) return scalarType(real);
    if (listed(kRelational, function)) return vectorType(boolean, first.rows);
    if (function == "inverse" || function == "matrixCompMult") return first;
    if (function == "transpose") return {first.base, first.rows, first.columns, 0, -1, {}};
    if (function == "outerProduct" && arguments.size() == 2)
        return {real, arguments[1].rows, first.rows, 0, -1, {}};
    if (!listed(kGeneric, function)) return {};
    const bool isUnsignedToo = function != "abs" && function != "sign";
    const bool keepsIntegers =
        listed(kIntegerToo, function) && (base == integer || (base == unsignedInteger && isUnsignedToo));
    widest.base = keepsIntegers ? base : real;
    return widest;
}

std::vector<std::string_view> coreFunctions() {
    constexpr std::string_view kOthers =
        " cross any all inverse transpose outerProduct matrixCompMult texture textureLod textureGrad "
        "textureProj "
        "textureOffset textureSize textureGather texelFetch length distance dot determinant ";
    std::vector<std::string_view> names;
    for (const std::string_view list : {kGeneric, kRelational, kOthers})
        std::ranges::copy(splitWords(list), std::back_inserter(names));
    return names;
}

std::string zeroOf(std::string_view typeWord) {
    const Type type = typeOfWord(typeWord);
    if (!type.numeric()) return {};
    std::string_view zero = "0.";
    if (type.base == integer) zero = "0";
    if (type.base == unsignedInteger) zero = "0u";
    if (type.base == boolean) zero = "false";
    if (type.scalar()) return type.base == doublePrecision ? "double(0.)" : std::string(zero);
    return std::string(typeWord) + "(" + std::string(zero) + ")";
}

}  // namespace glibra::glsl
