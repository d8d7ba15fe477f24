#pragma once
// How a scene is looked at: the size of the picture, transforms, projection and camera, and what is shown
// with or in place of the picture. Without a scene, all of it can be used and tested without a device.

#include <glibra/render.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/live/live_scene.h"
#include "view/debug_view/debug_renderer.h"
#include "view/scene/transforms.h"
#include "view/scene/window_target.h"

namespace glibra::view {

class Look {
  public:
    /// `changed` is called when the picture is out of date.
    explicit Look(std::function<void()> changed) : changed_(std::move(changed)) {}

    /// Another scene is opened, in its own size and view.
    void begin(const scene::Scene& scene);
    /// The scene is about to go. `next`: the same scene, loaded again; the transforms of objects, and what is
    /// picked, go with the same commands at the same places in the order of draws.
    void leave(const scene::Scene* next = nullptr);
    /// The scene that is shown from now on. It must stay until leave().
    void enter(render::LiveScene& live);

    [[nodiscard]] const ViewState& view() const { return view_; }
    void setView(ViewState view);
    /// The view as it is drawn: in a picture of another shape than setWholeShape() says, the scene is
    /// smaller.
    [[nodiscard]] ViewState shownView() const;
    /// The same for a frame that is drawn now; valid until the next call. A view that is drawn as it is, is
    /// not copied, so that frames of a moving scene allocate no memory.
    const ViewState& beginFrame();
    /// Resets scene, eye, object and texture transforms; values, projection and background stay.
    void resetTransforms();
    /// Applies a drag of the mouse in that mode. TransformMode::object does nothing if no object is picked.
    void drag(TransformMode mode, const Drag& drag);
    [[nodiscard]] Matrix transform(TransformMode mode) const;
    void setTransform(TransformMode mode, const Matrix& matrix);
    /// The next projection in a round: as in the scene, orthographic if the scene draws in perspective,
    /// perspective if it draws in an orthographic box.
    void nextProjection();
    /// The object that TransformMode::object moves.
    [[nodiscard]] const std::optional<Picked>& picked() const { return picked_; }
    void setPicked(std::optional<Picked> picked) { picked_ = std::move(picked); }

    /// The camera that the picture is seen from; empty: as in the scene. See LiveScene::setCamera.
    [[nodiscard]] const std::string& camera() const { return camera_; }
    /// A name that the scene does not declare means: as in the scene.
    void setCamera(const std::string& name);
    /// The next camera of the scene, by name; after the last one, as in the scene.
    void nextCamera();

    /// Sets the size of the picture in pixels. At first it is the scene's WindowSize.
    void resize(int width, int height);
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    /// Sets the shape that a perspective shows whole: width / height; 0: a perspective keeps its vertical
    /// angle. In pictures that are narrower, the scene then becomes smaller, and nothing of it is cropped.
    void setWholeShape(double aspect);

    [[nodiscard]] bool axes() const { return axes_; }
    void setAxes(bool on) { change(axes_, on); }
    [[nodiscard]] bool wireframe() const { return wireframe_; }
    void setWireframe(bool on);
    /// What is shown in place of the picture. It affects neither `glibra render` nor hardcopies.
    [[nodiscard]] DebugView debugView() const { return debugView_; }
    void setDebugView(DebugView kind) { change(debugView_, kind); }
    /// Length of normals as a fraction of half the picture's height, 0.005 to 1.
    [[nodiscard]] double normalLength() const { return normalLength_; }
    void setNormalLength(double length);
    /// The corner that shows the values; it affects hardcopies and suite shots, not the picture.
    [[nodiscard]] LabelCorner labels() const { return labels_; }
    /// `only`: those that begin so (labelBegin); empty: all. The rest is not known to renderOptions().
    void setLabels(LabelCorner corner, std::vector<std::string> only = {}) {
        labels_ = corner;
        labelled_ = std::move(only);
    }
    [[nodiscard]] const std::vector<std::string>& labelled() const { return labelled_; }

    /// Takes over all but labels and what is picked. The transforms of objects are named by lines; they stay
    /// out unless both show the same file.
    void setLike(const Look& other, bool isSameFile);

  private:
    template <class Value>
    void change(Value& value, Value now) {
        if (std::exchange(value, now) != now) changed_();
    }
    [[nodiscard]] double shrinking() const;
    [[nodiscard]] Surroundings surroundings(TransformMode mode) const;
    [[nodiscard]] const scene::Draw* pickedDraw() const;

    std::function<void()> changed_;
    render::LiveScene* live_ = nullptr;
    ViewState view_, smaller_;  ///< `smaller_`: beginFrame()
    std::optional<Picked> picked_;
    std::string camera_;
    int width_ = 600, height_ = 600;
    double wholeShape_ = 0, drawnShrinking_ = 1;
    bool axes_ = false, wireframe_ = false;
    DebugView debugView_ = DebugView::picture;
    double normalLength_ = kUsualNormalLength;
    LabelCorner labels_ = LabelCorner::none;
    std::vector<std::string> labelled_;
};

}  // namespace glibra::view
