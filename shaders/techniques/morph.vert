// R45 Between two key frames: each vertex has two positions and two normals.
#version 330 core

uniform float uBlend;

in vec3 aFirst, aFirstNormal;
in vec3 aSecond, aSecondNormal;
in vec2 aMap;

out vec3 vNormal;     // eye space
out vec2 vMap;

void main() {
    vec3 place = mix(aFirst, aSecond, uBlend);
    vNormal = uNormalMatrix * normalize(mix(aFirstNormal, aSecondNormal, uBlend));
    vMap = aMap;
    gl_Position = uModelViewProjectionMatrix * vec4(place, 1.);
}
