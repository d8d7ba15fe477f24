#pragma once
// Draws a FramePlan: the passes in order, each draw with its complete state.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "gpu/context/context.h"
#include "gpu/object/buffer.h"
#include "gpu/object/framebuffer.h"
#include "gpu/state/state_tracker.h"
#include "plan/frame_plan.h"
#include "plan/needs.h"
#include "render/draw/expanded_geometry.h"
#include "render/draw/memory_order.h"
#include "render/draw/view_matrices.h"
#include "render/draw/wide_lines.h"
#include "render/draw/work_share.h"
#include "render/load/device_scene.h"
#include "render/load/programs.h"
#include "render/load/supplied.h"
#include "render/stats.h"
#include "scene/view.h"

namespace glibra::render {

/// The value of Timer: the fraction of the period that has passed, from 0 to less than 1 (as a float).
double timerAt(double time, double period);

/// One frame to draw: what is seen, how large, and when.
struct Frame {
    const ViewMatrices& view;
    int width = 1, height = 1;  ///< pixels of the whole picture, which the window's aspect comes from
    Tile tile;                  ///< the part of it that the window's target shows
    double time = 0;            ///< seconds since loading
    bool texturePasses = true;  ///< false: only the window's passes are drawn
    const plan::StillNodes* still = nullptr;  ///< what need not be drawn; null: all is drawn
    /// The drawer may keep what it knows of the context's state for its next frame. Nothing else uses the
    /// context until then, or until FrameDrawer::close().
    bool staysOpen = false;
    /// Programs with open loops record which of them the driver ends (ProgramLibrary::countLoops). Those that
    /// store in memory do so in place of the others, the rest beside them, without changing a pixel.
    bool recordsLoops = false;
    /// Says whether the condition at the end of a round holds (NodeList::untils), so that the rounds after it
    /// are left out. Null: it never does.
    std::function<bool(const scene::Until& until)> holds{};
};

/// A pass of a frame while it is drawn.
struct PassInProgress {
    const Frame& frame;
    const scene::Pass& pass;
    const gpu::Target& target;
    const ViewMatrices& view;   ///< by which its draws are seen
    Tile part;                  ///< the part of the whole that the target shows
    int width = 1, height = 1;  ///< pixels of the whole
    glm::dvec2 shift{0.0};      ///< FrameDrawer::setShift
    [[nodiscard]] double aspect() const { return static_cast<double>(width) / height; }
};

/// True if every pass into textures, dispatch and clear comes before every pass into the window, so that
/// tiles can share them.
bool texturesComeFirst(const plan::FramePlan& plan);

/// Draws the frames of one plan. A drawer is complete when it is constructed; the setters below are options
/// that hold for all frames that follow, in any order.
class FrameDrawer {
  public:
    FrameDrawer(const gpu::Context& context, const plan::FramePlan& plan, const ProgramLibrary& programs,
                DeviceScene& device, Stats& stats);

    /// Draws one frame into `window`, which has the size of the frame's tile.
    Diagnostics draw(const gpu::Target& window, const Frame& frame);

    /// Executes a plan without passes into the window. What it writes lasts.
    Diagnostics run(const Frame& frame);
    /// Ends a row of frames with Frame::staysOpen: the context has the state that others expect, and what
    /// shaders have stored is visible to everything.
    void close();

    /// Draws and clears only these pixels of every target.
    void limitTo(const std::optional<gpu::PixelRectangle>& pixels) {
        limit_ = pixels;
        raster_.limitTo(pixels);
    }
    /// Draws triangles as their edges.
    void setWireframe(bool on) { wireframe_ = on; }
    [[nodiscard]] bool isWireframe() const { return wireframe_; }
    /// Called before (`begins`) and after the GL call of every draw, while its program and state are bound. A
    /// hook may change the state; the next draw sets all of it.
    using DrawHook = std::function<void(const plan::PlannedDraw& draw, bool isWindow, bool begins)>;
    void setDrawHook(DrawHook hook) { hook_ = std::move(hook); }
    /// Called before (`begins`) and after every node of the plan that is executed; `node` is an index into
    /// FramePlan::order.
    using NodeHook = std::function<void(std::size_t node, bool begins)>;
    void setNodeHook(NodeHook hook) { nodeHook_ = std::move(hook); }
    /// Draws with programs that did not link use this one, in magenta. Without it they are left out.
    void setFallback(const BuiltProgram* builtin) { fallback_ = builtin; }
    /// Moves the window's pictures right and up by parts of a pixel, and passes into textures, in their
    /// order, by parts of a texel; what shaders see as gl_FragCoord moves with them. Only programs that are
    /// made for tiles move.
    void setShift(const glm::dvec2& window, std::vector<glm::dvec2> textures) {
        shift_ = window;
        textureShifts_ = std::move(textures);
    }
    /// Skips draws that provably do not reach the tile, or the texture drawn into, if the device knows the
    /// bounds of their mesh. `samples`: of the window's target; 0: draws everything.
    void cullToTile(int samples) { windowSamples_ = samples; }
    /// Turns blending off for programs that always write 1 for alpha. The window's colours must be bytes:
    /// floats would keep the sign of a zero that blending loses.
    void skipOpaqueBlending();
    /// Runs fragment stages that may paint edges for each sample of the window, unless they write memory.
    void shadeSamples() { shadesSamples_ = true; }
    /// Draws that may take longer than this many seconds are cut into parts, for the same pixels; 0: none is.
    /// At first it is kTimeShare, and 0 where the processor draws. Vertex stages then run once per part.
    void setTimeShare(double seconds) { timeShare_ = seconds; }
    /// Queries count what is drawn: each draw is submitted once and whole, so that its loops are not
    /// recorded.
    void setCounted(bool on) { isCounted_ = on; }
    /// Draws only the first `draws` of the plan's draws, counted over all passes in their order. Passes still
    /// begin with their implicit clears.
    void setDrawLimit(std::size_t draws) { drawLimit_ = draws; }
    /// Call it after the plan's literals of this program (index into FramePlan::programs) have changed.
    void forgetLiterals(plan::PlannedProgramIndex program);

    /// True if a frame is drawn whole, as the scene says: no option above leaves out or moves anything.
    [[nodiscard]] bool drawsPlainly() const;

    /// For hooks: issues the GL calls of that draw alone, with whatever program and vertex array are bound.
    /// `withPoints`: also the points of a mesh of lines.
    void submit(const plan::PlannedDraw& planned, bool withPoints = false) const;
    /// The vertices of a draw: by indices in the buffer that is bound for them, or in order.
    struct Elements {
        bool areIndexed = false;
        std::uint64_t offset = 0;  ///< bytes before the first index
        int count = 0;
        int points = 0;  ///< the last ones, which are points, whatever the draw's primitives are
        int instances = 1;
    };
    /// For hooks: what the draw submits, with the counts that buffers hold; then it waits for the device.
    [[nodiscard]] Elements submittedBy(const plan::PlannedDraw& planned) const;
    /// The program that the draw uses, which may be the fallback; null if nothing is drawn.
    [[nodiscard]] const BuiltProgram* programOf(const plan::PlannedDraw& planned) const;

  private:
    /// The node of the scene before which the nodes that may still run begin, after the conditions of rounds
    /// that end before `node`, which are counted in `looked`.
    std::size_t afterRounds(std::size_t node, std::size_t& looked, const Frame& frame);
    /// The place of a node of the plan among NodeList::order.
    std::size_t placeInScene(const scene::NodeIndex& node);
    std::map<scene::NodeIndex, std::size_t> places_;  ///< empty until they are asked for
    /// What a program keeps between draws: literal uniform values are set once.
    struct ProgramState {
        bool literalsSet = false;         ///< the blocks hold them
        std::vector<gpu::Buffer> blocks;  ///< one per uniform block; without bytes: a buffer of the scene
    };

    [[nodiscard]] const BuiltProgram* ownProgramOf(const plan::PlannedDraw& planned) const;
    /// `window` may be null if no pass draws into it.
    Diagnostics execute(const gpu::Target* window, const Frame& frame);
    Diagnostics drawNodes(const gpu::Target* window, const Frame& frame);
    /// Exchanges the copies of objects with history that the node (index into FramePlan::order) writes.
    Diagnostics exchangeCopies(std::size_t node);
    /// True if the node may leave parts of the object as they were.
    bool keepsContent(std::size_t node, const plan::PlannedExchange& exchange);
    /// True if the dispatch has an invocation for each texel or element of the object.
    bool coversWhole(const plan::PlannedDispatch& planned, const plan::PlannedExchange& exchange);
    /// Exchanges copies, makes the barrier and tells the device what is written.
    Diagnostics beginNode(std::size_t node);
    void endNode(std::size_t node);
    /// Fills memory_, once.
    void noteNodes();
    /// True if the node of that number is still in the frame; counts it.
    bool isStill(std::size_t node, const Frame& frame);
    /// By which the draws of the pass are seen. `own` holds what is made for it.
    const ViewMatrices& viewOf(const scene::Pass& pass, const Frame& frame, ViewMatrices& own);
    /// `begin`: the number of draws of the plan before those of the pass.
    Diagnostics drawPass(const plan::PlannedPass& planned, const PassInProgress& pass, std::size_t begin);
    Diagnostics dispatch(const plan::PlannedDispatch& planned, const Frame& frame);
    /// The group counts of a dispatch without a buffer of counts; computed once.
    const GroupCounts& groupsOf(const plan::PlannedDispatch& planned, const BuiltProgram& built);
    void clearObject(const scene::ClearObject& clear);
    /// Nothing is known about the context's state.
    void forgetState();
    /// Colours that are drawn into sRGB textures are encoded.
    void encodeSrgb(bool on);
    void beginPass(const PassInProgress& pass);
    void clear(const PassInProgress& pass, const scene::Clear& clear);
    Diagnostics drawOne(const plan::PlannedDraw& planned, const PassInProgress& pass);
    void setLiterals(plan::PlannedProgramIndex program, const BuiltProgram& built);
    /// Makes the uniform blocks whose values are literals.
    void makeBlocks(ProgramState& state, plan::PlannedProgramIndex program, const BuiltProgram& built);
    /// Gives uniforms without a literal the values that they had after linking, if other planned programs may
    /// have changed them.
    void resetUniforms(plan::PlannedProgramIndex program, const BuiltProgram& built);
    [[nodiscard]] bool isOutOfTile(const plan::PlannedDraw& planned, const BuiltProgram& built,
                                   const PassInProgress& pass) const;
    void setSupplied(plan::PlannedProgramIndex program, const BuiltProgram& built, const DrawFacts& facts);
    void setBuiltins(const BuiltProgram& built, const DrawFacts& facts);
    Diagnostics setConstantInputs(const plan::PlannedDraw& planned, const BuiltProgram& built,
                                  const glm::dvec4& color);
    void bindTextures(const std::vector<plan::TextureUse>& textures, const BuiltProgram& built);
    void bindBlocks(plan::PlannedProgramIndex program, const BuiltProgram& built);
    void runPerSample(bool on);
    void setTessellationLevels(const std::array<float, 6>& levels);
    /// The same without the counts that buffers hold. The mesh of the draw must be on the device.
    [[nodiscard]] Elements elementsOf(const plan::PlannedDraw& planned) const;
    /// Of a program that does the work of its geometry or tessellation stages in the vertex stage
    /// (glsl::ExpandedGeometry).
    void submitExpanded(const plan::PlannedDraw& planned, const BuiltProgram& built,
                        const Elements& elements) const;
    /// Says how vertices are counted (glsl::ExpandedGeometry::numbersPrimitives).
    static void numberPrimitives(const plan::PlannedDraw& planned, const BuiltProgram& built);
    void submitPatches(const plan::PlannedDraw& planned, const BuiltProgram& built,
                       const Elements& elements) const;
    /// What OpenGL ES draws otherwise than the scene states, as a text; null: nothing.
    const char* lackOfEs(const base::RasterState& raster) const;
    /// True, once for each draw, if it reads borders that OpenGL ES lacks (glsl/es/additions.h).
    bool lacksBorders(const plan::PlannedDraw& planned, const BuiltProgram& built);
    /// The driver fills triangles only, and the draw shows their edges.
    [[nodiscard]] bool drawsEdges(const plan::PlannedDraw& planned) const;
    /// The draw shows lines: its primitives, those of its stages, or edges.
    [[nodiscard]] bool drawsLines(const plan::PlannedDraw& planned, const BuiltProgram& built) const;
    /// If its lines are wider than those of the driver, makes the next submissions draw quads, for which it
    /// changes the state, or reports draw-W04.
    void widenLines(const plan::PlannedDraw& planned, const BuiltProgram& built, const PassInProgress& pass,
                    base::RasterState& raster, Diagnostics& diagnostics);
    /// Draws the lines of so many vertices and instances as quads; null if the draw has none.
    [[nodiscard]] QuadDrawer quads() const;
    /// Binds what the draw reads on gpu::kWorkUnit, after textures were made.
    void bindWorkUnit(const plan::PlannedDraw& planned) const;
    /// Draws elements of one kind.
    void submitPart(const plan::PlannedDraw& planned, const Elements& elements, GLenum mode) const;
    /// The program that records the loops of the frame in place of, or beside, the given one; null: none.
    [[nodiscard]] const BuiltProgram* loopCounterOf(plan::PlannedProgramIndex program,
                                                    const BuiltProgram& built, const Frame& frame) const;
    /// Uses a program's loop counter with the values that the program has.
    void useCounter(const BuiltProgram& built);
    /// Draws with the loop counter of the program, whose state is set. True if that is the draw itself.
    bool recordLoops(const plan::PlannedDraw& planned, const BuiltProgram& built, const Frame& frame,
                     const base::RasterState& raster);
    /// Gives a program with guarded loops (glsl/es/additions.h) as many rounds as they need. Where the
    /// frame records loops, or its target has become larger, some pixels are drawn into another target: if
    /// their loops end by themselves, all have kMostRounds; else as many as a frame has time for.
    void tryLoops(const plan::PlannedDraw& planned, const BuiltProgram& built, const PassInProgress& pass,
                  const base::RasterState& raster);
    /// Submits a draw whose state is set, in parts if it may take long (work_share.h).
    void submitInShares(const plan::PlannedDraw& planned, const BuiltProgram& built);
    /// Submits a draw whose state is set in parts of the target, from the last to the first.
    void submitInReverse(const plan::PlannedDraw& planned);
    /// Does all rows by `work`, in parts if the program is not known to be quick. Returns their number.
    int workInShares(const BuiltProgram& built, int rows, double pixels,
                     const std::function<void(int first, int end)>& work);
    [[nodiscard]] bool mayTakeLong(const plan::PlannedDraw& planned, const BuiltProgram& built);
    void submitDirect(const plan::PlannedDraw& planned, const Elements& elements, GLenum mode) const;
    /// The word of that number of a buffer; 0 if the buffer has not been made. Waits for the device.
    [[nodiscard]] std::uint32_t countIn(const scene::CountFrom& from, std::uint64_t after = 0) const;
    /// memory-E06 if a buffer gives the draw more vertices or instances than a scene may state, memory-E15 if
    /// more indices than there are.
    [[nodiscard]] Diagnostics checkCounts(const scene::Draw& draw) const;
    /// Draws with counts that buffers hold.
    void submitIndirect(const scene::Draw& draw, const Elements& elements, GLenum mode) const;
    /// Returns the state that it has set.
    base::RasterState setRaster(const plan::PlannedDraw& planned, const BuiltProgram& built,
                                const PassInProgress& pass, Diagnostics& diagnostics);
    /// Makes what is read from textures that were drawn into: mipmaps, resolved samples.
    void completeReads(const std::vector<plan::TextureUse>& textures);
    /// Runs the groups in as many pieces as the scene wants, along the last axis with several groups. After
    /// each piece the driver gets the commands, so that none of them takes long.
    Diagnostics dispatchPieces(const BuiltProgram& built, const GroupCounts& groups,
                               const scene::Dispatch& dispatch, bool recordsLoops);
    /// The same in parts that follow from the time that the first ones take (work_share.h). `run` does the
    /// groups of that range along the axis.
    Diagnostics dispatchInShares(
        const BuiltProgram& built, const GroupCounts& groups, std::size_t axis,
        const std::function<Diagnostics(std::uint64_t begin, std::uint64_t end)>& run);
    /// After a draw or dispatch: tells the device what its shaders may have stored to. False: nothing.
    bool noteStores(plan::PlannedProgramIndex program, const std::vector<plan::TextureUse>& textures);

    const gpu::Context& context_;
    const plan::FramePlan& plan_;
    const ProgramLibrary& programs_;
    DeviceScene& device_;
    Stats& stats_;
    scene::List<ProgramState, plan::PlannedProgram> states_;
    std::map<const plan::PlannedDispatch*, GroupCounts> groups_;  ///< of groupsOf
    /// By node of FramePlan::order; empty if no shader of the plan stores. noteNodes() makes it.
    std::optional<std::vector<NodeMemory>> memory_;
    std::map<const plan::PlannedExchange*, bool> covered_;  ///< of coversWhole
    MemoryOrder order_;
    bool isOpen_ = false;
    std::size_t drawLimit_ = std::numeric_limits<std::size_t>::max();
    bool wireframe_ = false;
    bool blendsOpaque_ = true;
    int windowSamples_ = 0;  ///< 0: all draws are drawn
    DrawHook hook_;
    NodeHook nodeHook_;
    const BuiltProgram* fallback_ = nullptr;
    double timeShare_;
    bool isCounted_ = false;
    std::map<const BuiltProgram*, bool> loops_;  ///< whether it has any
    std::optional<gpu::Target> loopTarget_;      ///< of tryLoops()
    glm::dvec2 shift_{0.0};
    std::vector<glm::dvec2> textureShifts_;  ///< one per pass into textures, in their order
    bool encodesSrgb_ = false;               ///< as set
    bool shadesSamples_ = false;
    bool runsPerSample_ = false;  ///< as set
    std::optional<std::set<std::string>> movedCameras_;
    gpu::RasterTracker raster_;
    mutable gpu::BindingTracker bindings_;
    std::set<const gpu::Target*> seenTargets_;
    std::optional<gpu::PixelRectangle> limit_;
    std::optional<int> clipDistances_;            ///< those below this index are enabled; nothing: not known
    std::optional<int> patchVertices_;            ///< as set; nothing: not known
    std::array<float, 6> levels_ = kOneLevel;     ///< of tessellation; GL's own while nothing is drawn
    mutable std::optional<gpu::Buffer> command_;  ///< the arguments of an indirect draw
    mutable gpu::EdgeBuffers edges_;
    mutable PatchDivider patches_;
    mutable StripDrawer strips_;
    FetchedInputs fetched_;
    mutable LineWidener widener_;
    std::optional<LineWidener::Look> wide_;  ///< of the draw whose state is set
    bool lineWidthReported_ = false;
    std::set<const plan::PlannedDraw*> bordersChecked_;
    std::set<std::string> lacks_;  ///< that were reported (lackOfEs)
};

}  // namespace glibra::render
