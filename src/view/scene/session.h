#pragma once
// What a window shows and a user changes: a scene, its values, the view, the time. It knows no window and no
// widgets, so that all of it can be driven and tested without a display.

#include <glibra/render.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/context.h"
#include "gpu/target.h"
#include "view/lens/lens_view.h"
#include "view/scene/clock.h"
#include "view/scene/knobs.h"
#include "view/scene/live_scene.h"
#include "view/scene/pick.h"
#include "view/scene/transforms.h"

namespace glibra::view {

class Session {
  public:
    /// The context must outlive it. Of the options those count that are no matter of the window: view policy,
    /// library roots, shim.
    Session(gpu::Context& context, RenderOptions options);

    /// Shows that scene, with its own values and view. False if it cannot be read; what was shown stays.
    bool open(const std::filesystem::path& path);
    /// Reads the scene and its files again; values, view and time stay. False if it cannot be read.
    bool reload();
    [[nodiscard]] bool hasScene() const { return live_ != nullptr; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// How often a scene was read; what was made of live() before the last time is out of date.
    [[nodiscard]] std::uint64_t timesLoaded() const { return timesLoaded_; }
    [[nodiscard]] const LiveScene& live() const { return *live_; }
    LiveScene& live() { return *live_; }
    /// Of the last loading, and of the frames drawn since; those about long loops of the present values.
    [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }

    [[nodiscard]] const std::vector<Knob>& knobs() const { return knobs_; }
    /// Null if there is none; `program` is the title of a knob or empty for the first that has the tag.
    [[nodiscard]] const Knob* knob(std::string_view program, std::string_view tag) const;
    /// Any values, also beyond the knob's limits; too few leave the rest as it is.
    void setValue(std::size_t knob, std::vector<double> values);
    void resetValue(std::size_t knob);
    void resetValues();
    /// "NAME=VALUE" as on the command line; the diagnostics say what is wrong with it.
    Diagnostics setByText(const std::string& argument);

    [[nodiscard]] const ViewState& view() const { return view_; }
    void setView(ViewState view);
    /// Scene, eye, object and texture transforms; values, projection and background stay.
    void resetTransforms();
    /// What the mouse does in that mode. For objects: nothing without a picked one.
    void drag(TransformMode mode, const Drag& drag);
    [[nodiscard]] Matrix transform(TransformMode mode) const;
    void setTransform(TransformMode mode, const Matrix& matrix);
    [[nodiscard]] bool axes() const { return axes_; }
    void setAxes(bool on);
    [[nodiscard]] bool wireframe() const { return wireframe_; }
    void setWireframe(bool on);
    /// What is shown instead of the picture; `glibra render` and hardcopies know nothing of it.
    [[nodiscard]] Lens lens() const { return lens_; }
    void setLens(Lens lens);
    /// As a part of half the picture's height, 0.005 to 1.
    [[nodiscard]] double normalLength() const { return normalLength_; }
    void setNormalLength(double length);
    /// What the lens showed last, bottom row first; empty without one that shows numbers.
    [[nodiscard]] const TexelImage& lensNumbers() const;

    [[nodiscard]] const Clock& clock() const { return clock_; }
    void setClock(const Clock& clock);
    /// That much real time went by.
    void advance(double seconds);
    /// True if frames follow one another by themselves: time goes on and some program reads it.
    [[nodiscard]] bool isMoving() const;

    /// Pixels of the picture; the scene's WindowSize at first.
    void resize(int width, int height);
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

    /// True if the picture is not what it should be.
    [[nodiscard]] bool needsFrame() const { return isStale_ && live_ != nullptr; }
    /// Somebody drew into the picture.
    void setNeedsFrame() { isStale_ = true; }
    /// Draws if that is needed. True if it did.
    bool drawIfNeeded();
    /// The picture drawn last; null before.
    [[nodiscard]] const gpu::Target* picture() const { return target_ ? &*target_ : nullptr; }
    [[nodiscard]] std::uint64_t framesDrawn() const { return framesDrawn_; }

    /// Chooses the object at that pixel (x to the right, y downwards), or none.
    void pickAt(int x, int y);
    void clearPick();
    [[nodiscard]] const std::optional<Picked>& picked() const { return picked_; }

    /// What `glibra render` needs to give this picture, of that size (0: the present one).
    [[nodiscard]] RenderOptions renderOptions(int width = 0, int height = 0) const;
    /// What the window shows and neither `glibra render` nor a suite can: "wireframe", "wireframe and the
    /// view 'depth'"; empty if the picture is all there is.
    [[nodiscard]] std::string onlyOnScreen() const;
    /// True if a value or the view differs from what the file says.
    [[nodiscard]] bool isChanged() const;

  private:
    void take(LiveScene::Loading loading, bool sameScene);
    Diagnostics drawShown();
    void applyValue(std::size_t knob);
    [[nodiscard]] Surroundings surroundings(TransformMode mode) const;
    [[nodiscard]] const scene::Draw* pickedDraw() const;

    gpu::Context& context_;
    RenderOptions options_;
    std::filesystem::path path_;
    std::unique_ptr<LiveScene> live_;
    Diagnostics diagnostics_;
    std::vector<Knob> knobs_;
    KeptValues kept_;
    ViewState view_;
    Clock clock_;
    bool axes_ = false, wireframe_ = false;
    Lens lens_ = Lens::picture;
    double normalLength_ = kUsualNormalLength;
    std::optional<LensView> lensView_;  ///< of live_
    int width_ = 600, height_ = 600;
    std::optional<gpu::Target> target_;
    bool isStale_ = true;
    std::uint64_t framesDrawn_ = 0, timesLoaded_ = 0;
    std::optional<Picked> picked_;
};

}  // namespace glibra::view
