// S03 Light per vertex: the colour is interpolated.
#version 110
#include "ads.glsl"

void main() {
    gl_FrontColor = adsLight(vec3(gl_ModelViewMatrix * gl_Vertex), normalize(gl_NormalMatrix * gl_Normal));
    gl_Position = ftransform();
}
