#pragma once
// A scene on a device, which is loaded, loaded again and drawn, with what a user changes: its values, how it
// is looked at, and the time. It does not depend on a window or widgets, so that all of it can be driven and
// tested without a display.

#include <glibra/render.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/device_lost.h"
#include "gpu/context/context.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/texture.h"
#include "render/live/live_scene.h"
#include "view/debug_view/debug_renderer.h"
#include "view/debug_view/pixel_probe.h"
#include "view/edit/saved_scene.h"
#include "view/scene/window_target.h"
#include "view/session/drawing_service.h"
#include "view/session/look.h"
#include "view/session/object_timer.h"
#include "view/session/scene_values.h"

namespace glibra::view {

/// The draws that have another state than the scene says, to try that. They are found again after an edit.
class Trials {
  public:
    /// The text of a file of the scene, as it was read last.
    using TextOf = std::function<std::string(const std::filesystem::path&)>;

    [[nodiscard]] bool empty() const { return trials_.empty(); }
    /// By the draws of the scene as it is now. A draw whose line is missing has none, until the line is there
    /// again.
    [[nodiscard]] const render::TriedStates& states() const { return states_; }
    /// The draw gets another state; that of the scene ends the trial.
    void set(const scene::Draw& draw, const base::RasterState& state, const TextOf& textOf);
    /// The scene has been read again.
    void follow(const scene::Scene& scene, const TextOf& textOf);
    void clear() { *this = {}; }

  private:
    struct Trial {
        std::filesystem::path file;
        DrawId then, now;  ///< in texts_, and in the texts as they are; `now` has no line if it is gone
        render::TriedState state;
    };
    void keepTexts(const TextOf& textOf);
    void list();

    std::vector<Trial> trials_;
    render::TriedStates states_;                          ///< of those that are not gone
    std::map<std::filesystem::path, std::string> texts_;  ///< in which all trials stood
};

inline constexpr double kUsualDrawLimit = 2, kLongDrawLimit = 20;  ///< seconds

class Session {
  public:
    /// The context must outlive the session. Only options that do not depend on the window are used: view
    /// policy, library roots, shim.
    Session(gpu::Context& context, RenderOptions options);

    /// Shows the scene with the values and the view that its file gives. Returns false if the file cannot be
    /// read; the earlier scene stays then.
    bool open(const std::filesystem::path& path);
    /// Loads the scene and its files again; values, view and time stay. Returns false if the scene cannot be
    /// read; the earlier state stays then, unless memory ran out and hasScene() is false.
    bool reload();
    /// Destroys all that is on the device, because the device is lost. Call restoreDevice() when there is
    /// another one: the scene is loaded again, and values, view and time are as before.
    void releaseDevice();
    void restoreDevice();
    /// The scene is not drawn any more, because that has made the driver reset the device; view-E04 says so.
    /// This ends with a value that is set, or when the scene is loaded again.
    void stop(const base::DeviceLost& lost);
    [[nodiscard]] bool isStopped() const { return isStopped_; }
    /// Scenes with loops that may not end (LiveScene::openLoops) are drawn by a process of their own, which
    /// is ended after two seconds. The last picture stays then, and view-E05 names the loops.
    void setContained(bool on) { isContained_ = on; }
    /// Reports how long the last frame of the session has taken on this process. A scene that moves and has
    /// taken long several times in a row is drawn by that process from then on, so that the window goes on.
    void noteDrawn(double seconds);
    /// True while that process draws a picture that is wanted; drawIfNeeded() asks for its result.
    [[nodiscard]] bool isDrawing() const { return isWaiting_; }
    /// A scene that was stopped because it took too long is drawn again, for up to 20 seconds.
    void drawLonger();
    /// Chooses a file for a statement of the scene that names none; the next reload() uses it. Returns what
    /// is wrong; empty on success. open() forgets the choices.
    std::string chooseFile(const Place& place, const std::filesystem::path& file);
    [[nodiscard]] const std::vector<ChosenFile>& chosenFiles() const { return chosenFiles_; }
    void forgetChosenFiles() { chosenFiles_.clear(); }
    /// With it, loading reports each executed statement (glib-N02), as if the scene said Verbose.
    [[nodiscard]] bool isVerbose() const { return isVerbose_; }
    void setVerbose(bool on) { isVerbose_ = on; }
    /// The next loading takes these texts in place of what the files have (RenderOptions::texts). open()
    /// forgets them.
    void setTexts(std::map<std::filesystem::path, std::string> texts);
    [[nodiscard]] const std::map<std::filesystem::path, std::string>& texts() const { return options_.texts; }
    [[nodiscard]] bool hasScene() const { return live_ != nullptr; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// How often a scene was loaded. Whatever was derived from live() before the last loading is out of date.
    [[nodiscard]] std::uint64_t timesLoaded() const { return timesLoaded_; }
    [[nodiscard]] const render::LiveScene& live() const { return *live_; }
    render::LiveScene& live() { return *live_; }
    /// The diagnostics of the last loading and of the frames since, and those about long loops with the
    /// current values.
    [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }

    /// Its time, its values, and how it is looked at. What changes there makes the picture out of date, and a
    /// value that is set ends a stop().
    [[nodiscard]] const Clock& clock() const { return clock_; }
    Clock& clock() { return clock_; }
    [[nodiscard]] const SceneValues& values() const { return values_; }
    SceneValues& values() { return values_; }
    [[nodiscard]] const Look& look() const { return look_; }
    Look& look() { return look_; }

    /// Whether every frame measures how long its objects take. Frames are then drawn whole, without what is
    /// kept from the frame before.
    [[nodiscard]] bool measuresObjects() const { return measuresObjects_; }
    void setMeasuresObjects(bool on);
    /// The result, of frames that the device has done; nothing without one since it was turned on, and in
    /// debug views. See ObjectTimer.
    [[nodiscard]] std::optional<double> objectMilliseconds() const {
        return objectTimer_ ? objectTimer_->milliseconds() : std::nullopt;
    }
    /// Every texture keeps its content after a frame, for the inspector. See LiveScene::keepTextures.
    void keepTextures();
    /// The numbers behind the debug view of the last frame, bottom row first; empty if it shows none.
    [[nodiscard]] const TexelImage& debugNumbers() const;

    /// Where the mouse is in the picture, 0..1 from the lower left corner, and whether its left button is
    /// down.
    void setMouse(double x, double y, bool isDown);
    /// Does what the scene's Key statements say about that key; the name is compared without case. Returns
    /// false if there is none.
    bool pressKey(std::string_view key);
    /// The key has been down for these seconds, since the last call or since it was pressed: does what `held`
    /// says about it.
    void holdKey(std::string_view key, double seconds);

    /// Sets the time to 0; what lasts begins anew.
    void restart();
    /// Pauses, and moves the time to the next step of the scene's Step blocks.
    void nextStep();

    /// Reports that `seconds` of real time have passed. The time of a scene that does not use it stands
    /// still.
    void advance(double seconds);
    /// True if the picture depends on the time.
    [[nodiscard]] bool usesTime() const { return live_ && (live_->isAnimated() || values_.isAnyAnimated()); }
    /// True if the picture changes by itself: time advances and a program reads it.
    [[nodiscard]] bool isMoving() const;

    /// Sets the samples per pixel on the screen, limited to what the driver has; 0 or 1: one. Hardcopies and
    /// renderOptions() keep theirs.
    void setSamples(int samples);
    /// Takes over all that the last picture of `other` depends on besides its scene: samples, time, mouse,
    /// Look::setLike and SceneValues::setLike.
    void showLike(const Session& other);
    /// Marks the picture as out of date, after something else was drawn into it.
    void setNeedsFrame() { isStale_ = true; }
    /// Draws a frame if the picture is out of date. Returns true if it drew one.
    bool drawIfNeeded();
    /// Has the next frame report the loops that the driver ends (draw-W08), where the texts of the shaders do
    /// not show that they are short: once for each loading and after values were set. Call it when nothing
    /// else is to be done, since it takes time. Returns true if the picture is out of date for this.
    bool watchLoops();
    /// The last picture; null before the first.
    [[nodiscard]] const gpu::Target* picture() const { return target_ ? &*target_ : nullptr; }
    /// The same picture with one sample per pixel and readable depth; drawn for this if the screen has more.
    const gpu::Target* plainPicture();
    [[nodiscard]] std::uint64_t framesDrawn() const { return framesDrawn_; }

    /// What the fragment of the last frame at that pixel has: its inputs, outputs and uniforms (probePixel).
    /// x counts to the right, y downwards. Only the place is set while there is no picture yet.
    ProbedPixel probe(int x, int y);
    /// True if the frame that was drawn last can be drawn again, to look into it: for watchFrame() and its
    /// like. Draws it first if it is out of date.
    bool canLookInto();
    /// The draws that are drawn with another state than the scene says (LiveScene::tryStates), until the
    /// scene says another one for them, or another scene is opened. They are found again after an edit, and a
    /// draw that takes the place of another does not inherit its state.
    [[nodiscard]] const Trials& trials() const { return trials_; }
    void tryState(const scene::Draw& draw, const base::RasterState& state);
    /// The text of a file of the scene, with what was typed in it; empty if it cannot be read.
    [[nodiscard]] std::string readText(const std::filesystem::path& file) const;
    /// What one draw of the frame has at a pixel of the targets of its pass (view::probeDraw).
    ProbedPixel probeDraw(scene::StepIndex step, const TargetPixel& at);
    /// The debug view of one pass of the frame (DebugRenderer::drawPass), as numbers. Returns why there is
    /// none; empty on success. `layer`: of a pass into several.
    std::string numbersOfPass(std::size_t pass, DebugView kind, TexelImage& numbers, int layer = 0);

    /// The picture from before the last edit: of the files as they were last. Null if there is none.
    [[nodiscard]] const gpu::Target* pictureBefore() const { return before_ ? &*before_ : nullptr; }
    /// While it is on, shownPicture() is that picture. Another edit turns it off. A scene that uses time
    /// pauses at the time of that picture, so that the one after the edit is of the same moment; not one with
    /// Step, which would begin anew.
    void showBefore(bool on);
    [[nodiscard]] bool showsBefore() const { return showsBefore_; }
    [[nodiscard]] const gpu::Target* shownPicture() const {
        return showsBefore_ ? pictureBefore() : picture();
    }

    /// Picks the object at that pixel (x to the right, y downwards) for the look; the background picks none.
    /// While another process draws the picture, the pick waits for it.
    void pickAt(int x, int y);
    void clearPick();

    /// The options with which `glibra render` gives this picture in that size (0: the current size).
    [[nodiscard]] RenderOptions renderOptions(int width = 0, int height = 0) const;
    /// What the window shows but `glibra render` and suites cannot: "wireframe", "wireframe and the debug
    /// view 'depth'". Empty if it shows the plain picture.
    [[nodiscard]] std::string onlyOnScreen() const;

  private:
    void followClock();
    void apply(const render::Knob& knob);
    void take(render::LiveScene::Loading loading, bool sameScene);
    Diagnostics drawShown();
    enum class Elsewhere { no, waits, tried, shown };
    Elsewhere drawElsewhere();
    [[nodiscard]] DrawnState beginDrawnState();
    const std::vector<Place>& openLoops();
    bool showReceived(const DrawingOrder& order);
    void stopOpenLoops(DrawingProcess::State why);
    void keepBefore();
    bool makeTarget(std::optional<gpu::Target>& target, int samples);
    void pickWaiting();
    [[nodiscard]] std::optional<std::string> textWithFiles() const;
    [[nodiscard]] RenderOptions loadOptions() const;

    gpu::Context& context_;
    RenderOptions options_;
    std::filesystem::path path_;
    std::unique_ptr<render::LiveScene> live_;
    Diagnostics diagnostics_;
    Clock clock_{[this] { followClock(); }};
    SceneValues values_{clock_, [this](const render::Knob& knob) { apply(knob); }};
    Look look_{[this] { isStale_ = true; }};
    DrawnState::Mouse mouse_;
    bool isVerbose_ = false, measuresObjects_ = false;
    std::vector<ChosenFile> chosenFiles_;
    std::optional<ObjectTimer> objectTimer_;      ///< made for the context
    std::optional<DebugRenderer> debugRenderer_;  ///< made for live_
    int samples_ = 1;
    double pictureTime_ = 0;                ///< of the last picture, which another process may have drawn
    std::optional<gpu::Texture> received_;  ///< the picture of process_; target_ refers to it
    std::optional<gpu::Target> target_;
    std::optional<gpu::Target> plain_;  ///< plainPicture() of frame number `plainFrame_`
    std::uint64_t plainFrame_ = 0;
    std::optional<gpu::Target> before_;  ///< pictureBefore()
    double beforeTime_ = 0;              ///< of that picture
    bool showsBefore_ = false;
    bool isOfFiles_ = true;  ///< the scene was loaded without texts that are not saved
    Trials trials_;
    DrawingProcess process_;
    std::optional<std::vector<Place>> openLoops_;  ///< with the current values, if they are known
    std::string tried_;                            ///< what the process has drawn
    double drawLimit_ = kUsualDrawLimit;           ///< seconds
    bool isContained_ = false, isWaiting_ = false;
    /// As many slow frames make a scene slow. Drivers compile programs in the first two.
    static constexpr int kMostSlowFrames = 4;
    int slowFrames_ = 0;        ///< of this process, one after the other
    bool drawsItself_ = false;  ///< others read what frames leave on the device
    bool hasOtherSamples_ = false;
    bool isStale_ = true;
    bool isUnwatched_ = true;    ///< watchLoops() has not been called since
    bool watchesLoops_ = false;  ///< the next frame is drawn for it
    bool isStopped_ = false;
    std::uint64_t framesDrawn_ = 0, timesLoaded_ = 0;
    std::optional<std::array<int, 2>> pickLater_;  ///< a pixel that waits for its picture
};

}  // namespace glibra::view
