#pragma once
// What the functions of expressions do with the stack. For the order of arguments see Apply.

#include <algorithm>
#include <cstddef>

#include "expression/expression.h"

namespace glibra::expression {

/// Applies a function of one number to all components.
template <double (*Function)(double)>
const char* each1(double* stack, const Instruction& i) {
    for (std::size_t k = 0; k < i.n; ++k) stack[k] = Function(stack[k]);
    return nullptr;
}

/// Applies a function of two numbers to all components. An argument with one component is used for all.
/// Results overwrite only what has been read, because argument k begins at component k or later.
template <double (*Function)(double, double)>
const char* each2(double* stack, const Instruction& i) {
    const double* const b = stack + i.a;
    const double a0 = stack[0];
    const double b0 = b[0];
    for (std::size_t k = 0; k < i.n; ++k) stack[k] = Function(i.a == 1 ? a0 : stack[k], i.b == 1 ? b0 : b[k]);
    return nullptr;
}

template <double (*Function)(double, double, double)>
const char* each3(double* stack, const Instruction& i) {
    const double* const b = stack + i.a;
    const double* const c = b + i.b;
    const double a0 = stack[0];
    const double b0 = b[0];
    const double c0 = c[0];
    for (std::size_t k = 0; k < i.n; ++k)
        stack[k] = Function(i.a == 1 ? a0 : stack[k], i.b == 1 ? b0 : b[k], i.c == 1 ? c0 : c[k]);
    return nullptr;
}

/// GLSL's mod with an exact remainder: x - y * floor(x / y), in [0, y) or (y, 0]. Not a number for y = 0.
double modulo(double x, double y);
const char* applyModulo(double* stack, const Instruction& i);

// Vectors
const char* applyLength(double* stack, const Instruction& i);
const char* applyDistance(double* stack, const Instruction& i);
const char* applyDot(double* stack, const Instruction& i);
const char* applyCross(double* stack, const Instruction& i);
const char* applyNormalize(double* stack, const Instruction& i);
const char* applyReflect(double* stack, const Instruction& i);
const char* applyRefract(double* stack, const Instruction& i);
const char* applyFaceForward(double* stack, const Instruction& i);
const char* applyAny(double* stack, const Instruction& i);
const char* applyAll(double* stack, const Instruction& i);

// Whole numbers, which are doubles cut toward zero, below 2^53
const char* applyBitAnd(double* stack, const Instruction& i);
const char* applyBitOr(double* stack, const Instruction& i);
const char* applyBitXor(double* stack, const Instruction& i);
const char* applyBitNot(double* stack, const Instruction& i);
const char* applyShiftLeft(double* stack, const Instruction& i);
const char* applyShiftRight(double* stack, const Instruction& i);

// Matrices; the products are those of the operator *
const char* applyMatrixTimesMatrix(double* stack, const Instruction& i);
const char* applyMatrixTimesVector(double* stack, const Instruction& i);
const char* applyVectorTimesMatrix(double* stack, const Instruction& i);
const char* applyOuterProduct(double* stack, const Instruction& i);
const char* applyTranspose(double* stack, const Instruction& i);
const char* applyDeterminant(double* stack, const Instruction& i);
const char* applyInverse(double* stack, const Instruction& i);

// Constructors
const char* applySpread(double* stack, const Instruction& i);  ///< one component to n
const char* applyDiagonal(double* stack,
                          const Instruction& i);               ///< one number to the diagonal of n components
const char* applyResize(double* stack, const Instruction& i);  ///< a matrix of a components to n components
const char* applyFirst(double* stack, const Instruction& i);   ///< keeps the first n components
const char* applyTruth(double* stack, const Instruction& i);   ///< numbers to booleans

// Transforms
const char* applyTranslate(double* stack, const Instruction& i);
const char* applyScale(double* stack, const Instruction& i);
const char* applyRotate(double* stack, const Instruction& i);
const char* applyPerspective(double* stack, const Instruction& i);
const char* applyOrtho(double* stack, const Instruction& i);
const char* applyFrustum(double* stack, const Instruction& i);
const char* applyLookAt(double* stack, const Instruction& i);

// Motion and chance
const char* applyBounce(double* stack, const Instruction& i);
const char* applyWrap(double* stack, const Instruction& i);
const char* applyRandom(double* stack, const Instruction& i);
const char* applyNoise(double* stack, const Instruction& i);

}  // namespace glibra::expression
