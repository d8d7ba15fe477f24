#include "render/load/gl_names.h"

namespace glibra::render {

GLenum glStage(glsl::Stage stage) {
    switch (stage) {
        case glsl::Stage::vertex:
            return GL_VERTEX_SHADER;
        case glsl::Stage::tessControl:
            return GL_TESS_CONTROL_SHADER;
        case glsl::Stage::tessEvaluation:
            return GL_TESS_EVALUATION_SHADER;
        case glsl::Stage::geometry:
            return GL_GEOMETRY_SHADER;
        case glsl::Stage::compute:
            return GL_COMPUTE_SHADER;
        case glsl::Stage::fragment:
            break;
    }
    return GL_FRAGMENT_SHADER;
}

GLenum glMode(const plan::Submission& submission) {
    using geometry::ListTopology;
    if (submission.strip) switch (*submission.strip) {
            case ListTopology::lineStrip:
                return GL_LINE_STRIP;
            case ListTopology::lineLoop:
                return GL_LINE_LOOP;
            case ListTopology::triangleStrip:
            case ListTopology::quadStrip:  // covers the same area
                return GL_TRIANGLE_STRIP;
            case ListTopology::triangleFan:
            case ListTopology::polygon:
                return GL_TRIANGLE_FAN;
            case ListTopology::lineStripAdjacency:
                return GL_LINE_STRIP_ADJACENCY;
            case ListTopology::triangleStripAdjacency:
                return GL_TRIANGLE_STRIP_ADJACENCY;
            default:
                break;
        }
    switch (submission.topology) {
        case geometry::Topology::points:
            return GL_POINTS;
        case geometry::Topology::lines:
            return GL_LINES;
        case geometry::Topology::linesAdjacency:
            return GL_LINES_ADJACENCY;
        case geometry::Topology::triangles:
            return GL_TRIANGLES;
        case geometry::Topology::trianglesAdjacency:
            return GL_TRIANGLES_ADJACENCY;
        case geometry::Topology::patches:
            break;
    }
    return GL_PATCHES;
}

}  // namespace glibra::render
