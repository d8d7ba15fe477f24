// G14.7 Clouds: white where there is cloud, blue where there is none.
#version 430 core

uniform sampler3D uClouds;

in vec3 vTexCoord;
out vec4 fColor;

void main() {
    fColor = vec4(vec2(texture(uClouds, vTexCoord).r), 1., 1.);
}
