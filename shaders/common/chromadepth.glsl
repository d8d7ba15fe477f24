// SH026 ChromaDepth: eye-space z as a colour, from red at zRed (near) through yellow, green, cyan and blue to magenta at zBlue.
vec3 chromaDepth(float z, float zBlue, float zRed) {
    float span = zBlue - zRed;
    float t = abs(span) > 1e-6 ? clamp((z - zRed) / span, 0., 1.) : 0.;
    float hue = 5. * t;   // one unit per band: red, yellow, green, cyan, blue, magenta
    return clamp(vec3(abs(hue - 3.) - 1., 2. - abs(hue - 2.), 2. - abs(hue - 4.)), 0., 1.);
}
