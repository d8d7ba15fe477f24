// S06 Each point flies on its own: p + v t, and g / 2 t^2 more for the height.
#version 110

attribute vec3 vel;
uniform float g, t;

void main() {
    vec4 place = gl_Vertex;
    place.xyz += vel * t;
    place.y += .5 * g * t * t;
    gl_FrontColor = vec4(.5 + .5 * normalize(vel + vec3(0., 0., 1e-3)), 1.);
    gl_Position = gl_ModelViewProjectionMatrix * place;
}
