#pragma once
// What a scene executes, in order, as values: passes with their draws, dispatches, clears of objects.

#include <glibra/diagnostic.h>
#include <glibra/draw_id.h>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/raster_state.h"
#include "base/shared.h"
#include "scene/objects.h"

namespace glibra::scene {

class ConditionNames;

struct Perspective {
    double fieldOfView = 50;  ///< vertical, full angle, degrees
    double near = .1, far = 1000;
    friend bool operator==(const Perspective&, const Perspective&) = default;
};
struct Orthographic {
    double left = -3, right = 3, bottom = -3, top = 3, near = -1000, far = 1000;
    friend bool operator==(const Orthographic&, const Orthographic&) = default;
};
/// Positions are clip coordinates: no matrix acts on them. A fragment stage without a vertex stage of its own
/// may still ask for the matrices of the camera.
struct ClipSpace {
    std::variant<Perspective, Orthographic, glm::dmat4> projection = glm::dmat4(1.0);
    glm::dmat4 view{1.0};
    bool hasStage = false;  ///< a vertex stage that covers the target belongs to it, for programs without one
    friend bool operator==(const ClipSpace&, const ClipSpace&) = default;
};
/// A matrix is taken as it is, whatever the shape of the target.
using Projection = std::variant<Perspective, Orthographic, glm::dmat4, ClipSpace>;

/// A classic scene sets little of it, but each draw carries all of it.
using base::RasterState;

/// One geometry command with its complete state.
struct Draw {
    DrawId id;
    Place place;
    std::string word;  ///< the command as written, or the topology of a glBegin list; for messages
    ShapeIndex shape{};
    ProgramIndex program{};
    glm::dmat4 modelView{1.0};
    glm::dmat4 model{1.0};  ///< the transforms below the camera; modelView is the camera's view times it
    base::Shared<Projection> projection;
    glm::dvec4 color{1.0};
    base::Shared<RasterState> raster;
    int patchVertices = 3;
    bool flatColors = false;
    Sampling sampling;
    SlotTableIndex slots{};
    UniformSetIndex uniforms{};  ///< none: only those of the program
    double timerPeriod = 10;
    std::size_t givenNumbers = 0;  ///< how many of the shape's numbers the scene gives; the rest are defaults
    // The rest is of modern scenes.
    int instances = 1;
    CountFrom instancesFrom{};       ///< the number of instances
    CountFrom verticesFrom{};        ///< of `Vertices`: the number of vertices
    BufferView indices{};            ///< of `Vertices`: 32-bit numbers of the vertices, in order
    bool drawsAllIndices = false;    ///< as many vertices as that buffer has elements
    AttributeSetIndex attributes{};  ///< none: only those of the mesh
    std::optional<std::array<double, 6>> tessellationLevels{};  ///< four outer and two inner ones
    bool isSky = false;                                         ///< the eye is at the origin of modelView
    bool isFill = false;  ///< of `Fill`: stages that the program inherits are left out (Program::hasStage)
    /// The buffers that the draw reads besides those of its program and its attributes; some may be none.
    [[nodiscard]] std::array<BufferView, 3> ownBuffers() const {
        return {instancesFrom.buffer, verticesFrom.buffer, indices};
    }
    friend bool operator==(const Draw&, const Draw&) = default;
};

/// Clears parts of the target. A Clear that only repeats the implicit clear of the pass is left out.
struct Clear {
    Place place;
    std::optional<glm::dvec4> color{glm::dvec4(0.0)};  ///< of all colour targets
    bool depth = true;
    bool stencil = false;
    friend bool operator==(const Clear&, const Clear&) = default;
};

/// A part of a texture as a target.
struct TargetPart {
    std::optional<int> level{}, layer{};  ///< as in TextureView; without a layer all layers
    friend auto operator<=>(const TargetPart&, const TargetPart&) = default;
};

/// A pass without what it draws. The implicit clear of the language (2.3) is in `clearColors`, `clearDepth`
/// and `clearStencil`.
struct PassSetup {
    std::vector<TextureIndex> targets;  ///< of the colours
    std::vector<TargetPart> parts;      ///< one per target; empty: level 0 of all
    std::optional<TextureView> depth;   ///< nothing: `depthBuffer`
    bool isWindow = true;
    int depthBuffer = 0;  ///< passes with the same number share depth; 0 is the window's
    std::vector<std::optional<glm::dvec4>>
        clearColors;          ///< one per target (the window has one); nothing: the content is kept
    bool isReversed = false;  ///< the depth buffer holds one minus the depth
    bool clearDepth = false;
    double depthValue = 1;              ///< that clearDepth sets, before it is mirrored
    std::optional<int> clearStencil{};  ///< nothing: the content is kept, or there is no stencil
    Place place;                        ///< of RenderToTexture or Pass, for messages
    std::string camera{};               ///< of `from`; empty: `eye`
    /// The camera that `camera` is derived from by Reflect and Shift; empty: `eye`. What moves that one moves
    /// this one, too.
    std::string rootCamera{};
    glm::dmat4 shift{1.0};  ///< view of `camera` = shift * view of the root * reflections
    friend bool operator==(const PassSetup&, const PassSetup&) = default;
};

/// Drawing into one target list.
struct Pass : PassSetup {
    std::deque<std::variant<Draw, Clear>> steps;
};

/// As many invocations as the object has texels or elements, or as these three numbers say.
struct Over {
    std::variant<std::array<std::uint64_t, 3>, ObjectView> what;
    friend bool operator==(const Over&, const Over&) = default;
};
/// Three group counts that a buffer holds.
struct GroupsFrom {
    CountFrom first;
    friend bool operator==(const GroupsFrom&, const GroupsFrom&) = default;
};

/// Runs a compute program.
struct Dispatch {
    DrawId id;
    Place place;
    ProgramIndex program{};
    SlotTableIndex slots{};
    Sampling sampling;
    UniformSetIndex uniforms{};
    std::variant<std::array<std::uint64_t, 3>, Over, GroupsFrom> groups;  ///< the first: group counts
    int tiles = 1;  ///< parts that run one after the other, along the last dimension with several groups
    bool discards = false;  ///< what it writes with history begins without a copy of the content before
    double timerPeriod = 10;
};

/// Sets an object to zero.
struct ClearObject {
    Place place;
    std::variant<TextureIndex, BufferIndex> object;
};

/// What a check, a Print or a function of conditions looks at.
struct Selection {
    std::optional<ObjectView> object{};  ///< nothing: the window
    /// Components of texels or of vectors, "rgb", or a member of the structures of a buffer, "velocity.x";
    /// empty: all of a texel or element.
    std::string part{};
    /// Of a texture or the window: x, y, width and height in texels, counted from the lower left corner. Of a
    /// buffer: the first and the last element. Empty: all.
    std::vector<double> area{};
    friend bool operator==(const Selection&, const Selection&) = default;
};

/// What a function of a condition reads: `mean(glow, 0, 0, 8, 8) at 2`.
struct Measure {
    std::string function;  ///< "sum", "mean", "least", "largest"
    Selection of;
    std::optional<double> seconds{};  ///< the scene time; nothing: that at which the condition is answered
    friend bool operator==(const Measure&, const Measure&) = default;
};

/// An expression that is evaluated when the picture is there.
struct Question {
    const glib::Value* expression = nullptr;  ///< of the script, which must outlive this; null: there is none
    std::shared_ptr<const ConditionNames> names{};  ///< that it reads
};

/// A check of the picture, an object or a count.
struct Check {
    enum class Kind {
        pixel,       ///< `numbers` x y; all pixels count from the lower left corner
        mean,        ///< `numbers` x y width height
        count,       ///< `numbers` least and largest: pixels of the colour `wanted`
        buffer,      ///< `numbers` empty or the index of the first element
        range,       ///< `numbers` least and largest
        sum,         ///< `wanted` per component
        same,        ///< two objects
        different,   ///< two objects
        finite,      ///< all texels or elements
        primitives,  ///< `numbers` n
        samples,     ///< `numbers` n
        error,       ///< `word`: the id of a diagnostic
        condition,   ///< `condition`
    };
    Kind kind = Kind::pixel;
    Place place;
    std::string text;                 ///< as written
    std::optional<double> seconds{};  ///< the scene time; nothing: that of the picture
    Selection of{};
    Selection other{};  ///< of same and different
    std::vector<double> numbers;
    std::vector<double> wanted;  ///< components of a colour or values of a buffer
    double tolerance = 0;        ///< absolute
    std::string word{};
    Question condition{};
    /// The textures and buffers that it looks at, at any time.
    [[nodiscard]] std::vector<ObjectView> objects() const;
    /// The times that it states: its own, and those of a condition.
    [[nodiscard]] std::vector<double> times() const;
    /// Which run of the statement this is: the rounds of the repetitions around it, and the places of Draw
    /// and Include statements that lead to it. No two checks have equal places and paths.
    std::vector<std::size_t> path{};
    [[nodiscard]] bool isSame(const Check& check) const { return place == check.place && path == check.path; }
};

/// A Print statement.
struct Print {
    Place place;
    std::string name;  ///< what it prints, as written
    Selection of{};    ///< unless `value` is an expression
    Question value{};
    /// The textures and buffers that it looks at.
    [[nodiscard]] std::vector<ObjectView> objects() const;
};

/// An Expect statement that has not run.
struct IdleCheck {
    Place place;
    std::string text;                 ///< as written
    std::string why;                  ///< "group 'row' is not drawn"
    bool mayRun = false;              ///< at other times, or with other values of variables
    std::optional<double> seconds{};  ///< the scene time, if it is a plain number
};

/// A step of a node list.
struct StepIndex {
    std::size_t pass = 0, step = 0;  ///< indices into NodeList::passes and Pass::steps
    friend auto operator<=>(const StepIndex&, const StepIndex&) = default;
};

/// The end of a round of `Repeat n until (condition)` in Once or Step, whose condition reads buffers. If it
/// holds, the rounds that would follow are left out.
struct Until {
    Check condition;  ///< of Check::Kind::condition
    std::vector<BufferIndex> reads{};
    std::size_t first = 0;   ///< nodes of NodeList::order before the first round,
    std::size_t node = 0;    ///< before the end of this round,
    std::size_t end = 0;     ///< and before the end of the last one
    std::size_t round = 1;   ///< counted from 1
    std::size_t rounds = 1;  ///< of the whole repetition
};

/// A node: an index into the list of its kind.
struct NodeIndex {
    enum class Kind { pass, dispatch, clear };
    Kind kind = Kind::pass;
    std::size_t index = 0;
    friend auto operator<=>(const NodeIndex&, const NodeIndex&) = default;
};

/// What is executed.
struct NodeList {
    std::vector<Pass> passes;
    std::vector<Dispatch> dispatches;
    std::vector<ClearObject> clears;
    std::vector<NodeIndex> order;  ///< of all nodes; the passes among themselves are in the order of `passes`
    /// Variables that the block itself sets: uniforms of the same name that nothing else sets read these
    /// before those of Scene::namedValues.
    std::vector<glib::UniformSpec> namedValues{};
    std::vector<Until> untils{};  ///< in the order of Until::node

    [[nodiscard]] bool isEmpty() const { return order.empty(); }
    Pass& add(Pass pass) {
        order.push_back({NodeIndex::Kind::pass, passes.size()});
        return passes.emplace_back(std::move(pass));
    }
    Dispatch& add(Dispatch dispatch) {
        order.push_back({NodeIndex::Kind::dispatch, dispatches.size()});
        return dispatches.emplace_back(std::move(dispatch));
    }
    ClearObject& add(ClearObject clear) {
        order.push_back({NodeIndex::Kind::clear, clears.size()});
        return clears.emplace_back(std::move(clear));
    }

    [[nodiscard]] const Place& placeOf(const NodeIndex& node) const {
        switch (node.kind) {
            case NodeIndex::Kind::pass:
                return passes.at(node.index).place;
            case NodeIndex::Kind::dispatch:
                return dispatches.at(node.index).place;
            case NodeIndex::Kind::clear:
                break;
        }
        return clears.at(node.index).place;
    }
    /// Calls `visit(draw, pass)` with each Draw and its Pass.
    template <class Visit>
    void visitDraws(Visit&& visit) const {
        for (const Pass& pass : passes)
            for (const auto& step : pass.steps)
                if (const auto* draw = std::get_if<Draw>(&step)) visit(*draw, pass);
    }

    /// Throws std::out_of_range or std::bad_variant_access if that step is no draw.
    [[nodiscard]] const Draw& draw(StepIndex at) const {
        return std::get<Draw>(passes.at(at.pass).steps.at(at.step));
    }
    [[nodiscard]] Draw& draw(StepIndex at) { return std::get<Draw>(passes.at(at.pass).steps.at(at.step)); }
    /// The same for a Clear.
    [[nodiscard]] const Clear& clear(StepIndex at) const {
        return std::get<Clear>(passes.at(at.pass).steps.at(at.step));
    }
};

/// The statements of a Step block, for one step.
struct StepBlock {
    double rate = 1;  ///< steps per second of scene time
    Place place;
    NodeList nodes;
    bool dependsOnTick = false;  ///< the nodes of another tick may have other values
    /// The values after `reset`. Where they differ from those at the step before, the block begins anew.
    std::vector<double> resets{};
    /// The camera of a Fill changes with the tick, which matters if the program of the Fill reads it.
    bool fillsDependOnTick = false;
};

/// The statements of a Once block.
struct OnceBlock {
    Place place;
    NodeList nodes;
    std::vector<double> reads;  ///< the values of what it depends on; other values mean that it runs again
};

// The most that one draw may have (language, 12.6), whether the scene or a buffer gives the number.

inline constexpr int kMostInstances = 100'000'000;
inline constexpr int kMostVertices = 500'000'000;

}  // namespace glibra::scene
