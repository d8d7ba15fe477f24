// The slider of a Bound variable, as text for the scene.

#include <gtest/gtest.h>

#include "render/live/knobs.h"

namespace glibra::view {
namespace {

TEST(BoundKnob, IsWrittenFromTheCheapestToTheFinestValue) {
    render::Knob knob;
    knob.form = glib::UniformForm::range;
    knob.widget = render::Widget::slider;
    knob.minimum = .001;
    knob.maximum = .02;
    knob.current = {.005};
    EXPECT_EQ(valueText(knob), "<0.001 0.005 0.02>");
    knob.bound = scene::Variable::Fineness{.02, .001, false};
    EXPECT_EQ(valueText(knob), "<0.02 0.005 0.001>");
}

}  // namespace
}  // namespace glibra::view
