// G16.W Work groups: the colour tells the group (red, green), and the place in the group (blue).
#version 430 core
layout(local_size_x = 5, local_size_y = 5) in;

layout(rgba8) uniform writeonly image2DArray uPlaces;
layout(std430) buffer Counts { uint counts[]; };

void main() {
    atomicAdd(counts[0], 1u);
    vec2 group = vec2(gl_WorkGroupID.xy) / vec2(gl_NumWorkGroups.xy - 1u);
    float place = float(gl_LocalInvocationIndex) / 24.;
    imageStore(uPlaces, ivec3(gl_GlobalInvocationID), vec4(group, place, 1.));
}
