#include "plan/declared_uniform.h"

#include <utility>

#include "plan/uniform_members.h"

namespace glibra::plan {
namespace {

const glsl::DeclaredUniform* factOf(const ProgramInterface& interface, std::string_view name) {
    const auto declared = interface.facts.uniforms.find(std::string(name));
    return declared == interface.facts.uniforms.end() ? nullptr : &declared->second;
}

}  // namespace

int declaredElements(const ProgramInterface& interface, const ActiveUniform& uniform) {
    if (const auto* declared = factOf(interface, uniform.name)) return declared->arraySize;
    const auto member = searchMember(interface.facts.memory, uniform.name);
    return member ? member->elements : 0;
}

bool hasInitializer(const ProgramInterface& interface, const ActiveUniform& uniform) {
    const auto* declared = factOf(interface, rootName(uniform.name));
    return declared != nullptr && declared->hasInitializer;
}

const std::vector<std::string>* functionsOf(const ProgramInterface& interface, const ActiveUniform& uniform) {
    const auto* declared = factOf(interface, rootName(uniform.name));
    return declared == nullptr || declared->subroutines.empty() ? nullptr : &declared->subroutines;
}

std::optional<std::array<double, 9>> upperLeft(const GivenValue& given, const ActiveUniform& target,
                                               bool oneElement) {
    constexpr std::size_t kSide = 4;
    const bool isMat3 = target.type.columns == 3 && target.type.rows == 3 && (!target.isArray || oneElement);
    if (!isMat3 || given.form != glib::UniformForm::list || given.values.size() != kSide * kSide)
        return std::nullopt;
    std::array<double, 9> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = given.values[i / 3 * kSide + i % 3];
    return values;
}

bool isMatrixInstead(const GivenValue& given, const ActiveUniform& target, const NamedUniform& named) {
    return given.form == glib::UniformForm::list && (given.values.size() == 9 || given.values.size() == 16) &&
           !target.type.isOpaque() && target.type.columns == 1 && (!target.isArray || named.oneElement);
}

std::string_view describeValue(glsl::Builtin value) {
    using enum glsl::Builtin;
    constexpr std::pair<glsl::Builtin, std::string_view> kNames[] = {
        {modelView, "model-view matrix"},
        {projection, "projection matrix"},
        {modelViewProjection, "model-view-projection matrix"},
        {normalMatrix, "normal matrix"},
        {modelViewInverseTranspose, "inverse transpose of the model-view matrix"},
        {modelViewProjectionInverse, "inverse of the model-view-projection matrix"},
        {projectionInverse, "inverse of the projection matrix"},
        {model, "model matrix"},
        {modelInverse, "inverse of the model matrix"},
        {modelInverseTranspose, "inverse transpose of the model matrix"},
        {modelNormalMatrix, "normal matrix in world space"},
        {view, "view matrix"},
        {viewInverse, "inverse of the view matrix"},
        {viewProjection, "projection matrix times the view matrix"},
        {eyePosition, "position of the camera"},
    };
    for (const auto& [known, name] : kNames)
        if (known == value) return name;
    return "value that glibra supplies";
}

}  // namespace glibra::plan
