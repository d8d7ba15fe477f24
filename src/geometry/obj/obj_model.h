#pragma once
// Wavefront OBJ models as the file has them: positions, texture coordinates, normals, polygons.

#include <glibra/result.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace glibra::geometry {

/// The largest sizes that are read; beyond them: file-E09.
inline constexpr std::uint64_t kLargestModelFile = std::uint64_t{1} << 30;  ///< bytes
inline constexpr std::uint64_t kMostTriangles = 16'777'216;                 ///< also segments of a shapefile

/// One corner of a polygon: indices from 0 into the model's arrays; kNoIndex: it has none.
struct ObjCorner {
    std::uint32_t position = 0;
    std::uint32_t texCoord = kNoIndex;
    std::uint32_t normal = kNoIndex;

    friend bool operator==(const ObjCorner&, const ObjCorner&) = default;
};

using Triple = std::array<float, 3>;

/// The smoothing group of faces that share normals with no others (`s off`).
inline constexpr std::uint32_t kFlat = 0;

/// All indices are valid, every face has three corners or more, every line two or more, all numbers are
/// finite.
struct ObjModel {
    std::vector<Triple> positions;
    std::vector<Triple> colors;             ///< of each position; empty if the file has none
    std::vector<Triple> texCoords;          ///< s, t, p; missing ones 0
    std::vector<Triple> normals;            ///< as written, not yet of unit length
    std::vector<ObjCorner> corners;         ///< of all faces, face after face
    std::vector<std::uint32_t> faceStarts;  ///< the first corner of each face; last, the number of corners
    /// The smoothing group of each face; kNoIndex above the first `s` line. Empty if the file has no such
    /// line; all faces are one group then.
    std::vector<std::uint32_t> groups;
    /// Faces whose triangles are not the fan from their first corner, in ascending order, and their
    /// triangles, face after face: numbers of corners of the face.
    std::vector<std::uint32_t> splitFaces, splitTriangles;

    // Only with ObjElements::edges:
    std::vector<ObjCorner> lineCorners;     ///< of all `l` lines, line after line
    std::vector<std::uint32_t> lineStarts;  ///< the first corner of each; last, the number of corners
    std::vector<ObjCorner> points;          ///< of all `p` lines

    [[nodiscard]] std::size_t faceCount() const { return faceStarts.empty() ? 0 : faceStarts.size() - 1; }
    /// The number of triangles that all faces have.
    [[nodiscard]] std::uint64_t triangleCount() const {
        return corners.size() - 2 * std::uint64_t{faceCount()};
    }
};

/// What is wanted of a file: its faces; or all that has edges, which are faces, lines and points.
enum class ObjElements { faces, edges };

/// Reads the whole text of a model; `path` is for messages. It may hold any bytes.
///
/// v, vt, vn, f and s are read, and l and p if they are wanted. o, g, usemtl, mtllib and comments are
/// skipped; any other word is reported once (file-W04). A v line with six numbers or more has a colour; in a
/// file with such lines, the other positions are white. Indices count from 1; negative ones count back from
/// the last element above the face; positive ones may also refer to elements further down. Faces with fewer
/// than three corners or with an index out of range are dropped (file-W05), and so are such lines and points.
/// A malformed number is replaced by its longest numeric prefix, or by 0 (file-W06). file-W05 and file-W06
/// are given at most a hundred times each, then once with the number of the rest. file-W17: faces that are
/// fans although they are concave, because cutting them takes too long. Errors: file-E07 nothing that is
/// wanted, file-E08 a compiler's object file, file-E09 too large.
///
/// A file without anything to report is read by obj_plain.h, every other one by a reader that goes line by
/// line and knows the line and column of everything.
Result<ObjModel> parseObj(std::string_view text, std::string path, ObjElements wanted = ObjElements::faces);

}  // namespace glibra::geometry
