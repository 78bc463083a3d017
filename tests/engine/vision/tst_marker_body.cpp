#include "engine/vision/marker_body.h"
#include "engine/vision/marker_dictionary.h"
#include "engine/vision/printed_tools.h"
#include "tests/engine/vision/vision_bench.h"
#include "tests/support/test_class.h"

#include <set>

namespace carina::marker_body_test
{
namespace
{

constexpr double kTolerance = 1e-12;

} // namespace

class TestMarkerBody : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasItsCornersAsThePictureIsRead()
    {
        const auto corners = cornersOf({0, 0.02, RigidTransform::translation({1.0, 2.0, 3.0})});
        QVERIFY((corners[0] - Vec3{0.99, 2.01, 3.0}).norm() < kTolerance);
        QVERIFY((corners[1] - Vec3{1.01, 2.01, 3.0}).norm() < kTolerance);
        QVERIFY((corners[2] - Vec3{1.01, 1.99, 3.0}).norm() < kTolerance);
        QVERIFY((corners[3] - Vec3{0.99, 1.99, 3.0}).norm() < kTolerance);
    }

    void refusesABodyThatIsNone_data()
    {
        QTest::addColumn<MarkerBody>("body");
        QTest::addColumn<QByteArray>("named");
        QTest::newRow("no marker") << MarkerBody{} << QByteArray{"64"};
        QTest::newRow("too many") << MarkerBody(65) << QByteArray{"64"};
        QTest::newRow("one twice")
            << MarkerBody{{3, 0.02, {}}, {3, 0.02, {}}} << QByteArray{"marker 3"};
        QTest::newRow("beyond the dictionary")
            << MarkerBody{{50, 0.02, {}}} << QByteArray{"marker 50"};
        QTest::newRow("before it") << MarkerBody{{-1, 0.02, {}}} << QByteArray{"marker -1"};
        QTest::newRow("without a size") << MarkerBody{{2, 0.0, {}}} << QByteArray{"marker 2"};
        QTest::newRow("of two metres") << MarkerBody{{2, 2.0, {}}} << QByteArray{"marker 2"};
    }

    void refusesABodyThatIsNone()
    {
        QFETCH(const MarkerBody, body);
        QFETCH(const QByteArray, named);
        const auto checked = checkBody(body, 50);
        QVERIFY(!checked);
        QCOMPARE(checked.error().code, Errc::OutOfRange);
        QVERIFY(QByteArray::fromStdString(checked.error().detail).contains(named));
    }

    /// The cells of marker 0 of 4x4_50, as printed in many places: 0xb532.
    void knowsTheCellsOfAMarker()
    {
        const auto cells = cellsOf(MarkerDictionary::Bits4Of50, 0);
        const QByteArray shown{"000000"
                               "010110"
                               "001010"
                               "000110"
                               "000100"
                               "000000"};
        QCOMPARE(cells.size(), std::size_t(shown.size()));
        for (qsizetype i = 0; i < shown.size(); ++i)
            QCOMPARE(cells[std::size_t(i)], shown[i] == '1');
        QCOMPARE(sizeOf(MarkerDictionary::Bits4Of50), 50);
        QCOMPARE(cellsOf(MarkerDictionary::AprilTag36h11), 8);
    }

    void printsNoMarkerOnTwoTools()
    {
        std::set<int> ids;
        for (const PrintedTool& tool : printedTools()) {
            QVERIFY(checkBody(tool.body, sizeOf(kPrintedDictionary)));
            for (const BodyMarker& marker : tool.body)
                QVERIFY(ids.insert(marker.id).second);
        }
    }

    /// Folded along the edges between the faces, a sleeve is a box about +z.
    void foldsASleeveToABox()
    {
        for (const PrintedTool& tool : printedTools()) {
            if (!tool.isSleeve)
                continue;
            for (std::size_t i = 0; i < 4; ++i) {
                const RigidTransform& X_BK = tool.body[i].X_BK;
                const RigidTransform& next = tool.body[(i + 1) % 4].X_BK;
                const Vec3 outwards = X_BK.rotation() * Vec3::UnitZ();
                const Vec3 right = X_BK.rotation() * Vec3::UnitX();
                QVERIFY((X_BK.rotation() * Vec3::UnitY() - Vec3::UnitZ()).norm() < kTolerance);
                QVERIFY(std::abs(outwards.dot(X_BK.translation()) - 0.5 * tool.width.si)
                        < kTolerance);
                // The next face begins at this one's right edge, and looks there.
                QVERIFY((next.rotation() * Vec3::UnitZ() - right).norm() < kTolerance);
            }
        }
    }
};

CARINA_TEST(TestMarkerBody)

} // namespace carina::marker_body_test

#include "tst_marker_body.moc"
