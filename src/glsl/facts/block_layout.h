#pragma once
// Where the members of blocks lie in memory by the rules std140 and std430 (OpenGL 4.6 Core, 7.6.2.2), so
// that scenes can fill buffers without a linked program. All offsets, strides and sizes are bytes.

#include <glibra/result.h>

#include <string>
#include <string_view>
#include <vector>

#include "glsl/types/translated_program.h"

namespace glibra::glsl {

struct MemoryArray {
    long long count = 0;  ///< 0: runtime-sized
    long long stride = 0;
};

/// One scalar, vector or matrix, or an array of them.
struct MemoryField {
    std::string path;      ///< "light.position", "particles[].velocity"; [] stands for one array dimension
    std::string scalar;    ///< "float", "double", "int", "uint" or "bool"
    int components = 1;    ///< of a vector or of a matrix column
    int columns = 1;       ///< more than 1: a matrix
    long long offset = 0;  ///< of the first element of all arrays around it
    std::vector<MemoryArray> arrays;  ///< one for each [] of the path, in that order
    long long matrixStride = 0;       ///< between columns, or between rows if isRowMajor; 0: no matrix
    bool isRowMajor = false;
};

struct MemoryLayout {
    std::vector<MemoryField> fields;
    /// With a runtime-sized last member: where that begins. Otherwise the size of all members, rounded up to
    /// the alignment.
    long long size = 0;
    /// The distance between two elements of the runtime-sized last member; 0: there is none. For a type: the
    /// distance between two elements of an array of it.
    long long stride = 0;
    long long alignment = 1;
};

/// The layout of a block. The error, which has no id, says why the text does not decide it.
Result<MemoryLayout> layoutOf(const MemoryBlock& block, const MemoryStructures& structures);

/// The layout of one value of a basic type or a structure: "float", "vec3", "Particle". A basic type is one
/// field with an empty path.
Result<MemoryLayout> layoutOf(std::string_view type, Packing packing, const MemoryStructures& structures);

}  // namespace glibra::glsl
