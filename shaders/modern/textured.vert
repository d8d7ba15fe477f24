// G5.1 Texture: the texture coordinates, scaled and moved.
#version 430 core

uniform mat4 mv_matrix, p_matrix;
uniform vec2 uFrom = vec2(0.), uTo = vec2(1.);  // where 0 and 1 go

in vec3 vertPos;
in vec2 texCoord;
out vec2 vTexCoord;

void main() {
    vTexCoord = mix(uFrom, uTo, texCoord);
    gl_Position = p_matrix * mv_matrix * vec4(vertPos, 1.);
}
