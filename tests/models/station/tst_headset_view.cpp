#include "models/station/headset_view.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::headset_view_test
{

namespace
{

constexpr double kTolerance = 1e-12; ///< metres, and tangents

/// Eyes 60 mm apart before a screen of 0.8 m by 0.6 m, 2 m ahead and 0.1 m to the right.
const DisplayGeometry kDisplay{.p_HDl = {-0.03, 0.0, 0.0},
                               .p_HDr = {0.03, 0.0, 0.0},
                               .p_HQ_screenCentre = {0.1, 0.0, -2.0},
                               .screenWidth = 0.8,
                               .screenHeight = 0.6};

/// A head that looks up, a quarter turn about its x axis, so that its y axis is A's z axis.
PoseSample head(Validity validity = Validity::Tracked)
{
    const double half = std::sqrt(0.5);
    PoseSample sample;
    sample.X_FO = RigidTransform{Quat{half, half, 0.0, 0.0}, Vec3{1.0, 2.0, 3.0}};
    sample.validity = validity;
    return sample;
}

HeadsetView headset() { return HeadsetView::of(kDisplay).value(); }

bool isPart(const WindowPart& part, double x, double width)
{
    return part.x == x && part.y == 0.0 && part.width == width && part.height == 1.0;
}

bool isAt(const EyePicture& eye, const Vec3& p_A)
{
    return (eye.X_AD.translation() - p_A).norm() < kTolerance
           && (eye.X_AD * Vec3{0.0, 0.0, -1.0} - p_A - Vec3{0.0, 1.0, 0.0}).norm() < kTolerance;
}

bool spans(const EyePicture& eye, double left, double right)
{
    return std::abs(eye.frustum.left - left) < kTolerance
           && std::abs(eye.frustum.right - right) < kTolerance
           && std::abs(eye.frustum.bottom + 0.15) < kTolerance
           && std::abs(eye.frustum.top - 0.15) < kTolerance;
}

} // namespace

class TestHeadsetView : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsItsOutputsByName();
    void refusesAnotherOutput_data();
    void refusesAnotherOutput();
    void leavesAScreenToItsCamera();
    void looksOnceFromMidwayBetweenTheEyes();
    void showsTheLeftEyeLeftAndTheRightEyeRight();
    void showsTheSameToAHeadWhosePlaceIsKnown();
    void showsNothingToAHeadThatIsLost_data();
    void showsNothingToAHeadThatIsLost();
    void refusesADisplayBehindOneEye();
};

void TestHeadsetView::knowsItsOutputsByName()
{
    QVERIFY(viewOutputNamed(QStringLiteral("screen")) == ViewOutput::Screen);
    QVERIFY(viewOutputNamed(QStringLiteral("mono")) == ViewOutput::Mono);
    QVERIFY(viewOutputNamed(QStringLiteral("side-by-side")) == ViewOutput::SideBySide);
}

void TestHeadsetView::refusesAnotherOutput_data()
{
    QTest::addColumn<QString>("word");
    for (const char* word : {"", "Mono", "stereo", "side by side", "mono "})
        QTest::addRow("'%s'", word) << QString::fromLatin1(word);
}

void TestHeadsetView::refusesAnotherOutput()
{
    QFETCH(QString, word);
    const Result<ViewOutput> output = viewOutputNamed(word);
    QVERIFY(!output);
    QCOMPARE(output.error().code, Errc::WrongOption);
    QVERIFY(
        QString::fromStdString(output.error().detail).endsWith(QStringLiteral("'%1'").arg(word)));
}

void TestHeadsetView::leavesAScreenToItsCamera()
{
    QVERIFY(!headset().eyes(ViewOutput::Screen, head()).has_value());
    QVERIFY(!headset().eyes(ViewOutput::Screen, std::nullopt).has_value());
}

void TestHeadsetView::looksOnceFromMidwayBetweenTheEyes()
{
    const auto eyes = headset().eyes(ViewOutput::Mono, head());
    QCOMPARE(eyes.value().size(), std::size_t{1});
    QVERIFY(isAt(eyes->front(), {1.0, 2.0, 3.0}));
    QVERIFY(spans(eyes->front(), -0.15, 0.25));
    QVERIFY(isPart(eyes->front().part, 0.0, 1.0));
}

void TestHeadsetView::showsTheLeftEyeLeftAndTheRightEyeRight()
{
    for (const Validity validity : {Validity::Tracked, Validity::PartlyOccluded}) {
        const auto eyes = headset().eyes(ViewOutput::SideBySide, head(validity));
        QCOMPARE(eyes.value().size(), std::size_t{2});
        QVERIFY(isAt((*eyes)[0], {0.97, 2.0, 3.0}));
        QVERIFY(spans((*eyes)[0], -0.135, 0.265));
        QVERIFY(isPart((*eyes)[0].part, 0.0, 0.5));
        QVERIFY(isAt((*eyes)[1], {1.03, 2.0, 3.0}));
        QVERIFY(spans((*eyes)[1], -0.165, 0.235));
        QVERIFY(isPart((*eyes)[1].part, 0.5, 0.5));
    }
}

void TestHeadsetView::showsTheSameToAHeadWhosePlaceIsKnown()
{
    const RigidTransform X_AH = head().X_FO;
    QVERIFY(!headset().eyesAt(ViewOutput::Screen, X_AH).has_value());
    const auto one = headset().eyesAt(ViewOutput::Mono, X_AH);
    QCOMPARE(one.value().size(), std::size_t{1});
    QVERIFY(isAt(one->front(), {1.0, 2.0, 3.0}));
    const auto two = headset().eyesAt(ViewOutput::SideBySide, X_AH);
    QCOMPARE(two.value().size(), std::size_t{2});
    QVERIFY(isAt((*two)[0], {0.97, 2.0, 3.0}));
    QVERIFY(isAt((*two)[1], {1.03, 2.0, 3.0}));
}

void TestHeadsetView::showsNothingToAHeadThatIsLost_data()
{
    QTest::addColumn<ViewOutput>("output");
    QTest::newRow("mono") << ViewOutput::Mono;
    QTest::newRow("side by side") << ViewOutput::SideBySide;
}

void TestHeadsetView::showsNothingToAHeadThatIsLost()
{
    QFETCH(ViewOutput, output);
    for (const auto& lost : {std::optional<PoseSample>{}, std::optional{head(Validity::Lost)}}) {
        const auto eyes = headset().eyes(output, lost);
        QVERIFY(eyes.has_value());
        QVERIFY(eyes->empty());
    }
}

void TestHeadsetView::refusesADisplayBehindOneEye()
{
    for (Vec3 DisplayGeometry::*eye : {&DisplayGeometry::p_HDl, &DisplayGeometry::p_HDr}) {
        DisplayGeometry display = kDisplay;
        (display.*eye).z() = -2.1;
        const Result<HeadsetView> refused = HeadsetView::of(display);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, Errc::OutOfRange);
    }
}

CARINA_TEST(TestHeadsetView)

} // namespace carina::headset_view_test

#include "tst_headset_view.moc"
