#pragma once

namespace glibra::view {

/// Font and spacing for that scale, once, before the first frame.
void loadFont(float scale);
/// Colours and spacing.
void applyTheme(bool light, float scale);

}  // namespace glibra::view
