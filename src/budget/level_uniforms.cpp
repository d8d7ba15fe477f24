#include "budget/level_uniforms.h"

#include <algorithm>
#include <variant>

namespace glibra::budget {

std::vector<LevelUniform> levelUniforms(const plan::PlannedProgram& program, double mostLevel) {
    std::vector<LevelUniform> found;
    for (const plan::UniformBinding& binding : program.values) {
        const auto* literal = std::get_if<plan::Literal>(&binding.value);
        if (!literal || literal->values.size() != 1 || !(literal->values[0] > 0)) continue;
        const plan::ActiveUniform& uniform = at(program.interface->uniforms, binding.uniform);
        if (!program.interface->facts.levelUniforms.contains(uniform.name)) continue;
        LevelUniform level{binding.uniform, literal->values[0], 1, mostLevel};
        for (const plan::Control& control : program.controls)
            if (control.uniform == binding.uniform && control.maximum > 0) {
                level.least = std::max(control.minimum, std::min(1., control.maximum));
                level.most = control.maximum;
            }
        found.push_back(level);
    }
    return found;
}

}  // namespace glibra::budget
