// Macros that expand to translated names, and unusual layouts of the text.

#include "case.h"

namespace glibra::oracle {

std::vector<Case> casesOfMacros() {
    return {
        {.name = "macros_that_stand_for_built_in_names",
         .stages = {.vertex = R"glsl(
#version 110
#define POSITION gl_Vertex
#define TRANSFORM(v) (gl_ModelViewProjectionMatrix * (v))
#define PASS varying
#define ATTRIBUTE(type, name) attribute type name
#define LIGHT(i, what) gl_LightSource[i].what
#define TEXTURE_COORDINATE(n) gl_TexCoord[n]
PASS vec3 vNormal;
ATTRIBUTE(vec3, Tangent);
void main() {
    vNormal = gl_NormalMatrix * gl_Normal + .2 * Tangent;
    TEXTURE_COORDINATE(1) = gl_MultiTexCoord0;
    gl_FrontColor = LIGHT(0, diffuse) * LIGHT(0, position).z * .5;
    gl_Position = TRANSFORM(POSITION);
}
)glsl",
                    .fragment = R"glsl(
#version 110
#define OUT gl_FragColor
#define LOOKUP texture2D
#define SECOND gl_TexCoord[1]
#define SHADE(n) \
    (gl_Color.rgb * \
     (.5 + .5 * (n)))
uniform sampler2D uPicture;
varying vec3 vNormal;
void main() { OUT = vec4(SHADE(normalize(vNormal)), 1.) * .5 + LOOKUP(uPicture, SECOND.st) * .5; }
)glsl"},
         .before = "Texture2D 5 pattern.png\n",
         .tags = "uPicture 5"},
        {.name = "macros_that_are_redefined_or_named_like_later_words",
         .stages = {.vertex = R"glsl(
#version 130
#define OUTPUT out
OUTPUT vec3 vPoint;
#undef OUTPUT
#define OUTPUT gl_Position
void main() {
    vPoint = gl_Vertex.xyz;
    OUTPUT = gl_ModelViewProjectionMatrix * gl_Vertex;
    gl_FrontColor = vec4(gl_MultiTexCoord0.st, 0., 1.);
}
)glsl",
                    .fragment = R"glsl(
#version 130
#define sample(x) fract((x) * 3.)
#define texture vPoint.yz
in vec3 vPoint;
void main() { gl_FragColor = vec4(gl_Color.r, sample(vPoint.x), texture.x, 1.); }
)glsl"}},
        {.name = "macros_and_branches_by_version",
         .stages = {.vertex = R"glsl(
#version 120
#if __VERSION__ >= 130
out vec3 vPoint;
#define MODERN 1
#else
varying vec3 vPoint;
#endif
#ifdef GL_compatibility_profile
#define SIGN 1.
#else
#define SIGN 1.0
#endif
#if defined(MODERN) || !defined(GL_ES) && __VERSION__ == 120
#line 100
#define WHOLE gl_Vertex
#elif 1
#define WHOLE this is not read
#endif
#if 0
varying float vNever; gl_ModelViewMatrix @ '
#endif
void main() {
    vPoint = SIGN * WHOLE.xyz;
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
#version 120
#ifndef GL_FRAGMENT_PRECISION_HIGH_NOT_DEFINED_ANYWHERE
varying vec3 vPoint;
#endif
#define BANDS 4 /* of them
                   on the way */
#define BAND(p) (floor((p) * float(BANDS)) / float(BANDS))  // to a step
void main() {
    gl_FragColor = vec4(.5 + .5 * BAND(vPoint), 1.);
#if (BANDS > 3) && defined BAND
    gl_FragColor.b *= .5;
#endif
}
)glsl"}},
        {.name = "macros_around_functions_and_outputs",
         .stages = {.vertex = R"glsl(
#version 110
varying vec3 vPoint;
#define MAIN void main()
#define END_WITH(p) gl_Position = p; return
MAIN {
    vPoint = gl_Vertex.xyz;
    gl_FrontColor = vec4(2. * gl_Normal, 1.);
    if (gl_Vertex.x > 9.) { END_WITH(vec4(0.)); }
    END_WITH(ftransform());
}
)glsl",
                    .fragment = R"glsl(
#version 110
varying vec3 vPoint;
#define RETURN(c) { gl_FragColor = vec4(c, 1.); return; }
void main() {
    if (vPoint.y > .3) RETURN(gl_Color.rgb)
    else if (vPoint.x > 0.) RETURN(fract(2. * vPoint))
    RETURN(.5 + .5 * vPoint)
}
)glsl"}},
        {.name = "macro_calls_over_lines_and_inside_each_other",
         .stages = {.vertex = R"glsl(
#version 130
#define JOIN(a, b) a##b
#define IN_TURN(f, x) f(x)
#define TWICE(x) (2. * (x))
#define SELF SELF
#define PAIR(a, b) vec2(a, b)
#define FIRST(a, b) a
#define EMPTY
out vec3 JOIN(v, Point);
void main() {
    float SELF = .25;
    vPoint = vec3(PAIR(
        FIRST(gl_Vertex.x, (1., 2.)),  // a comment, with a comma
        IN_TURN(
            TWICE
            ,
            gl_Vertex.y
        ) * SELF
    ), FIRST(EMPTY .3, EMPTY));
    gl_Position = ftransform();
}
)glsl",
                    .fragment = R"glsl(
#version 130
#ifdef GL_core_profile
#error not at 1.30
#endif
#ifndef GL_compatibility_profile
in vec3 vPoint;
#endif
#define WAVE(x) .5 + .5 * sin(x)
#define COLOR(r, \
              g, b) vec4(r, g, b, 1.)
void main() {
    gl_FragColor = COLOR(WAVE(3. * vPoint.x),
                         WAVE(WAVE(vPoint.y)), vPoint.z);
}
)glsl"}},
        {.name = "text_in_unusual_layout",
         .stages = {.vertex = "/* a comment before it */\n"
                              "# version 110  // and one after it\r\n"
                              "varying\n    vec3 // of the vertex\r\n  vPoint ; "
                              "attribute /* a */ float /* b */ FaceIndex;\r\n"
                              "void main ( void )\r\n{\r\n  vPoint=gl_Vertex . xyz+FaceIndex ;\r\n"
                              "  gl_Position=gl_ProjectionMatrix\n*gl_ModelViewMatrix*/**/gl_Vertex;\r\n}",
                    .fragment = "varying vec3 vPoint;void main(){gl_FragColor=vec4(.5+vPoint*.5e0,1.E0);"
                                "gl_FragColor.stpq=gl_FragColor.pstq;"
                                "if(vPoint.x>float(0x0))\n;gl_FragColor.r+=float(017)*.01;}"}},
    };
}

}  // namespace glibra::oracle
