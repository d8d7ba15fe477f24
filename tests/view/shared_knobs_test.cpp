#include "render/live/knobs.h"

#include <gtest/gtest.h>

namespace glibra::view::test {
namespace {

render::Knob knobOf(std::size_t program, const char* tag, double initial, double maximum = 1) {
    render::Knob knob;
    knob.program = scene::ProgramIndex(program);
    knob.tag = tag;
    knob.type.word = "float";
    knob.widget = render::Widget::slider;
    knob.maximum = maximum;
    knob.initial = knob.current = {initial};
    return knob;
}

TEST(SharedKnobs, AreThoseOfSeveralProgramsWithOneRangeAndValue) {
    std::vector<render::Knob> knobs{knobOf(0, "uKd", .5), knobOf(0, "uKs", .2),     knobOf(1, "uKd", .5),
                                    knobOf(1, "uKs", .3), knobOf(2, "uKd", .5, 2.), knobOf(3, "uKd", .5)};
    knobs[3].current = {.2};  // what a user has set does not matter
    EXPECT_EQ(sharedKnobs(knobs), (std::vector<std::vector<std::size_t>>{{0, 2, 5}}));
    render::Knob variable = knobOf(0, "uKd", .5);
    variable.program = {};
    EXPECT_TRUE(sharedKnobs(std::vector<render::Knob>{variable, knobOf(1, "uKd", .5)}).empty());
    EXPECT_TRUE(render::sharedKnobs({}).empty());
}

}  // namespace
}  // namespace glibra::view::test
