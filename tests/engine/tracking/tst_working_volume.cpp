#include "engine/tracking/working_volume.h"
#include "tests/support/test_class.h"

namespace carina::working_volume_test
{

/// The cone of the first Polaris: 1.5 m high, base radius 0.5 m, apex at T, axis -z.
class WorkingVolumeTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holdsWhatLiesInTheCone_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("z");
        QTest::addColumn<bool>("inside");
        QTest::newRow("apex") << 0.0 << 0.0 << 0.0 << true;
        QTest::newRow("behind the apex") << 0.0 << 0.0 << 1e-9 << false;
        QTest::newRow("on the axis") << 0.0 << 0.0 << -0.7 << true;
        QTest::newRow("centre of the base") << 0.0 << 0.0 << -1.5 << true;
        QTest::newRow("beyond the base") << 0.0 << 0.0 << -1.500000001 << false;
        QTest::newRow("rim of the base") << 0.5 << 0.0 << -1.5 << true;
        QTest::newRow("outside the rim") << 0.0 << 0.500000001 << -1.5 << false;
        QTest::newRow("on the side, half way") << 0.0 << -0.25 << -0.75 << true;
        QTest::newRow("just outside the side") << -0.250000001 << 0.0 << -0.75 << false;
        QTest::newRow("beside the apex") << 0.1 << 0.0 << 0.0 << false;
        QTest::newRow("both ways off the axis") << 0.2 << 0.2 << -0.8 << false;
        QTest::newRow("both ways, deeper") << 0.2 << 0.2 << -0.9 << true;
        QTest::newRow("not a number") << std::nan("") << 0.0 << -0.9 << false;
    }
    void holdsWhatLiesInTheCone()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        QTEST(WorkingVolume{}.contains({x, y, z}), "inside");
    }
};

CARINA_TEST(WorkingVolumeTest)

} // namespace carina::working_volume_test

#include "tst_working_volume.moc"
