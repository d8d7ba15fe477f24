#include "expression/apply.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "base/matrices.h"
#include "expression/random.h"

namespace glibra::expression {
namespace {

double dot(const double* a, const double* b, std::size_t count) {
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) sum += a[k] * b[k];
    return sum;
}

/// Neither overflows nor underflows on the way.
double length(const double* a, std::size_t count) {
    double result = std::abs(a[0]);
    for (std::size_t k = 1; k < count; ++k) result = std::hypot(result, a[k]);
    return result;
}

constexpr const char* kNotWhole = "bits are defined for whole numbers between -2^53 and 2^53";
constexpr double kLargestWhole = 0x1p53;

bool isWithinWhole(double value) {
    return value >= -kLargestWhole && value <= kLargestWhole;
}

/// Applies an operation of 64-bit integers to two numbers.
template <class Operation>
const char* bits(double* stack, const Operation& operation) {
    if (!isWithinWhole(stack[0]) || !isWithinWhole(stack[1])) return kNotWhole;
    stack[0] = static_cast<double>(
        operation(static_cast<std::int64_t>(stack[0]), static_cast<std::int64_t>(stack[1])));
    return nullptr;
}

/// How far to shift, or -1.
int shiftOf(double count) {
    constexpr double kMost = 63;
    return count > -1 && count <= kMost ? static_cast<int>(count) : -1;
}
constexpr const char* kWrongShift = "a shift is between 0 and 63 bits";

}  // namespace

double modulo(double x, double y) {
    const double rest = std::fmod(x, y);
    if (rest == 0) return 0;
    if ((rest < 0) == (y < 0)) return rest;
    const double other = rest + y;
    return other == y ? 0 : other;  // too small a rest
}

const char* applyModulo(double* stack, const Instruction& i) {
    const double* const divisor = stack + i.a;
    const bool byZero = std::find(divisor, divisor + i.b, 0.0) != divisor + i.b;
    each2<modulo>(stack, i);
    return byZero ? "division by zero" : nullptr;
}

// ---- Vectors

const char* applyLength(double* stack, const Instruction& i) {
    stack[0] = length(stack, i.a);
    return nullptr;
}

const char* applyDistance(double* stack, const Instruction& i) {
    for (std::size_t k = 0; k < i.a; ++k) stack[k] -= stack[i.a + k];
    return applyLength(stack, i);
}

const char* applyDot(double* stack, const Instruction& i) {
    stack[0] = dot(stack, stack + i.a, i.a);
    return nullptr;
}

const char* applyCross(double* stack, const Instruction& /*i*/) {
    const double* const a = stack;
    const double* const b = stack + 3;
    const double product[3] = {a[1] * b[2] - b[1] * a[2], a[2] * b[0] - b[2] * a[0],
                               a[0] * b[1] - b[0] * a[1]};
    std::copy_n(product, 3, stack);
    return nullptr;
}

const char* applyNormalize(double* stack, const Instruction& i) {
    const double size = length(stack, i.n);
    if (!(size > 0)) return "a vector of length 0 has no direction";
    for (std::size_t k = 0; k < i.n; ++k) stack[k] /= size;
    return nullptr;
}

const char* applyReflect(double* stack, const Instruction& i) {
    const double* const normal = stack + i.a;
    const double twice = 2 * dot(normal, stack, i.n);
    for (std::size_t k = 0; k < i.n; ++k) stack[k] -= twice * normal[k];
    return nullptr;
}

const char* applyRefract(double* stack, const Instruction& i) {
    const double* const normal = stack + i.a;
    const double ratio = stack[i.a + i.b];
    const double cosine = dot(normal, stack, i.n);
    const double rest = 1 - ratio * ratio * (1 - cosine * cosine);
    const double along = rest < 0 ? 0 : ratio * cosine + std::sqrt(rest);
    for (std::size_t k = 0; k < i.n; ++k) stack[k] = rest < 0 ? 0 : ratio * stack[k] - along * normal[k];
    return nullptr;
}

const char* applyFaceForward(double* stack, const Instruction& i) {
    const double side = dot(stack + i.a + i.b, stack + i.a, i.n);
    if (!(side < 0))
        for (std::size_t k = 0; k < i.n; ++k) stack[k] = -stack[k];
    return nullptr;
}

const char* applyAny(double* stack, const Instruction& i) {
    stack[0] = std::find(stack, stack + i.a, 1.0) != stack + i.a ? 1 : 0;
    return nullptr;
}
const char* applyAll(double* stack, const Instruction& i) {
    stack[0] = std::find(stack, stack + i.a, 0.0) == stack + i.a ? 1 : 0;
    return nullptr;
}

// ---- Whole numbers

const char* applyBitAnd(double* stack, const Instruction& /*i*/) {
    return bits(stack, [](std::int64_t a, std::int64_t b) { return a & b; });
}
const char* applyBitOr(double* stack, const Instruction& /*i*/) {
    return bits(stack, [](std::int64_t a, std::int64_t b) { return a | b; });
}
const char* applyBitXor(double* stack, const Instruction& /*i*/) {
    return bits(stack, [](std::int64_t a, std::int64_t b) { return a ^ b; });
}
const char* applyBitNot(double* stack, const Instruction& /*i*/) {
    if (!isWithinWhole(stack[0])) return kNotWhole;
    stack[0] = static_cast<double>(~static_cast<std::int64_t>(stack[0]));
    return nullptr;
}
const char* applyShiftLeft(double* stack, const Instruction& /*i*/) {
    const int shift = shiftOf(stack[1]);
    if (shift < 0) return kWrongShift;
    const double result = std::ldexp(std::trunc(stack[0]), shift);
    if (!isWithinWhole(stack[0]) || !isWithinWhole(result)) return kNotWhole;
    stack[0] = result;
    return nullptr;
}
const char* applyShiftRight(double* stack, const Instruction& /*i*/) {
    const int shift = shiftOf(stack[1]);
    if (shift < 0) return kWrongShift;
    if (!isWithinWhole(stack[0])) return kNotWhole;
    stack[0] = std::floor(std::ldexp(std::trunc(stack[0]), -shift));
    return nullptr;
}

// ---- Motion and chance

const char* applyBounce(double* stack, const Instruction& /*i*/) {
    const double low = stack[0];
    const double high = stack[1];
    const double distance = stack[2] * stack[3];  // speed * time
    const double size = std::abs(high - low);
    if (size == 0) return nullptr;
    const double there = modulo(distance, 2 * size);
    const double gone = there <= size ? there : 2 * size - there;
    stack[0] = gone == size ? high : low + (high < low ? -gone : gone);
    return nullptr;
}

const char* applyWrap(double* stack, const Instruction& /*i*/) {
    const double low = stack[0];
    const double size = stack[1] - low;
    if (size == 0) return nullptr;
    stack[0] = low + modulo(stack[2] * stack[3], size);
    return nullptr;
}

const char* applyRandom(double* stack, const Instruction& i) {
    const auto value = random(stack[0], i.b == 0 ? 0 : stack[1]);
    if (!value) return "the arguments of rand are between -2^63 and 2^63";
    stack[0] = *value;
    return nullptr;
}

const char* applyNoise(double* stack, const Instruction& i) {
    stack[0] = gradientNoise(stack, i.a);
    return nullptr;
}

namespace {

template <class Matrix>
void put(double* stack, const Matrix& matrix) {
    std::copy_n(glm::value_ptr(matrix), Matrix::length() * Matrix::length(), stack);
}

/// Calls work(matrix) with the matrix of `components` numbers at `from`.
template <class Work>
const char* withMatrix(const double* from, std::size_t components, const Work& work) {
    constexpr std::size_t kTwo = 4;
    constexpr std::size_t kThree = 9;
    if (components == kTwo) return work(glm::make_mat2(from));
    if (components == kThree) return work(glm::make_mat3(from));
    return work(glm::make_mat4(from));
}

/// Columns of a square matrix with this many components.
std::size_t columnsOf(std::size_t components) {
    std::size_t columns = 1;
    while (columns * columns < components) ++columns;
    return columns;
}

}  // namespace

const char* applyMatrixTimesMatrix(double* stack, const Instruction& i) {
    return withMatrix(stack, i.a, [&](const auto& left) -> const char* {
        std::remove_cvref_t<decltype(left)> right;
        std::copy_n(stack + i.a, i.b, glm::value_ptr(right));
        put(stack, left * right);
        return nullptr;
    });
}

const char* applyMatrixTimesVector(double* stack, const Instruction& i) {
    return withMatrix(stack, i.a, [&](const auto& matrix) -> const char* {
        typename std::remove_cvref_t<decltype(matrix)>::row_type vector;
        std::copy_n(stack + i.a, i.b, glm::value_ptr(vector));
        const auto product = matrix * vector;
        std::copy_n(glm::value_ptr(product), i.n, stack);
        return nullptr;
    });
}

const char* applyVectorTimesMatrix(double* stack, const Instruction& i) {
    return withMatrix(stack + i.a, i.b, [&](const auto& matrix) -> const char* {
        typename std::remove_cvref_t<decltype(matrix)>::col_type vector;
        std::copy_n(stack, i.a, glm::value_ptr(vector));
        const auto product = vector * matrix;
        std::copy_n(glm::value_ptr(product), i.n, stack);
        return nullptr;
    });
}

const char* applyOuterProduct(double* stack, const Instruction& i) {
    double product[16];
    for (std::size_t column = 0; column < i.b; ++column)
        for (std::size_t row = 0; row < i.a; ++row)
            product[column * i.a + row] = stack[row] * stack[i.a + column];
    std::copy_n(product, i.n, stack);
    return nullptr;
}

const char* applyTranspose(double* stack, const Instruction& i) {
    const std::size_t size = columnsOf(i.n);
    for (std::size_t column = 0; column < size; ++column)
        for (std::size_t row = 0; row < column; ++row)
            std::swap(stack[column * size + row], stack[row * size + column]);
    return nullptr;
}

const char* applyDeterminant(double* stack, const Instruction& i) {
    return withMatrix(stack, i.a, [&](const auto& matrix) -> const char* {
        stack[0] = glm::determinant(matrix);
        return nullptr;
    });
}

const char* applyInverse(double* stack, const Instruction& i) {
    return withMatrix(stack, i.n, [&](const auto& matrix) -> const char* {
        if (base::isSingular(matrix)) return "the matrix is singular, so it has no inverse";
        put(stack, base::inverseOrZero(matrix));
        return nullptr;
    });
}

const char* applySpread(double* stack, const Instruction& i) {
    std::fill_n(stack + 1, i.n - 1, stack[0]);
    return nullptr;
}

const char* applyDiagonal(double* stack, const Instruction& i) {
    const double value = stack[0];
    std::fill_n(stack, i.n, 0.0);
    for (std::size_t k = 0; k < i.n; k += columnsOf(i.n) + 1) stack[k] = value;
    return nullptr;
}

const char* applyResize(double* stack, const Instruction& i) {
    const std::size_t from = columnsOf(i.a);
    const std::size_t to = columnsOf(i.n);
    double resized[16];
    for (std::size_t column = 0; column < to; ++column)
        for (std::size_t row = 0; row < to; ++row)
            resized[column * to + row] = column < from && row < from ? stack[column * from + row]
                                         : column == row             ? 1
                                                                     : 0;
    std::copy_n(resized, i.n, stack);
    return nullptr;
}

const char* applyFirst(double* /*stack*/, const Instruction& /*i*/) {
    return nullptr;
}

const char* applyTruth(double* stack, const Instruction& i) {
    for (std::size_t k = 0; k < i.n; ++k) stack[k] = stack[k] != 0 ? 1 : 0;
    return nullptr;
}

const char* applyTranslate(double* stack, const Instruction& /*i*/) {
    put(stack, base::translation({stack[0], stack[1], stack[2]}));
    return nullptr;
}

const char* applyScale(double* stack, const Instruction& i) {
    const bool uniform = i.a == 1 && i.b == 0;
    put(stack, base::scaling({stack[0], uniform ? stack[0] : stack[1], uniform ? stack[0] : stack[2]}));
    return nullptr;
}

const char* applyRotate(double* stack, const Instruction& /*i*/) {
    const glm::dvec3 axis{stack[1], stack[2], stack[3]};
    if (axis == glm::dvec3(0.0)) return "the axis has length 0";
    put(stack, base::rotation(stack[0], axis));
    return nullptr;
}

const char* applyPerspective(double* stack, const Instruction& /*i*/) {
    constexpr double kFlat = 180;
    if (!(stack[0] > 0 && stack[0] < kFlat)) return "the angle is not between 0 and 180 degrees";
    if (!(stack[1] > 0)) return "the aspect is not positive";
    if (!(stack[2] > 0 && stack[3] > 0)) return "near and far are not positive";
    if (stack[2] == stack[3]) return "near and far are equal";
    put(stack, base::perspectiveProjection(stack[0], stack[1], stack[2], stack[3]));
    return nullptr;
}

const char* applyOrtho(double* stack, const Instruction& /*i*/) {
    if (stack[0] == stack[1]) return "left and right are equal";
    if (stack[2] == stack[3]) return "bottom and top are equal";
    if (stack[4] == stack[5]) return "near and far are equal";
    put(stack, base::boxProjection(stack[0], stack[1], stack[2], stack[3], stack[4], stack[5]));
    return nullptr;
}

const char* applyFrustum(double* stack, const Instruction& i) {
    if (!(stack[4] > 0 && stack[5] > 0)) return "near and far are not positive";
    double box[16];
    std::copy_n(stack, 6, box);
    if (const char* why = applyOrtho(box, i)) return why;
    put(stack, base::frustumProjection(stack[0], stack[1], stack[2], stack[3], stack[4], stack[5]));
    return nullptr;
}

const char* applyLookAt(double* stack, const Instruction& /*i*/) {
    const auto matrix = base::viewingMatrix({stack[0], stack[1], stack[2]}, {stack[3], stack[4], stack[5]},
                                            {stack[6], stack[7], stack[8]});
    if (!matrix) return "eye and centre are the same point, or the view is along the up vector";
    put(stack, *matrix);
    return nullptr;
}

}  // namespace glibra::expression
