#pragma once
// The keys of a shot that give its picture the view of a window.

#include <glibra/render.h>
#include <toml++/toml.h>

#include <string_view>

#include "suite/file/toml_reader.h"

namespace glibra::suite {

/// A list of 16 numbers, column by column; `matrix` stays as it is if the list is wrong, which the reader
/// then knows.
void readMatrix(TomlReader& reader, const toml::node& node, std::string_view name, Matrix& matrix);
/// { 12 = [16 numbers], 14 = ... }: a matrix for the object on each of those lines of the scene.
void readObjectTransforms(TomlReader& reader, const toml::node& node, ViewState& view);
/// "scene", "perspective" or "orthographic".
void readProjection(TomlReader& reader, const toml::node& node, ViewState& view);
/// [R, G, B] or [R, G, B, A].
void readBackground(TomlReader& reader, const toml::node& node, ViewState& view);

}  // namespace glibra::suite
