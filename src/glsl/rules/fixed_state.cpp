// Lights, materials, fog and other state of the fixed pipeline, with GL's initial values: uniform variables
// where scenes can set them, otherwise constants (language, 7.6; OpenGL 2.1 specification, state tables 6.9
// to 6.11 and 6.22).

#include <algorithm>
#include <array>

#include "glsl/rules/rules.h"
#include "glsl/types/builtins.h"

namespace glibra::glsl {
namespace {

struct Structure {
    std::string_view user;
    std::string_view definition;
};
constexpr std::array kStructures = std::to_array<Structure>({
    {"gl_LightSourceParameters",
     "struct glibra_LightSourceParameters { vec4 ambient, diffuse, specular, position, halfVector; vec3 "
     "spotDirection; "
     "float spotExponent, spotCutoff, spotCosCutoff, constantAttenuation, linearAttenuation, "
     "quadraticAttenuation; };"},
    {"gl_LightModelParameters", "struct glibra_LightModelParameters { vec4 ambient; };"},
    {"gl_MaterialParameters",
     "struct glibra_MaterialParameters { vec4 emission, ambient, diffuse, specular; float shininess; };"},
    {"gl_LightModelProducts", "struct glibra_LightModelProducts { vec4 sceneColor; };"},
    {"gl_LightProducts", "struct glibra_LightProducts { vec4 ambient, diffuse, specular; };"},
    {"gl_FogParameters", "struct glibra_FogParameters { vec4 color; float density, start, end, scale; };"},
    {"gl_PointParameters",
     "struct glibra_PointParameters { float size, sizeMin, sizeMax, fadeThresholdSize, "
     "distanceConstantAttenuation, "
     "distanceLinearAttenuation, distanceQuadraticAttenuation; };"},
});

struct Value {
    std::string_view user;
    std::string_view structure;  ///< the user's name of the type, or a plain type
    int size;                    ///< the array size; 0: no array
    std::string_view first;      ///< the value; of an array, that of element 0
    std::string_view others;
};
constexpr std::string_view kLight0 =
    "glibra_LightSourceParameters(vec4(0., 0., 0., 1.), vec4(1.), vec4(1.), vec4(0., 0., 1., 0.), vec4(0., "
    "0., 1., 0.), "
    "vec3(0., 0., -1.), 0., 180., -1., 1., 0., 0.)";
constexpr std::string_view kLight =
    "glibra_LightSourceParameters(vec4(0., 0., 0., 1.), vec4(0., 0., 0., 1.), vec4(0., 0., 0., 1.), vec4(0., "
    "0., 1., 0.), "
    "vec4(0., 0., 1., 0.), vec3(0., 0., -1.), 0., 180., -1., 1., 0., 0.)";
constexpr std::string_view kMaterial =
    "glibra_MaterialParameters(vec4(0., 0., 0., 1.), vec4(.2, .2, .2, 1.), vec4(.8, .8, .8, 1.), vec4(0., "
    "0., 0., 1.), 0.)";
constexpr std::string_view kScene = "glibra_LightModelProducts(vec4(.04, .04, .04, 1.))";
constexpr std::string_view kProduct0 =
    "glibra_LightProducts(vec4(0., 0., 0., 1.), vec4(.8, .8, .8, 1.), vec4(0., 0., 0., 1.))";
constexpr std::string_view kProduct =
    "glibra_LightProducts(vec4(0., 0., 0., 1.), vec4(0., 0., 0., 1.), vec4(0., 0., 0., 1.))";
constexpr std::string_view kPlaneS = "vec4(1., 0., 0., 0.)";
constexpr std::string_view kPlaneT = "vec4(0., 1., 0., 0.)";
constexpr std::string_view kZero = "vec4(0.)";

constexpr std::array kValues = std::to_array<Value>({
    {"gl_LightSource", "gl_LightSourceParameters", 8, kLight0, kLight},
    {"gl_LightModel", "gl_LightModelParameters", 0, "glibra_LightModelParameters(vec4(.2, .2, .2, 1.))", ""},
    {"gl_FrontMaterial", "gl_MaterialParameters", 0, kMaterial, ""},
    {"gl_BackMaterial", "gl_MaterialParameters", 0, kMaterial, ""},
    {"gl_FrontLightModelProduct", "gl_LightModelProducts", 0, kScene, ""},
    {"gl_BackLightModelProduct", "gl_LightModelProducts", 0, kScene, ""},
    {"gl_FrontLightProduct", "gl_LightProducts", 8, kProduct0, kProduct},
    {"gl_BackLightProduct", "gl_LightProducts", 8, kProduct0, kProduct},
    {"gl_Fog", "gl_FogParameters", 0, "glibra_FogParameters(vec4(0.), 1., 0., 1., 1.)", ""},
    {"gl_Point", "gl_PointParameters", 0,
     "glibra_PointParameters(glibra_PointSize, 0., 255., 1., 1., 0., 0.)", ""},
    {"gl_ClipPlane", "vec4", 8, kZero, kZero},
    {"gl_TextureEnvColor", "vec4", 8, kZero, kZero},
    {"gl_EyePlaneS", "vec4", 8, kPlaneS, kPlaneS},
    {"gl_EyePlaneT", "vec4", 8, kPlaneT, kPlaneT},
    {"gl_EyePlaneR", "vec4", 8, kZero, kZero},
    {"gl_EyePlaneQ", "vec4", 8, kZero, kZero},
    {"gl_ObjectPlaneS", "vec4", 8, kPlaneS, kPlaneS},
    {"gl_ObjectPlaneT", "vec4", 8, kPlaneT, kPlaneT},
    {"gl_ObjectPlaneR", "vec4", 8, kZero, kZero},
    {"gl_ObjectPlaneQ", "vec4", 8, kZero, kZero},
    {"gl_NormalScale", "float", 0, "1.", ""},
});

/// What Light and Material set.
constexpr std::array<std::string_view, 4> kSettable = {"gl_LightSource", "gl_LightModel", "gl_FrontMaterial",
                                                       "gl_BackMaterial"};

bool isSettable(std::string_view user) {
    return std::ranges::find(kSettable, user) != kSettable.end();
}
/// "gl_FrontLightModelProduct" and "gl_FrontLightProduct", which GL computes from what is settable.
bool isProduct(std::string_view user) {
    return user.ends_with("Product");
}

constexpr std::array<std::string_view, 4> kFixedLimits = {"gl_MaxLights", "gl_MaxClipPlanes",
                                                          "gl_MaxTextureUnits", "gl_MaxTextureCoords"};

class FixedState {
  public:
    FixedState(Unit& unit, Report& report) : unit_(unit), report_(report) {}

    void run() {
        for (const Structure& each : kStructures)
            if (isWanted(each.user)) {
                unit_.declare(std::string(each.definition));
                unit_.renames[std::string(each.user)] = emittedName(each.user);
            }
        for (const Value& each : kValues)
            if (isWanted(each.user)) value(each);
        for (const std::string_view each : kFixedLimits)
            if (isWanted(each)) {
                unit_.declare("const int " + emittedName(each) + " = 8;");
                unit_.renames[std::string(each)] = emittedName(each);
            }
        if (isWanted("gl_MaxVaryingFloats")) unit_.renames["gl_MaxVaryingFloats"] = "gl_MaxVaryingComponents";
    }

  private:
    /// True if the stage contains the name. A type name does not count as a use, so all words are searched.
    [[nodiscard]] bool isWanted(std::string_view name) {
        if (words_.empty())
            for (const ViewToken& each : unit_.view)
                if (each.kind == TokenKind::word && each.text.starts_with("gl_")) words_.insert(each.text);
        return words_.contains(name);
    }

    void value(const Value& row) {
        std::string type(row.structure);
        for (const Structure& each : kStructures)
            if (each.user == row.structure) {
                unit_.declare(std::string(each.definition));
                type = emittedName(each.user);
            }
        if (unit_.request->hasLights && isProduct(row.user)) return product(row, type);
        const bool isUniform = unit_.request->hasLights && isSettable(row.user);
        const bool point = row.user == "gl_Point";
        if (point) unit_.declare("uniform float glibra_PointSize;");
        std::string text(row.first);
        if (row.size > 0) {
            text = type + "[" + std::to_string(row.size) + "](" + text;
            for (int i = 1; i < row.size; ++i) text += ", " + std::string(row.others);
            text += ")";
        }
        const std::string size = row.size > 0 ? "[" + std::to_string(row.size) + "]" : "";
        unit_.declare((isUniform ? "uniform "
                       : point   ? ""
                                 : "const ") +
                      type + " " + emittedName(row.user) + size + " = " + text + ";");
        unit_.renames[std::string(row.user)] = emittedName(row.user);
        if (unit_.request->setsLights && isSettable(row.user)) return;
        const auto use = unit_.uses.find(row.user);
        report_.reportOnce(
            unit_.path + std::string(row.user), "glsl-W04",
            std::string(row.user) + " has GL's initial values; scenes define no " + what(row.user),
            use == unit_.uses.end() ? unit_.start() : unit_.place(use->second.front()));
    }

    void product(const Value& row, const std::string& type) {
        const std::string material =
            row.user.starts_with("gl_Front") ? "glibra_FrontMaterial" : "glibra_BackMaterial";
        for (const Value& each : kValues)
            if (emittedName(each.user) == material ||
                each.user == (row.size > 0 ? "gl_LightSource" : "gl_LightModel"))
                value(each);
        std::string text;
        if (row.size == 0) {
            text =
                type + "(" + material + ".emission + " + material + ".ambient * glibra_LightModel.ambient)";
        } else {
            text = type + "[" + std::to_string(row.size) + "](";
            for (int i = 0; i < row.size; ++i) {
                const std::string light = "glibra_LightSource[" + std::to_string(i) + "].";
                text += (i > 0 ? ", " : "") + type + "(";
                for (const char* member : {"ambient", "diffuse", "specular"})
                    text += (*member == 'a' ? "" : ", ") + (material + "." + member) + " * " + light + member;
                text += ")";
            }
            text += ")";
        }
        unit_.declare(type + " " + emittedName(row.user) +
                      (row.size > 0 ? "[" + std::to_string(row.size) + "]" : "") + " = " + text + ";");
        unit_.renames[std::string(row.user)] = emittedName(row.user);
    }

    static std::string what(std::string_view user) {
        if (user.find("Light") != std::string_view::npos) return "lights";
        if (user.find("Material") != std::string_view::npos) return "materials";
        if (user == "gl_Fog") return "fog";
        if (user == "gl_Point") return "point parameters but the size";
        if (user.find("Plane") != std::string_view::npos) return "planes";
        return "such state";
    }

    Unit& unit_;
    Report& report_;
    std::set<std::string_view> words_;
};

}  // namespace

void supplyFixedState(Unit& unit, Report& report) {
    FixedState(unit, report).run();
}

}  // namespace glibra::glsl
