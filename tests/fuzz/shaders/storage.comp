#version 450 core
const int kRows = 4;
layout(local_size_x = 16, local_size_y = kRows) in;
layout(std430) buffer;

struct Particle { vec3 position; float age; mat2x3 frames[2]; };

layout(binding = 0) readonly buffer Particles { uint count; Particle particles[]; };
layout(std430, row_major, binding = 1) buffer Sums { mat3 total; double weights[3][kRows]; float sums[]; } result;
layout(std140) uniform Light { vec4 ambient; layout(offset = 32) bvec2 flags; Particle one; } light;
layout(r32ui, binding = 2) uniform coherent uimage2DArray uCounts[2];
layout(rgba16f) uniform writeonly image2D uOut;
layout(binding = 0, offset = 4) uniform atomic_uint uTickets;

shared Particle part[16][kRows];
shared mat4 basis;
#define AT(a, k) a[(k)]

subroutine float Weigh(float age);
subroutine(Weigh) float plain(float age) { return age; }
subroutine uniform Weigh uWeigh;

void main()
{
    uint i = gl_GlobalInvocationID.x, k = gl_LocalInvocationID.y;
    part[i][k] = particles[i];
    AT(part[0], k).frames[i % 2u][1].xy += light.one.position.xy;
    basis[k] = light.ambient;
    barrier();
    for (int round = 0; round < 70000; round++)
        result.sums[i] += uWeigh(part[i & 15u][(k + 1u) % 4u].age);
    imageStore(uOut, ivec2(i, k), vec4(result.total[1], 1.));
    imageAtomicAdd(uCounts[1], ivec3(0), atomicCounterIncrement(uTickets));
}
