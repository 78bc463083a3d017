#include "tests/support/test_class.h"
#include "tests/widgets/scene/plate.h"

namespace carina::error_range_test
{

using namespace carina::test;

namespace
{

constexpr double kSingle_mm = 1e-5; ///< rounding of positions in single precision

} // namespace

class TestErrorRange : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void liesBetweenTheNearestAndTheFarthestPlace();
    void countsWhatIsShownWhole();
};

void TestErrorRange::liesBetweenTheNearestAndTheFarthestPlace()
{
    std::vector parts{platePart(1, MaterialGroup::Bone),
                      spherePart(2, MaterialGroup::Lung, {0.05, 0.0, 0.0}, 0.1, "jaw")};
    SceneFrame frame;
    frame.bodies["jaw"] = {RigidTransform::translation({0.1, 0.0, 0.0}), 2.0};
    const auto range = errorRange(growingAlongX(-0.4, 5e-3), parts, frame);
    QVERIFY(range.has_value());
    QVERIFY(std::abs(inMillimetres(range->least) - 0.5) < kSingle_mm); // left edge of the plate
    QVERIFY(std::abs(inMillimetres(range->most) - 4.0) < kSingle_mm);  // right end of the ball: 0.4
}

void TestErrorRange::countsWhatIsShownWhole()
{
    std::vector parts{platePart(1, MaterialGroup::Tool), platePart(2, MaterialGroup::Bone, "jaw"),
                      platePart(3, MaterialGroup::Skin)};
    parts[2].framed = false;
    QVERIFY(!errorRange(growingAlongX(0.0, 1.0), parts, {}).has_value());
    SceneFrame frame;
    frame.bodies["jaw"] = RigidTransform{};
    QVERIFY(errorRange(growingAlongX(0.0, 1.0), parts, frame).has_value());
}

CARINA_TEST(TestErrorRange)

} // namespace carina::error_range_test

#include "tst_error_range.moc"
