#pragma once
// Private to this room: what of a texture or buffer a check, a Print or a function of conditions names.

#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "scene/conditions.h"
#include "scene/run/state.h"

namespace glibra::scene {

/// The window, or the texture or buffer that a value names, with its part, and components or a member after
/// it: `glow.level(1).a`, `window.rgb`, `particles.velocity.x`. Nothing with the reason reported.
std::optional<Selection> selectionNamed(Interpreter&, const Value& value);

/// Limits the selection to a rectangle of texels (x, y, width, height) or a range of elements (first, last).
/// `what`: the statement or function, for messages. False with glib-E26 reported for another number of
/// numbers, with glib-E29 for a range that ends before it begins, and with glib-E05 for what lies outside of
/// the object, as far as its size is known.
bool selectArea(Interpreter&, const Value& where, std::span<const double> numbers, std::string_view what,
                Selection& selection);

/// The names that an expression reads which is evaluated when the picture is there, with their values where
/// it stands. Null with the reason reported if it is wrong; what depends on the structures of shaders is
/// checked when it is evaluated. The scene depends on what the expression reads. `takesTimes`: calls may say
/// `at`.
std::shared_ptr<const ConditionNames> namesOfQuestion(Interpreter&, const Value& value,
                                                      const expression::Wanted& wanted, bool takesTimes);

}  // namespace glibra::scene
