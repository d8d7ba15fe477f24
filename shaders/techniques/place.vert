// R02 Nothing but the place on the model.
#version 140

uniform mat4 MVPMatrix;
in vec4 MCvertex;
out vec3 vPlace;

void main() {
    vPlace = MCvertex.xyz;
    gl_Position = MVPMatrix * MCvertex;
}
