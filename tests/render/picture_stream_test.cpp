// Pictures that are encoded on several threads and written in their order.

#include "render/file/picture_writer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "image/png/png_writer.h"

namespace glibra::render {
namespace {

using Png = PictureStream::Png;

/// Pictures of very different sizes, so that threads finish in another order.
image::Image pictureOf(int number) {
    const int side = number % 3 == 0 ? 600 : 8;
    image::Image made{side, side, 3, image::Component::u8, {}};
    made.data.resize(made.rowBytes() * static_cast<std::size_t>(side));
    for (std::size_t i = 0; i < made.data.size(); ++i)
        made.data[i] = static_cast<std::byte>(i * static_cast<std::size_t>(number + 3) / 7);
    return made;
}

TEST(PictureStream, WritesTheBytesOfEachPictureInOrder) {
    std::vector<Png> written;
    std::vector<int> numbers;
    PictureStream stream(
        [&](const Png& png) {
            written.push_back(png);
            return Diagnostics();
        },
        [&](int number) { numbers.push_back(number); });
    std::vector<Png> wanted;
    for (int i = 0; i < 40; ++i) {
        const bool isCopy = i % 5 == 4;
        ASSERT_TRUE(isCopy ? stream.addAgain(i) : stream.add(i, pictureOf(i)));
        wanted.push_back(isCopy ? wanted.back() : image::encodePng(pictureOf(i)));
    }
    EXPECT_TRUE(stream.finish().empty());
    EXPECT_TRUE(written == wanted);
    std::vector<int> all(40);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(numbers, all);
}

TEST(PictureStream, EndsWithTheFirstThatCannotBeWritten) {
    int tried = 0;
    std::vector<int> numbers;
    PictureStream stream(
        [&](const Png&) { return ++tried == 3 ? Diagnostics{diagnose("file-E10", "full")} : Diagnostics(); },
        [&](int number) { numbers.push_back(number); });
    int added = 0;
    while (added < 1000 && stream.add(added, pictureOf(1))) ++added;
    EXPECT_LT(added, 1000) << "adding tells it";
    const Diagnostics problems = stream.finish();
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems.front().text, "full");
    EXPECT_EQ(tried, 3) << "nothing is written after it";
    EXPECT_EQ(numbers, (std::vector<int>{0, 1}));
}

TEST(PictureStream, IsWrittenWhileTheNextPictureIsDrawn) {
    // The time limit of a frame begins again when the one before is written, not when a next one is added.
    std::atomic<int> last = -1;
    PictureStream stream([](const Png&) { return Diagnostics(); },
                         [&](int number) {
                             last = number;
                             last.notify_all();
                         });
    ASSERT_TRUE(stream.add(0, pictureOf(1)));
    last.wait(-1);
    EXPECT_EQ(last, 0);
}

TEST(PictureStream, ThatIsLeftWritesNoMore) {
    std::atomic<int> tried = 0;
    {
        PictureStream stream(
            [&](const Png&) {
                ++tried;
                return Diagnostics();
            },
            [](int) {});
        for (int i = 0; i < 3; ++i) ASSERT_TRUE(stream.add(3 * i, pictureOf(3 * i)));
    }
    const int before = tried;
    EXPECT_LE(before, 3);
}

TEST(PictureStream, PassesOnWhatIsThrown) {
    PictureStream stream([](const Png&) -> Diagnostics { throw std::runtime_error("lost"); }, [](int) {});
    ASSERT_TRUE(stream.add(0, pictureOf(0)));
    EXPECT_THROW(stream.finish(), std::runtime_error);
}

}  // namespace
}  // namespace glibra::render
