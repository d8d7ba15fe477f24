// G11.f3 Gx11.2 A Bezier curve of degree 1, 2 or 3 as a band of constant width, by Bernstein's sums.
#version 410 core

uniform mat4 mvp_matrix;
uniform vec2 uPoints[4];
uniform int uDegree;
uniform int uSteps;         // pairs of vertices
uniform float uWidth;

vec2 pointAt(float t) {
    float s = 1. - t;
    if (uDegree == 1) return s * uPoints[0] + t * uPoints[1];
    if (uDegree == 2) return s * s * uPoints[0] + 2. * s * t * uPoints[1] + t * t * uPoints[2];
    return s * s * s * uPoints[0] + 3. * s * s * t * uPoints[1] + 3. * s * t * t * uPoints[2] + t * t * t * uPoints[3];
}

void main() {
    float t = float(gl_VertexID / 2) / float(uSteps - 1);
    // The direction from two points beside t, also where the derivative is 0.
    vec2 along = pointAt(min(t + .001, 1.)) - pointAt(max(t - .001, 0.));
    vec2 side = vec2(-along.y, along.x) / max(length(along), 1e-6);
    gl_Position = mvp_matrix * vec4(pointAt(t) + uWidth * (float(gl_VertexID % 2) - .5) * side, 0., 1.);
}
