#pragma once
// The names that every scene has.

#include <span>
#include <string_view>

#include "expression/names.h"

namespace glibra::expression {

/// A name that needs no declaration.
struct NameRow {
    std::string_view path;
    Type type;
    Depends depends;
    std::string_view summary;
};

/// time, dt, frame, tick, window, aspect, mouse, mouse.down, model.
std::span<const NameRow> sceneNames();
/// view, projection, ... without `prev`, which has these fields again.
std::span<const NameRow> cameraFields();

}  // namespace glibra::expression
