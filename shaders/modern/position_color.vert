// G4.1b Tumbling cubes: the colour is the place in model space, mapped from -1..1 to 0..1.
#version 330 compatibility

out vec3 vColor;

void main() {
    vColor = .5 * gl_Vertex.xyz + .5;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
