// V04 One constant colour, whatever the current colour is.
#version 110

void main() {
    gl_FragColor = vec4(1., 0., 0., 1.);
}
