// R12 Reads the picture, or the cube map, at the coordinates that the vertex stage has made.
#version 330 core

uniform int uRule;
uniform sampler2D uPicture;
uniform samplerCube uSky;

in vec4 vCoord;
in float vLight;
out vec4 fColor;

void main() {
    vec4 color = uRule < 3 ? textureProj(uPicture, vec3(vCoord.st, vCoord.q)) : texture(uSky, vCoord.xyz);
    fColor = vec4((uRule < 2 ? vLight : 1.) * color.rgb, 1.);
}
