// G7.f16 A dragon's body: the skin of a torus, laid along a trefoil knot that thins out to a tail, with rows of scales.
#version 410 core

uniform mat4 m_matrix, v_matrix, p_matrix, norm_matrix;

in vec2 tc;         // along the knot, around the body
out vec3 vPlace, vNormal;

const float kTurn = 6.2831853;

vec3 knot(float s) {
    float a = kTurn * s;
    return .62 * vec3(sin(a) + 2. * sin(2. * a), cos(a) - 2. * cos(2. * a), -1.1 * sin(3. * a));
}

/// Scales: rows along the body, every other one shifted by half, each rising toward its end.
float scales(vec2 st) {
    vec2 cell = st * vec2(160., 24.);
    if (mod(floor(cell.y), 2.) == 1.) cell.x += .5;
    vec2 p = fract(cell) - vec2(0., .5);
    return (1. - p.x) * smoothstep(.5, .2, abs(p.y));
}

vec3 skin(vec2 st) {
    vec3 along = normalize(knot(st.s + .002) - knot(st.s - .002));
    vec3 side = normalize(cross(along, knot(st.s))), up = cross(side, along);
    float radius = .2 + .16 * sin(kTurn * .5 * st.s), angle = kTurn * st.t;
    radius += .035 * scales(st);
    // A ridge of spikes on the back.
    radius += .14 * pow(max(cos(angle), 0.), 12.) * abs(2. * fract(60. * st.s) - 1.);
    return knot(st.s) + radius * (cos(angle) * up + sin(angle) * side);
}

void main() {
    const float h = .0006;
    vec3 alongS = skin(tc + vec2(h, 0.)) - skin(tc - vec2(h, 0.));
    vec3 alongT = skin(tc + vec2(0., 2. * h)) - skin(tc - vec2(0., 2. * h));
    vec4 place = m_matrix * vec4(skin(tc), 1.);
    vPlace = place.xyz;
    vNormal = mat3(norm_matrix) * cross(alongT, alongS);
    gl_Position = p_matrix * v_matrix * place;
}
