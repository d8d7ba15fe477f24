// S22 One colour per patch, from its longest side; light by its centre.
#version 400

in vec3 vModel;
in vec3 vInPatch;
in float vLongest;
out vec4 fColor;

void main() {
    vec3 color = mix(vec3(.15, .35, .8), vec3(1., .75, .25), smoothstep(.2, .75, vLongest));
    float light = .4 + .6 * max(dot(normalize(vModel), normalize(vec3(-1., 1.5, 2.))), 0.);
    float edge = min(vInPatch.x, min(vInPatch.y, vInPatch.z));
    fColor = vec4(color * light * mix(.75, 1., smoothstep(.02, .08, edge)), 1.);
}
