#include "expression/functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "expression/apply.h"

namespace glibra::expression {
namespace {

using G = FunctionGroup;

constexpr double kDegrees = 180 / std::numbers::pi;

double roundEven(double x) {
    const double below = std::floor(x);
    const double rest = x - below;
    if (rest != .5) return rest < .5 ? below : below + 1;
    return std::fmod(below, 2) == 0 ? below : below + 1;
}
double sign(double x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}
double clamp(double x, double low, double high) {
    const double atLeast = x < low ? low : x;  // not a number stays so
    return high < atLeast ? high : atLeast;
}
double smoothstep(double low, double high, double x) {
    const double t = clamp((x - low) / (high - low), 0, 1);
    return t * t * (3 - 2 * t);
}
double mixed(double a, double b, double t) {
    return a * (1 - t) + b * t;
}
double selected(double a, double b, double which) {
    return which != 0 ? b : a;
}

constexpr FunctionRow kRows[] = {
    {G::constructors, "number float(any value)", "the first component as a number; true is 1", nullptr},
    {G::constructors, "number int(any value)", "the first component, cut toward zero", nullptr},
    {G::constructors, "bool bool(any value)", "whether the first component is not 0", nullptr},
    {G::constructors, "vec2 vec2(any ...)", "from one number for all components, a longer vector, or parts",
     nullptr},
    {G::constructors, "vec3 vec3(any ...)", "", nullptr},
    {G::constructors, "vec4 vec4(any ...)", "", nullptr},
    {G::constructors, "bvec2 bvec2(any ...)", "the same for bools", nullptr},
    {G::constructors, "bvec3 bvec3(any ...)", "", nullptr},
    {G::constructors, "bvec4 bvec4(any ...)", "", nullptr},
    {G::constructors, "mat2 mat2(any ...)",
     "from one number for the diagonal, another matrix, or all components by columns", nullptr},
    {G::constructors, "mat3 mat3(any ...)", "", nullptr},
    {G::constructors, "mat4 mat4(any ...)", "", nullptr},

    {G::scalars, "T radians(T degrees)", "degrees * pi / 180", each1<+[](double x) { return x / kDegrees; }>},
    {G::scalars, "T degrees(T radians)", "radians * 180 / pi", each1<+[](double x) { return x * kDegrees; }>},
    {G::scalars, "T sin(T angle)", "sine of an angle in radians",
     each1<+[](double x) { return std::sin(x); }>},
    {G::scalars, "T cos(T angle)", "cosine", each1<+[](double x) { return std::cos(x); }>},
    {G::scalars, "T tan(T angle)", "tangent", each1<+[](double x) { return std::tan(x); }>},
    {G::scalars, "T asin(T x)", "the angle in -pi/2 to pi/2 whose sine is x",
     each1<+[](double x) { return std::asin(x); }>},
    {G::scalars, "T acos(T x)", "the angle in 0 to pi whose cosine is x",
     each1<+[](double x) { return std::acos(x); }>},
    {G::scalars, "T atan(T x)", "the angle in -pi/2 to pi/2 whose tangent is x",
     each1<+[](double x) { return std::atan(x); }>},
    {G::scalars, "T atan(T y, T x)", "the angle in -pi to pi of the direction (x, y)",
     each2<+[](double y, double x) { return std::atan2(y, x); }>},
    {G::scalars, "T sinh(T x)", "hyperbolic sine", each1<+[](double x) { return std::sinh(x); }>},
    {G::scalars, "T cosh(T x)", "hyperbolic cosine", each1<+[](double x) { return std::cosh(x); }>},
    {G::scalars, "T tanh(T x)", "hyperbolic tangent", each1<+[](double x) { return std::tanh(x); }>},
    {G::scalars, "T asinh(T x)", "inverse of sinh", each1<+[](double x) { return std::asinh(x); }>},
    {G::scalars, "T acosh(T x)", "inverse of cosh, at least 0",
     each1<+[](double x) { return std::acosh(x); }>},
    {G::scalars, "T atanh(T x)", "inverse of tanh", each1<+[](double x) { return std::atanh(x); }>},
    {G::scalars, "T pow(T x, T y)", "x to the power y",
     each2<+[](double x, double y) { return std::pow(x, y); }>},
    {G::scalars, "T exp(T x)", "e to the power x", each1<+[](double x) { return std::exp(x); }>},
    {G::scalars, "T log(T x)", "natural logarithm", each1<+[](double x) { return std::log(x); }>},
    {G::scalars, "T exp2(T x)", "2 to the power x", each1<+[](double x) { return std::exp2(x); }>},
    {G::scalars, "T log2(T x)", "logarithm to base 2", each1<+[](double x) { return std::log2(x); }>},
    {G::scalars, "T sqrt(T x)", "square root", each1<+[](double x) { return std::sqrt(x); }>},
    {G::scalars, "T inversesqrt(T x)", "1 / sqrt(x)", each1<+[](double x) { return 1 / std::sqrt(x); }>},
    {G::scalars, "T abs(T x)", "x without its sign", each1<+[](double x) { return std::abs(x); }>},
    {G::scalars, "T sign(T x)", "-1, 0 or 1", each1<sign>},
    {G::scalars, "T floor(T x)", "the largest whole number that is not above x",
     each1<+[](double x) { return std::floor(x); }>},
    {G::scalars, "T trunc(T x)", "x cut toward zero", each1<+[](double x) { return std::trunc(x); }>},
    {G::scalars, "T round(T x)", "the nearest whole number; halves away from zero",
     each1<+[](double x) { return std::round(x); }>},
    {G::scalars, "T roundEven(T x)", "the nearest whole number; halves to the even one", each1<roundEven>},
    {G::scalars, "T ceil(T x)", "the smallest whole number that is not below x",
     each1<+[](double x) { return std::ceil(x); }>},
    {G::scalars, "T fract(T x)", "x - floor(x)", each1<+[](double x) { return x - std::floor(x); }>},
    {G::scalars, "T mod(T x, T y)", "x - y * floor(x / y), which has the sign of y", applyModulo},
    {G::scalars, "T mod(T x, number y)", "", applyModulo},
    {G::scalars, "T min(T x, T y)", "the smaller one",
     each2<+[](double x, double y) { return y < x ? y : x; }>},
    {G::scalars, "T min(T x, number y)", "", each2<+[](double x, double y) { return y < x ? y : x; }>},
    {G::scalars, "T max(T x, T y)", "the larger one",
     each2<+[](double x, double y) { return x < y ? y : x; }>},
    {G::scalars, "T max(T x, number y)", "", each2<+[](double x, double y) { return x < y ? y : x; }>},
    {G::scalars, "T clamp(T x, T low, T high)", "min(max(x, low), high)", each3<clamp>},
    {G::scalars, "T clamp(T x, number low, number high)", "", each3<clamp>},
    {G::scalars, "T mix(T a, T b, T t)", "a * (1 - t) + b * t", each3<mixed>},
    {G::scalars, "T mix(T a, T b, number t)", "", each3<mixed>},
    {G::scalars, "T mix(T a, T b, B which)", "b where `which` is true, else a", each3<selected>},
    {G::scalars, "T step(T edge, T x)", "0 if x is below the edge, else 1",
     each2<+[](double edge, double x) { return x < edge ? 0. : 1.; }>},
    {G::scalars, "T step(number edge, T x)", "",
     each2<+[](double edge, double x) { return x < edge ? 0. : 1.; }>},
    {G::scalars, "T smoothstep(T low, T high, T x)",
     "0 below `low`, 1 above `high`, between them t * t * (3 - 2 * t) with t = (x - low) / (high - low)",
     each3<smoothstep>},
    {G::scalars, "T smoothstep(number low, number high, T x)", "", each3<smoothstep>},
    {G::scalars, "B isnan(T x)", "whether x is not a number; x may be what would be an error elsewhere",
     each1<+[](double x) { return std::isnan(x) ? 1. : 0.; }>, false, true},
    {G::scalars, "B isinf(T x)", "whether x is infinite; x may be what would be an error elsewhere",
     each1<+[](double x) { return std::isinf(x) ? 1. : 0.; }>, false, true},

    {G::vectors, "number length(T v)", "square root of dot(v, v)", applyLength},
    {G::vectors, "number distance(T a, T b)", "length(a - b)", applyDistance},
    {G::vectors, "number dot(T a, T b)", "scalar product", applyDot},
    {G::vectors, "vec3 cross(vec3 a, vec3 b)", "vector product", applyCross},
    {G::vectors, "T normalize(T v)", "v / length(v); v must not be 0", applyNormalize},
    {G::vectors, "T reflect(T i, T n)", "i - 2 * dot(n, i) * n", applyReflect},
    {G::vectors, "T refract(T i, T n, number eta)",
     "the refracted direction for the ratio `eta` of refractive indices; 0 for total reflection",
     applyRefract},
    {G::vectors, "T faceforward(T n, T i, T nref)", "n if dot(nref, i) is below 0, else -n",
     applyFaceForward},

    {G::booleans, "bvec lessThan(vec a, vec b)", "a < b for each component",
     each2<+[](double a, double b) { return a < b ? 1. : 0.; }>},
    {G::booleans, "bvec lessThanEqual(vec a, vec b)", "a <= b for each component",
     each2<+[](double a, double b) { return a <= b ? 1. : 0.; }>},
    {G::booleans, "bvec greaterThan(vec a, vec b)", "a > b for each component",
     each2<+[](double a, double b) { return b < a ? 1. : 0.; }>},
    {G::booleans, "bvec greaterThanEqual(vec a, vec b)", "a >= b for each component",
     each2<+[](double a, double b) { return b <= a ? 1. : 0.; }>},
    {G::booleans, "bvec equal(vec a, vec b)", "a == b for each component",
     each2<+[](double a, double b) { return a == b ? 1. : 0.; }>},
    {G::booleans, "bvec equal(bvec a, bvec b)", "",
     each2<+[](double a, double b) { return a == b ? 1. : 0.; }>},
    {G::booleans, "bvec notEqual(vec a, vec b)", "a != b for each component",
     each2<+[](double a, double b) { return a != b ? 1. : 0.; }>},
    {G::booleans, "bvec notEqual(bvec a, bvec b)", "",
     each2<+[](double a, double b) { return a != b ? 1. : 0.; }>},
    {G::booleans, "bool any(bvec b)", "whether a component is true", applyAny},
    {G::booleans, "bool all(bvec b)", "whether all components are true", applyAll},
    {G::booleans, "bvec not(bvec b)", "! for each component", each1<+[](double b) { return 1 - b; }>},

    {G::matrices, "mat matrixCompMult(mat a, mat b)", "the products of the components",
     each2<+[](double a, double b) { return a * b; }>},
    {G::matrices, "mat outerProduct(vec column, vec row)", "the matrix column * row", applyOuterProduct},
    {G::matrices, "mat transpose(mat m)", "rows and columns exchanged", applyTranspose},
    {G::matrices, "number determinant(mat m)", "the determinant", applyDeterminant},
    {G::matrices, "mat inverse(mat m)", "the inverse; a singular matrix is an error", applyInverse},

    {G::transforms, "mat4 translate(vec3 offset)", "the matrix of `Translate`", applyTranslate},
    {G::transforms, "mat4 translate(number x, number y, number z)", "", applyTranslate},
    {G::transforms, "mat4 rotate(number degrees, vec3 axis)",
     "the matrix of `Rotate`: the angle is in degrees", applyRotate},
    {G::transforms, "mat4 rotate(number degrees, number x, number y, number z)", "", applyRotate},
    {G::transforms, "mat4 scale(vec3 factors)", "the matrix of `Scale`", applyScale},
    {G::transforms, "mat4 scale(number x, number y, number z)", "", applyScale},
    {G::transforms, "mat4 scale(number all)", "", applyScale},
    {G::transforms, "mat4 perspective(number degrees, number aspect, number near, number far)",
     "perspective projection; the angle is the vertical full angle", applyPerspective},
    {G::transforms,
     "mat4 ortho(number left, number right, number bottom, number top, number near, number far)",
     "parallel projection of a box", applyOrtho},
    {G::transforms,
     "mat4 frustum(number left, number right, number bottom, number top, number near, number far)",
     "perspective projection through a window in the near plane", applyFrustum},
    {G::transforms, "mat4 lookAt(vec3 eye, vec3 centre, vec3 up)", "the matrix of `LookAt`", applyLookAt},

    {G::motion, "number bounce(number lo, number hi, number speed)",
     "runs from `lo` to `hi` and back: lo + (hi - lo) * (1 - abs(1 - mod(speed * time / abs(hi - lo), 2)))",
     applyBounce, true},
    {G::motion, "number wrap(number lo, number hi, number speed)",
     "runs from `lo` to `hi` and begins again: lo + mod(speed * time, hi - lo)", applyWrap, true},
    {G::motion, "number rand(number i, number seed)",
     "random number `i` of the sequence `seed`, in 0 to 1, without 1; both are cut toward zero", applyRandom},
    {G::motion, "number rand(number i)", "random number `i` of the sequence 0", applyRandom},
    {G::motion, "number noise(T p)",
     "gradient noise in -1 to 1 for a number, a vec2 or a vec3; 0 where all coordinates are whole",
     applyNoise},

    {G::data, "T sum(object)", "the sums of the components over all texels or elements", nullptr},
    {G::data, "T sum(texture, number x, number y, number w, number h)", "", nullptr},
    {G::data, "T sum(buffer, number first, number last)", "", nullptr},
    {G::data, "T mean(object)", "the sums divided by the number of texels or elements", nullptr},
    {G::data, "T mean(texture, number x, number y, number w, number h)", "", nullptr},
    {G::data, "T mean(buffer, number first, number last)", "", nullptr},
    {G::data, "T least(object)", "the least value of each component", nullptr},
    {G::data, "T least(texture, number x, number y, number w, number h)", "", nullptr},
    {G::data, "T least(buffer, number first, number last)", "", nullptr},
    {G::data, "T largest(object)", "the largest value of each component", nullptr},
    {G::data, "T largest(texture, number x, number y, number w, number h)", "", nullptr},
    {G::data, "T largest(buffer, number first, number last)", "", nullptr},
};

/// Splits a prototype into its words: the result, the name, and the types of the parameters.
struct Prototype {
    std::string_view result, name;
    std::vector<std::string_view> parameters;
};

Prototype split(std::string_view text) {
    Prototype prototype;
    const std::size_t blank = text.find(' ');
    const std::size_t open = text.find('(');
    prototype.result = text.substr(0, blank);
    prototype.name = text.substr(blank + 1, open - blank - 1);
    for (std::size_t at = open + 1; at < text.size(); at = text.find_first_of(",)", at) + 1) {
        while (text[at] == ' ') ++at;
        prototype.parameters.push_back(text.substr(at, text.find(' ', at) - at));
    }
    return prototype;
}

/// The type that a word of a prototype means where the generic types have n components.
Type typeOf(std::string_view word, std::size_t n) {
    if (word == "number") return Type::number();
    if (word == "bool") return Type::boolean();
    if (word == "T" || word == "vec") return Type::vector(n);
    if (word == "B" || word == "bvec") return Type::vector(n, Kind::boolean);
    if (word == "mat") return Type::matrix(n);
    const auto digit = static_cast<std::size_t>(word.back() - '0');
    return word.starts_with("mat") ? Type::matrix(digit) : Type::vector(digit);
}

/// How many components the generic types of a prototype may have.
struct Sizes {
    std::size_t least, most;
};
Sizes sizesOf(const Prototype& prototype) {
    Sizes sizes{1, 4};
    for (const std::string_view each : prototype.parameters)
        if (each == "vec" || each == "bvec" || each == "mat") sizes.least = 2;
    if (prototype.name == "noise") sizes.most = 3;
    return sizes;
}

}  // namespace

std::string_view FunctionRow::name() const {
    const std::size_t blank = prototype.find(' ');
    return prototype.substr(blank + 1, prototype.find('(') - blank - 1);
}

std::span<const FunctionRow> functionTable() {
    return kRows;
}

std::string_view title(FunctionGroup group) {
    static constexpr std::array<std::string_view, 8> kTitles{"Types",
                                                             "Numbers, and vectors component by component",
                                                             "Vectors",
                                                             "Comparisons of vectors",
                                                             "Matrices",
                                                             "Transforms and projections",
                                                             "Motion and chance",
                                                             "What textures and buffers hold"};
    return kTitles.at(static_cast<std::size_t>(group));
}

std::span<const FunctionRow> functionsNamed(std::string_view name) {
    static const auto kByName = [] {
        std::map<std::string_view, std::span<const FunctionRow>> map;
        for (const FunctionRow& row : kRows) {
            const auto [place, isNew] = map.try_emplace(row.name(), &row, 1);
            if (!isNew) place->second = {place->second.data(), place->second.size() + 1};
        }
        return map;
    }();
    const auto found = kByName.find(name);
    return found == kByName.end() ? std::span<const FunctionRow>() : found->second;
}

std::size_t parameterCount(const FunctionRow& row) {
    return split(row.prototype).parameters.size();
}

std::optional<Call> callOf(const FunctionRow& row, std::span<const Type> arguments) {
    const Prototype prototype = split(row.prototype);
    if (row.apply == nullptr || arguments.size() != prototype.parameters.size()) return std::nullopt;
    const Sizes sizes = sizesOf(prototype);
    for (std::size_t n = sizes.least; n <= sizes.most; ++n) {
        bool fits = true;
        for (std::size_t k = 0; k < arguments.size(); ++k)
            fits = fits && arguments[k] == typeOf(prototype.parameters[k], n);
        if (!fits) continue;
        Call call;
        call.result = typeOf(prototype.result, n);
        Instruction& i = call.instruction;
        i.op = Op::call;
        i.apply = row.apply;
        i.n = static_cast<std::uint8_t>(call.result.size());
        std::uint8_t* const parts[] = {&i.a, &i.b, &i.c, &i.d};
        for (std::size_t k = 0; k < arguments.size() + (row.readsTime ? 1 : 0); ++k) {
            std::uint8_t& part = *parts[std::min<std::size_t>(k, 3)];
            part = static_cast<std::uint8_t>(part + (k < arguments.size() ? arguments[k].size() : 1));
        }
        return call;
    }
    return std::nullopt;
}

}  // namespace glibra::expression
