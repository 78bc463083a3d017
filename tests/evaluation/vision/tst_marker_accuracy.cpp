#include "engine/vision/printed_tools.h"
#include "evaluation/vision/marker_accuracy.h"
#include "tests/engine/vision/vision_bench.h"
#include "tests/support/test_class.h"

namespace carina::marker_accuracy_test
{
namespace
{

MarkerAccuracy accuracyOf(const std::string& tool, double distance)
{
    const PrintedTool& printed = vision_test::printed(tool);
    return markerAccuracy({.camera = vision_test::webcam(),
                           .dictionary = kPrintedDictionary,
                           .body = printed.body,
                           .rendering = {},
                           .distance = distance,
                           .isTurning = printed.isSleeve,
                           .poses = 40});
}

} // namespace

/// The camera tracker on rendered pictures of 640 by 480 pixels, against the poses rendered.
class TestMarkerAccuracy : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isAsGoodAsAWebcamCanBe_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("across_mm");
        QTest::addColumn<double>("along_mm");
        QTest::addColumn<double>("rotation_deg");
        QTest::newRow("chest at 0.4 m") << QStringLiteral("Manikin") << 0.4 << 0.1 << 0.4 << 0.3;
        QTest::newRow("chest at 0.8 m") << QStringLiteral("Manikin") << 0.8 << 0.2 << 1.2 << 0.7;
        QTest::newRow("tube at 0.3 m") << QStringLiteral("Tube") << 0.3 << 0.2 << 1.0 << 0.8;
        QTest::newRow("tube at 0.5 m") << QStringLiteral("Tube") << 0.5 << 0.4 << 2.0 << 2.0;
    }

    void isAsGoodAsAWebcamCanBe()
    {
        QFETCH(const QString, tool);
        QFETCH(const double, distance);
        QFETCH(const double, across_mm);
        QFETCH(const double, along_mm);
        QFETCH(const double, rotation_deg);
        const MarkerAccuracy found = accuracyOf(tool.toStdString(), distance);
        const auto told = [&] {
            return QStringLiteral("%1 mm, %2 mm, %3 deg, seen %4, wrong %5, corners %6 px")
                .arg(1e3 * found.acrossRms)
                .arg(1e3 * found.alongRms)
                .arg(inDegrees(radians(found.rotationRms)))
                .arg(found.seen)
                .arg(found.wrong)
                .arg(found.cornerRms);
        };
        qInfo("%s", qPrintable(told()));
        QVERIFY2(found.seen >= 30, qPrintable(told()));
        QCOMPARE(found.wrong, 0);
        QVERIFY2(1e3 * found.acrossRms < across_mm, qPrintable(told()));
        QVERIFY2(1e3 * found.alongRms < along_mm, qPrintable(told()));
        QVERIFY2(inDegrees(radians(found.rotationRms)) < rotation_deg, qPrintable(told()));
    }

    /// No pose that is given is its mirror image, however small the marker; the others are told to
    /// be ambiguous.
    void givesNoMirrorImage()
    {
        const MarkerAccuracy found = markerAccuracy({.camera = vision_test::webcam(),
                                                     .dictionary = kPrintedDictionary,
                                                     .body = {{0, 0.03, {}}},
                                                     .rendering = {},
                                                     .distance = 0.7,
                                                     .poses = 60});
        QCOMPARE(found.wrong, 0);
        QVERIFY(found.ambiguous > 0);
    }

    void growsWithTheDistance()
    {
        const MarkerAccuracy near = accuracyOf("Manikin", 0.4);
        const MarkerAccuracy far = accuracyOf("Manikin", 1.0);
        QVERIFY(near.alongRms < far.alongRms);
        QVERIFY(near.rotationRms < far.rotationRms);
    }
};

CARINA_TEST(TestMarkerAccuracy)

} // namespace carina::marker_accuracy_test

#include "tst_marker_accuracy.moc"
