#pragma once
// The uniforms that a scene's Program lines set, as controls: one knob per tag that reaches an active
// uniform.

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plan/frame_plan.h"
#include "scene/scene.h"

namespace glibra::render {

enum class Widget {
    slider,    ///< <min cur max>: one slider per component, integer steps for int and uint
    checkBox,  ///< <true>, <false>, and every value of a bool
    color,     ///< {r g b}, {r g b a}
    numbers    ///< constants: entry fields
};

struct Knob {
    scene::ProgramIndex program{};  ///< none: a variable of the scene
    std::string title;              ///< the program's name; numbered if several programs have that name
    std::string tag;
    plan::ValueType type;  ///< of one element
    Widget widget = Widget::numbers;
    glib::UniformForm form = glib::UniformForm::number;
    double minimum = 0, maximum = 1;  ///< of sliders; values may lie outside
    std::vector<double> written;      ///< the numbers between the brackets, as the file has them
    std::vector<double> initial;      ///< all components of the first array element, then of the next
    std::vector<double> current;      ///< same order and size as `initial`
    Place place;                      ///< of the value in the scene
    bool isShared = false;  ///< another program has a uniform of this name, whether the scene sets it or not
    bool isUnset = false;   ///< nothing of the scene sets it, so that it is 0; only unsetKnobs() has these
    std::string declaration;  ///< type and name for the tooltip: "vec3 uColor"

    std::vector<std::string> words;  ///< of a variable that is a choice; the value counts them from 0
    std::optional<scene::Variable::Fineness> bound{};  ///< of a variable that Bound declares

    [[nodiscard]] bool isInteger() const {
        return type.base == plan::BaseType::integer || type.base == plan::BaseType::unsignedInteger;
    }
    [[nodiscard]] bool isChanged() const { return current != initial; }
};

/// All knobs of these plans of the scene, grouped by program, in the order of the file.
std::vector<Knob> knobsOf(const scene::Scene& scene, std::span<const plan::FramePlan* const> plans);

/// The same of uniforms that nothing sets: neither the scene nor an initializer, glibra or a buffer.
std::vector<Knob> unsetKnobs(const scene::Scene& scene, std::span<const plan::FramePlan* const> plans);

/// Values that several programs have in common: one control moves them all. Each entry has the indices of
/// knobs of different programs that the scene gives the same tag, type, range and value; two at least, in
/// their order. Variables of the scene are in none.
std::vector<std::vector<std::size_t>> sharedKnobs(std::span<const Knob> knobs);

/// Writes the knobs' values into a plan. Returns the planned programs that have changed.
std::vector<plan::PlannedProgramIndex> apply(const scene::Scene& scene, std::span<const Knob> knobs,
                                             plan::FramePlan& plan);

/// The values that a user has set, kept while a scene is read again. A value returns if the program, the tag
/// and the specification in the file are the same. Programs are known by their names, and those of one name
/// by their order. Between two programs that stay, programs are renamed if as many names are gone as are new,
/// in their order.
class KeptValues {
  public:
    void keep(const scene::Scene& scene, std::span<const Knob> knobs);
    void restore(const scene::Scene& scene, std::span<Knob> knobs);
    void forget() { values_.clear(); }
    /// As JSON, for another run of the program; empty if there are no values.
    [[nodiscard]] std::string text() const;
    /// No values if the text is not of text().
    static KeptValues ofText(std::string_view text);

  private:
    /// The name, and the index among the programs of that name; empty for variables.
    using Owner = std::pair<std::string, int>;
    static std::vector<Owner> ownersOf(const scene::Scene& scene);
    void rename(const std::vector<Owner>& now);

    struct Kept {
        glib::UniformForm form{};
        std::vector<double> written, current;
    };
    std::map<std::pair<Owner, std::string>, Kept> values_;
    std::vector<Owner> owners_;  ///< the programs of the scene that keep() was called with, in its order
};

/// "<0 0.25 1>": the knob's current value in the form that the file uses.
std::string valueText(const Knob& knob);
/// "uKd <0 0.25 1>": the knob's tag and value.
std::string pairText(const Knob& knob);
/// A Program statement with all knobs of that program; for none, the Let statements of all variables.
std::string programLine(const scene::Scene& scene, scene::ProgramIndex program, std::span<const Knob> knobs);
/// How the label of the value begins: "Dots : uKd = " (labelsOf).
std::string labelBegin(const Knob& knob);
/// The labels that begin so; all if `only` is empty.
std::vector<std::string> onlyLabels(std::vector<std::string> labels, std::span<const std::string> only);
/// An argument for `--set`: "uKd=0.25", or "8:uKd=0.25" with the line of the Program command if another
/// program has the uniform too. The numbers are the shortest text that reads back as the same value.
std::string setArgument(const scene::Scene& scene, const Knob& knob, std::span<const Knob> knobs);

/// A knob as JSON, for the pages that show its control:
/// { "owner": the program or "", "name", "widget": "slider", "checkBox", "color" or "numbers", "declaration":
///   as "vec3 uColor", "isInteger", "isShared": other programs have it, too, "minimum", "maximum",
///   "components": of one element of an array, "initial": [numbers], "current": [numbers],
///   "words": [of a choice] }
nlohmann::ordered_json jsonOf(const Knob& knob);

}  // namespace glibra::render
