// G16.11 G16.14 G16.15 A picture of the scene's list of objects, with shadows.
#version 430 core
#define SHADOWS
#define MARBLE
#include "tracer.glsl"
