// S03 Light per fragment: place and normal are interpolated.
#version 110
#include "ads.glsl"

varying vec3 vPlace, vNormal;

void main() { gl_FragColor = adsLight(vPlace, normalize(vNormal)); }
