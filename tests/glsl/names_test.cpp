// The tables of names that glibra supplies, and of names that books and frameworks use.

#include <gtest/gtest.h>

#include <set>
#include <tuple>
#include <utility>

#include "glsl/read/words.h"
#include "glsl/types/builtins.h"

namespace glibra::glsl {
namespace {

bool isSupplied(std::string_view name) {
    return findBuiltinUniform(name) != nullptr || findBuiltinInput(name) != nullptr;
}

TEST(WellKnownNames, UniformsAreUniqueAndClassicNamesStayClassic) {
    std::set<std::tuple<std::string_view, std::string_view, std::string_view>> seen;
    for (const WellKnownUniform& row : wellKnownUniforms()) {
        EXPECT_TRUE(seen.insert({row.name, row.type, row.beside}).second) << row.name;
        EXPECT_TRUE(row.type == "mat4" || row.type == "mat3" || row.type == "vec3") << row.name;
        EXPECT_FALSE(isSupplied(row.name)) << row.name;
        EXPECT_EQ(0, keywordSince(row.name)) << row.name;
        // The first row that fits wins, so a row with a condition must come before the one without.
        const auto always = [](std::string_view) { return true; };
        const WellKnownUniform* found = findWellKnownUniform(row.name, row.type, always);
        ASSERT_NE(nullptr, found);
        EXPECT_TRUE(found == &row || !found->beside.empty()) << row.name;
    }
    EXPECT_GT(seen.size(), 150U);
}

TEST(WellKnownNames, InputsAreUniqueAndClassicNamesStayClassic) {
    std::set<std::string_view> seen;
    for (const WellKnownInput& row : wellKnownInputs()) {
        EXPECT_TRUE(seen.insert(row.name).second) << row.name;
        EXPECT_FALSE(isSupplied(row.name)) << row.name;
        EXPECT_EQ(0, keywordSince(row.name)) << row.name;
        ASSERT_FALSE(inputTypes(row.attribute).empty()) << row.attribute;
        for (const std::string_view type : inputTypes(row.attribute)) {
            EXPECT_TRUE(isTypeWord(type));
            EXPECT_EQ(&row, findWellKnownInput(row.name, type));
        }
        EXPECT_EQ(nullptr, findWellKnownInput(row.name, "ivec4"));
    }
    EXPECT_GT(seen.size(), 100U);
}

struct Known {
    const char *name, *type;
    Builtin value;
};

TEST(WellKnownNames, MatricesOfTheBooks) {
    using enum Builtin;
    const Known known[] = {
        // Gordon and Clevenger
        {"mv_matrix", "mat4", modelView},
        {"p_matrix", "mat4", projection},
        {"proj_matrix", "mat4", projection},
        {"m_matrix", "mat4", model},
        {"v_matrix", "mat4", view},
        {"norm_matrix", "mat4", modelViewInverseTranspose},
        {"mvp", "mat4", modelViewProjection},
        // learnopengl.com
        {"model", "mat4", model},
        {"view", "mat4", view},
        {"projection", "mat4", projection},
        {"viewPos", "vec3", eyePosition},
        // three.js
        {"modelViewMatrix", "mat4", modelView},
        {"projectionMatrix", "mat4", projection},
        {"normalMatrix", "mat3", normalMatrix},
        {"cameraPosition", "vec3", eyePosition},
        // Rost
        {"MVMatrix", "mat4", modelView},
        {"MVPMatrix", "mat4", modelViewProjection},
        {"NormalMatrix", "mat3", normalMatrix},
        // Wolff
        {"ModelViewMatrix", "mat4", modelView},
        {"ProjectionMatrix", "mat4", projection},
        {"MVP", "mat4", modelViewProjection},
        {"u_modelViewProjectionMatrix", "mat4", modelViewProjection},
        {"u_normalMatrix", "mat4", modelViewInverseTranspose},
    };
    for (const Known& each : known) {
        const WellKnownUniform* row = findWellKnownUniform(each.name, each.type);
        ASSERT_NE(nullptr, row) << each.name;
        EXPECT_EQ(each.value, row->value) << each.name;
    }
    EXPECT_EQ(nullptr, findWellKnownUniform("model", "mat3"));
    EXPECT_EQ(nullptr, findWellKnownUniform("model", "int"));
    EXPECT_EQ(nullptr, findWellKnownUniform("uModelViewMatrix", "mat4"));
}

TEST(WellKnownNames, NormalsAreInTheSpaceOfTheOtherMatrix) {
    const auto has = [](std::string_view wanted) {
        return [wanted](std::string_view name) { return name == wanted; };
    };
    EXPECT_EQ(Builtin::modelInverseTranspose,
              findWellKnownUniform("norm_matrix", "mat4", has("m_matrix"))->value);
    EXPECT_EQ(Builtin::modelViewInverseTranspose,
              findWellKnownUniform("norm_matrix", "mat4", has("mv_matrix"))->value);
}

TEST(WellKnownNames, VertexInputsOfTheBooks) {
    const std::pair<const char*, const char*> known[] = {
        {"vertPos", "position"},    {"vertNormal", "normal"},
        {"texCoord", "texCoord"},   {"tc", "texCoord"},
        {"MCvertex", "position"},   {"position", "position"},
        {"normal", "normal"},       {"uv", "texCoord"},
        {"texcoord", "texCoord"},   {"vertex_normal", "normal"},
        {"aPos", "position"},       {"aTexCoords", "texCoord"},
        {"inPosition", "position"}, {"VertexPosition", "position"}};
    for (const auto& [name, attribute] : known) {
        const WellKnownInput* row = findWellKnownInput(name, "vec3");
        ASSERT_NE(nullptr, row) << name;
        EXPECT_EQ(attribute, row->attribute) << name;
    }
    EXPECT_EQ(nullptr, findWellKnownInput("normal", "vec2"));
    EXPECT_EQ(nullptr, findWellKnownInput("aNormal", "vec3"));  // a classic name
}

}  // namespace
}  // namespace glibra::glsl
