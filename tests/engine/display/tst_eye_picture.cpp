#include "engine/display/eye_picture.h"
#include "tests/support/test_class.h"

namespace carina::eye_picture_test
{

namespace
{

const Frustum kFourByThree{-0.1, 0.3, -0.2, 0.1}; // not about the line of sight
const Frustum kTwoByOne{-1.0, 1.0, -0.5, 0.5};

constexpr double kTangentTolerance = 1e-12;

bool isNear(const Frustum& f, const Frustum& truth)
{
    return std::abs(f.left - truth.left) < kTangentTolerance
           && std::abs(f.right - truth.right) < kTangentTolerance
           && std::abs(f.bottom - truth.bottom) < kTangentTolerance
           && std::abs(f.top - truth.top) < kTangentTolerance;
}

} // namespace

class TestEyePicture : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesTheNearestPixels_data();
    void takesTheNearestPixels();
    void fillsOneSideAndIsCentred_data();
    void fillsOneSideAndIsCentred();
    void leavesAPictureThatFitsAsItIs();
    void showsBeyondAnEdgeWhatIsThere();
};

void TestEyePicture::takesTheNearestPixels_data()
{
    QTest::addColumn<WindowPart>("part");
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<PixelRect>("pixels");
    QTest::newRow("all") << WindowPart{} << 1280 << 800 << PixelRect{0, 0, 1280, 800};
    QTest::newRow("left half") << WindowPart{0.0, 0.0, 0.5, 1.0} << 1280 << 800
                               << PixelRect{0, 0, 640, 800};
    QTest::newRow("right half") << WindowPart{0.5, 0.0, 0.5, 1.0} << 1280 << 800
                                << PixelRect{640, 0, 640, 800};
    QTest::newRow("left half of an odd width")
        << WindowPart{0.0, 0.0, 0.5, 1.0} << 1001 << 10 << PixelRect{0, 0, 501, 10};
    QTest::newRow("right half of an odd width")
        << WindowPart{0.5, 0.0, 0.5, 1.0} << 1001 << 10 << PixelRect{501, 0, 500, 10};
    QTest::newRow("lower quarter")
        << WindowPart{0.25, 0.75, 0.5, 0.25} << 100 << 200 << PixelRect{25, 150, 50, 50};
    QTest::newRow("one pixel") << WindowPart{} << 1 << 1 << PixelRect{0, 0, 1, 1};
}

void TestEyePicture::takesTheNearestPixels()
{
    QFETCH(WindowPart, part);
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(PixelRect, pixels);
    QCOMPARE(pixelsOf(part, width, height), pixels);
}

void TestEyePicture::fillsOneSideAndIsCentred_data()
{
    QTest::addColumn<Frustum>("frustum");
    QTest::addColumn<PixelRect>("area");
    QTest::addColumn<PixelRect>("picture");
    QTest::newRow("of the same shape")
        << kFourByThree << PixelRect{0, 0, 640, 480} << PixelRect{0, 0, 640, 480};
    QTest::newRow("too high") << kFourByThree << PixelRect{0, 0, 640, 800}
                              << PixelRect{0, 160, 640, 480};
    QTest::newRow("too high, the right half")
        << kFourByThree << PixelRect{640, 0, 640, 800} << PixelRect{640, 160, 640, 480};
    QTest::newRow("too wide, lower down")
        << kTwoByOne << PixelRect{10, 20, 300, 100} << PixelRect{60, 20, 200, 100};
    // 106 2/3 pixels are left at either side: two columns show a third of the picture each.
    QTest::newRow("edges between pixels")
        << kFourByThree << PixelRect{0, 0, 1280, 800} << PixelRect{106, 0, 1068, 800};
    // One and a half rows about the middle line touch one row above it and one below.
    QTest::newRow("a wide picture in a narrow area")
        << kTwoByOne << PixelRect{0, 0, 3, 100} << PixelRect{0, 49, 3, 2};
    QTest::newRow("a tenth of a row") << Frustum{-1000.0, 1000.0, -1.0, 1.0}
                                      << PixelRect{0, 0, 100, 99} << PixelRect{0, 49, 100, 1};
    QTest::newRow("hardly a row, between two")
        << Frustum{-1e9, 1e9, -1.0, 1.0} << PixelRect{0, 0, 100, 98} << PixelRect{0, 49, 100, 1};
    QTest::newRow("a tenth of a column") << Frustum{-1.0, 1.0, -1000.0, 1000.0}
                                         << PixelRect{0, 0, 99, 100} << PixelRect{49, 0, 1, 100};
    QTest::newRow("one pixel for all")
        << kTwoByOne << PixelRect{7, 8, 1, 1} << PixelRect{7, 8, 1, 1};
}

void TestEyePicture::fillsOneSideAndIsCentred()
{
    QFETCH(Frustum, frustum);
    QFETCH(PixelRect, area);
    QFETCH(PixelRect, picture);
    QCOMPARE(letterboxed(frustum, area).pixels, picture);
}

void TestEyePicture::leavesAPictureThatFitsAsItIs()
{
    QVERIFY(isNear(letterboxed(kFourByThree, {640, 0, 640, 800}).frustum, kFourByThree));
    QVERIFY(isNear(letterboxed(kTwoByOne, {10, 20, 300, 100}).frustum, kTwoByOne));
}

void TestEyePicture::showsBeyondAnEdgeWhatIsThere()
{
    // 800 rows for 0.3: 8000 / 3 pixels per unit. Two thirds of a pixel are beyond either side.
    const double beyond = (2.0 / 3.0) / (8000.0 / 3.0);
    QVERIFY(isNear(letterboxed(kFourByThree, {0, 0, 1280, 800}).frustum,
                   {-0.1 - beyond, 0.3 + beyond, -0.2, 0.1}));
    // Three columns for 2: a picture of 1.5 rows, of 2 drawn.
    QVERIFY(isNear(letterboxed(kTwoByOne, {0, 0, 3, 100}).frustum,
                   {-1.0, 1.0, -0.5 - 0.25 / 1.5, 0.5 + 0.25 / 1.5}));
    // The same in an area of 99 rows: the picture lies from 48.75 to 50.25, in rows 48 to 50.
    const PlacedPicture odd = letterboxed(kTwoByOne, {0, 0, 3, 99});
    QCOMPARE(odd.pixels, (PixelRect{0, 48, 3, 3}));
    QVERIFY(isNear(odd.frustum, {-1.0, 1.0, -0.5 - 0.75 / 1.5, 0.5 + 0.75 / 1.5}));
}

CARINA_TEST(TestEyePicture)

} // namespace carina::eye_picture_test

#include "tst_eye_picture.moc"
