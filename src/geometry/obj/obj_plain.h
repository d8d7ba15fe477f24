#pragma once
// The usual OBJ file, fast: in pieces, by all processors.

#include <cstddef>
#include <optional>
#include <string_view>

#include "geometry/obj/obj_model.h"

namespace glibra::geometry {

/// Bytes that a thread should have at least.
inline constexpr std::size_t kPlainPiece = std::size_t{1} << 20;

/// The model of a text in which nothing has to be remarked on: complete v, vt and vn lines, faces of three or
/// more corners with positive indices that all exist, lines without meaning, comments; LF or CR LF; no joined
/// lines. Nothing for any other text, which parseObj then reads line by line. In pieces of about
/// `pieceBytes`; the model does not depend on it.
std::optional<ObjModel> readPlainObj(std::string_view text, std::size_t pieceBytes = kPlainPiece);

}  // namespace glibra::geometry
