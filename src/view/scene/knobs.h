#pragma once
// The uniforms that a scene's Program lines set, as things to turn: one knob for each tag that reaches an
// active uniform.

#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "plan/frame_plan.h"
#include "scene/scene.h"

namespace glibra::view {

enum class Widget {
    slider,    ///< <min cur max>: one slider a component, integer steps for int and uint
    checkBox,  ///< <true>, <false>, and every value of a bool
    color,     ///< {r g b}, {r g b a}
    numbers    ///< constants: entry fields
};

struct Knob {
    scene::ProgramIndex program{};
    std::string title;  ///< of the program; numbered if the scene has several of that name
    std::string tag;
    plan::ValueType type;  ///< of one element
    Widget widget = Widget::numbers;
    glib::UniformForm form = glib::UniformForm::number;
    double minimum = 0, maximum = 1;  ///< sliders; values may lie outside
    std::vector<double> written;      ///< as the file gives them, the numbers between the brackets
    std::vector<double> initial;      ///< component by component, element by element
    std::vector<double> current;      ///< as long as `initial`
    Place place;                      ///< of the value in the scene
    bool isShared = false;            ///< another program has a uniform of that name, set by the scene or not
    std::string placeOfUniform;       ///< what the interface calls it, for the tooltip: "vec3 uColor"

    struct Binding {
        plan::PlannedProgramIndex program{};
        std::size_t value = 0;  ///< index into PlannedProgram::values
    };
    std::vector<Binding> bindings;

    [[nodiscard]] bool isInteger() const {
        return type.base == plan::BaseType::integer || type.base == plan::BaseType::unsignedInteger;
    }
    [[nodiscard]] bool isChanged() const { return current != initial; }
};

/// All knobs, program by program, in the order of the file.
std::vector<Knob> knobsOf(const scene::Scene& scene, const plan::FramePlan& plan);

/// Puts the knob's values where the plan has them. Returns the programs of the plan that have changed.
std::vector<plan::PlannedProgramIndex> apply(const Knob& knob, plan::FramePlan& plan);

/// Values as a user set them, which outlive a scene: they come back for every (program position, program
/// name, tag) whose specification in the file is the same.
class KeptValues {
  public:
    void keep(const scene::Scene& scene, std::span<const Knob> knobs);
    void restore(const scene::Scene& scene, std::span<Knob> knobs) const;
    void forget() { values_.clear(); }

  private:
    struct Kept {
        glib::UniformForm form{};
        std::vector<double> written, current;
    };
    std::map<std::tuple<scene::ProgramIndex, std::string, std::string>, Kept> values_;
};

/// "<0. .25 1.>": the knob's present value in the form that the file uses.
std::string valueText(const Knob& knob);
/// "uKd <0 .25 1>", the pair of one knob.
std::string pairText(const Knob& knob);
/// A Program statement with all knobs of that program.
std::string programLine(const scene::Scene& scene, scene::ProgramIndex program, std::span<const Knob> knobs);
/// "Dots:uKd=.25", or "uKd=.25" if no other program has the uniform; the shortest text that gives the value
/// back.
std::string setArgument(const scene::Scene& scene, const Knob& knob, std::span<const Knob> knobs);

}  // namespace glibra::view
