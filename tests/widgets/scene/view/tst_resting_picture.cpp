#include "tests/support/test_class.h"
#include "widgets/scene/view/resting_picture.h"
#include "widgets/scene/view/same_picture.h"

#include <functional>

namespace carina::resting_picture_test
{

namespace
{

/// So many frames that are all drawn alike; how many of them have to be drawn.
int drawn(RestingPicture& picture, int frames)
{
    int count = 0;
    for (int i = 0; i < frames; ++i)
        count += picture.comes(true) ? 1 : 0;
    return count;
}

using Change = std::function<void(SceneFrame&)>;

RigidTransform aside() { return RigidTransform::translation({1e-3, 0.0, 0.0}); }

} // namespace

class TestRestingPicture : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isHeldAfterAFullOne();
    void isDrawnAnewWhenSomethingMoves();
    void isDrawnAnewWhenStirred();
    void neverRestsWhileSomethingMoves();
    void waitsLongerWhereFullDetailTakesLong();
    void framesOfOtherTimesAreDrawnAlike();
    void whatIsDrawnOtherwiseIsNotAlike_data();
    void whatIsDrawnOtherwiseIsNotAlike();
};

void TestRestingPicture::isHeldAfterAFullOne()
{
    RestingPicture picture;
    QCOMPARE(drawn(picture, RestingPicture::kFramesBefore), RestingPicture::kFramesBefore);
    QVERIFY(picture.isFull());
    QVERIFY(picture.comes(false)); // finer surfaces may have another state
    QCOMPARE(drawn(picture, 100), RestingPicture::kFullFrames - 1);
    QVERIFY(picture.isFull());
}

void TestRestingPicture::isDrawnAnewWhenSomethingMoves()
{
    RestingPicture picture;
    (void)drawn(picture, 100);
    QVERIFY(picture.comes(false));
    QVERIFY(!picture.isFull());
    QCOMPARE(drawn(picture, 100), RestingPicture::kFramesBefore + RestingPicture::kFullFrames);
}

void TestRestingPicture::isDrawnAnewWhenStirred()
{
    RestingPicture picture;
    (void)drawn(picture, 100);
    picture.stir();
    QVERIFY(!picture.isFull());
    QCOMPARE(drawn(picture, 100), RestingPicture::kFramesBefore + RestingPicture::kFullFrames);
}

void TestRestingPicture::neverRestsWhileSomethingMoves()
{
    RestingPicture picture;
    for (int i = 0; i < 200; ++i) {
        QVERIFY(picture.comes(i % 10 != 0));
        QVERIFY(!picture.isFull());
    }
}

/// 40 times 80 ms are 200 frames of 16 ms.
void TestRestingPicture::waitsLongerWhereFullDetailTakesLong()
{
    using std::chrono::milliseconds;
    RestingPicture picture;
    (void)drawn(picture, 100);
    picture.fullTook(milliseconds{80}, milliseconds{16});
    QVERIFY(picture.isFull()); // this time it does
    QCOMPARE(drawn(picture, 100), 0);
    QVERIFY(picture.comes(false));
    QCOMPARE(drawn(picture, 1000), 200 + RestingPicture::kFullFrames);
    picture.fullTook(milliseconds{2}, milliseconds{16});
    QVERIFY(picture.comes(false));
    QCOMPARE(drawn(picture, 1000), RestingPicture::kFramesBefore + RestingPicture::kFullFrames);
    picture.fullTook(milliseconds{900}, milliseconds{16});
    picture.stir();
    QCOMPARE(drawn(picture, 1000), RestingPicture::kMostFramesBefore + RestingPicture::kFullFrames);
}

void TestRestingPicture::framesOfOtherTimesAreDrawnAlike()
{
    SceneFrame frame;
    frame.bodies["tube"] = aside();
    frame.eyes.emplace().push_back({});
    SceneFrame later = frame;
    later.time += std::chrono::seconds{1};
    QVERIFY(areDrawnAlike(frame, later));
}

void TestRestingPicture::whatIsDrawnOtherwiseIsNotAlike_data()
{
    QTest::addColumn<Change>("change");
    QTest::newRow("a body elsewhere") << Change{[](SceneFrame& f) { f.bodies["tube"] = aside(); }};
    QTest::newRow("a body that is gone") << Change{[](SceneFrame& f) { f.bodies.clear(); }};
    QTest::newRow("a larger body") << Change{[](SceneFrame& f) { f.bodies["tube"].scale = 1.01; }};
    QTest::newRow("lifted out") << Change{[](SceneFrame& f) { f.lifted["lungs"] = aside(); }};
    QTest::newRow("a breath") << Change{
        [](SceneFrame& f) { f.chest.motion[1].right.descent = 0.01; }};
    QTest::newRow("the jaw") << Change{[](SceneFrame& f) { f.throat.X_AJ = aside(); }};
    QTest::newRow("the neck") << Change{[](SceneFrame& f) {
        f.throat.neck = NeckField{{0.0, 0.0, 0.1}, {0.0, -0.2, 0.25}, {degrees(15.0), {}}};
    }};
    QTest::newRow("a swelling") << Change{[](SceneFrame& f) {
        f.airway.swell({.across = metres(0.2), .along = metres(0.1), .outward = metres(0.02)});
    }};
    QTest::newRow("another eye") << Change{[](SceneFrame& f) { f.eyes->front().X_AD = aside(); }};
    QTest::newRow("another frustum")
        << Change{[](SceneFrame& f) { f.eyes->front().frustum.left = -1.1; }};
    QTest::newRow("the desktop's camera") << Change{[](SceneFrame& f) { f.eyes.reset(); }};
    QTest::newRow("a viewpoint") << Change{[](SceneFrame& f) { f.viewpoint = aside(); }};
}

void TestRestingPicture::whatIsDrawnOtherwiseIsNotAlike()
{
    QFETCH(Change, change);
    SceneFrame frame;
    frame.bodies["tube"] = RigidTransform{};
    frame.eyes.emplace().push_back({});
    SceneFrame other = frame;
    change(other);
    QVERIFY(!areDrawnAlike(frame, other));
    QVERIFY(!areDrawnAlike(other, frame));
}

CARINA_TEST(TestRestingPicture)

} // namespace carina::resting_picture_test

#include "tst_resting_picture.moc"
