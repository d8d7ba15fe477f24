#include "view/window/platform/input.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace glibra::view {
namespace {

using Event = Display::InputEvent;
using Point = MousePoint;

constexpr int kLeft = 0, kRight = 1;
constexpr int kShift = 340, kA = 65, kEnter = 257;  // as in GLFW

Event move(double x, double y) {
    return {Event::Kind::move, 0, false, {x, y}};
}
Event press(int button) {
    return {Event::Kind::button, button, true, {}};
}
Event release(int button) {
    return {Event::Kind::button, button, false, {}};
}
Event key(int code, bool isDown) {
    return {Event::Kind::key, code, isDown, {}};
}

std::vector<InputQueue::Frame> framesOf(InputQueue& queue, const std::vector<Event>& events) {
    queue.add(events);
    std::vector<InputQueue::Frame> frames;
    do frames.push_back(queue.next());
    while (queue.isWaiting());
    return frames;
}

TEST(InputQueue, ADragBetweenTwoFramesBeginsAndEndsWhereItsButtonChanged) {
    InputQueue queue;
    const auto frames = framesOf(
        queue, {move(10, 20), press(kLeft), move(50, 20), move(130, 25), release(kLeft), move(300, 300)});
    ASSERT_EQ(frames.size(), 5U);
    EXPECT_EQ(frames[0].buttons, 0U) << "what is below the mouse knows of it before it is clicked";
    EXPECT_EQ(frames[0].mouse, (Point{10, 20}));
    EXPECT_EQ(frames[1].buttons, 1U);
    EXPECT_EQ(frames[1].mouse, (Point{10, 20}));
    EXPECT_TRUE(frames[1].way.empty());
    EXPECT_EQ(frames[2].buttons, 1U);
    EXPECT_EQ(frames[2].way, (std::vector<Point>{{50, 20}, {130, 25}}));
    EXPECT_EQ(frames[3].buttons, 0U);
    EXPECT_EQ(frames[3].mouse, (Point{130, 25}));
    EXPECT_TRUE(frames[3].way.empty());
    EXPECT_EQ(frames[4].mouse, (Point{300, 300}));
}

TEST(InputQueue, TheWayIsTheSameInOneFrameAndInMany) {
    const std::vector<Event> events{move(1, 1),   press(kLeft), move(40, 1),
                                    move(40, 40), move(1, 1),   release(kLeft)};
    const auto wayOf = [](const std::vector<InputQueue::Frame>& frames) {
        std::vector<Point> way;
        for (const InputQueue::Frame& each : frames) way.insert(way.end(), each.way.begin(), each.way.end());
        return way;
    };
    InputQueue slow, fast;
    const auto few = framesOf(slow, events);
    std::vector<InputQueue::Frame> many;
    for (const Event& each : events)
        for (InputQueue::Frame& frame : framesOf(fast, {each})) many.push_back(std::move(frame));
    EXPECT_EQ(few.size(), 4U);
    EXPECT_EQ(many.size(), 6U);
    EXPECT_EQ(wayOf(few), wayOf(many)) << "there and back is no click";
    EXPECT_EQ(wayOf(few).size(), 3U);
}

TEST(InputQueue, EveryClickOfSeveralHasItsPlace) {
    InputQueue queue;
    const auto frames = framesOf(queue, {move(5, 5), press(kLeft), release(kLeft), move(9, 9), press(kLeft),
                                         release(kLeft), press(kRight), release(kRight)});
    std::vector<std::pair<unsigned, Point>> changes;
    for (const InputQueue::Frame& each : frames) changes.emplace_back(each.buttons, *each.mouse);
    EXPECT_EQ(changes, (std::vector<std::pair<unsigned, Point>>{{0, {5, 5}},
                                                                {1, {5, 5}},
                                                                {0, {5, 5}},
                                                                {0, {9, 9}},
                                                                {1, {9, 9}},
                                                                {0, {9, 9}},
                                                                {2, {9, 9}},
                                                                {0, {9, 9}}}));
}

TEST(InputQueue, AKeyThatIsHeldDuringADragHoldsForAllOfIt) {
    InputQueue queue;
    queue.add(std::vector<Event>{move(5, 5), key(kShift, true), press(kLeft), move(60, 5), key(kShift, false),
                                 move(80, 5), release(kLeft)});
    std::vector<std::pair<bool, double>> shiftAndPlace;
    while (queue.isWaiting()) {
        const InputQueue::Frame frame = queue.next();
        shiftAndPlace.emplace_back(queue.isDown(kShift), frame.mouse->x);
    }
    // Pressed; pressed with Shift; dragged with Shift; released Shift and dragged; released.
    EXPECT_EQ(shiftAndPlace, (std::vector<std::pair<bool, double>>{
                                 {true, 5}, {true, 5}, {true, 60}, {false, 80}, {false, 80}}));
}

TEST(InputQueue, AKeyKnowsWhetherShiftWasDownWhenItWasPressed) {
    InputQueue queue;
    const auto frames =
        framesOf(queue, {key(kShift, true), key(kA, true), key(kA, false), key(kShift, false)});
    ASSERT_EQ(frames.front().pressed.size(), 1U);
    EXPECT_TRUE(frames.front().pressed.front().shift);
    const auto plain =
        framesOf(queue, {key(kA, true), key(kA, false), key(kShift, true), key(kShift, false)});
    ASSERT_EQ(plain.front().pressed.size(), 1U);
    EXPECT_FALSE(plain.front().pressed.front().shift);
}

TEST(InputQueue, KeysKeepTheirOrderAndAClickComesBeforeWhatIsTypedAfterIt) {
    InputQueue queue;
    const Event a{Event::Kind::character, 'a', true, {}};
    const auto frames =
        framesOf(queue, {move(5, 5), press(kLeft), release(kLeft), key(kA, true), a, key(kA, false),
                         key(kEnter, true), key(kEnter, false), press(kLeft)});
    ASSERT_EQ(frames.size(), 7U);
    EXPECT_TRUE(frames[1].characters.empty() && frames[2].characters.empty());
    EXPECT_EQ(frames[3].characters, std::vector<unsigned>{'a'});
    ASSERT_EQ(frames[3].pressed.size(), 1U);
    ASSERT_EQ(frames[4].pressed.size(), 1U) << "Enter knows the text before it";
    EXPECT_EQ(frames[4].pressed[0].key, kEnter);
    EXPECT_TRUE(frames[4].characters.empty());
    EXPECT_EQ(frames[6].buttons, 1U);
}

TEST(InputQueue, CharactersGoTogetherAndAKeyThatEditsAlone) {
    constexpr int kB = 66;
    InputQueue queue;
    const auto character = [](int code) { return Event{Event::Kind::character, code, true, {}}; };
    const auto frames =
        framesOf(queue, {key(kA, true), character('a'), key(kB, true), character('b'), key(kEnter, true),
                         key(kEnter, false), key(kB, false), key(kA, false), key(kA, true), character('a')});
    std::vector<std::pair<std::size_t, std::size_t>> charactersAndKeys;
    for (const InputQueue::Frame& each : frames)
        charactersAndKeys.emplace_back(each.characters.size(), each.pressed.size());
    EXPECT_EQ(charactersAndKeys,
              (std::vector<std::pair<std::size_t, std::size_t>>{{2, 2}, {0, 1}, {0, 0}, {1, 1}}));
}

TEST(InputQueue, AFrameHasAWordAtMost) {
    InputQueue queue;
    std::vector<Event> typed;
    for (const char each : std::string("ab  c "))
        typed.push_back({Event::Kind::character, static_cast<int>(each), true, {}});
    std::vector<std::string> words;
    for (const InputQueue::Frame& each : framesOf(queue, typed))
        words.emplace_back(each.characters.begin(), each.characters.end());
    EXPECT_EQ(words, (std::vector<std::string>{"ab  ", "c "}));
}

TEST(InputQueue, ControlTypesNoBlankAsWindowsHasItButAltGrDoes) {
    constexpr int kBlank = 32, kControl = 341, kAlt = 342;
    InputQueue queue;
    std::string typed;
    for (const InputQueue::Frame& each : framesOf(queue, {key(kControl, true),
                                                          key(kBlank, true),
                                                          {Event::Kind::character, ' ', true, {}},
                                                          key(kBlank, false),
                                                          key(kAlt, true),
                                                          {Event::Kind::character, '@', true, {}},
                                                          key(kAlt, false),
                                                          key(kControl, false),
                                                          {Event::Kind::character, 'a', true, {}}}))
        typed.append(each.characters.begin(), each.characters.end());
    EXPECT_EQ(typed, "@a");
}

TEST(InputQueue, AltIsDownForAFrameBeforeItGoesUp) {
    constexpr int kAlt = 342;
    InputQueue queue;
    queue.add(std::vector<Event>{key(kAlt, true), key(kAlt, false)});
    queue.next();
    EXPECT_TRUE(queue.isDown(kAlt));
    queue.next();
    EXPECT_FALSE(queue.isDown(kAlt));
    EXPECT_FALSE(queue.isWaiting());
}

TEST(InputQueue, TheMouseIsUnknownOutsideTheWindowButForADrag) {
    InputQueue queue;
    const Event leave{Event::Kind::leave, 0, false, {}};
    EXPECT_FALSE(queue.next().mouse) << "no event yet";
    EXPECT_TRUE(framesOf(queue, {move(5, 5)}).back().mouse);
    EXPECT_FALSE(framesOf(queue, {leave}).back().mouse);
    EXPECT_EQ(framesOf(queue, {move(5, 5), press(kLeft), leave, move(-40, 5)}).back().way,
              (std::vector<Point>{{-40, 5}}));
    EXPECT_FALSE(framesOf(queue, {release(kLeft), leave}).back().mouse);
}

TEST(InputQueue, TheWheelTurnsByAllItsNotches) {
    InputQueue queue;
    const Event notch{Event::Kind::wheel, 0, false, {0, 1}};
    double sum = 0;
    for (const InputQueue::Frame& each : framesOf(queue, {move(5, 5), notch, notch, move(6, 5), notch}))
        sum += each.wheel;
    EXPECT_EQ(sum, 3);
    EXPECT_EQ(queue.next().wheel, 0);
}

}  // namespace
}  // namespace glibra::view
