#pragma once
// Statements of a compute stage that writes a picture from the one before, and whether the text shows that it
// writes all of it. The facts of the translator and pictures with and without a copy are tested with them.

#include <array>
#include <string>

namespace glibra::test {

struct WholeWriteBody {
    const char* statements;
    bool isWhole;
    const char* before = "";  ///< text before main
};

/// A stage with images uIn and uOut, and the function after(), which gives each texel its next value.
inline std::string stageOf(const WholeWriteBody& body) {
    return std::string("#version 430 core\nlayout(local_size_x = 8, local_size_y = 4) in;\n") +
           "layout(r32ui) readonly uniform uimage2D uIn;\nlayout(r32ui) writeonly uniform uimage2D uOut;\n" +
           "uniform int uOne = 1;\n" + "uvec4 after(ivec2 p) {\n    uint old = imageLoad(uIn, p).r;\n" +
           "    return uvec4(old * 1664525u + 1013904223u + uint(p.x) * 7u);\n}\n" + body.before +
           "\nvoid main() {\n" + body.statements + "\n}\n";
}

inline constexpr auto kWholeWriteBodies = std::to_array<WholeWriteBody>({
    // All of these store the texel of each invocation.
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); imageStore(uOut, p, after(p));", true},
    {"const ivec2 p = ivec2(gl_GlobalInvocationID); imageStore(uOut, p, after(p));", true},
    {"uvec2 id = gl_GlobalInvocationID.xy; ivec2 p = ivec2(id); imageStore(uOut, p, after(p));", true},
    {"int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y); "
     "imageStore(uOut, ivec2(x, y), after(ivec2(x, y)));",
     true},
    {"imageStore(uOut, ivec2(gl_GlobalInvocationID.st), after(ivec2(gl_GlobalInvocationID.xy)));", true},
    {"imageStore(uOut, (ivec2((gl_GlobalInvocationID).xyz.xy)), after(ivec2(gl_GlobalInvocationID.xy)));",
     true},
    {"ivec2 size = imageSize(uOut), p = ivec2(gl_GlobalInvocationID.xy);\n"
     "if (any(greaterThanEqual(p, size))) return;\nimageStore(uOut, p, after(p));",
     true},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\n"
     "if (p.x >= imageSize(uIn).x || imageSize(uOut).y <= p.y) { return; }\nimageStore(uOut, p, after(p));",
     true},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\n"
     "if (all(lessThan(p, imageSize(uOut)))) { uvec4 next = after(p); imageStore(uOut, p, next); }",
     true},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\n"
     "if (p.x < imageSize(uOut).x && p.y < imageSize(uOut).y) imageStore(uOut, p, after(p));",
     true},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\n"
     "if (!all(lessThan(p, imageSize(uOut)))) return; else imageStore(uOut, p, after(p));",
     true},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\n"
     "if (gl_GlobalInvocationID.x >= uint(imageSize(uOut).x)) return;\nimageStore(uOut, p, after(p));",
     true},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); uvec4 next = after(p);\n"
     "for (int i = 0; i < 3; ++i) { if (i == p.x) continue; next += uint(i); }\n"
     "if (p.x == 2) next = uvec4(5u); else if (p.x == 3) next = uvec4(6u); else next += 1u;\n"
     "do next += 1u; while (next.x % 3u != 0u);\nimageStore(uOut, p, next);",
     true},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); { imageStore(uOut, p, after(p)); }\n"
     "if (p.x == 3) return; if (p.y == 2) imageStore(uOut, p, uvec4(9u));",
     true},
    {"STORE(HERE);", true,
     "#define HERE ivec2(gl_GlobalInvocationID.xy)\n#define STORE(p) imageStore(uOut, p, after(p))"},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\n#if 0\nif (p.x == 1) return;\n#endif\n"
     "/* return; */ imageStore(uOut, p, after(p)); // p.x++",
     true},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); imageStore(uOut, p, twice(p));", true,
     "uvec4 twice(ivec2 p) { if (p.x == 3) return uvec4(3u); return after(p) * 2u; }"},
    // These leave texels as they were, or the text does not show that they do not.
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); if (p.x == 3) return; imageStore(uOut, p, after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); if (p.x != 3) imageStore(uOut, p, after(p));", false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); if (p.x != 3) { imageStore(uOut, p, after(p)); }", false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); if (p.x == 3) p.y = 0; else imageStore(uOut, p, after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); for (int i = 0; i < p.x % 2; ++i) imageStore(uOut, p, "
     "after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); for (int i = 0; i < p.x % 2; ++i, imageStore(uOut, p, "
     "after(p))) ;",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); int i = p.x % 2;\n"
     "while (i > 0) { imageStore(uOut, p, after(p)); --i; }",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\n"
     "switch (p.x % 3) { case 0: break; default: imageStore(uOut, p, after(p)); }",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); for (int i = 0; i < 2; ++i) if (p.x == 4) return;\n"
     "imageStore(uOut, p, after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); switch (p.x) { case 2: return; default: break; }\n"
     "imageStore(uOut, p, after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); if (p.x == 1) if (p.y == 1) return; else p.y = p.y;\n"
     "imageStore(uOut, p, after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); imageStore(uOut, p + ivec2(1, 0), after(p));", false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy) + 1; imageStore(uOut, p, after(p));", false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); p.x += 1; imageStore(uOut, p, after(p));", false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); p.x++; imageStore(uOut, p, after(p));", false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); (p) = p / 2; imageStore(uOut, p, after(p));", false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); move(p); imageStore(uOut, p, after(p));", false,
     "void move(inout ivec2 p) { p.x += 1; }"},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); frexp(vec2(p), p); imageStore(uOut, p, after(p));", false},
    {"imageStore(uOut, ivec2(gl_GlobalInvocationID.yx), after(ivec2(gl_GlobalInvocationID.xy)));", false},
    {"imageStore(uOut, ivec2(gl_GlobalInvocationID.xx), after(ivec2(0)));", false},
    {"imageStore(uOut, ivec2(gl_GlobalInvocationID.x), after(ivec2(0)));", false},
    {"imageStore(uOut, ivec2(gl_LocalInvocationID.xy), after(ivec2(0)));", false},
    {"imageStore(uOut, ivec2(gl_WorkGroupID.xy), after(ivec2(0)));", false},
    {"imageStore(uOut, ivec2(gl_GlobalInvocationID.xy * 2u), after(ivec2(gl_GlobalInvocationID.xy)));",
     false},
    {"imageStore(uOut, ivec2(vec2(gl_GlobalInvocationID.xy) * .5), after(ivec2(0)));", false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); { ivec2 p = ivec2(3, uOne); imageStore(uOut, p, after(p)); "
     "}",
     false},
    {"{ ivec2 p = ivec2(gl_GlobalInvocationID.xy); } imageStore(uOut, p, after(p));", false,
     "const ivec2 p = ivec2(2, 3);"},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\nif (p.x >= imageSize(uOut).x / 2) return;\n"
     "imageStore(uOut, p, after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\nif (p.x >= imageSize(uOut).y) return;\n"
     "imageStore(uOut, p, after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\nif (any(lessThan(p, imageSize(uOut) / 2))) return;\n"
     "imageStore(uOut, p, after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\nif (any(greaterThan(imageSize(uOut), p))) return;\n"
     "imageStore(uOut, p, after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\nif (!any(greaterThanEqual(p, imageSize(uOut)))) return;\n"
     "imageStore(uOut, p, after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\n"
     "if (any(greaterThanEqual(p, imageSize(uOut))) || p.x == 3) return;\nimageStore(uOut, p, after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\n"
     "if (all(lessThan(p, imageSize(uOut))) && p.x != 3) imageStore(uOut, p, after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\n"
     "if (all(lessThan(p, imageSize(uOut)))) { if (p.x == 3) return; imageStore(uOut, p, after(p)); }",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy);\nif (any(greaterThanEqual(p, ivec2(uOne * 9)))) return;\n"
     "imageStore(uOut, p, after(p));",
     false},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); bool is = p.x != 3 && store(p);", false,
     "bool store(ivec2 p) { imageStore(uOut, p, after(p)); return true; }"},
    {"store(ivec2(gl_GlobalInvocationID.xy));", false,
     "void store(ivec2 p) { if (p.x != 3) imageStore(uOut, p, after(p)); }"},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); STORE;", false,
     "#define STORE if (p.x != 3) imageStore(uOut, p, after(p))"},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); SKIP imageStore(uOut, p, after(p));", false,
     "#define SKIP if (p.x == 3) return;"},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); imageStore(uOut, p, after(p));", false,
     "void uOutStore(ivec2 p, uvec4 v) { imageStore(uOut, p, v); }\n"
     "#define imageStore(image, place, value) if (place.x != 3) image##Store(place, value)"},
    {"ivec2 p = ivec2(gl_GlobalInvocationID.xy); if (any(greaterThanEqual(p, imageSize(uOut)))) return;\n"
     "imageStore(uOut, p, after(p));",
     false, "bool any(bvec2 a) { return a.x || a.y || gl_GlobalInvocationID.x == 3u; }"},
    {"imageStore(uOut, ivec2(3, 4), after(ivec2(3, 4)));", false},
    {"", false},
});

}  // namespace glibra::test
