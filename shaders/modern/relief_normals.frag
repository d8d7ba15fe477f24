// G10.2 Normal map from a height map: (east, north, up), each mapped from -1..1 to the bytes 1..255.
#version 430 core

uniform sampler2D heightMap;
uniform vec4 uArea;     // west, south, east and north border in degrees of a map of a sphere, or
uniform float uExtent;  // the side of a flat map
uniform float uRelief;  // how much the heights are exaggerated

in vec2 vST;
out vec4 fNormal;

float heightAt(vec2 step) {
    return uRelief * texture(heightMap, vST + step).r;
}

void main() {
    vec2 texel = 1. / vec2(textureSize(heightMap, 0));
    vec2 size = vec2(uExtent);  // of the map, in units of the height
    if (uExtent == 0.) {
        size = radians(uArea.zw - uArea.xy);
        size.x *= max(cos(radians(mix(uArea.y, uArea.w, vST.y))), .01);
    }
    float east = heightAt(vec2(texel.x, 0.)) - heightAt(vec2(-texel.x, 0.));
    float north = heightAt(vec2(0., texel.y)) - heightAt(vec2(0., -texel.y));
    vec3 normal = normalize(vec3(-vec2(east, north) / (2. * texel * size), 1.));
    fNormal = vec4((127. * normal + 128.) / 255., 1.);  // 0 is a byte, so that flat ground stays flat
}
