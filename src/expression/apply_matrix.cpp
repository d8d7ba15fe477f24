#include <algorithm>
#include <cstddef>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "base/matrices.h"
#include "expression/apply.h"

namespace glibra::expression {
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
