// Gx15.3 Light that waves gather into bright bands: one function for all that is under water.
#include "modern/waves.glsl"

uniform float uCaustics;

float causticLight(vec2 place) {
    float band = 1. - abs(sin(6.2831853 * waveHeight(2.5 * place) / uWaveHeight));
    return uCaustics * band * band * band * band;
}
