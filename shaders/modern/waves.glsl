// The normal of the water at a place: three heights from the cube of waves give two directions along the surface.

uniform sampler3D waveHeights;
uniform float uMoment;     // slice of the cube; it repeats after 1
uniform float uWaveWidth;  // side of the cube in the world
uniform float uWaveHeight;

float waveHeight(vec2 place) {
    return uWaveHeight * textureLod(waveHeights, vec3(place / uWaveWidth, uMoment).xzy, 0.).r;
}

vec3 waveNormal(vec2 place) {
    float step = uWaveWidth / float(textureSize(waveHeights, 0).x);
    float here = waveHeight(place);
    vec3 east = vec3(step, waveHeight(place + vec2(step, 0.)) - here, 0.);
    vec3 south = vec3(0., waveHeight(place + vec2(0., step)) - here, step);
    return normalize(cross(south, east));
}
