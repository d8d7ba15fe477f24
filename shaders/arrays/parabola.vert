// V14 Ball on a parabola: the last column of a matrix moves it to (t, t + t*t/2).
#version 110

uniform mat4 mvpMatrix;
uniform float t, size;

attribute vec4 vPosition;

void main() {
    mat4 m = mat4(size);
    m[3] = vec4(t, t + .5 * t * t, 0., 1.);
    gl_Position = mvpMatrix * m * vec4(vPosition.xyz, 1.);
}
