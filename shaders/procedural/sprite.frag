// R64 Point sprites: gl_PointCoord makes a square of pixels a shaded ball.
#version 330 core

uniform bool uRound;

in vec3 vEye;
in vec3 vColor;

out vec4 fColor;

void main() {
    // gl_PointCoord counts down the screen.
    vec2 xy = vec2(2., -2.) * (gl_PointCoord - .5);
    float rr = dot(xy, xy);
    if (uRound && rr > 1.) discard;
    vec3 normal = vec3(xy, sqrt(max(1. - rr, 0.)));
    vec3 toLight = normalize(vec3(.5, .8, .7));
    float diffuse = max(dot(normal, toLight), 0.);
    float gloss = pow(max(dot(reflect(-toLight, normal), normalize(-vEye)), 0.), 40.);
    fColor = vec4(uRound ? vColor * (.2 + .8 * diffuse) + .6 * gloss : vColor, 1.);
}
