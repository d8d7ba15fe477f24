// The level of a mipmap by the formula of OpenGL (4.6 core, 8.14.1). Drivers may choose levels near it for texture(), and do.

/// Levels for coordinates in texels: the longer way from this pixel to its neighbours decides.
float levelOfDetail(vec2 texels) {
    vec2 across = dFdx(texels), up = dFdy(texels);
    return .5 * log2(max(max(dot(across, across), dot(up, up)), 1e-12));
}
