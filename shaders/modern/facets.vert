// G4.4 Facets: eye-space place, for normals of flat faces.
#version 330 compatibility

out vec3 vPlace;

void main() {
    vPlace = vec3(gl_ModelViewMatrix * gl_Vertex);
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
