// R13 The five modes in which the fixed pipeline applied a texture `t` to the colour `p` of the primitive.
vec4 applyTexture(int mode, vec4 p, vec4 t, vec3 constant) {
    if (mode == 0) return t;                                                     // REPLACE
    if (mode == 1) return p * t;                                                 // MODULATE
    if (mode == 2) return vec4(mix(p.rgb, t.rgb, t.a), p.a);                     // DECAL
    if (mode == 3) return vec4(mix(p.rgb, constant, t.rgb), p.a * t.a);          // BLEND
    return vec4(min(p.rgb + t.rgb, 1.), p.a * t.a);                              // ADD
}
