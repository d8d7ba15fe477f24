#pragma once
// Wavefront OBJ models, their meshes, and the messages about a model file.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace glibra::geometry {

// The messages about one model file. Their number is limited however damaged the file is.

/// Returns a text of the file in a form that a message can show: at most 40 bytes, control bytes replaced.
std::string shown(std::string_view text);

/// Returns the last part of a path.
std::string_view fileName(std::string_view path);

class FileRemarks {
  public:
    explicit FileRemarks(std::string path) : path_(std::move(path)) {}

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] Place place(int line, int column) const { return {path_, line, column}; }

    /// Adds a warning at that place. From the 101st warning with the same id on they are only counted.
    void warn(std::string_view id, std::string_view text, int line, int column);

    /// Counts a statement that is ignored; finish() gives one file-W04 per word.
    void ignored(std::string_view word, int line, int column);

    /// Returns all messages in the order of the file, then one per id whose messages were only counted.
    [[nodiscard]] Diagnostics finish() &&;

  private:
    struct Ignored {
        std::size_t count = 0;
        int line = 1, column = 1;
    };
    std::string path_;
    Diagnostics warnings_;
    std::map<std::string, std::size_t, std::less<>> warningCounts_;  // by id
    std::map<std::string, Ignored, std::less<>> ignored_;            // by word, at most a hundred
    std::size_t otherIgnored_ = 0;
};

// Models as the file has them: positions, texture coordinates, normals, polygons.

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

// Meshes of OBJ models. Positions are those of the file; nothing is moved or scaled.

/// Makes triangles: a polygon with n corners becomes the fan (0, i, i + 1), or, if that leaves its outline,
/// n - 2 other triangles (concave_faces.h). Each different triple (v, vt, vn) becomes one vertex, in the
/// order of first use.
///
/// Normals are those of the file, made unit vectors; a corner without a normal, or with one of length zero,
/// gets the area-weighted mean of the faces around its position index. In a file with `s` lines these are the
/// faces of its smoothing group, or, for `s off`, its own face alone; a vertex then belongs to one group, or
/// to one such face. Texture coordinates are left out if
/// the file has none; a corner without one has (0, 0, 0). Tangents are the directions of rising t, weighted
/// by area over the triangles at the vertex and made perpendicular to the normal, or T0(N) where they are
/// undefined. Colours are those of the `v` lines, or left out. `withTangents` is false for a draw whose
/// program reads no tangents; the mesh then has none.
Mesh obj(const ObjModel& model, bool withTangents = true);

/// Makes the same vertices and triangles, as patches of 3 vertices.
Mesh objPatch(const ObjModel& model, bool withTangents = true);

/// Makes the same triangles with adjacency: the corners are at 0, 2, 4, and at 1, 3, 5 are the far corners of
/// the neighbours across 0-2, 2-4, 4-0. Two edges are the same if their ends have equal coordinates. An edge
/// that has no neighbour, or no length, has its own first vertex there; an edge shared by three or more
/// triangles has the first other one in file order.
Mesh objAdj(const ObjModel& model, bool withTangents = true);

/// Makes the same vertices, with each edge of the file's polygons once as a line. Edges are told apart by
/// their position indices and stand in the order of first use; those of `l` lines follow, then the points of
/// `p` lines (Mesh::pointCount).
Mesh wireObj(const ObjModel& model, bool withTangents = true);

}  // namespace glibra::geometry
